"""A talusd of a test, and what talus-gen exports of the same world."""

import json
import os
import pathlib
import re
import subprocess
import unittest

import numpy as np

TALUSD = os.environ.get("TALUSD")
TALUS_GEN = os.environ.get("TALUS_GEN")

needs_programs = unittest.skipUnless(TALUSD and TALUS_GEN, "set TALUSD and TALUS_GEN to the paths of the programs")


class Server:
    """talusd with the built-in world on free ports of this machine. `settings`: environment variables."""

    def __init__(self, **settings):
        environment = {name: value for name, value in os.environ.items() if not name.startswith("TALUS_")}
        self.process = subprocess.Popen(
            [TALUSD, "--listen", settings.pop("TALUS_LISTEN", "127.0.0.1:0"), "--http", "127.0.0.1:0"],
            env={**environment, **settings},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        said = []
        for line in self.process.stdout:
            said.append(line)
            if line.startswith("listening on "):
                self.address = line.split()[-1]
            web = re.search(r"https?://\S+", line)
            if web:
                self.web = web.group()
                return
        raise AssertionError("talusd did not start:\n" + "".join(said))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.stdout.read()
        self.process.wait()
        self.process.stdout.close()


class Export:
    """Columns of a square of chunks by talus-gen, at one level of detail."""

    def __init__(self, folder, chunk_x, chunk_z, size, lod):
        folder = pathlib.Path(folder) / f"{chunk_x},{chunk_z},{lod}"
        self.lod, self.size = lod, size
        self.x, self.z = chunk_x, chunk_z
        span = 32 << lod
        subprocess.run(
            [TALUS_GEN, "export", "--origin", f"{chunk_x * span},{chunk_z * span}"]
            + ["--size", f"{32 * size},{32 * size}", "--lod", str(lod), "-o", str(folder)],
            check=True,
            capture_output=True,
        )
        self.first_row = json.loads((folder / "export.json").read_text())["y0"]
        self.voxels = np.load(folder / "voxels.npy")
        self.surface = np.load(folder / "surface.npy")
        self.look = np.load(folder / "look.npy")

    def keys(self):
        """All whole chunks that the export has voxels of; there is air in the rows above them."""
        top = self.first_row + len(self.voxels)
        rows = range(-(-self.first_row // 32), (top + 31) // 32 + 1)
        return [(self.x + dx, y, self.z + dz, self.lod)
                for y in rows for dz in range(self.size) for dx in range(self.size)]

    def chunk(self, x, y, z, _lod):
        voxels = np.zeros((32, 32, 32), np.uint16)
        west, north, begin = 32 * (x - self.x), 32 * (z - self.z), 32 * y - self.first_row
        part = self.voxels[begin : begin + 32, north : north + 32, west : west + 32]
        voxels[: len(part)] = part
        return voxels
