"""Worlds without a server, by libtalus-local: TALUS_LOCAL_LIBRARY names it."""

import os
import pathlib
import tempfile
import threading
import unittest
import unittest.mock

import numpy as np

import paths

if os.environ.get("TALUS_LOCAL_LIBRARY"):
    from talus import local
    from talus.local import Conflict, LocalError, World

LAND = paths.ROOT / "core/worlds/classic.toml"
BEGIN = '[[placeable]]\nname = "planks"\ncolour = "#8a6b3d"\n'


@unittest.skipUnless(os.environ.get("TALUS_LOCAL_LIBRARY"), "TALUS_LOCAL_LIBRARY is not set")
class LocalTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.land = self.folder / "land.toml"
        self.land.write_text(LAND.read_text() + BEGIN)

    def open(self, path=None, **options):
        world = World.open(path or self.land, **options)
        self.addCleanup(world.close)
        return world

    def test_heights_are_the_tops_of_the_voxels(self):
        world = self.open()
        heights = world.heights(-2, 0, 4, 3)
        self.assertEqual(heights.shape, (3, 4))
        top = (int(heights[1, 0] * 256) + 127 >> 8) - 1
        voxels = world.generate_all([(-1, top // 32, 0), (-1, (top + 1) // 32, 0)])
        self.assertEqual(voxels.dtype, np.uint16)
        self.assertGreater(voxels[0, top % 32, 1, 30], 1)  # [y, z, x]
        self.assertEqual(voxels[1, (top + 1) % 32, 1, 30], 0)

    def test_a_save_has_the_edits(self):
        save = self.folder / "game.talus"
        world = self.open(settles=True)
        done = world.edit([((0, 200, 0), "planks")], guards=[((0, 200, 0), "air")])
        self.assertEqual((done.revision, done.changed, done.chunks[0]), (1, 1, (0, 6, 0, 0)))
        world.edit(fills=[((3, 205, 3), (1, 201, 1), "planks"), ((2, 202, 2), (2, 204, 2), None)])
        world.save(save)
        self.assertEqual(world.changed_chunks(), [(0, 6, 0)])
        with self.assertRaises(LocalError) as in_use:
            World.open(save)
        self.assertIn("game.talus: is in use", str(in_use.exception))
        voxels, edits = world.generate(0, 6, 0), world.hash
        world.close()
        again = self.open(save, read_only=True)
        np.testing.assert_array_equal(again.generate(0, 6, 0), voxels)
        self.assertEqual((again.hash, again.revision), (edits, 2))
        self.assertEqual(int((voxels == 256).sum()), 1 + 3 * 5 * 3 - 3)
        self.assertFalse((again.generate(0, 6, 0, edits=False) == 256).any())

    def test_materials_are_found_by_id(self):
        world = self.open()
        self.assertEqual(world.materials[0].name, "air")
        self.assertEqual(world.materials[256], (256, "planks", 0x8A6B3D, "solid"))

    def test_a_missing_library_names_its_package(self):
        with unittest.mock.patch.dict(os.environ, TALUS_LOCAL_LIBRARY="/nowhere.so"):
            with self.assertRaisesRegex(OSError, "/nowhere.so.*libtalus-local1.*TALUS_LOCAL_LIBRARY"):
                local._load()

    def test_refusals_name_their_reason(self):
        world = self.open()
        world.edit([((0, 200, 0), "planks")])
        with self.assertRaises(Conflict) as conflict:
            world.edit([((0, 200, 0), 0)], guards=[((0, 201, 0), 0), ((0, 200, 0), 0)])
        self.assertEqual(conflict.exception.index, 1)
        with self.assertRaisesRegex(ValueError, "no material 'gold'"):
            world.edit([((0, 0, 0), "gold")])
        with self.assertRaisesRegex(LocalError, "material 999"):
            world.edit([((0, 0, 0), 999)])
        self.land.write_text("seed = 1\nwrong = 2\n")
        with self.assertRaisesRegex(LocalError, r"world\.toml:2: wrong"):
            World.open(self.land)
        world.close()
        with self.assertRaisesRegex(ValueError, "closed"):
            world.generate(0, 0, 0)

    def test_threads_generate_the_same(self):
        world = self.open()
        expected, found = world.generate_all([(x, 3, 0) for x in range(4)]), {}

        def generate(x):
            found[x] = world.generate(x, 3, 0)

        threads = [threading.Thread(target=generate, args=(x,)) for x in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for x in range(4):
            np.testing.assert_array_equal(found[x], expected[x])

    def test_a_world_may_be_closed_while_threads_use_it(self):
        save = self.folder / "game.talus"
        world = self.open()
        world.save(save)
        running, ends = threading.Barrier(4), []

        def use(x):
            world.generate(x, 3, 0)
            running.wait()
            try:
                while True:
                    world.generate_all([(4 * at, 3, 8 * x) for at in range(20)])
                    world.edit([((x, 200, 0), "planks")])
                    world.edit([((x, 200, 0), "air")])
            except ValueError as error:
                ends.append(str(error))

        threads = [threading.Thread(target=use, args=(x,)) for x in range(3)]
        for thread in threads:
            thread.start()
        running.wait()
        world.close()
        for thread in threads:
            thread.join()
        self.assertEqual(ends, ["the world is closed"] * 3)
        self.open(save).close()  # is in use no longer


if __name__ == "__main__":
    unittest.main()
