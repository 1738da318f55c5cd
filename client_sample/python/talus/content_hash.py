"""XXH3-128 with seed 0 of a chunk's voxels, the hash in Chunk and Unchanged.

Implements only inputs of 65,536 bytes: 64 blocks of 16 stripes of 64 bytes, in eight lanes of 64 bits.
"""

import numpy as np

_SECRET = bytes.fromhex(
    "b8fe6c3923a44bbe7c01812cf721ad1cded46de9839097db7240a4a4b7b3671fcb79e64eccc0e578825ad07dccff7221"
    "b8084674f743248ee03590e6813a264c3c2852bb91c300cb88d0658b1b532ea371644897a20df94e3819ef46a9deacd8"
    "a8fa763fe39c343ff9dcbbc7c70b4f1d8a51e04bcdb45931c89f7ec9d9787364eac5ac8334d3ebc3c581a0fffa1363eb"
    "170ddd51b7f0da49d316552629d4689e2b16be587d47a1fc8ff8b8d17ad031ce45cb3a8f95160428afd7fbcabb4b407e"
)
_PRIME32_1, _PRIME32_2, _PRIME32_3 = 0x9E3779B1, 0x85EBCA77, 0xC2B2AE3D
_PRIME64_1, _PRIME64_2, _PRIME64_3 = 0x9E3779B185EBCA87, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9
_PRIME64_4, _PRIME64_5 = 0x85EBCA77C2B2AE63, 0x27D4EB2F165667C5
_MASK64 = (1 << 64) - 1

_BYTES = 65536


def _secret(at, count):
    return np.frombuffer(_SECRET, "<u8", count, at).astype(np.uint64)


_STRIPE_KEYS = np.stack([_secret(8 * stripe, 8) for stripe in range(16)])
_LAST_STRIPE_KEY = _secret(121, 8)
_SCRAMBLE_KEY = _secret(128, 8)
_START = np.array(
    [_PRIME32_3, _PRIME64_1, _PRIME64_2, _PRIME64_3, _PRIME64_4, _PRIME32_2, _PRIME64_5, _PRIME32_1], np.uint64
)


def content_hash(voxels):
    """The hash of uint16[32][32][32] as a 128-bit number: high * 2^64 + low of Hash128."""
    data = np.ascontiguousarray(voxels, "<u2").view("<u8")
    if data.nbytes != _BYTES:
        raise ValueError(f"a chunk has 32 x 32 x 32 voxels, not {voxels.size}")
    blocks = data.reshape(64, 16, 8).astype(np.uint64, copy=False)
    keyed = blocks ^ _STRIPE_KEYS
    keyed[63, 15] = blocks[63, 15] ^ _LAST_STRIPE_KEY
    # A block's contribution does not depend on the lanes, so all blocks are summed at once; neighbour lanes swap data.
    sums = ((keyed & np.uint64(0xFFFFFFFF)) * (keyed >> np.uint64(32))).sum(axis=1, dtype=np.uint64)
    sums += blocks.sum(axis=1, dtype=np.uint64)[:, [1, 0, 3, 2, 5, 4, 7, 6]]
    lanes = _START.copy()
    shift, prime = np.uint64(47), np.uint64(_PRIME32_1)
    for block in sums[:63]:
        lanes += block
        lanes ^= lanes >> shift
        lanes ^= _SCRAMBLE_KEY
        lanes *= prime
    lanes += sums[63]
    lanes = lanes.tolist()
    low = _merge(lanes, 11, _BYTES * _PRIME64_1)
    high = _merge(lanes, 117, ~(_BYTES * _PRIME64_2))
    return high << 64 | low


def _merge(lanes, at, result):
    for i in range(0, 8, 2):
        first = lanes[i] ^ int.from_bytes(_SECRET[at + 8 * i : at + 8 * i + 8], "little")
        second = lanes[i + 1] ^ int.from_bytes(_SECRET[at + 8 * i + 8 : at + 8 * i + 16], "little")
        product = first * second
        result += (product ^ product >> 64) & _MASK64
    result &= _MASK64
    result ^= result >> 37
    result = result * 0x165667919E3779F9 & _MASK64
    return result ^ result >> 32
