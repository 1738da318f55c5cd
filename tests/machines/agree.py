#!/usr/bin/env python3
"""Serves one world from this machine and from another one (in an emulator), to clients of both: every byte that they see,
store and export must be the same.

agree.py --other BUILD --emulator "qemu-aarch64-static -L ROOT" [--here BUILD] [--world FILE]"""

import argparse
import contextlib
import hashlib
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent.parent.parent
CHUNKS = ((0, 0, 0, 0), (0, 1, 0, 0), (-3, 1, 5, 0), (0, 0, 0, 3), (2, 0, -2, 6))
BOX = ("40,{y},40", "55,{y},49")
HOLE = (64, 32, 64)  # in rock
CLIENT = "client_sample/cli/talus-client"
GAME, FLY = "client_sample/c_api/talus_game", "client_sample/c_api/fly"


class Machine:
    def __init__(self, name, build, emulator=""):
        self.name, self.build, self.emulator = name, pathlib.Path(build), shlex.split(emulator)

    def path(self, program):
        return self.build / program

    def command(self, program, *words):
        return [*self.emulator, str(self.path(program)), *map(str, words)]

    def run(self, program, *words, **options):
        done = subprocess.run(self.command(program, *words), capture_output=True, text=True, timeout=300, **options)
        if done.returncode != 0:
            sys.exit(f"{self.name}: {program} {' '.join(map(str, words))} ended with {done.returncode}: {done.stderr}")
        return done.stdout

    @contextlib.contextmanager
    def served(self, world, data, **more):
        """Yields the address of a talusd."""
        settings = {
            "TALUS_WORLD": str(world), "TALUS_DATA": str(data), "TALUS_LISTEN": "127.0.0.1:0", "PATH": "/usr/bin:/bin",
            "TALUS_ACCESS_WITHOUT_TOKEN": "read,edit", "TALUS_THREADS_IO": "1", "TALUS_THREADS_GENERATOR": "1",
            **more,
        }
        server = subprocess.Popen(self.command("server/talusd"), env=settings, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True)
        try:
            log = []
            for line in server.stdout:
                log.append(line)
                if found := re.search(r"listening on ([^ ]+:\d+)", line):
                    yield found[1]
                    break
            else:
                sys.exit(f"{self.name}: talusd did not start:\n{''.join(log)}")
            server.send_signal(signal.SIGTERM)
            rest = server.stdout.read()
            if server.wait(60) != 0:
                sys.exit(f"{self.name}: talusd ended with {server.returncode}:\n{rest}")
        finally:
            if server.poll() is None:
                server.kill()


def bytes_of(path):
    return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()


def hash_in(stat):
    return re.search(r'"[a-z_]*hash"\s*:\s*"([0-9a-f]{32})"', stat)[1]


def seen(client, connect, scratch, what):
    """What a client receives, as hashes and text. `connect`: options that name the server."""
    result = {}
    for chunk in CHUNKS:
        *place, lod = chunk
        file = scratch / "chunk.npy"
        client.run(CLIENT, *connect, "get", "--lod", lod, "-o", file, "--", *place)
        result[f"{what}: chunk {chunk}"] = bytes_of(file)
    result[f"{what}: columns"] = client.run(CLIENT, *connect, "at", "--", "0,0", "40,40", "-1000,777")
    file = scratch / "map.png"
    client.run(CLIENT, *connect, "map", "--size", "128,96", "-o", file)
    result[f"{what}: map"] = bytes_of(file)
    return result


def played(server, client, world):
    """A client looks, edits and looks again; the server starts anew, and its store is exported."""
    result = {}
    with tempfile.TemporaryDirectory(prefix="talus-agree.") as folder:
        scratch = pathlib.Path(folder)
        data = scratch / "data"
        with server.served(world, data) as address:
            connect = ("--connect", address)
            result |= seen(client, connect, scratch, "before")
            first, last = (corner.format(y=40) for corner in BOX)
            client.run(CLIENT, *connect, "edit", "--material", "air", "--", first, last)
            client.run(CLIENT, *connect, "edit", "--material", "planks", "--", "3,35,3")
            result |= seen(client, connect, scratch, "after")
        with server.served(world, data) as address:
            result |= seen(client, ("--connect", address), scratch, "restarted")
        stat = server.run("server/talusd", "store", "stat", "--json", "--data", data)
        result["hash of all edits"] = hash_in(stat)
        server.run("server/talusd", "store", "verify", "--data", data)
        file = scratch / "edits"
        server.run("server/talusd", "store", "export", "--data", data, file)
        # Each machine reads what the other has written.
        imported = set()
        for reader in {server, client}:
            if not reader.path("server/talusd").exists():
                continue
            moved = scratch / f"moved-{reader.name}"
            reader.run("server/talusd", "store", "import", "--data", moved, "--world", world, file)
            again = reader.run("server/talusd", "store", "stat", "--json", "--data", moved)
            imported.add(hash_in(again))
        result["imported"] = sorted(imported)
    return result


