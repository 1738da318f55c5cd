"""Draws the land around a world's spawn from above: python3 relief.py [HOST:PORT] [FILE.png] [CHUNKS TO EACH SIDE]"""

import struct
import sys
import zlib

import numpy as np
import talus

address, path, radius = (sys.argv[1:] + ["127.0.0.1:4780", "relief.png", "6"][len(sys.argv) - 1 :])[:3]
radius = int(radius)
width = (2 * radius + 1) * 32
height, colour = np.full((width, width), -(1 << 20)), np.zeros((width, width, 3))

with talus.connect(address) as world:
    x, y, z = world.spawn
    west, north = (x // 32 - radius) * 32, (z // 32 - radius) * 32
    palette = np.zeros((65536, 3))
    for id, material in world.materials.items():
        palette[id] = [material.colour >> shift & 255 for shift in (16, 8, 0)]
    for chunk in world.view(x, z, radius, vertical_radius=8):
        solid = chunk.voxels != 0
        row = 31 - solid[::-1].argmax(axis=0)  # of each column's highest voxel that is not air
        top = chunk.origin[1] + row
        south_by, east_by = chunk.origin[2] - north, chunk.origin[0] - west
        here = np.s_[south_by : south_by + 32, east_by : east_by + 32]
        higher = solid.any(axis=0) & (top > height[here])
        height[here][higher] = top[higher]
        colour[here][higher] = palette[np.take_along_axis(chunk.voxels, row[None], 0)[0]][higher]

soft = sum(np.roll(height, (i, j), (0, 1)) for i in range(-2, 3) for j in range(-2, 3)) / 25
for part, strength in ((soft, 0.5), (height, 0.12)):  # the slopes of the land, then each voxel: light from north-west
    south, east = np.gradient(part.astype(float))
    colour *= np.clip(1 + strength * (south + east) / np.sqrt(1 + south**2 + east**2), 0.3, 1.4)[:, :, None]
pixels = np.insert(np.clip(colour, 0, 255).astype(np.uint8).reshape(width, -1), 0, 0, axis=1)  # 0: no filter
header = struct.pack(">IIBBBBB", width, width, 8, 2, 0, 0, 0)
with open(path, "wb") as file:
    file.write(b"\x89PNG\r\n\x1a\n")
    for kind, data in ((b"IHDR", header), (b"IDAT", zlib.compress(pixels.tobytes())), (b"IEND", b"")):
        file.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)))
