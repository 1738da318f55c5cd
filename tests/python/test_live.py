"""The client against a real talusd: by TCP, TLS and HTTP the voxels are those that talus-gen exports."""

import contextlib
import io
import itertools
import os
import random
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import numpy as np

import paths
from server import TALUS_GEN, TALUSD, Export, Server, needs_programs
from test_decoder import mutate, vectors

import talus
from talus.view_shape import level_boxes

LEVELS = (0, 1, 4)


@needs_programs
class Live(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.server = cls.enterClass(Server())
        with talus.connect(cls.server.address) as world:
            x, _, z = world.spawn
        cls.exports = [Export(cls.folder.name, *((c // (32 << lod)) for c in (x, z)), 2, lod) for lod in LEVELS]

    @classmethod
    def enterClass(cls, context):
        """unittest's own is younger than Python 3.9."""
        entered = context.__enter__()
        cls.addClassCleanup(context.__exit__, None, None, None)
        return entered

    def both_ways(self):
        for address in (self.server.address, self.server.web):
            with self.subTest(address), talus.connect(address) as world:
                yield world

    def test_chunks_are_what_is_exported(self):
        for world in self.both_ways():
            for export in self.exports:
                keys = export.keys()
                self.assertGreater(len(keys), 4)
                for key, chunk in zip(keys, world.chunks(keys)):
                    self.assertEqual(tuple(chunk.key), key)
                    np.testing.assert_array_equal(chunk.voxels, export.chunk(*key), str(key))

    def test_heights_and_looks_are_what_is_exported(self):
        export = self.exports[0]
        columns = [(32 * export.x + i % 64, 32 * export.z + i // 64) for i in range(64 * 64)]
        with talus.connect(self.server.address) as world:
            names = world.welcome.looks
            # The exported surface has what aprons add; the ground of heights does too.
            places = world.places(columns, fields=["height", "moisture"])
            np.testing.assert_array_equal(places.heights * 256, export.surface.ravel())
            self.assertEqual(places.looks, [names[look] for look in export.look.ravel()])
            np.testing.assert_array_equal(world.heights(columns[:9]), places.heights[:9])
        with talus.connect(self.server.web) as web:
            by_http = web.places(columns[:600], fields=["height", "moisture"])
        np.testing.assert_array_equal(by_http.heights, places.heights[:600])
        self.assertEqual(by_http.looks, places.looks[:600])
        for name in ("height", "moisture"):
            np.testing.assert_allclose(by_http.fields[name], places.fields[name][:600], rtol=1e-6)

    def test_views_have_all_their_chunks_once_and_the_same_by_http(self):
        (x, y, z), rings = self.spawn(), [(1, 6), (2, 12)]
        boxes = level_boxes((x, y, z), 3, 2, rings)
        payloads = []
        for world in self.both_ways():
            chunks = {}
            for chunk in world.view(x, z, 3, y=y, vertical_radius=2, rings=rings):
                self.assertNotIn(chunk.key, chunks)
                chunks[chunk.key] = chunk
            self.assertEqual(len(chunks), sum(map(len, boxes)))
            self.assertTrue(all(any(key in box for box in boxes) for key in chunks))
            payloads.append({key: chunk.payload for key, chunk in chunks.items()})
            for key in itertools.islice(chunks, 20):
                np.testing.assert_array_equal(chunks[key].voxels, world.chunk(*key).voxels)
        self.assertEqual(payloads[0], payloads[1])

    def test_a_view_with_a_horizon_has_all_rows_far_away(self):
        x, y, z = self.spawn()
        for world in self.both_ways():
            heights = (0, world.info["max_y"]) if hasattr(world, "info") else (world.welcome.min_y, world.welcome.max_y)
            boxes = level_boxes((x, y, z), 2, 1, [(2, 8)], heights)
            count = sum(1 for _ in world.view(x, z, 2, y=y, vertical_radius=1, rings=[(2, 8)], horizon=True))
            self.assertEqual(count, sum(map(len, boxes)))

    def test_requests_and_new_views_within_a_view(self):
        x, y, z = self.spawn()
        with talus.connect(self.server.address) as world:
            first = world.view(x, z, 5, y=y)
            for chunk in itertools.islice(first, 10):
                self.assertEqual(world.chunk(*chunk.key).hash or chunk.hash, chunk.hash or world.chunk(*chunk.key).hash)
            self.assertEqual(sum(1 for _ in world.view(x, z, 1, y=y, vertical_radius=1)), 27)
            with self.assertRaisesRegex(RuntimeError, "a newer view"):
                next(first)
            for _ in world.view(x + 5000, z, 5, y=y):
                break
            self.assertEqual(sum(1 for _ in world.view(x, z, 1, y=y, vertical_radius=1)), 27)
            self.assertLess(world.ping(), 60)

    def test_columns_and_squares_by_http(self):
        export = self.exports[0]
        with talus.connect(self.server.web) as web:
            x, z = export.x // 2 * 2, export.z // 2 * 2
            square = web.square(x, z, 2)
            self.assertEqual([(c.x, c.z) for c in square], [(x, z), (x + 1, z), (x, z + 1), (x + 1, z + 1)])
            self.assertEqual(square[3].runs, web.column(x + 1, z + 1).runs)
            column = web.column(export.x, export.z)
            for key in export.keys():
                if key[0] == export.x and key[2] == export.z:
                    np.testing.assert_array_equal(column.chunk(key[1]).voxels, export.chunk(*key), str(key))

    def test_a_refusal_of_the_server_is_reported(self):
        for world in self.both_ways():
            with self.assertRaisesRegex(talus.ServerError, "level of detail is 7") as raised:
                world.chunk(0, 0, 0, lod=7)
            self.assertEqual(raised.exception.code.name, "out_of_range" if hasattr(world, "welcome") else "malformed")
            with self.assertRaises((talus.ServerError, ValueError)):
                world.places([(0, 0)], fields=["colour of the sky"])
            self.assertEqual(world.chunk(0, 0, 0).voxels.shape, (32, 32, 32))
            self.assertEqual(world.materials[0].name, "air")

    def test_the_example_draws_a_picture(self):
        picture = os.path.join(self.folder.name, "relief.png")
        example = paths.ROOT / "client_sample/python/examples/relief.py"
        environment = {**os.environ, "PYTHONPATH": str(example.parents[1])}
        subprocess.run([sys.executable, str(example), self.server.address, picture, "1"], check=True, env=environment,
                       capture_output=True)
        with open(picture, "rb") as file:
            self.assertTrue(file.read().startswith(b"\x89PNG"))

    def test_the_readme_says_what_runs(self):
        readme = (paths.ROOT / "client_sample/python/README.md").read_text()
        program = readme.split("```python\n")[1].split("```")[0]
        self.assertLessEqual(len(program.splitlines()), 10)
        with contextlib.redirect_stdout(io.StringIO()) as said:
            exec(program.replace("127.0.0.1:4780", self.server.address), {})
        self.assertIn("(32, 32, 32) uint16", said.getvalue())
        self.assertGreater(len(said.getvalue().splitlines()), 9 * 9 * 9)

    def spawn(self):
        with talus.connect(self.server.web) as web:
            return web.spawn


@needs_programs
class Judgement(unittest.TestCase):
    """Both decoders say the same of bytes that are nearly payloads: the voxels, or which error comes first."""

    SAYS = {
        "empty": "payload is empty",
        "unknown_version": "not a known codec version",
        "unknown_encoding": "names no encoding",
        "truncated": "ends before the chunk",
        "too_long": "goes on after the chunk's end",
        "bad_materials": "list of materials",
        "bad_number": "number that is past its range",
        "bad_ending": "last bytes do not end its chunk",
    }

    def test_hostile_payloads_are_judged_as_talus_gen_does(self):
        seed = int(os.environ.get("TALUS_SEED", random.randrange(1 << 32)))
        print(f"\nTALUS_SEED={seed}", flush=True)
        rng = random.Random(seed)
        originals = [payload for kind, _, _, payload in vectors() if kind == "chunk"]
        with tempfile.TemporaryDirectory() as folder:
            file, array = (os.path.join(folder, name) for name in ("m.chunk", "m.npy"))
            for _ in range(int(os.environ.get("TALUS_ROUNDS", 60))):
                hostile = mutate(rng.choice(originals), rng)
                with open(file, "wb") as out:
                    out.write(hostile)
                theirs = subprocess.run([TALUS_GEN, "decode", file, "-o", array], capture_output=True, text=True)
                with self.subTest(hostile.hex()):
                    try:
                        voxels = talus.decode(hostile)
                    except talus.DecodeError as error:
                        self.assertIn(self.SAYS[error.reason], theirs.stderr)
                    else:
                        self.assertEqual(theirs.returncode, 0, theirs.stderr)
                        np.testing.assert_array_equal(voxels, np.load(array))


@needs_programs
class Limited(unittest.TestCase):
    def test_a_low_rate_refuses_nothing(self):
        with Server(TALUS_RATES_SESSION_REQUESTS="50", TALUS_RATES_BURST_MS="1000") as server:
            with mock.patch("talus.pace.Pace.refused") as refused, talus.connect(server.address) as world:
                self.assertEqual(sum(1 for _ in world.chunks((x, 0, 0) for x in range(90))), 90)
                refused.assert_not_called()


@needs_programs
@unittest.skipUnless(shutil.which("openssl"), "needs openssl, to make a certificate")
class Secure(unittest.TestCase):
    def test_tls_and_tokens(self):
        with tempfile.TemporaryDirectory() as folder:
            key, certificate, secret = (os.path.join(folder, name) for name in ("key.pem", "certificate.pem", "secret"))
            subprocess.run(
                "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 2 -subj /CN=localhost"
                " -addext subjectAltName=DNS:localhost,IP:127.0.0.1".split() + ["-keyout", key, "-out", certificate],
                check=True,
                capture_output=True,
            )
            with open(secret, "w") as file:
                os.chmod(secret, 0o600)
                file.write("a secret of some length")
            settings = {"TALUS_TLS_CERTIFICATE": certificate, "TALUS_TLS_KEY": key, "TALUS_ACCESS_SECRET_FILE": secret}
            with Server(**settings) as server:
                self.assertTrue(server.web.startswith("https://"), server.web)
                voxels = []
                for address in (server.address, server.web):
                    with talus.connect(address, ca=certificate, token="a secret of some length") as world:
                        voxels.append(world.chunk(1, 2, 3).voxels)
                        self.assertEqual(sum(1 for _ in world.view(0, 0, 1, y=0, vertical_radius=1)), 27)
                    with self.assertRaises(talus.ServerError) as raised:
                        with talus.connect(address, ca=certificate, token="wrong") as world:
                            world.chunk(1, 2, 3)
                    self.assertEqual(raised.exception.code.name, "unauthorized")
                    with self.assertRaises(OSError) as raised:
                        talus.connect(address, tls=True, token="a secret of some length")
                    self.assertIn("CERTIFICATE_VERIFY_FAILED", str(raised.exception))
                np.testing.assert_array_equal(*voxels)


if __name__ == "__main__":
    print(f"TALUSD={TALUSD}", flush=True)
    unittest.main()
