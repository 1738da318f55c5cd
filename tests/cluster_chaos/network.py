"""Hosts as network namespaces, which can be cut from each other: wants root.

A host has two addresses. By the one it reaches the other hosts; tests and players reach it by the other, whatever is cut."""

import os
import shutil
import subprocess

IP = shutil.which("ip") or "/usr/sbin/ip"
_CUT_OFF = "c"  # the bridge of those that are cut from the rest: they reach each other
_REST = "m"
_TESTS = "t"


def is_possible():
    return os.geteuid() == 0 and _runs(IP, "netns", "list")


def _runs(*command):
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def _run(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(command)}: {done.stderr.strip()}")


class Network:
    def __init__(self, names):
        # Several runs on one machine have networks of their own.
        self.tag = f"tc{os.getpid() % 10000}"
        net = 100 + os.getpid() % 100
        self.tests, self.balancer = f"10.{net}.1.254", f"10.{net}.1.253"
        self.names = list(names)
        self._inner = {name: f"10.{net}.0.{number + 1}" for number, name in enumerate(names)}
        self._address = {name: f"10.{net}.1.{number + 1}" for number, name in enumerate(names)}

    def __enter__(self):
        try:
            for bridge in (_REST, _CUT_OFF, _TESTS):
                _run(IP, "link", "add", self.tag + bridge, "type", "bridge")
                _run(IP, "link", "set", self.tag + bridge, "up")
            for address in (self.tests, self.balancer):
                _run(IP, "address", "add", f"{address}/24", "dev", self.tag + _TESTS)
            for name in self.names:
                space = self._space(name)
                _run(IP, "netns", "add", space)
                _run(IP, "-n", space, "link", "set", "lo", "up")
                for bridge, device, address in ((_REST, "inner", self._inner[name]), (_TESTS, "tests", self._address[name])):
                    port = self._port(name, bridge)
                    _run(IP, "link", "add", port, "type", "veth", "peer", "name", device, "netns", space)
                    _run(IP, "link", "set", port, "master", self.tag + bridge, "up")
                    _run(IP, "-n", space, "address", "add", f"{address}/24", "dev", device)
                    _run(IP, "-n", space, "link", "set", device, "up")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for name in self.names:
            subprocess.run([IP, "netns", "del", self._space(name)], capture_output=True, check=False)  # its devices go with it
        for bridge in (_REST, _CUT_OFF, _TESTS):
            subprocess.run([IP, "link", "del", self.tag + bridge], capture_output=True, check=False)

    def inner(self, name):
        return self._inner[name]

    def address(self, name):
        return self._address[name]

    def command(self, name):
        """What begins a command that runs there."""
        return [IP, "netns", "exec", self._space(name)]

    def cut(self, names):
        """These from all others, without a word to either side."""
        for name in names:
            _run(IP, "link", "set", self._port(name, _REST), "master", self.tag + _CUT_OFF)

    def heal(self):
        for name in self.names:
            _run(IP, "link", "set", self._port(name, _REST), "master", self.tag + _REST)

    def deafen(self, name, ports):
        """What comes there from these ports is lost; what goes there is not."""
        _run(*self.command(name), "iptables", "-A", "INPUT", "-p", "tcp", "-m", "multiport", "--sports", ",".join(map(str, ports)), "-j",
             "DROP")

    def silence(self, name, ports):
        """Whatever comes there from or to these ports is lost."""
        _run(*self.command(name), "iptables", "-A", "INPUT", "-p", "tcp", "-m", "multiport", "--ports", ",".join(map(str, ports)), "-j", "DROP")

    def let_hear(self, name):
        _run(*self.command(name), "iptables", "-F", "INPUT")

    def _space(self, name):
        return f"{self.tag}-{name}"

    def _port(self, name, bridge):
        return f"{self.tag}{bridge}{self.names.index(name)}"
