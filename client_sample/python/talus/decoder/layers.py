"""FORMAT.md, Layered. numpy finds the features of a row at once."""

import numpy as np

from .coding import SIZE, VOXELS, DecodeError, Header
from .model import BLOCKS

# The features of a column, two bits of its key each.
_FEATURES = (
    "west",
    "east",
    "far east",
    "step",
    "step west",
    "step east",
    "step far west",
    "step far east",
    "floor",
    "thickness",
    "thickness west",
    "thickness east",
    "symbol west",
    "symbol east",
)
_PAIRS = (
    ("step west", "step east"),
    ("floor", "thickness east"),
    ("west", "east"),
    ("step", "step far west"),
    ("far east", "step far east"),
    ("thickness west", "thickness east"),
    ("west", "thickness"),
    ("east", "thickness"),
    ("floor", "thickness"),
    ("west", "symbol west"),
    ("east", "symbol east"),
    ("thickness", "symbol west"),
    ("thickness", "symbol east"),
)
_SYMBOL_WEST, _SYMBOL_EAST = (2 * _FEATURES.index(name) for name in ("symbol west", "symbol east"))


def _interval_ends():
    """For each pair of classes, 16 * the first score's + the second's: ends of the intervals of symbols 0, 1 and 2."""
    a, o, u = (list(map(int, line.split())) for line in BLOCKS["intervals"].strip().split("\n"))
    return [(a[i], a[i] + 1 + ((o[i] - a[i] - 2) * u[j] >> 8), o[i]) for i in range(16) for j in range(16)]


