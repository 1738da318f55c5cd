"""FORMAT.md, Volume. numpy finds the contexts of a wave at once; only voxels that are not steady are looped over."""

import functools

import numpy as np

from .coding import SIZE, VOXELS, DecodeError, Header, slot_table
from .model import BLOCKS

_WAVES = 94
_PADDED = SIZE + 2  # a row with its first and last voxel repeated at its ends
_FIRST_ROW = SIZE * SIZE  # a row of the first material
_GAPS = slot_table([int(size) for size in BLOCKS["gap-sizes"].split()])


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


class Exceptions:
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

    def pass_by(self, count):
        self.wait -= count

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


# What is equal near a voxel, as bits of one number. The first eight of them are known before its row is.
_NEAR_BITS = 8


def _bits(count):
    numbers = np.arange(1 << count)
    return [(numbers >> i & 1).astype(bool) for i in range(count)]


def _number(*bits):
    return sum(bit.astype(np.int16) << i for i, bit in enumerate(bits))


def _even_contexts():
    upright, level_south, west_n, east_n, west_b, east_b, same, level, south_north = _bits(_NEAR_BITS + 1)
    surroundings = _number(upright, level_south, west_n, east_n, west_b, east_b)
    differ = _number(level, upright, level_south, south_north, west_n & east_n, west_b & east_b)
    return np.where(same, surroundings, 64 + differ).astype(np.int16)


def _odd_contexts():
    """Contexts, and where E is first: by the first eight bits and W = E, N = W, B = W, N = E, B = E."""
    upright, level_south, west_n, east_n, west_b, east_b, same, level, between, nw, bw, ne, be = _bits(_NEAR_BITS + 5)
    base_west, other_west = np.where(level, nw, bw), np.where(level, bw, nw)
    base_east, other_east = np.where(level, ne, be), np.where(level, be, ne)
    swap = base_east | (other_east & ~base_west)
    surroundings = _number(upright, level_south, west_n, east_n, west_b, east_b)
    differ = _number(
        np.where(swap, base_east, base_west),
        np.where(swap, other_east, other_west),
        np.where(swap, base_west, base_east),
        np.where(swap, other_west, other_east),
        upright,
        level,
        level_south,
    )
    equal = _number(base_west, other_west, same, upright, level, level_south)
    contexts = np.where(between, np.where(base_west & other_west, 128 + surroundings, 192 + equal), 256 + differ)
    return contexts.astype(np.int16), swap & ~between


_EVEN_CONTEXTS = _even_contexts()
_ODD_CONTEXTS, _EAST_FIRST = _odd_contexts()
_STEADY_EVEN, _STEADY_ODD = 63, 128 + 63  # the contexts of steady voxels


def _packed(equal):
    """Each voxel's eight bits, the last axis, as one number. Along any other axis packbits takes ten times as long."""
    return np.packbits(equal, bitorder="little").reshape(equal.shape[:2]).astype(np.intp)


def read_volume(payload):
    header = Header(payload)
    ids, slots = header.materials_with_probabilities()
    count = header.number()
    if len(payload) < header.at + 33:
        raise DecodeError("truncated")
    table = header.take(1)[0]
    if table > 7:
        raise DecodeError("bad_number", f"table {table}; there are 0 to 7")
    ends = _volume_ends(table)
    coded = header.coded()
    exceptions = Exceptions(coded, slots, count)
    # Places in the list of materials, of which the first is 0. The last row stays as it is.
    rows = np.zeros((SIZE * SIZE + 1, _PADDED), np.uint8)
    for wave in range(_WAVES):
        places = _wave_rows(wave)
        rows[places[0]] = Wave(rows[places[1:]], coded, exceptions, ends, slots).read()
    if exceptions.left or exceptions.group:
        raise DecodeError("bad_number", "exceptions are left over")
    coded.finish()
    return np.array(ids, np.uint16)[rows[:-1, 1:-1]]


