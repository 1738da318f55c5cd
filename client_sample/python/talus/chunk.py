"""A chunk as received, from a stream or over HTTP."""

import functools

from .content_hash import content_hash
from .decoder import SIZE, DecodeError, decode
from .protocol import ChunkKey

_UNIFORM = b"\3\0\1"  # layers of one material, whose id follows


class Chunk:
    """32 x 32 x 32 voxels at `key`: x, y, z in chunks of level `lod`.

    `payload` is encoded. `revision` is 0 for generated chunks. `hash` is the content hash sent with the payload, as a
    128-bit number, or None over HTTP.
    """

    def __init__(self, key, payload, hash=None, revision=0):
        self.key = ChunkKey(*key)
        self.payload = payload
        self.hash = hash
        self.revision = revision

    @classmethod
    def uniform(cls, key, material):
        number = b""
        while material > 127:
            number += bytes([material & 127 | 128])
            material >>= 7
        return cls(key, _UNIFORM + number + bytes([material]))

    @functools.cached_property
    def voxels(self):
        """Material ids, uint16[y][z][x]: x east, y up, z south.

        Decoded and checked against the hash on first use.
        """
        voxels = decode(self.payload)
        if self.hash is not None and content_hash(voxels) != self.hash:
            raise DecodeError("wrong_hash", f"chunk {self.key} has not the voxels that its hash says")
        return voxels

    @property
    def is_uniform(self):
        """True if it is known, without decoding, to consist of one material. False if that is unknown."""
        return self.payload.startswith(_UNIFORM)

    @property
    def origin(self):
        """Base voxel at its west, bottom, north corner."""
        size = SIZE << self.key.lod
        return self.key.x * size, self.key.y * size, self.key.z * size

    def __repr__(self):
        x, y, z, lod = self.key
        return f"<chunk {x} {y} {z} of level {lod}, {len(self.payload)} bytes>"
