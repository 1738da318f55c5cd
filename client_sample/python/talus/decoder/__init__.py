"""The payload of a chunk as voxels: codec 4 of core/voxel/FORMAT.md, whose words and order these files follow.

    voxels = decode(payload)        # numpy uint16[32][32][32]: y, z, x

The symbols of the entropy coder come one after another, so a loop reads them; what predicts them is done by numpy for
a row of a plane or a wave of a volume at once.
"""

import numpy as np

from .coding import MAX_PAYLOAD_BYTES, SIZE, DecodeError
from .layers import read_layered
from .palette import read_palette
from .runs import read_raw, read_runs
from .volume import read_volume

_ENCODINGS = {
    (3, 0): read_layered,
    (3, 1): read_palette,
    (3, 2): read_raw,
    (4, 1): read_volume,
    (4, 2): read_raw,
    (4, 3): read_runs,
}


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
