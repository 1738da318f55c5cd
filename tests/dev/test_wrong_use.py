"""./dev refuses what it does not know, before it does anything."""

import pathlib
import subprocess
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Dependencies(unittest.TestCase):
    def refused(self, *groups):
        run = subprocess.run([ROOT / "dev", "deps", *groups], capture_output=True, text=True, timeout=60)
        self.assertEqual((run.returncode, run.stdout), (2, ""), run.stderr)
        return run.stderr

    def groups(self):
        lines = (ROOT / "docker/packages.txt").read_text().splitlines()
        return list(dict.fromkeys(line.partition(":")[0] for line in lines))

    def test_an_unknown_group_is_named_with_those_there_are(self):
        expected = f"deps: 'bild' is no group of packages; there are {', '.join(self.groups())}\n"
        self.assertEqual(self.refused("bild"), expected)
        # Before those that are known are installed.
        self.assertEqual(self.refused("build", "bild"), expected)

    def test_what_only_looks_like_a_group(self):
        for group in ["build:", "buil", "build, runtime", ".*"]:
            self.assertIn(f"deps: '{group}' is no group", self.refused(group))


if __name__ == "__main__":
    unittest.main()
