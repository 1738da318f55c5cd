"""./dev refuses what it does not know, before it does anything; .ci/run keeps its time."""

import os
import pathlib
import shutil
import subprocess
import tempfile
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

    def test_an_unknown_group_is_named_with_the_known_ones(self):
        expected = f"deps: 'bild' is no group of packages; there are {', '.join(self.groups())}\n"
        self.assertEqual(self.refused("bild"), expected)
        # Before those that are known are installed.
        self.assertEqual(self.refused("build", "bild"), expected)

    def test_a_word_that_only_resembles_a_group(self):
        for group in ["build:", "buil", "build, runtime", ".*"]:
            self.assertIn(f"deps: '{group}' is no group", self.refused(group))


def dev(*words, **environment):
    kept = {name: value for name, value in os.environ.items() if not name.startswith("TALUS_")}
    return subprocess.run([ROOT / "dev", *words], capture_output=True, text=True, timeout=60, env=kept | environment)


class Commands(unittest.TestCase):
    COMMANDS = ["demo", "run", "cluster", "test", "bench", "lint", "sanitize", "clang", "golden", "wasm", "package", "coverage", "first-picture", "avx512", "fuzz", "deps"]

    def test_the_usage_has_every_command_and_no_other(self):
        usage = dev("--help").stdout
        self.assertEqual([line.split()[0] for line in usage.splitlines() if line.startswith("  ") and line[2:3].isalpha()], self.COMMANDS)

    def test_every_command_has_help(self):
        for command in self.COMMANDS:
            run = dev(command, "--help")
            self.assertEqual((run.returncode, run.stderr), (0, ""), command)
            self.assertTrue(run.stdout.startswith(f"usage: ./dev {command}"), run.stdout)

    def refused(self, *words, **environment):
        run = dev(*words, **environment)
        self.assertEqual((run.returncode, run.stdout, run.stderr.count("\n")), (2, "", 1), run.stderr)
        return run.stderr

    def test_every_command_refuses_an_argument_that_it_does_not_know(self):
        for command in self.COMMANDS:
            said = self.refused(command, "--sideways")
            self.assertTrue(said.startswith(f"{command}: "), said)
            self.assertIn("--sideways", said)

    def test_one_argument_too_many(self):
        for words in [["demo", "8080", "9"], ["run", "8", "9"], ["test", "--full", "e2e"], ["lint", "--fix", "now"], ["clang", "--all", "now"], ["golden", "x86-64", "now"], ["fuzz", "1", "2"]]:
            self.assertIn(f"'{words[-1]}'", self.refused(*words))

    def test_run_reads_its_world_and_addresses_before_it_compiles(self):
        self.assertEqual(self.refused("run", TALUS_WORLD="/nowhere.toml"), "run: TALUS_WORLD: /nowhere.toml is not a file\n")
        for name in ["TALUS_LISTEN", "TALUS_HTTP_LISTEN"]:
            for address in ["4780", "localhost:", "localhost:65536", ":4780", "http://localhost:4780"]:
                self.assertEqual(self.refused("run", **{name: address}), f"run: {name}: '{address}' is not HOST:PORT\n")
        for address in ["127.0.0.1:0", "localhost:4780", "[::1]:4780"]:
            self.assertEqual(self.refused("run", TALUS_LISTEN=address, TALUS_HTTP_LISTEN="x"),
                             "run: TALUS_HTTP_LISTEN: 'x' is not HOST:PORT\n")
        self.assertIn("TALUS_HTTP_LISTEN", self.refused("run", TALUS_HTTP="127.0.0.1:4782"))


class Budget(unittest.TestCase):
    def test_a_stage_that_passes_its_budget_ends_the_run_by_name(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / ".ci").mkdir()
            shutil.copy(ROOT / ".ci/run", pathlib.Path(folder) / ".ci/run")
            dev_in_place = pathlib.Path(folder) / "dev"
            dev_in_place.write_text("#!/bin/sh\n[ $1 = test ] || exec sleep 600\n")
            dev_in_place.chmod(0o755)
            run = subprocess.run([pathlib.Path(folder) / ".ci/run"], capture_output=True, text=True, timeout=60,
                                 env=os.environ | {"TALUS_CI_SECONDS": "20"})
        self.assertEqual(run.returncode, 1, run.stdout)
        self.assertRegex(run.stdout.splitlines()[-1],
                         r"^==> \./dev clang failed: it was stopped after \d+ s, its budget of the 20 s for all stages$")
        self.assertNotIn("stage: ./dev sanitize", run.stdout)


if __name__ == "__main__":
    unittest.main()
