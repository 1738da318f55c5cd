"""./dev cluster for real: three nats-servers, three talusd, HAProxy and Varnish, an edit seen everywhere, parts killed, a clean end.

It needs build/release's talusd and talus-client (BUILD=... another build's)."""

import os
import pathlib
import re
import signal
import socket
import subprocess
import time
import unittest
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / os.environ.get("BUILD", "build/release")
SCRIPT = ROOT / "docker/cluster/local.sh"
CLIENT = BUILD / "client_sample/cli/talus-client"


def free_base():
    """A port with 163 free ones above it, below those that the system deals out."""
    base = 20000 + os.getpid() % 50 * 200
    while True:
        try:
            for port in range(base, base + 164):
                socket.create_server(("127.0.0.1", port)).close()
            return base
        except OSError:
            base += 200


def wait(what, seconds=30):
    until = time.monotonic() + seconds
    while not (found := what()):
        assert time.monotonic() < until, "it did not come to be in time"
        time.sleep(0.02)
    return found


def ports_of_checks(configuration):
    """Of each backend of HAProxy's whose check names ports: those, and those on which the frontends listen that send to it. A range is
    its first and last."""
    kind = name = None
    binds, targets, checks = {}, {}, {}
    for line in configuration.splitlines():
        if found := re.match(r"(frontend|backend|defaults|global)\b *(\S*)", line):
            kind, name = found.groups()
        elif kind == "frontend" and (found := re.match(r" +bind \S*:(\d+)(?:-(\d+))?$", line)):
            binds.setdefault(name, []).append((int(found[1]), int(found[2] or found[1])))
        elif kind == "frontend" and (found := re.match(r" +(?:default|use)_backend (\S+)", line)):
            targets.setdefault(name, []).append(found[1])
        elif kind == "backend" and (found := re.search(r"[?&]ports=(\d+)(?:-(\d+))?[& ]", line)):
            checks[name] = (int(found[1]), int(found[2] or found[1]))
    return {backend: (check, [bind for frontend, its in binds.items() if backend in targets[frontend] for bind in its])
            for backend, check in checks.items()}


class Checks(unittest.TestCase):
    def test_of_what_ships_each_is_about_the_ports_of_its_own_players(self):
        self.assertEqual(ports_of_checks((ROOT / "docker/haproxy/haproxy.cfg").read_text()),
                         {"talus": ((4780, 4780), [(4780, 4780)]), "places": ((4800, 4863), [(4800, 4863)]), "streams": ((0, 0), [(80, 80)])})


class WrongUse(unittest.TestCase):
    def refused(self, *arguments):
        run = subprocess.run([SCRIPT, *arguments], capture_output=True, text=True, timeout=60)
        self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
        return run.returncode, run.stderr

    def test_options(self):
        for arguments, said in [(["--servers", "12"], "'12' is not 1 to 9"), (["--nats", "2"], "'2' is not 1, 3 or 5"),
                                (["--port", "x"], "'x' is not 1 to 65372"), (["--port"], "wants a value"), (["--foo"], "'--foo' is not one of"),
                                (["--world", "/nowhere"], "/nowhere is no file")]:
            status, text = self.refused(*arguments)
            self.assertEqual(status, 2)
            self.assertIn(said, text)

    def test_a_port_that_is_taken(self):
        base = free_base()
        with socket.create_server(("127.0.0.1", base + 43)):
            status, text = self.refused("--port", str(base))
        self.assertEqual(status, 1)
        self.assertIn(f"port {base + 43}, for talus-1, is taken", text)


