"""The bindings of talus.h: they are what make.py makes of it, have C's layout, and show the world that C shows. C# and Rust are
tested with their packages (tests/packages/sdk.sh, crate.sh)."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import layout

HERE = pathlib.Path(__file__).resolve().parent
EXAMPLES = layout.BINDINGS.parent / "examples"
INCLUDE = layout.BINDINGS.parent / "include"
LIBRARY = pathlib.Path(os.environ["TALUS_LIBRARY"]).parent


def run(*command, library=LIBRARY, **more):
    environment = {**os.environ, "LD_LIBRARY_PATH": str(library), "PYTHONPATH": str(layout.BINDINGS), "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=300, env=environment, **more)


class Made(unittest.TestCase):
    def check_in_copy(self, change):
        """What --check says after the header was changed."""
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder) / "client_sample"
            shutil.copytree(layout.BINDINGS, copy / "c_api/bindings")
            shutil.copytree(layout.BINDINGS.parents[1] / "rust/src", copy / "rust/src")
            (copy / "c_api/include").mkdir()
            text = (INCLUDE / "talus.h").read_text()
            changed = change(text)
            (copy / "c_api/include/talus.h").write_text(changed)
            return run(sys.executable, copy / "c_api/bindings/make.py", "--check")

    def test_they_are_what_the_header_makes(self):
        checked = run(sys.executable, layout.BINDINGS / "make.py", "--check")
        self.assertEqual((checked.returncode, checked.stderr), (0, ""))

    def test_a_field_that_the_header_gains_makes_all_of_them_stale(self):
        checked = self.check_in_copy(lambda text: text.replace("uint64_t round_trip_ns;", "uint64_t round_trip_ns;\n  uint64_t added;"))
        self.assertEqual(checked.stderr, "stale: talus.cdef.h, talus_ctypes.py, Talus.cs, talus.rs; run make.py\n")

    def test_a_declaration_that_it_cannot_read_is_named_with_its_line(self):
        checked = self.check_in_copy(lambda text: text.replace("typedef int32_t talus_status;", "typedef int32_t talus_status, other;"))
        self.assertRegex(checked.stderr, r"^talus\.h:\d+: 'typedef int32_t talus_status, other;' is no constant, macro, enum, typedef,")
        line = int(re.search(r"\d+", checked.stderr)[0])
        self.assertEqual((INCLUDE / "talus.h").read_text().splitlines()[line - 1], "typedef int32_t talus_status;")


class Layout(unittest.TestCase):
    def printed(self, language, file, *commands):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / file).write_text(layout.program(language))
            for command in commands:
                ended = run(*command, cwd=folder)
                self.assertEqual((ended.returncode, ended.stderr), (0, ""))
            return ended.stdout.splitlines()

    @classmethod
    def setUpClass(cls):
        cls.compiled = cls().printed("c", "layout.c", [os.environ["CC"], f"-I{INCLUDE}", "layout.c", "-o", "layout"], ["./layout"])

    def test_the_compiler_sees_all_of_it(self):
        self.assertIn("talus_event.chunk 56", self.compiled)
        self.assertIn("TALUS_OUTCOME_UNKNOWN -31", self.compiled)
        self.assertGreaterEqual(len(self.compiled), 164)  # those of version 1.0

    def test_ctypes_lays_out_as_c_does(self):
        self.assertEqual(self.printed("python", "layout.py", [sys.executable, "layout.py"]), self.compiled)

    def test_luajit_lays_out_as_c_does(self):
        self.assertEqual(self.printed("lua", "layout.lua", ["luajit", "layout.lua", layout.BINDINGS / "talus.cdef.h"]), self.compiled)


class Flights(unittest.TestCase):
    """The example in each language prints what it prints in C, of one server."""

    @classmethod
    def setUpClass(cls):
        environment = {name: value for name, value in os.environ.items() if not name.startswith("TALUS_")}
        environment["TALUS_ACCESS_WITHOUT_TOKEN"] = "read,edit"
        # On a busy machine a client may stand still for long.
        environment |= {f"TALUS_LIMITS_{limit}_TIMEOUT_MS": "300000" for limit in ("IDLE", "WRITE", "HANDSHAKE")}
        data = tempfile.TemporaryDirectory()
        cls.addClassCleanup(data.cleanup)
        cls.server = subprocess.Popen([os.environ["TALUSD"], "--listen", "127.0.0.1:0", "--data", data.name], env=environment, text=True,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        cls.addClassCleanup(cls.server.communicate)
        cls.addClassCleanup(cls.server.terminate)
        said = []
        for line in cls.server.stdout:
            said.append(line)
            if found := re.search(r"listening on (\S+):(\d+)", line):
                cls.address = found.groups()
                break
        else:
            raise AssertionError("talusd did not start:\n" + "".join(said))
        cls.in_c = run(os.environ["TALUS_FLY"], *cls.address).stdout

    def flown(self, *command):
        ended = run(*command, *self.address)
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        self.assertRegex(ended.stdout, r"^ground at spawn: .*\ntalusd \S+: 2601 chunks, ")
        self.assertEqual(ended.stdout, self.in_c)
        lost = run(*command, "127.0.0.1", "1")
        self.assertEqual((lost.returncode, lost.stderr), (1, "127.0.0.1:1: no server answers there: Connection refused\n"))
        alone = run(*command, library="")
        self.assertEqual((alone.returncode, alone.stdout), (1, ""))
        self.assertRegex(alone.stderr, r"^libtalus is not found: copy libtalus\.so .*, or set LD_LIBRARY_PATH \(.*No such file.*\)\n$")
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(EXAMPLES, pathlib.Path(folder) / "examples")
            (pathlib.Path(folder) / "bindings").symlink_to(layout.BINDINGS)
            (pathlib.Path(folder) / "examples/libtalus.so").symlink_to(LIBRARY / "libtalus.so")
            beside = run(command[0], f"{folder}/examples/{command[1].name}", "127.0.0.1", "1", library="")
            self.assertEqual(beside.stderr, lost.stderr)

    def test_by_ctypes(self):
        self.flown(sys.executable, EXAMPLES / "fly.py")

    def test_by_luajit(self):
        self.flown("luajit", EXAMPLES / "fly.lua")

    def dug(self, *command):
        ended = run(*command, self.address[1])
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        self.assertRegex(ended.stdout, r"^edited: 0 1\nedited: -29 0\nbuilt: (\d+) of \w+ \1\nknown: 0 True\ncancelled: True\n"
                                       r"place: \d+ \w+ \w+ -?\d+\nedited: 0 1\nrings: \d+ \d+ \d+ \d+ \d+ 256 \d+\n$")
        return ended.stdout

    def test_ctypes_and_luajit_make_the_other_calls(self):
        by_ctypes = self.dug(sys.executable, HERE / "dig.py")
        self.assertEqual(self.dug("luajit", HERE / "dig.lua", layout.BINDINGS / "talus.cdef.h"), by_ctypes)


if __name__ == "__main__":
    unittest.main()
