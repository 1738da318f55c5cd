"""The payload of a chunk as voxels: codec 4 of core/voxel/FORMAT.md, whose words and order this file follows.

    voxels = decode(payload)        # numpy uint16[32][32][32]: y, z, x

The symbols of the entropy coder come one after another, so a loop reads them; what predicts them is done by numpy for
a row of a plane or a wave of a volume at once.
"""

import functools
import struct

import numpy as np

from .model import BLOCKS

SIZE = 32
VOXELS = SIZE**3
MAX_PAYLOAD_BYTES = 65538

# Zeros after the payload, so that a step may read past the end and be refused after it. A batch of a volume is the
# longest step: 17 groups of exceptions and 256 symbols and escapes, under 2,000 bytes.
_READ_AHEAD = 4096


class DecodeError(ValueError):
    """Bytes that are no payload. `reason` is the error's name in FORMAT.md, with underscores."""

    def __init__(self, reason, detail=""):
        super().__init__(f"not a chunk's payload: {reason.replace('_', ' ')}" + (f" ({detail})" if detail else ""))
        self.reason = reason


def decode(payload):
    """Voxels of a payload (bytes), as a new array uint16[y][z][x]. Raises DecodeError for anything else."""
    payload = bytes(payload)
    if not payload:
        raise DecodeError("empty")
    version = payload[0]
    if version not in (3, 4):
        raise DecodeError("unknown_version", f"{version}; this decoder knows 3 and 4")
    if len(payload) < 2:
        raise DecodeError("truncated")
    if len(payload) > MAX_PAYLOAD_BYTES:
        raise DecodeError("too_long", f"{len(payload)} bytes; a payload has at most {MAX_PAYLOAD_BYTES}")
    read = _ENCODINGS.get((version, payload[1]))
    if read is None:
        raise DecodeError("unknown_encoding", f"{payload[1]} of version {version}")
    return read(payload).astype(np.uint16, copy=False).reshape(SIZE, SIZE, SIZE)


# ---- numbers, lists, states and symbols --------------------------------------------------------------------------


class _Header:
    """The parts of a body before the coded ones, from the payload's third byte on."""

    def __init__(self, payload):
        self.payload = payload
        self.at = 2

    def take(self, count):
        part = self.payload[self.at : self.at + count]
        if len(part) < count:
            raise DecodeError("truncated")
        self.at += count
        return part

    def number(self):
        value = 0
        for shift in (0, 7, 14):
            byte = self.take(1)[0]
            value |= (byte & 127) << shift
            if byte < 128:
                if value > 0xFFFF or (byte == 0 and shift > 0):
                    break
                return value
        raise DecodeError("bad_number", "a number over 65,535 or longer than necessary")

    def numbers(self, count, most):
        if not 1 <= count <= most:
            raise DecodeError("bad_materials", f"{count} materials; from 1 to {most} are possible")
        return [self.number() for _ in range(count)]

    def materials_with_probabilities(self):
        ids = self.numbers(self.number(), 256)
        if ids[0] in ids[1:] or any(a >= b for a, b in zip(ids[1:], ids[2:])):
            raise DecodeError("bad_materials", "an id repeats, or ids after the first do not rise")
        return ids, _slots([size + 1 for size in self.take(len(ids))])

    def coded(self):
        """What is left: 16 states and the coded part."""
        return _Coded(self.payload, self.at)


def _slots(sizes):
    """For each slot 0 to 255: (the size of its interval, the slot's place in it, the symbol)."""
    if sum(sizes) != 256:
        raise DecodeError("bad_number", f"intervals end at {sum(sizes)} instead of 256")
    return [(size, place, symbol) for symbol, size in enumerate(sizes) for place in range(size)]