class Running(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.base = free_base()
        (ROOT / "out").mkdir(exist_ok=True)
        cls.log = open(ROOT / "out/cluster_test.log", "w+")
        cls.process = subprocess.Popen([SCRIPT, "--port", str(cls.base), *(["--keep"] if os.environ.get("KEEP") else [])], stdout=cls.log, stderr=cls.log)
        cls.addClassCleanup(cls.log.close)
        cls.addClassCleanup(cls.stop)
        wait(lambda: cls.process.poll() is not None or "Ctrl-C ends it all" in cls.said(), 180)
        assert cls.process.poll() is None, cls.said()
        cls.scratch = pathlib.Path(re.search(r"(/\S+)/haproxy\.log", cls.said())[1])

    @classmethod
    def said(cls):
        return re.sub("\x1b\\[[0-9]*m", "", (ROOT / "out/cluster_test.log").read_text())

    @classmethod
    def stop(cls):
        if cls.process.poll() is None:
            cls.process.terminate()
            cls.process.wait(60)

    def server(self, i, part=0):
        return self.base + 40 + 3 * i + part

    def revision(self, i):
        """Of server i; none while it starts."""
        try:
            page = urllib.request.urlopen(f"http://127.0.0.1:{self.server(i, 1)}/metrics", timeout=5).read().decode()
        except OSError:
            return None
        found = re.search(r"(?m)^talus_edits_revision (\d+)$", page)
        return int(found[1]) if found else None

    def client(self, where, *arguments):
        run = subprocess.run([CLIENT, "--connect", where, *arguments], capture_output=True, text=True, timeout=60)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout

    def edit(self, where, at, material="granite"):
        return self.client(where, "edit", at, "--material", material)

    def chunk(self, where):
        """Hash and revision of the one that is edited."""
        return tuple(re.findall(r"(?m)^(?:hash|revision) .*$", self.client(where, "get", "0", "6", "0")))

    def everywhere(self, revision):
        for i in range(3):
            wait(lambda i=i: self.revision(i) == revision)

    def pids(self, name):
        """Of what runs by this scratch directory's file of that name."""
        found = []
        for entry in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
            try:
                words = entry.read_bytes().split(b"\0")
            except OSError:
                continue
            if any(str(self.scratch / name).encode() in word for word in words):
                found.append(int(entry.parent.name))
        return found

    def test_0_each_check_is_about_the_ports_of_its_own_players(self):
        base, places = (self.base, self.base), (self.base + 100, self.base + 163)
        self.assertEqual(ports_of_checks((self.scratch / "haproxy.cfg").read_text()),
                         {"talus": (base, [base]), "places": (places, [places]), "streams": ((0, 0), [(self.base + 3, self.base + 3)])})

    def test_1_an_edit_at_one_server_is_everywhere(self):
        places = [f"127.0.0.1:{self.server(i)}" for i in range(3)] + [f"127.0.0.1:{self.base}", f"ws://127.0.0.1:{self.base + 2}"]
        before = self.chunk(places[0])
        self.edit(places[0], "3,200,3")
        self.everywhere(1)
        after = {self.chunk(place) for place in places}
        self.assertEqual(len(after), 1, after)
        self.assertNotIn(before, after)
        # And by the balancer, whichever server that is.
        self.edit(f"127.0.0.1:{self.base}", "4,200,3")
        self.everywhere(2)

    def test_2_the_log_goes_on_without_a_nats_server(self):
        before = self.revision(0)
        [victim] = self.pids("nats-1/nats-server.conf")
        os.kill(victim, signal.SIGKILL)
        wait(lambda: "nats-1 has ended" in self.said())
        self.edit(f"127.0.0.1:{self.server(2)}", "5,200,3")
        self.everywhere(before + 1)

    def test_3_a_server_that_is_killed_comes_back_with_what_it_missed(self):
        before = self.revision(0)
        [victim] = self.pids("talus-1.toml")
        os.kill(victim, signal.SIGKILL)
        command = wait(lambda: re.search(r"talus-1 has ended with status 137; start it again by: (.*)", self.said()))[1]
        self.edit(f"127.0.0.1:{self.server(0)}", "6,200,3")
        again = subprocess.Popen(["bash", "-c", f"exec {command.replace(' &', '')}"])
        self.addCleanup(again.wait, 30)
        self.addCleanup(again.terminate)
        self.everywhere(before + 1)
        # Each in one line, and the shell says nothing of its own.
        told = self.said().partition("Ctrl-C ends it all\n")[2]
        self.assertEqual(re.findall(r"(?m)^==> (\S+) has ended with status 137; start it again by: ", told), ["nats-1", "talus-1"])
        self.assertEqual(len(told.splitlines()), 2, told)

    def test_4_two_that_are_killed_at_once_are_told_of_both(self):
        victims = [*self.pids("talus-2.toml"), *self.pids("nats-2/nats-server.conf")]
        self.assertEqual(len(victims), 2)
        for victim in victims:
            os.kill(victim, signal.SIGKILL)
        for name in ["talus-2", "nats-2"]:
            wait(lambda name=name: f"{name} has ended with status 137" in self.said())

    def test_5_ctrl_c_ends_it_all(self):
        self.process.send_signal(signal.SIGINT)
        self.assertEqual(self.process.wait(90), 0)
        self.assertEqual(self.scratch.exists(), "KEEP" in os.environ)
        left = [pid for name in ["nats-0/", "nats-2/", "talus-0", "talus-2", "haproxy", "varnish"] for pid in self.pids(name)]
        self.assertEqual(left, [])


if __name__ == "__main__":
    unittest.main()