def certificate(folder):
    """A certificate for localhost and its key."""
    certificate, key = folder / "certificate.pem", folder / "key.pem"
    subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-days", "2",
                    "-subj", "/CN=localhost", "-addext", "subjectAltName=DNS:localhost,IP:127.0.0.1", "-keyout", key,
                    "-out", certificate], check=True, capture_output=True)
    return certificate, key


def refused(machine, program, *words):
    """The one line with which it fails, and its status."""
    done = subprocess.run(machine.command(program, *words), capture_output=True, text=True, timeout=120)
    if done.returncode == 0 or done.stdout or done.stderr.count("\n") != 1:
        sys.exit(f"{machine.name}: {program} {' '.join(map(str, words))}: status {done.returncode}, {done.stdout!r}, not one "
                 f"line of error: {done.stderr!r}")
    return f"{done.returncode}: {done.stderr}"


def streamed(server, client, world):
    """What a client sees by TLS, and what a game by libtalus does."""
    result = {}
    with tempfile.TemporaryDirectory(prefix="talus-agree.") as name:
        folder = pathlib.Path(name) / "Länder 地図"
        folder.mkdir()
        pem, key = certificate(folder)
        settings = {"TALUS_TLS_CERTIFICATE": str(pem), "TALUS_TLS_KEY": str(key)}
        with server.served(world, folder / "data", **settings) as address:
            host, port = address.rsplit(":", 1)
            result |= seen(client, ("--connect", address, "--ca", pem), folder, "TLS")
            unread = refused(client, CLIENT, "--connect", address, "--ca", folder / "none.pem", "at", "0,0")
            result["no authority"] = unread.replace(str(folder), "").replace(address, "")
            result["game by TLS"] = client.run(GAME, host, port, pem, *HOLE)
        with server.served(world, folder / "data-open") as address:
            host, port = address.rsplit(":", 1)
            result["game"] = client.run(GAME, host, port, "-", *HOLE)
            result["fly"] = client.run(FLY, host, port)
    return result


def exported(machine, world):
    """What talus-gen makes of the world without a network."""
    result = {}
    with tempfile.TemporaryDirectory(prefix="talus-agree.") as folder:
        out = pathlib.Path(folder) / "export"
        machine.run("core/tools/talus-gen", "export", "--world", world, "--origin", "-32,-32", "--size", "64,64", "-o", out)
        for file in sorted(out.rglob("*")):
            if file.is_file():
                result[f"export: {file.relative_to(out)}"] = bytes_of(file)
        result["hash"] = machine.run("core/tools/talus-gen", "hash", "--world", world, "--origin", "-128,-128", "--size", "256,256").split()[0]
    return result


def compare(what, expected, found):
    different = [key for key in sorted(expected.keys() | found.keys()) if expected.get(key) != found.get(key)]
    for key in different:
        print(f"{what}: {key}: {found.get(key)}, expected {expected.get(key)}", file=sys.stderr)
    print(f"{what}: {len(expected) - len(different)} of {len(expected)} the same", flush=True)
    return not different


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--here", default=HERE / "build/release", help="build folder of this machine")
    parser.add_argument("--other", required=True, help="build folder of the other machine")
    parser.add_argument("--emulator", required=True, help="command that runs the other machine's programs")
    parser.add_argument("--world", default=HERE / "core/worlds/default.toml", type=pathlib.Path)
    options = parser.parse_args()
    here, other = Machine("here", options.here), Machine("other", options.other, options.emulator)
    expected = exported(here, options.world)
    same = compare("talus-gen of the other", expected, exported(other, options.world))
    for what, use in (("by TCP", played), ("by TLS, and libtalus", streamed)):
        expected = use(here, here, options.world)
        for server, client in ((other, other), (other, here), (here, other)):
            same &= compare(f"{what}: server {server.name}, client {client.name}", expected, use(server, client, options.world))
    sys.exit(0 if same else 1)


if __name__ == "__main__":
    main()
