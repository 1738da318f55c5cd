"""Several talusd of one world behind a real HAProxy, which has the configuration that ships, changed in its addresses alone."""

import json
import os
import pathlib
import random
import re
import signal
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[2]
CONFIGURATION = ROOT / "docker/haproxy/haproxy.cfg"
TALUSD = os.environ.get("TALUSD", str(ROOT / "build/release/server/talusd"))
TALUS_LOAD = os.environ.get("TALUS_LOAD", str(ROOT / "build/release/client_sample/load/talus-load"))
HAPROXY = next((path for path in ("/usr/sbin/haproxy", "/usr/local/sbin/haproxy", "/usr/bin/haproxy") if os.path.exists(path)), None)
PATIENCE_S = 120
PLACES = 64  # ports of the frontend of that name
PROXY = "127.0.0.9"  # from where HAProxy connects: another address than players'
# From one address come as many as are wanted, as fast as they like.
UNLIMITED = {
    "TALUS_LIMITS_CONNECTIONS": "20000",
    "TALUS_LIMITS_CONNECTIONS_PER_ADDRESS": "20000",
    "TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_PER_SECOND": "20000",
    "TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_BURST": "20000",
    "TALUS_LIMITS_HANDSHAKES_IN_FLIGHT": "20000",
    "TALUS_RATES_ADDRESS_CHUNKS": "0",
    "TALUS_RATES_ADDRESS_BYTES": "0",
    "TALUS_RATES_ADDRESS_REQUESTS": "0",
}

_taken = set()


def _is_free(port):
    """Nobody listens there, nor holds it for a server that is away."""
    with socket.socket() as probe:
        try:
            probe.bind(("127.0.0.1", port))
        except OSError:
            return False
    return True


def free_port():
    """One that nobody has now, below those that the system deals out, so that it stays free."""
    while True:
        port = random.randrange(18000, 32000)
        if port in _taken or not _is_free(port):
            continue
        _taken.add(port)
        return port


def free_ports(count):
    """The first of so many in a row."""
    for _ in range(100):
        first = random.randrange(18000, 32000 - count)
        ports = set(range(first, first + count))
        if ports & _taken or not all(map(_is_free, ports)):
            continue
        _taken.update(ports)
        return first
    raise AssertionError(f"there are no {count} free ports in a row")


def until(done, what, patience_s=PATIENCE_S, beat_s=0.05):
    """Asks until `done` answers something true, and returns it. Fails where that takes very long."""
    deadline = time.monotonic() + patience_s
    while True:
        answer = done()
        if answer:
            return answer
        if time.monotonic() > deadline:
            raise AssertionError(f"it took over {patience_s} s until {what}")
        time.sleep(beat_s)


def fetch(url, timeout_s=30, **headers):
    """Status and body."""
    request = urllib.request.Request(url, headers=headers)
    try:
        with urllib.request.urlopen(request, timeout=timeout_s) as answer:
            return answer.status, answer.read()
    except urllib.error.HTTPError as error:
        with error:
            return error.code, error.read()


class Server:
    """A talusd that may be ended and started again, on the same ports. It is reached at `address`; `command` goes before
    talusd's own, to start it elsewhere."""

    def __init__(self, name, folder, settings, address="127.0.0.1", command=()):
        self.name, self.log = name, folder / f"{name}.log"
        self.address, self.command = address, list(command)
        self.port, self.http, self.admin = free_port(), free_port(), free_port()
        inherited = {key: value for key, value in os.environ.items() if not key.startswith("TALUS")}
        self.environment = {**inherited, "TALUS_PROXIES": PROXY, "TALUS_LOG_LEVEL": "info", **UNLIMITED, **settings}
        self.process = None

    def start(self):
        self.launch()
        until(self.is_ready, f"{self.name} is ready; it said:\n{self.log.read_text()}")

    def launch(self, listen=None):
        addresses = [f"--{flag}={listen or self.address}:{port}" for flag, port in
                     (("listen", self.port), ("http", self.http), ("admin", self.admin))]
        with open(self.log, "ab") as log:
            self.process = subprocess.Popen([*self.command, TALUSD, *addresses], env=self.environment, stdout=log, stderr=log)

    def is_ready(self):
        if self.process.poll() is not None:
            raise AssertionError(f"{self.name} ended with {self.process.returncode}:\n{self.log.read_text()}")
        try:
            return self.ready() == 200
        except OSError:
            return False

    def ready(self):
        return fetch(f"http://{self.address}:{self.admin}/-/ready")[0]

    def ready_text(self):
        return fetch(f"http://{self.address}:{self.admin}/-/ready")[1].decode().strip()

    def metrics(self):
        """Of each name, with its labels, the value."""
        text = fetch(f"http://{self.address}:{self.admin}/metrics")[1].decode()
        return {match[1]: float(match[2]) for match in re.finditer(r"^(talus_\S+|process_\S+) (\S+)$", text, re.M)}

    def players(self):
        try:
            return int(self.metrics()['talus_sessions{state="greeted"}'])
        except OSError:  # it is away
            return 0

    def http_answers(self):
        return int(sum(value for name, value in self.metrics().items() if name.startswith("talus_http_responses_total")))

    def flows(self):
        return fetch(f"http://{self.address}:{self.admin}/flows.json")[1].decode()

    def signal(self, number):
        self.process.send_signal(number)

    def wait(self):
        return self.process.wait(PATIENCE_S)

    def stop(self):
        if self.process is None or self.process.poll() is not None:
            return
        self.process.terminate()
        try:
            self.process.wait(1)
        except subprocess.TimeoutExpired:
            self.process.terminate()  # ends it at once
            self.process.wait(PATIENCE_S)


