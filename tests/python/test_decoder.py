"""The decoder against core/voxel/vectors, FORMAT.md and hostile bytes."""

import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

from paths import ROOT

import talus
from talus import decoder


def vectors():
    for line in (ROOT / "core/voxel/vectors/payloads.txt").read_text().splitlines():
        if not line.startswith("#"):
            kind, name, expected, payload = line.split()
            yield kind, name, expected, b"" if payload == "-" else bytes.fromhex(payload)


class Vectors(unittest.TestCase):
    def test_payloads_have_the_voxels_of_their_hash(self):
        count = 0
        for kind, name, expected, payload in vectors():
            if kind == "chunk":
                with self.subTest(name):
                    voxels = talus.decode(payload)
                    self.assertEqual((voxels.shape, voxels.dtype), ((32, 32, 32), np.uint16))
                    self.assertEqual(f"{talus.content_hash(voxels):032x}", expected)
                    count += 1
        self.assertGreater(count, 9)

    def test_an_invalid_payload_is_refused_by_its_name(self):
        count = 0
        for kind, name, expected, payload in vectors():
            if kind == "error":
                with self.subTest(name), self.assertRaises(talus.DecodeError) as raised:
                    talus.decode(payload)
                self.assertEqual(raised.exception.reason, expected, name)
                count += 1
        self.assertGreater(count, 15)

    def test_raw_payloads(self):
        voxels = np.arange(32768, dtype="<u2").reshape(32, 32, 32)
        payload = b"\4\2" + voxels.tobytes()
        np.testing.assert_array_equal(talus.decode(payload), voxels)
        for wrong, reason in ((payload[:-1], "truncated"), (payload + b"\0", "too_long")):
            with self.assertRaises(talus.DecodeError) as raised:
                talus.decode(wrong)
            self.assertEqual(raised.exception.reason, reason)

    def test_worked_examples_have_the_voxels_that_they_describe(self):
        by_name = {name: payload for kind, name, _, payload in vectors() if kind == "chunk"}
        z, x = np.indices((32, 32))
        layered = talus.decode(by_name["example_layered"])
        first = 10 + x // 8
        second = np.where(z < 20, first + 2, first)
        y = np.arange(32)[:, None, None]
        np.testing.assert_array_equal(layered, np.where(y < first, 2, np.where(y < second, 300, 0)))
        volume = talus.decode(by_name["example_volume"])
        self.assertEqual([volume[20, 7, 5], volume[11, 31, 31], volume[12, 0, 0]], [300, 1, 0])

    def test_trained_numbers_are_as_in_format_md(self):
        text = (ROOT / "core/voxel/FORMAT.md").read_text()
        for name, block in decoder.BLOCKS.items():
            expected = re.findall(rf"```{name}\n(.*?)```", text, re.DOTALL)
            self.assertEqual([b.split() for b in ([block] if isinstance(block, str) else block)],
                             [b.split() for b in expected], name)


class Alone(unittest.TestCase):
    def test_the_file_decodes_without_the_rest_of_the_package(self):
        name, payload = next((name, payload) for kind, name, _, payload in vectors() if kind == "chunk")
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(ROOT / "client_sample/python/talus/decoder.py", pathlib.Path(folder, "copied.py"))
            # Isolated: of this package nothing can be imported there.
            program = "import sys; sys.path.append(sys.argv[1]); import copied\n" \
                      "sys.stdout.buffer.write(copied.decode(sys.stdin.buffer.read()).tobytes())"
            done = subprocess.run([sys.executable, "-I", "-c", program, folder], input=payload, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr.decode())
        self.assertEqual(done.stdout, talus.decode(payload).tobytes(), name)


class Hostile(unittest.TestCase):
    """Mutated payloads are decoded or raise DecodeError: nothing else, and nothing larger than a chunk."""

    def test_mutated_payloads(self):
        seed = int(os.environ.get("TALUS_SEED", random.randrange(1 << 32)))
        rounds = int(os.environ.get("TALUS_ROUNDS", 25))
        print(f"\nTALUS_SEED={seed}", flush=True)
        rng = random.Random(seed)
        originals = [(name, payload) for kind, name, _, payload in vectors() if kind == "chunk"]
        for name, payload in originals:
            for turn in range(rounds):
                hostile = mutate(payload, rng)
                try:
                    voxels = talus.decode(hostile)
                except talus.DecodeError:
                    pass
                except Exception as error:
                    raise AssertionError(f"{name}, turn {turn}, seed {seed}: {hostile.hex()}") from error
                else:
                    self.assertEqual(voxels.shape, (32, 32, 32))

    def test_scores_that_are_kept_are_bounded(self):
        columns = decoder.Columns("level", "odd")
        columns.MAX_KEYS = 100
        for key in range(1000):
            self.assertEqual(columns[key], columns[key])
        self.assertLessEqual(len(columns), 100)

    def test_every_cut_of_a_payload_is_refused(self):
        for kind, name, _, payload in vectors():
            if kind == "chunk" and name.startswith("example"):
                for length in range(len(payload)):
                    with self.assertRaises(talus.DecodeError, msg=f"{name} cut to {length}"):
                        talus.decode(payload[:length])


def mutate(payload, rng):
    data = bytearray(payload)
    for _ in range(rng.choice((1, 1, 1, 2, 5))):
        at = rng.randrange(len(data)) if data else 0
        change = rng.randrange(5)
        if change == 0:
            del data[at:]
        elif change == 1:
            data[at:at] = rng.randbytes(rng.randrange(1, 40))
        elif data and change == 2:
            data[at] ^= 1 << rng.randrange(8)
        elif data and change == 3:
            data[at] = rng.choice((0, 1, 127, 128, 255))
        elif data:
            end = rng.randrange(at, len(data)) + 1
            data[at:end] = rng.randbytes(end - at)
    return bytes(data)


if __name__ == "__main__":
    unittest.main()