class _Coded:
    """Sixteen rANS states and the bytes that they take, to the end of the payload."""

    def __init__(self, payload, at):
        if len(payload) < at + 32:
            raise DecodeError("truncated")
        self.states = list(struct.unpack_from("<16H", payload, at))
        if min(self.states) < 256:
            raise DecodeError("bad_ending", "a state begins below 256")
        self.data = payload + bytes(_READ_AHEAD)
        self.at = at + 32
        self.end = len(payload)

    def symbols(self, ends):
        """A symbol 0 to 3 for each (end of symbol 0, of 1, of 2); the k-th is read from state k % 16."""
        states, data, at = self.states, self.data, self.at
        symbols = []
        put = symbols.append
        lane = 0
        for one, two, three in ends:
            state = states[lane]
            slot = state & 255
            if slot < one:
                state = one * (state >> 8) + slot
                put(0)
            elif slot < two:
                state = (two - one) * (state >> 8) + slot - one
                put(1)
            elif slot < three:
                state = (three - two) * (state >> 8) + slot - two
                put(2)
            else:
                state = (256 - three) * (state >> 8) + slot - three
                put(3)
            if state < 256:
                state = state << 8 | data[at]
                at += 1
            states[lane] = state
            lane = lane + 1 & 15
        self.at = at
        return symbols

    def values(self, slots, count):
        """`count` symbols of the same intervals; the k-th is read from state k % 16."""
        states, data, at = self.states, self.data, self.at
        values = []
        for k in range(count):
            state = states[k & 15]
            size, place, value = slots[state & 255]
            state = size * (state >> 8) + place
            if state < 256:
                state = state << 8 | data[at]
                at += 1
            states[k & 15] = state
            values.append(value)
        self.at = at
        return values

    def digits(self, slots, count):
        """A group of up to 16 numbers as digits."""
        counts = self.values(slots, count)
        size = sum(digits - 1 for digits in counts if digits) + 7 >> 3
        bits = int.from_bytes(self.bytes(size), "little")
        numbers = []
        for digits in counts:
            below = max(digits - 1, 0)
            numbers.append(bits & (1 << below) - 1 | 1 << below if digits else 0)
            bits >>= below
        return numbers

    def bytes(self, count):
        part = self.data[self.at : self.at + count]
        self.at += count
        return part

    def end_of_step(self, bad=""):
        if self.at > self.end:
            raise DecodeError("truncated")
        if bad:
            raise DecodeError("bad_number", bad)

    def finish(self, endings=None):
        """At the end. Without `endings` all states must be 256; else they hold bytes, which are given back."""
        if self.at < self.end:
            raise DecodeError("too_long", f"{self.end - self.at} bytes after the end")
        rest = [state - 256 for state in self.states]
        if max(rest) > (255 if endings else 0):
            raise DecodeError("bad_ending", "the final states are not those of a whole payload")
        return bytes(rest)


# ---- raw and runs ------------------------------------------------------------------------------------------------


def _read_raw(payload):
    if len(payload) < MAX_PAYLOAD_BYTES:
        raise DecodeError("truncated")
    return np.frombuffer(payload, "<u2", VOXELS, 2).copy()


def _read_runs(payload):
    header = _Header(payload)
    ids, slots = header.materials_with_probabilities()
    count = header.number()
    single = count == VOXELS
    digits = None if single else _slots(header.take(16))
    coded = header.coded()
    lengths, kinds = [], []
    filled = 0
    for begin in range(0, count, 256 if single else 16):
        size = min(count - begin, 256 if single else 16)
        group = [1] * size if single else [more + 1 for more in coded.digits(digits, size)]
        kinds += coded.values(slots, size)
        filled += sum(group)
        coded.end_of_step("runs of more voxels than a chunk has" if filled > VOXELS else "")
        lengths += group
    if filled != VOXELS:
        raise DecodeError("bad_number", f"runs of {filled} voxels; a chunk has {VOXELS}")
    coded.finish()
    return np.repeat(np.array(ids, np.uint16)[kinds], lengths)


# ---- volume ------------------------------------------------------------------------------------------------------

