"""How long chunks of a server take to decode: python3 decode_times.py HOST:PORT"""

import collections
import sys
import time

import numpy as np

import paths  # noqa: F401

import talus

KINDS = {(3, 0): "layers", (4, 1): "volume", (4, 3): "runs"}


def seconds(function, argument):
    """Of processor time; the best of three, as other programs disturb."""
    times = []
    for _ in range(3):
        began = time.process_time()
        function(argument)
        times.append(time.process_time() - began)
    return min(times)


with talus.connect(sys.argv[1]) as world:
    x, _, z = world.spawn
    chunks = list(world.view(x, z, 6, vertical_radius=8))
kinds = collections.defaultdict(list)
for chunk in chunks:
    kind = "one material" if chunk.is_uniform else KINDS.get(tuple(chunk.payload[:2]), "raw")
    kinds[kind].append(1000 * seconds(talus.decode, chunk.payload))
print(f"{len(chunks)} chunks; milliseconds: median, 95th percentile, largest, mean")
for kind, times in [*kinds.items(), ("all", sum(kinds.values(), []))]:
    figures = "  ".join(f"{value:6.2f}" for value in (*np.percentile(times, (50, 95, 100)), np.mean(times)))
    print(f"{kind:12} {len(times):5}  {figures}")
hashing = 1000 * seconds(talus.content_hash, chunks[0].voxels)
print(f"content hash      {hashing:6.2f}")
