"""FORMAT.md, Version 3: palette. No encoder writes it today; speed does not matter."""

import numpy as np

from .coding import SIZE, DecodeError, Header


class Bits:
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


class SymbolModels:
    def __init__(self):
        self.differs = [[[32768, 32768, 0] for _ in range(3)] for _ in range(5)]
        self.index = [[32768, 32768, 0] for _ in range(256)]


def read_palette(payload):
    header = Header(payload)
    ids = header.numbers(header.number(), 256)
    if any(a >= b for a, b in zip(ids, ids[1:])):
        raise DecodeError("bad_materials", "ids do not rise")
    bits = Bits(payload, header.at)
    is_mixed = [[32768, 32768, 0] for _ in range(8)]
    of_blocks, of_voxels = SymbolModels(), SymbolModels()
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
    if voxels.max() >= len(ids):
        raise DecodeError("bad_number", "a palette index past the end of the list")
    return np.array(ids, np.uint16)[voxels[1:, 1:, 1:]]
