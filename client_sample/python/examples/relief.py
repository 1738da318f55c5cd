"""Draws the land around a world's spawn from above: python3 relief.py [HOST:PORT] [FILE.png] [CHUNKS TO EACH SIDE]

From a copy of the repository: PYTHONPATH=client_sample/python python3 client_sample/python/examples/relief.py"""

import struct
import sys
import zlib

import numpy as np
import talus

address, path, radius = (sys.argv[1:] + ["127.0.0.1:4780", "relief.png", "6"][len(sys.argv) - 1 :])[:3]
size = 32 * (2 * int(radius) + 1)
height, colour = np.full((size, size), -(1 << 20)), np.zeros((size, size, 3))
with talus.connect(address) as world:
    x, _, z = world.spawn
    west, north = x - x % 32 - 32 * int(radius), z - z % 32 - 32 * int(radius)
    palette = np.zeros((65536, 3))
    for id, material in world.materials.items():
        palette[id] = [material.colour >> shift & 255 for shift in (16, 8, 0)]
    for chunk in world.view(x, z, int(radius), vertical_radius=8):
        solid = chunk.voxels != 0
        row = 31 - solid[::-1].argmax(axis=0)  # of each column's highest voxel that is not air
        top = chunk.origin[1] + row
        here = tuple(slice(begin, begin + 32) for begin in (chunk.origin[2] - north, chunk.origin[0] - west))
        higher = solid.any(axis=0) & (top > height[here])
        height[here][higher] = top[higher]
        colour[here][higher] = palette[np.take_along_axis(chunk.voxels, row[None], 0)[0]][higher]

soft = sum(np.roll(height, (i, j), (0, 1)) for i in range(-2, 3) for j in range(-2, 3)) / 25
for part, strength in ((soft, 0.45), (height, 0.1)):  # light from the north-west on the land, then on each voxel
    south, east = np.gradient(part.astype(float))
    colour *= np.clip(0.95 + strength * (south + east) / np.sqrt(1 + south**2 + east**2), 0.3, 1.35)[:, :, None]
rows = np.clip(colour, 0, 255).astype(np.uint8)[4:-4, 4:-4]  # at the edge np.roll brings the other side in
header = struct.pack(">IIBBBBB", len(rows), len(rows), 8, 2, 0, 0, 0)
pixels = zlib.compress(b"".join(b"\0" + line.tobytes() for line in rows), 9)  # 0: PNG's filter "none"
with open(path, "wb") as file:
    file.write(b"\x89PNG\r\n\x1a\n")
    for kind, data in ((b"IHDR", header), (b"IDAT", pixels), (b"IEND", b"")):
        file.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)))
