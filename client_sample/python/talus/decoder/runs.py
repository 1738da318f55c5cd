"""FORMAT.md, Raw and Runs."""

import numpy as np

from .coding import MAX_PAYLOAD_BYTES, VOXELS, DecodeError, Header, slot_table


def read_raw(payload):
    if len(payload) < MAX_PAYLOAD_BYTES:
        raise DecodeError("truncated")
    return np.frombuffer(payload, "<u2", VOXELS, 2).copy()


def read_runs(payload):
    header = Header(payload)
    ids, slots = header.materials_with_probabilities()
    count = header.number()
    single = count == VOXELS
    digits = None if single else slot_table(header.take(16))
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