class Columns(dict):
    """Ends of intervals by a column's key, for one kind of row and parity of x. Keys repeat, so scores are kept."""

    INTERVAL_ENDS = _interval_ends()
    MOST = 1 << 14

    def __init__(self, kind, parity):
        super().__init__()
        weights = [list(map(int, line.split())) for line in BLOCKS[f"weights-{kind}-{parity}"].strip().split("\n")]
        self.pairs = [
            (2 * _FEATURES.index(first), 2 * _FEATURES.index(second), weights[2 * i], weights[2 * i + 1])
            for i, (first, second) in enumerate(_PAIRS[: len(weights) // 2])
        ]

    def __missing__(self, key):
        one = two = 0
        for first, second, weights_one, weights_two in self.pairs:
            features = (key >> first & 3) + 4 * (key >> second & 3)
            one = min(max(one + weights_one[features], -128), 127)
            two = min(max(two + weights_two[features], -128), 127)
        if len(self) == self.MOST:
            self.clear()
        ends = self[key] = self.INTERVAL_ENDS[(max(one, 0) >> 3) * 16 + (max(two, 0) >> 3)]
        return ends


_COLUMNS = {kind: (Columns(kind, "even"), Columns(kind, "odd")) for kind in ("first", "level", "carried")}


def read_layered(payload):
    header = Header(payload)
    count = header.number()
    ids = None
    if 66 <= count <= 80:
        count -= 64
    else:
        ids = header.numbers(count, 64)
        _check_neighbours(ids)
        if count == 1:
            if header.at < len(payload):
                raise DecodeError("too_long")
            return np.full(VOXELS, ids[0], np.uint16)
    coded = header.coded()
    floor = np.zeros((SIZE, SIZE), int)
    # A voxel has as many planes at or below it as materials lie below its own.
    levels = np.arange(SIZE)[:, None, None]
    materials = np.zeros((SIZE, SIZE, SIZE), np.uint8)
    for _ in range(count - 1):
        floor = _read_plane(coded, floor)
        materials += floor <= levels
    ending = coded.finish(endings=ids is None)
    if ids is None:
        ids = _ids_of_ending(ending, count)
        _check_neighbours(ids)
    return np.array(ids, np.uint16)[materials]


def _check_neighbours(ids):
    if any(a == b for a, b in zip(ids, ids[1:])):
        raise DecodeError("bad_materials", "neighbours are equal")


def _ids_of_ending(ending, count):
    header = Header(b"  " + ending)
    try:
        ids = [header.number() for _ in range(count)]
    except DecodeError:
        raise DecodeError("bad_ending", "the final states hold no ids") from None
    if any(ending[header.at - 2 :]):
        raise DecodeError("bad_ending", "the final states hold more than ids")
    return ids


# The features of a row in one array: steps from x = -2, rises from x - 1 to x, rises of two columns, thicknesses from
# x = -1, and the floor's rises.
_STEPS, _RISES, _FAR, _THICKNESS, _FLOOR, _END = 0, 36, 70, 102, 136, 168
_PLACES = {
    "west": _RISES,
    "east": _RISES + 1,
    "far east": _FAR,
    "step": _STEPS + 2,
    "step west": _STEPS + 1,
    "step east": _STEPS + 3,
    "step far west": _STEPS,
    "step far east": _STEPS + 4,
    "floor": _FLOOR,
    "thickness": _THICKNESS + 1,
    "thickness west": _THICKNESS,
    "thickness east": _THICKNESS + 2,
}
_GATHER = np.array([_PLACES[name] + np.arange(SIZE) for name in _FEATURES if name in _PLACES])
_KEY_BITS = np.array([1 << 2 * i for i, name in enumerate(_FEATURES) if name in _PLACES])
_REPEATED = np.array([0, *range(SIZE), SIZE - 1, SIZE - 1])  # x = -1 to 33


class RowFeatures:
    """The keys of a row's columns, without the symbols."""

    def __init__(self):
        self.signs = np.empty(_END, int)
        self.thickness = np.empty(34, int)

    def keys(self, steps, north, below_north, below):
        signs = self.signs
        near = north[_REPEATED]
        signs[:_RISES] = steps
        np.subtract(near[1:], near[:-1], out=signs[_RISES : _FAR])
        np.subtract(near[3:], north, out=signs[_FAR : _THICKNESS])
        np.subtract(below, below_north, out=signs[_FLOOR :])
        np.sign(signs, out=signs)
        signs += 1
        np.subtract(near[:34], below_north[_REPEATED[:34]], out=self.thickness)
        np.minimum(self.thickness, 2, out=signs[_THICKNESS : _FLOOR])
        return np.dot(_KEY_BITS, signs[_GATHER]).tolist()


def _read_plane(coded, floor):
    present = coded.bytes(1)[0]
    masks = [coded.bytes(1)[0] if present >> b & 1 else 0 for b in range(4)]
    carried = int.from_bytes(bytes(masks), "little")
    coded.end_of_step("a mask of carried rows" if present > 15 or carried & 1 else "")
    plane = np.zeros((SIZE, SIZE), int)
    features = RowFeatures()
    steps = np.zeros(SIZE + 4, int)  # of the row before, from x = -2
    for z in range(SIZE):
        north, below_north = (plane[z - 1], floor[z - 1]) if z else (floor[0], floor[0])
        kind = "carried" if carried >> z & 1 else "level" if z else "first"
        changes = _read_changes(coded, features.keys(steps, north, below_north, floor[z]), *_COLUMNS[kind])
        steps[2:-2] = changes if kind == "level" else np.cumsum(changes)
        np.maximum(north * (north != below_north), floor[z], out=plane[z])  # as predicted: no floor is below 0
        plane[z] += steps[2:-2]
        if coded.at > coded.end:
            break
    whole = slice(z if coded.at > coded.end else SIZE)  # a wrong height in a row before goes before an early end
    if (plane[whole] < floor[whole]).any() or (plane[whole] > SIZE).any():
        raise DecodeError("bad_number", "a height below its floor or over 32")
    coded.end_of_step()
    return plane


def _read_changes(coded, keys, even_columns, odd_columns):
    """The changes of a row's steps."""
    even = coded.symbols([even_columns[key] for key in keys[0::2]])
    odd_keys = keys[1::2]
    if any(even):
        odd_keys = [
            key + (west << _SYMBOL_WEST) + (east << _SYMBOL_EAST)
            for key, west, east in zip(odd_keys, even, even[1:] + [0])
        ]
    odd = coded.symbols([odd_columns[key] for key in odd_keys])
    symbols = [symbol for pair in zip(even, odd) for symbol in pair]
    return [_CHANGES[symbol] if symbol < 3 else _signed(coded.bytes(1)[0]) for symbol in symbols]


_CHANGES = (0, 1, -1)


def _signed(byte):
    return byte - 256 if byte > 127 else byte