class Farm:
    """`count` servers, each with `settings` (environment variables; a function of the server's number where each has its
    own), and HAProxy in front. `make`: makes a server of its name, folder and settings."""

    def __init__(self, folder, count=3, settings=None, make=Server, proxy=PROXY):
        self.folder, self.proxy, self.address = pathlib.Path(folder), proxy, "127.0.0.1"
        of = settings if callable(settings) else lambda _: dict(settings or {})
        self.servers = [make(f"talus-{number}", self.folder, of(number)) for number in range(count)]
        self.port, self.http = free_port(), free_port()
        self.places = free_ports(PLACES)
        self.stats = self.folder / "haproxy.sock"
        self.haproxy = None

    def __enter__(self):
        try:
            for server in self.servers:
                server.start()
            self.start_haproxy()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_):
        self.stop()

    def stop(self):
        if self.haproxy is not None:
            self.haproxy.terminate()
            self.haproxy.wait(PATIENCE_S)
            self.haproxy = None
        for server in self.servers:
            if server.process is not None and server.process.poll() is None:
                server.process.terminate()
        for server in self.servers:
            server.stop()

    def configuration(self):
        text = CONFIGURATION.read_text()
        lines = []
        for line in text.splitlines():
            match = re.fullmatch(r"( +server talus-)(\d) talus-\d:(\d+)(.*)", line)
            if match and match[2] == "0":  # a line for each of ours in place of those that ship
                for number, server in enumerate(self.servers):
                    port = {"4780": server.port, "4782": server.http}[match[3]]
                    lines.append(f"{match[1]}{number} {server.address}:{port} port {server.admin}{match[4]}")
            elif not match:
                lines.append(line)
        text = "\n".join(lines) + "\n"
        for there, here in (
            ("bind :4780\n", f"bind 127.0.0.1:{self.port}\n"),
            ("bind :4800-4863\n", f"bind 127.0.0.1:{self.places}-{self.places + PLACES - 1}\n"),
            ("?ports=4780 ", f"?ports={self.port} "),
            ("&ports=4800-4863 ", f"&ports={self.places}-{self.places + PLACES - 1} "),
            ("bind :80\n", f"bind 127.0.0.1:{self.http}\n"),
            ("tcp-ut 10s\n", f"tcp-ut 10s source {self.proxy}\n"),
            ("log stdout format raw local0\n", f"log stdout format raw local0\n    stats socket {self.stats} level admin\n"),
        ):
            if there not in text:
                raise AssertionError(f"{CONFIGURATION} has no {there!r}")
            text = text.replace(there, here)
        return text

    def start_haproxy(self):
        path = self.folder / "haproxy.cfg"
        path.write_text(self.configuration())
        checked = subprocess.run([HAPROXY, "-c", "-f", path], capture_output=True, text=True, check=False)
        if checked.returncode != 0 or "[WARNING]" in checked.stderr:
            raise AssertionError(f"HAProxy takes the configuration not, or with a warning:\n{checked.stderr}")
        with open(self.folder / "haproxy.log", "ab") as log:
            self.haproxy = subprocess.Popen([HAPROXY, "-f", path], stdout=log, stderr=log)
        until(self.haproxy_runs, "HAProxy is up")
        for server in self.servers:
            until(lambda server=server: self.state(server) == "UP", f"{server.name} is up for HAProxy")

    def haproxy_runs(self):
        if self.haproxy.poll() is not None:
            raise AssertionError(f"HAProxy ended:\n{(self.folder / 'haproxy.log').read_text()}")
        try:
            self.tell("show info")
        except OSError:  # its socket is not there, or nobody listens yet
            return False
        return True

    def tell(self, command):
        with socket.socket(socket.AF_UNIX) as stats:
            stats.connect(str(self.stats))
            stats.sendall(command.encode() + b"\n")
            answer = b""
            while part := stats.recv(65536):
                answer += part
        return answer.decode()

    def state(self, server, backend="talus"):
        """UP, DOWN, or on its way from one to the other: "UP 1/2"."""
        names, *rows = [line.split(",") for line in self.tell("show stat").splitlines() if line]
        for row in rows:
            fields = dict(zip(names, row))
            if fields["# pxname"] == backend and fields["svname"] == server.name:
                return fields["status"]
        raise AssertionError(f"HAProxy has no {server.name}")

    def players(self):
        return [server.players() for server in self.servers]


def load(address, *arguments, json_file=None, **popen):
    """talus-load as a process that runs."""
    arguments = [TALUS_LOAD, "--connect", address, *map(str, arguments)]
    if json_file is not None:
        arguments += ["--json", str(json_file)]
    return subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **popen)


def figures(json_file):
    return json.loads(pathlib.Path(json_file).read_text())["figures"]


def restart(farm, server):
    """Ends it as an operator does, and starts it again when it has ended."""
    server.signal(signal.SIGTERM)
    status = server.wait()
    if status != 0:
        raise AssertionError(f"{server.name} ended with {status}:\n{server.log.read_text()}")
    server.start()
    until(lambda: farm.state(server) == "UP", f"{server.name} is up again for HAProxy")


def say(line):
    print(line, flush=True, file=sys.stdout)