_WAVES = 94
_PADDED = SIZE + 2  # a row with its first and last voxel repeated at its ends
_FIRST_ROW = SIZE * SIZE  # a row of the first material
_GAPS = _slots([int(size) for size in BLOCKS["gap-sizes"].split()])


@functools.lru_cache(maxsize=None)
def _volume_ends(table):
    """For each context 0 to 383: where the intervals of symbols 0, 1 and 2 end."""
    numbers = [int(end) for end in BLOCKS["volume-ends"].split()]
    classes = [tuple(numbers[i : i + 3]) for i in range(0, len(numbers), 3)]
    letters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
    return [classes[letters.index(letter)] for line in BLOCKS["volume-classes"][table].split() for letter in line]


@functools.lru_cache(maxsize=None)
def _wave_rows(wave):
    """Places in the array of rows: those of the wave, and of their rows north, below, below north and below south."""

    def place(y, z):
        return y * SIZE + z

    rows = []
    for y in range(max(0, (wave - SIZE + 2) // 2), min(SIZE - 1, wave // 2) + 1):
        z = wave - 2 * y
        if y == 0 and z == 0:
            around = [_FIRST_ROW] * 4
        elif y == 0:
            around = [place(0, z - 1)] * 4
        else:
            below = place(y - 1, z)
            around = [
                place(y, z - 1) if z > 0 else below,
                below,
                place(y - 1, z - 1) if z > 0 else below,
                place(y - 1, z + 1) if z < SIZE - 1 else below,
            ]
        rows.append([place(y, z), *around])
    return np.array(rows).T


class _Exceptions:
    """Materials of steady voxels that are not as predicted. `wait` counts the steady voxels before the next one."""

    def __init__(self, coded, slots, count):
        self.coded, self.slots, self.left = coded, slots, count
        self.group = []
        self.wait = VOXELS  # more than can come
        self.advance()

    def advance(self):
        if not self.group and self.left:
            size = min(self.left, 16)
            gaps = self.coded.digits(_GAPS, size)
            self.group = list(zip(gaps, self.coded.values(self.slots, size)))[::-1]
            self.left -= size
        self.wait = self.group[-1][0] if self.group else VOXELS

    def among(self, count):
        """(place, material) of each exception among the next `count` steady voxels."""
        found = []
        at = 0
        while at + self.wait < count:
            at += self.wait
            found.append((at, self.group.pop()[1]))
            at += 1
            self.advance()
        self.wait -= count - at
        return found


def _read_volume(payload):
    header = _Header(payload)
    ids, slots = header.materials_with_probabilities()
    count = header.number()
    if len(payload) < header.at + 33:
        raise DecodeError("truncated")
    table = header.take(1)[0]
    if table > 7:
        raise DecodeError("bad_number", f"table {table}; there are 0 to 7")
    ends = _volume_ends(table)
    coded = header.coded()
    exceptions = _Exceptions(coded, slots, count)
    # Places in the list of materials, of which the first is 0. The last row stays as it is.
    rows = np.zeros((SIZE * SIZE + 1, _PADDED), np.uint8)
    for wave in range(_WAVES):
        places = _wave_rows(wave)
        _Wave(rows[places[1:]], coded, exceptions, ends, slots).read(rows, places[0])
    if exceptions.left or exceptions.group:
        raise DecodeError("bad_number", "exceptions are left over")
    coded.finish()
    return np.array(ids, np.uint16)[rows[:-1, 1:-1]]


class _Wave:
    """The rows around a wave's, and what is equal in them; arrays are [row of the wave][x]."""

    def __init__(self, around, coded, exceptions, ends, slots):
        self.around, self.coded, self.exceptions, self.ends, self.slots = around, coded, exceptions, ends, slots
        self.north, self.below, below_north, self.below_south = around[:, :, 1:-1]
        equal = np.empty((8, *self.north.shape), bool)
        np.equal(self.north, below_north, out=equal[0])  # upright
        np.equal(self.below, self.below_south, out=equal[1])  # level south
        np.equal(around[0, :, :-2], self.north, out=equal[2])  # west n
        np.equal(around[0, :, 2:], self.north, out=equal[3])  # east n
        np.equal(around[1, :, :-2], self.below, out=equal[4])  # west b
        np.equal(around[1, :, 2:], self.below, out=equal[5])  # east b
        np.equal(self.north, self.below, out=equal[6])  # same
        np.equal(self.below, below_north, out=equal[7])  # level
        self.equal = equal
        self.surroundings = np.packbits(equal[:6], axis=0, bitorder="little")[0]

    def read(self, rows, places):
        same = self.equal[6]
        steady = same & (self.surroundings == 63)
        now = np.where(self.equal[7], self.north, self.below)  # base, first of all
        if steady.all() and self.exceptions.wait >= now.size:
            self.exceptions.among(now.size)  # every odd voxel is steady too, as both of its neighbours are base
        else:
            self.base = now.copy()
            self.other = np.where(self.equal[7], self.below, self.north)
            self.read_even(now, same, steady)
            self.read_odd(now, same, steady)
        rows[places, 1:-1] = now
        rows[places, 0] = now[:, 0]
        rows[places, -1] = now[:, -1]

    def read_even(self, now, same, steady):
        upright, level_south, west_n, east_n, west_b, east_b, _, level = self.equal[:, :, 0::2]
        differ = np.packbits(
            [
                level,
                upright,
                level_south,
                self.below_south[:, 0::2] == self.north[:, 0::2],
                west_n & east_n,
                west_b & east_b,
            ],
            axis=0,
            bitorder="little",
        )[0]
        contexts = np.where(same[:, 0::2], self.surroundings[:, 0::2], differ + 64)
        voxels = self.base[:, 0::2].ravel()
        self.read_batch(voxels, contexts, steady[:, 0::2], 0)
        now[:, 0::2] = voxels.reshape(contexts.shape)

    def read_odd(self, now, same, steady):
        base, other = self.base[:, 1::2], self.other[:, 1::2]
        upright, level_south, _, _, _, _, _, level = self.equal[:, :, 1::2]
        west = now[:, 0::2]
        east = np.concatenate((west[:, 1:], west[:, -1:]), axis=1)
        between = west == east
        base_west, other_west = base == west, other == west
        base_east, other_east = base == east, other == east
        swap = base_east | (other_east & ~base_west)
        first = np.where(swap, east, west)
        second = np.where(swap, west, east)
        all_equal = between & base_west & other_west
        # What is said of first and second where W and E differ is said of W alone where they do not.
        contexts = np.packbits(
            [
                np.where(swap, base_east, base_west),
                np.where(swap, other_east, other_west),
                np.where(between, same[:, 1::2], base == second),
                np.where(between, upright, other == second),
                np.where(between, level, upright),
                np.where(between, level_south, level),
                level_south & ~between,
            ],
            axis=0,
            bitorder="little",
        )[0].astype(np.int16)
        contexts += np.where(between, 192, 256).astype(np.int16)
        contexts = np.where(all_equal, self.surroundings[:, 1::2] + np.int16(128), contexts)
        voxels = first.ravel()
        self.first, self.second = voxels.tolist(), second.ravel().tolist()
        self.read_batch(voxels, contexts, all_equal & (self.surroundings[:, 1::2] == 63), 1)
        now[:, 1::2] = voxels.reshape(contexts.shape)

    def read_batch(self, voxels, contexts, steady, odd):
        """`voxels` are the first candidates of a batch, and become the voxels."""
        coded = self.coded
        steady = steady.ravel()
        others = np.flatnonzero(~steady)
        count = steady.size - others.size
        if self.exceptions.wait < count:
            places = np.flatnonzero(steady)
            for place, material in self.exceptions.among(count):
                voxels[places[place]] = material
        else:
            self.exceptions.among(count)
        ends = self.ends
        symbols = coded.symbols([ends[context] for context in contexts.ravel()[others].tolist()])
        bad = ""
        if any(symbols):
            others = others.tolist()
            escapes = []
            near = self.around.tobytes()
            for place, symbol in zip(others, symbols):
                if symbol == 3:
                    escapes.append(place)
                elif symbol:
                    candidates = self.candidates(near, place, odd)
                    if symbol < len(candidates):
                        voxels[place] = candidates[symbol]
                    else:
                        bad = "a candidate that there is not"
            voxels[escapes] = coded.values(self.slots, len(escapes))
        coded.end_of_step(bad)

    def candidates(self, near, place, odd):
        """The different materials around the voxel at `place` of its batch, the likeliest first."""
        row, column = divmod(place, SIZE // 2)
        stride = self.around.shape[1] * _PADDED
        north = row * _PADDED + 2 * column + odd + 1
        below = north + stride
        level = near[below] == near[below + stride]
        both = (near[north], near[below]) if level else (near[below], near[north])
        sides = (self.first[place], self.second[place]) if odd else ()
        around = (near[north + 1], near[north - 1], near[below + 1], near[below - 1])
        return list(dict.fromkeys(sides + both + around + (near[below + 2 * stride], near[below + stride])))[:3]


# ---- layered -----------------------------------------------------------------------------------------------------

# Where the features of a row lie in one array, and each pair of features as their two places: for x = 0 to 31.
_STEPS, _NORTH, _FAR, _THICK, _FLOOR = 0, 36, 70, 102, 136
_PAIRS = (
    (_STEPS + 1, _STEPS + 3),  # step west, step east
    (_FLOOR, _THICK + 2),  # floor, thickness east
    (_NORTH, _NORTH + 1),  # west, east
    (_STEPS + 2, _STEPS),  # step, step far west
    (_FAR, _STEPS + 4),  # far east, step far east
    (_THICK, _THICK + 2),  # thickness west, thickness east
    (_NORTH, _THICK + 1),  # west, thickness
    (_NORTH + 1, _THICK + 1),  # east, thickness
    (_FLOOR, _THICK + 1),  # floor, thickness
)
_X = np.arange(SIZE)
_FIRST_FEATURES = np.array([first + _X for first, _ in _PAIRS])
_SECOND_FEATURES = np.array([second + _X for _, second in _PAIRS])
# Weights of both scores for even columns, then for odd ones: [score][parity * 208 + pair * 16 + features].
_PAIR_WEIGHTS = np.arange(9)[:, None] * 16 + _X % 2 * 208
_SYMBOL_WEIGHTS = (208 + 9 * 16 + np.arange(4) * 16)[:, None] + np.zeros(16, int)
_REPEATED = np.array([0, *_X, 31, 31])  # x = -1 to 33


def _weights(kind):
    weights = np.zeros((2, 2, 13, 16), int)
    for parity, name in enumerate(("even", "odd")):
        numbers = np.array(BLOCKS[f"weights-{kind}-{name}"].split(), int).reshape(-1, 2, 16)
        weights[:, parity, : len(numbers)] = numbers.transpose(1, 0, 2)
    return weights.reshape(2, -1)


_WEIGHTS = {kind: _weights(kind) for kind in ("first", "level", "carried")}


def _interval_ends():
    """By 16 * the first score's class + the second's."""
    a, o, u = (list(map(int, line.split())) for line in BLOCKS["intervals"].strip().split("\n"))
    return [(a[i], a[i] + 1 + ((o[i] - a[i] - 2) * u[j] >> 8), o[i]) for i in range(16) for j in range(16)]


_INTERVAL_ENDS = _interval_ends()


def _read_layered(payload):
    header = _Header(payload)
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
    header = _Header(b"  " + ending)
    try:
        ids = [header.number() for _ in range(count)]
    except DecodeError:
        raise DecodeError("bad_ending", "the final states hold no ids") from None
    if any(ending[header.at - 2 :]):
        raise DecodeError("bad_ending", "the final states hold more than ids")
    return ids


def _read_plane(coded, floor):
    present = coded.bytes(1)[0]
    masks = [coded.bytes(1)[0] if present >> b & 1 else 0 for b in range(4)]
    carried = int.from_bytes(bytes(masks), "little")
    coded.end_of_step("a mask of carried rows" if present > 15 or carried & 1 else "")
    plane = np.zeros((SIZE, SIZE), int)
    features = np.ones(168, int)
    steps = np.zeros(SIZE + 4, int)  # of the row before, from x = -2
    for z in range(SIZE):
        north = plane[z - 1] if z else floor[0]
        below_north = floor[z - 1] if z else floor[0]
        below = floor[z]
        near = north[_REPEATED]
        features[_STEPS:_NORTH] = steps
        np.subtract(near[1:], near[:-1], out=features[_NORTH:_FAR])
        np.subtract(near[3:], north, out=features[_FAR:_THICK])
        np.subtract(below, below_north, out=features[_FLOOR:])
        np.sign(features, out=features)
        features += 1
        np.minimum((near - below_north[_REPEATED])[:34], 2, out=features[_THICK:_FLOOR])
        kind = "carried" if carried >> z & 1 else "level" if z else "first"
        change = _read_changes(coded, features, _WEIGHTS[kind])
        steps[2:-2] = change if kind == "level" else np.cumsum(change)
        predicted = np.where(north == below_north, below, np.maximum(north, below))
        row = np.add(predicted, steps[2:-2], out=plane[z])
        coded.end_of_step("a height below its floor or over 32" if (row < below).any() or row.max() > SIZE else "")
    return plane


def _read_changes(coded, features, weights):
    """The changes of a row's steps."""
    pairs = features[_FIRST_FEATURES] + 4 * features[_SECOND_FEATURES]
    scores = _add(None, weights.take(pairs + _PAIR_WEIGHTS, axis=1))
    symbols = [0] * SIZE
    symbols[0::2] = coded.symbols(_ends(scores[:, 0::2]))
    west = np.array(symbols[0::2])
    east = np.append(west[1:], 0)
    first = features[_ODD_FEATURES]
    first[:2] += 4 * np.stack((west, east))
    first[2:] += 4 * np.stack((west, east))
    symbols[1::2] = coded.symbols(_ends(_add(scores[:, 1::2], weights.take(first + _SYMBOL_WEIGHTS, axis=1))))
    return np.array([_CHANGES[s] if s < 3 else _signed(coded.bytes(1)[0]) for s in symbols])


_CHANGES = (0, 1, -1)
_ODD_FEATURES = np.array([place + _X[1::2] for place in (_NORTH, _NORTH + 1, _THICK + 1, _THICK + 1)])


def _signed(byte):
    return byte - 256 if byte > 127 else byte


def _add(scores, weights):
    """Adds weights[score][pair][x] to scores[score][x] pair by pair, saturating."""
    sums = np.cumsum(weights, axis=1)
    if scores is not None:
        sums += scores[:, None]
    if sums.max() <= 127 and sums.min() >= -128:
        return sums[:, -1]
    scores = np.zeros_like(sums[:, 0]) if scores is None else scores
    for pair in range(weights.shape[1]):
        scores = np.clip(scores + weights[:, pair], -128, 127)
    return scores


def _ends(scores):
    first, second = np.maximum(scores, 0) >> 3
    return [_INTERVAL_ENDS[place] for place in (first * 16 + second).tolist()]


# ---- palette, of version 3: no encoder writes it today ------------------------------------------------------------


class _Bits:
    """The adaptive binary range coder. A model is [fast, slow, age]."""

    def __init__(self, payload, at):
        self.data = payload + b"\0\0"
        self.at = at + 4
        if self.at > len(self.data):
            raise DecodeError("truncated")
        self.code = int.from_bytes(self.data[at : self.at], "big")
        self.full = self.code == 0xFFFFFFFF
        self.range = 0xFFFFFFFF

    def read(self, model):
        fast, slow, age = model
        bound = (self.range >> 12) * (fast + slow >> 5)
        s = (age + 1).bit_length()
        f = min(s, 4)
        bit = self.code >= bound
        if bit:
            self.range -= bound
            self.code -= bound
            model[0] = fast - (fast >> f)
            model[1] = slow - (slow >> s)
        else:
            self.range = bound
            model[0] = fast + (65536 - fast >> f)
            model[1] = slow + (65536 - slow >> s)
        model[2] = min(age + 1, 31)
        while self.range < 1 << 24:
            if self.at == len(self.data):
                raise DecodeError("truncated")
            self.range <<= 8
            self.code = (self.code << 8 | self.data[self.at]) & 0xFFFFFFFF
            self.at += 1
        return bit

    def finish(self):
        if self.at < len(self.data):
            raise DecodeError("too_long")
        if self.code > 0xFFFF or self.full:
            raise DecodeError("bad_ending")


class _SymbolModels:
    def __init__(self):
        self.differs = [[[32768, 32768, 0] for _ in range(3)] for _ in range(5)]
        self.index = [[32768, 32768, 0] for _ in range(256)]


def _read_palette(payload):
    header = _Header(payload)
    ids = header.numbers(header.number(), 256)
    if any(a >= b for a, b in zip(ids, ids[1:])):
        raise DecodeError("bad_materials", "ids do not rise")
    bits = _Bits(payload, header.at)
    is_mixed = [[32768, 32768, 0] for _ in range(8)]
    of_blocks, of_voxels = _SymbolModels(), _SymbolModels()
    # With a border of zeros below, to the north and to the west.
    mixed = np.zeros((9, 9, 9), bool)
    voxels = np.zeros((SIZE + 1, SIZE + 1, SIZE + 1), np.uint8)

    def symbol(models, y, z, x):
        below, west, north = int(voxels[y, z + 1, x + 1]), int(voxels[y + 1, z + 1, x]), int(voxels[y + 1, z, x + 1])
        if below == west:
            pattern = 0 if west == north else 1
        else:
            pattern = 2 if below == north else 3 if west == north else 4
        differs = models.differs[pattern]
        if not bits.read(differs[0]):
            return below
        if west != below and not bits.read(differs[1]):
            return west
        if north != below and north != west and not bits.read(differs[2]):
            return north
        node = 1
        for _ in range(8):
            node = node * 2 + bits.read(models.index[node])
        if node - 256 >= len(ids):
            raise DecodeError("bad_number", "a palette index past the end of the list")
        return node - 256

    for y, z, x in np.ndindex(8, 8, 8):
        context = mixed[y + 1, z + 1, x] + 2 * mixed[y + 1, z, x + 1] + 4 * mixed[y, z + 1, x + 1]
        if bits.read(is_mixed[context]):
            mixed[y + 1, z + 1, x + 1] = True
            for dy, dz, dx in np.ndindex(4, 4, 4):
                at = (4 * y + dy, 4 * z + dz, 4 * x + dx)
                voxels[at[0] + 1, at[1] + 1, at[2] + 1] = symbol(of_voxels, *at)
        else:
            at = (4 * y + 1, 4 * z + 1, 4 * x + 1)
            voxels[at[0] : at[0] + 4, at[1] : at[1] + 4, at[2] : at[2] + 4] = symbol(of_blocks, 4 * y, 4 * z, 4 * x)
    bits.finish()
    return np.array(ids, np.uint16)[voxels[1:, 1:, 1:]]


_ENCODINGS = {
    (3, 0): _read_layered,
    (3, 1): _read_palette,
    (3, 2): _read_raw,
    (4, 1): _read_volume,
    (4, 2): _read_raw,
    (4, 3): _read_runs,
}