class Wave:
    """The rows around a wave's: [north, below, below north, below south][row of the wave][x + 1]."""

    def __init__(self, around, coded, exceptions, ends, slots):
        self.around, self.coded, self.exceptions, self.ends, self.slots = around, coded, exceptions, ends, slots

    def read(self):
        """The wave's rows, padded."""
        around = self.around
        padded = around[1].copy()
        now = padded[:, 1:-1]
        north, below, below_north, below_south = around[:, :, 1:-1]
        equal = np.empty((*now.shape, _NEAR_BITS), bool)
        bits = equal.transpose(2, 0, 1)
        np.equal(north, below_north, out=bits[0])  # upright
        np.equal(below, below_south, out=bits[1])  # level south
        np.equal(around[:2, :, :-2], around[:2, :, 1:-1], out=bits[2:6:2])  # west n, west b
        np.equal(around[:2, :, 2:], around[:2, :, 1:-1], out=bits[3:6:2])  # east n, east b
        np.equal(north, below, out=bits[6])  # same
        np.equal(below, below_north, out=bits[7])  # level
        near = _packed(equal)
        np.copyto(now, north, where=bits[7])  # base, the first candidate of even columns
        if (near & 127).min() == 127 and self.exceptions.wait >= now.size:
            self.exceptions.pass_by(now.size)  # odd voxels are steady too, as their neighbours are base
            return padded
        self.read_even(now, near[:, 0::2], north[:, 0::2] == below_south[:, 0::2])
        padded[:, -1] = padded[:, -3]  # E of the last column is W
        self.read_odd(padded, near[:, 1::2], north[:, 1::2], below[:, 1::2])
        padded[:, 0] = padded[:, 1]
        padded[:, -1] = padded[:, -2]
        return padded

    def read_even(self, now, near, south_north):
        contexts = _EVEN_CONTEXTS[near + south_north * (1 << _NEAR_BITS)]
        now[:, 0::2] = self.read_batch(now[:, 0::2].ravel(), contexts.ravel(), None).reshape(near.shape)

    def read_odd(self, padded, near, north, below):
        west, east = padded[:, 1:-2:2], padded[:, 3::2]
        equal = np.zeros((*near.shape, 8), bool)
        bits = equal.transpose(2, 0, 1)
        np.equal(west, east, out=bits[0])
        np.equal(north, west, out=bits[1])
        np.equal(below, west, out=bits[2])
        np.equal(north, east, out=bits[3])
        np.equal(below, east, out=bits[4])
        places = near + (_packed(equal) << _NEAR_BITS)
        swap = _EAST_FIRST[places]
        first = np.where(swap, east, west).ravel()
        read = self.read_batch(first, _ODD_CONTEXTS[places].ravel(), lambda: np.where(swap, west, east).ravel())
        padded[:, 2::2] = read.reshape(near.shape)

    def read_batch(self, voxels, contexts, seconds):
        """`voxels`, the first candidates of a batch, become the voxels. `seconds`, of odd columns, gives the second."""
        coded, exceptions, ends = self.coded, self.exceptions, self.ends
        steady = contexts == (_STEADY_EVEN if seconds is None else _STEADY_ODD)
        others = np.flatnonzero(~steady)
        count = steady.size - others.size
        if exceptions.wait >= count:
            exceptions.pass_by(count)
        else:
            places = np.flatnonzero(steady)
            for place, material in exceptions.among(count):
                voxels[places[place]] = material
        symbols = coded.symbols([ends[context] for context in contexts[others].tolist()])
        bad = ""
        if any(symbols):
            escapes = []
            around = self.around.tobytes()
            if seconds:
                seconds = seconds()
            for place, first, symbol in zip(others.tolist(), voxels[others].tolist(), symbols):
                if symbol == 3:
                    escapes.append(place)
                elif symbol:
                    candidates = self.candidates(around, place, () if seconds is None else (first, int(seconds[place])))
                    if symbol < len(candidates):
                        voxels[place] = candidates[symbol]
                    else:
                        bad = "a candidate that there is not"
            voxels[escapes] = coded.values(self.slots, len(escapes))
        coded.end_of_step(bad)
        return voxels

    def candidates(self, around, place, beside):
        """The different materials around the voxel at `place` of its batch, the likeliest first."""
        row, column = divmod(place, SIZE // 2)
        stride = self.around.shape[1] * _PADDED
        north = row * _PADDED + 2 * column + (1 + (len(beside) > 0))
        below = north + stride
        n, b, d, s = around[north], around[below], around[below + stride], around[below + 2 * stride]
        both = (n, b) if b == d else (b, n)
        sides = (around[north + 1], around[north - 1], around[below + 1], around[below - 1])
        return list(dict.fromkeys(beside + both + sides + (s, d)))
