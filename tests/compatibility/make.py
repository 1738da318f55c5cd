#!/usr/bin/env python3
"""Makes the kept data of a release, in a new folder here: TALUSD=build/release/server/talusd ./make.py v0.2

README.md says what is in it. What is there already is never made anew.
"""

import json
import pathlib
import shutil
import sys
import tempfile

import kept
from kept import HERE, Log, Server, seen, serve, settings, stored, talus, talusd, vectors
from talus import Fill

# Sand-like soil slides, and planks get an id of the store's own.
WORLD = kept.paths.ROOT / "core/worlds/hills.toml"
PLACEABLE = '\n[[placeable]]\nname = "planks"\ncolour = "#a07848"\n'
AROUND = [(x, y, z, 0) for y in (-1, 0, 1) for z in (-1, 0, 1) for x in (-1, 0, 1)]
LEVELS = [(0, 0, 0, lod) for lod in range(1, 7)]


def build(world):
    """Edits of every kind; the land of the spawn is at y = 14."""
    world.edit([((4, 30, 4), "planks"), ((5, 30, 4), "gravel"), ((-1, 40, -1), "bedrock")])
    world.edit(fills=[Fill((-7, 4, -7), (6, 13, 6), "air")])
    world.edit([((4, 31, 4), "planks")], guards=[((4, 30, 4), "planks")])
    world.edit(fills=[Fill((-6, 20, -6), (5, 20, 5), "planks"), Fill((-2, 20, -2), (1, 20, 1), "air", "planks")])
    world.edit([((x, 33 + (x * z) % 5, z), 2 + (7 * x + 3 * z) % 7) for x in range(10, 20) for z in range(20, 26)])
    world.edit(paste=((3, 36, -40), world.chunk(0, 1, 0).payload, False))
    world.edit([((4, 30, 4), "air")])
    world.edit(fills=[Fill((5, 30, 4), (5, 30, 4), None)])


def copy_store(data, to):
    """What a stopped talusd leaves, without locks, caches and RocksDB's own log."""
    shutil.copytree(data, to, ignore=shutil.ignore_patterns("lock", "LOCK", "LOG*", "columns", "talusd.socket"))


def make_store(folder, scratch):
    data = scratch / "data"
    with serve(folder, data) as server:
        with talus.connect(server.address) as world:
            build(world)
            (folder / "chunks.json").write_text(json.dumps(seen(world, AROUND + LEVELS), indent=0) + "\n")
        talusd("store", "backup", folder / "backup", "--data", data)
        talusd("store", "export", folder / "edits.talus", "--data", data)
    copy_store(data, folder / "store")
    (folder / "stat.json").write_text(json.dumps(stored(data), indent=2) + "\n")


def make_cluster(folder, scratch):
    data = scratch / "member"
    with Log(scratch, settings(folder, data)) as log:
        with Server(**log.settings) as server, talus.connect(server.address) as world:
            build(world)
        messages = log.messages()
    (folder / "log").mkdir()
    for number, message in enumerate(messages, 1):
        (folder / "log" / f"{number:02}").write_bytes(message)


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: make.py vMAJOR.MINOR")
    folder = HERE / sys.argv[1]
    folder.mkdir()
    (folder / "world.toml").write_text(WORLD.read_text() + PLACEABLE)
    (folder / "vectors.txt").write_text("".join(f"{vector}\n" for vector in vectors()))
    with tempfile.TemporaryDirectory() as scratch:
        make_store(folder, pathlib.Path(scratch))
        make_cluster(folder, pathlib.Path(scratch))


if __name__ == "__main__":
    main()
