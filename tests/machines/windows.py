#!/usr/bin/env python3
"""The zip for Windows: what is in it, and its talus-gen, talus-client and talus.dll (in Wine) beside this machine's, against this
machine's talusd: the same bytes by TCP and by TLS; names of files beyond ASCII; what is refused, and how; certificates that
Windows trusts.

windows.py [--here BUILD] [--world FILE] ZIP"""

import argparse
import hashlib
import os
import pathlib
import pty
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zipfile

from agree import CLIENT, FLY, GAME, HERE, Machine, bytes_of, certificate, compare, exported, played, refused, streamed

WINE = HERE / ".cmake/windows/wine.sh"
GEN = "core/tools/talus-gen"
PROGRAMS = {CLIENT: "talus-client", GEN: "talus-gen", GAME: "game", FLY: "fly"}
MINGW = "x86_64-w64-mingw32"
WINDOWS_OWN = {"advapi32.dll", "crypt32.dll", "kernel32.dll", "mswsock.dll", "msvcrt.dll", "user32.dll", "ws2_32.dll"}


class Package(Machine):
    """An unpacked zip, and games that are compiled with nothing but what is in it."""

    def __init__(self, file, folder):
        with zipfile.ZipFile(file) as package:
            package.extractall(folder)
        (root,) = folder.iterdir()
        super().__init__("windows", root, str(WINE))
        # Without the manifest their arguments would not be UTF-8.
        manifest = folder / "program.o"
        subprocess.run([f"{MINGW}-windres", "-I", WINE.parent, "-DTALUS_VERSION=0", "-DTALUS_NUMBERS=0", WINE.parent / "program.rc",
                        "-O", "coff", "-o", manifest], check=True)
        library = folder / "talus.lib"  # as Visual C++ makes it
        subprocess.run([f"{MINGW}-dlltool", "-d", root / "lib/talus.def", "-l", library], check=True)
        for source, talus in ((root / "share/talus/examples/fly.c", library), (HERE / "tests/machines/game.c", root / "lib/libtalus.dll.a"),
                              (HERE / "tests/machines/load.c", "-lws2_32")):
            subprocess.run([f"{MINGW}-gcc-posix", "-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror", "-I", root / "include",
                            source, manifest, talus, "-o", self.path(source.stem)], check=True)

    def path(self, program):
        return self.build / "bin" / (PROGRAMS.get(program, program) + ".exe")


def expect(what, found, expected):
    if found != expected:
        sys.exit(f"{what}: {found}, not {expected}")


def check_contents(package):
    """What the package is made of, and that nothing else is needed."""
    root = package.build
    header = re.sub(r"^#.*", "", (root / "include/talus.h").read_text(), flags=re.MULTILINE)
    declared = sorted(re.findall(r"TALUS_API [^(]*?(talus_\w+)\(", header))
    tables = {file.name: subprocess.run([f"{MINGW}-objdump", "-p", file], check=True, capture_output=True, text=True).stdout
              for file in (root / "bin").iterdir()}
    expect("programs and libraries", sorted(tables), ["fly.exe", "game.exe", "load.exe", "talus-client.exe", "talus-gen.exe", "talus.dll"])
    for name, table in tables.items():
        needed = {library.lower() for library in re.findall(r"DLL Name: (\S+)", table)} - {"talus.dll"}
        expect(f"{name} needs beside Windows' own", sorted(needed - WINDOWS_OWN), [])
    exports = tables["talus.dll"].split("[Ordinal/Name Pointer] Table")[1].split("\n\n")[0]
    expect("exports of talus.dll", re.findall(r"\] (\S+)$", exports, re.MULTILINE), declared)
    expect("talus.def", sorted(re.findall(r"^  (\S+)$", (root / "lib/talus.def").read_text(), re.MULTILINE)), declared)
    package.run("load")
    version = package.run(GEN, "--version").split()[1]
    for name in ("talus-client.exe", "talus-gen.exe", "talus.dll"):
        resources = subprocess.run([f"{MINGW}-windres", "-J", "coff", root / "bin" / name], check=True, capture_output=True, text=True)
        expect(f"version of {name}", re.findall(r'"ProductVersion", "(.*)"', resources.stdout), [version])
    examples = ("fly.c", "Fly.cs", "fly.lua", "fly.py")
    csharp = sorted(file.name for file in (HERE / "client_sample/c_api/bindings").glob("*.cs"))
    bindings = ("TalusClient.cs", *csharp, "talus.cdef.h", "talus_ctypes.py")
    for name in ("README.txt", "LICENSE", "licences/libssl-dev.txt", "worlds/default.toml",
                 *(f"share/talus/examples/{name}" for name in examples), *(f"share/talus/bindings/{name}" for name in bindings)):
        if not (root / name).is_file():
            sys.exit(f"the package has no {name}")
    for name in examples:
        if name not in (root / "README.txt").read_text():
            sys.exit(f"README.txt does not name {name}")


def named(machine, world):
    """Files whose names are not ASCII: read, written, written again, and named in the output."""
    result = {}
    with tempfile.TemporaryDirectory(prefix="talus-windows.") as name:
        folder = pathlib.Path(name) / "Länder 地図"
        folder.mkdir()
        copy, picture = folder / "welt-ß.toml", folder / "karte→.png"
        shutil.copy(world, copy)
        words = ("--world", copy, "--center", "0,0", "--size", "64,64", "-o", picture)
        for turn in ("written", "replaced"):
            machine.run(GEN, "map", *words)
            result[turn] = bytes_of(picture)
            picture.write_bytes(b"older")
        machine.run(GEN, "map", *words)
        machine.run(GEN, "export", "--world", copy, "--origin", "0,0", "--size", "32,32", "-o", folder / "ausfuhr-é")
        result["there"] = sorted(str(file.relative_to(folder)) for file in folder.rglob("*"))
        (folder / "kein-öl.toml").write_text("x = 1\n", encoding="utf-8")
        result["an error's name"] = refused(machine, GEN, "hash", "--world", folder / "kein-öl.toml", "--origin", "0,0",
                                            "--size", "32,32").replace(str(folder), "")
    return result


def check_console(package):
    """A name beyond ASCII is whole on a console."""
    name = "kein-öl→.toml"
    command = package.command(GEN, "hash", "--world", name, "--origin", "0,0", "--size", "32,32")
    process, terminal = pty.fork()
    if process == 0:
        os.execv(command[0], command)
    printed = b""
    try:
        while part := os.read(terminal, 4096):
            printed += part
    except OSError:  # it has ended
        pass
    os.waitpid(process, 0)
    text = re.sub(r"\x1b\[[\d;?]*[A-Za-z]", "", printed.decode(errors="replace"))
    if name not in text:
        sys.exit(f"on a console: {text!r}, without {name}")


# The system's own words for a host or a port follow the part that is compared.
REFUSED = {
    "no such world": (GEN, "hash", "--world", "nowhere.toml", "--origin", "0,0", "--size", "32,32"),
    "a folder as a world": (GEN, "hash", "--world", "tests", "--origin", "0,0", "--size", "32,32"),
    "no folder for a picture": (GEN, "map", "--center", "0,0", "--size", "8,8", "-o", "no/folder/map.png"),
    "a folder as a picture": (GEN, "map", "--center", "0,0", "--size", "8,8", "-o", "tests"),
    "no folder for a chunk": (CLIENT, "get", "-o", "no/folder/c.npy", "0", "0", "0"),
    "port 0": (CLIENT, "--connect", "localhost:0", "at", "0,0"),
    "port 99999": (CLIENT, "--connect", "localhost:99999", "at", "0,0"),
    "no token": (CLIENT, "--token-file", "nowhere", "at", "0,0"),
    "an unknown option": (CLIENT, "--conect", "localhost:1", "at", "0,0"),
}
UNREACHABLE = {
    "nothing listens": (CLIENT, "--connect", "127.0.0.1:1", "at", "0,0"),
    "no such host": (CLIENT, "--connect", "nowhere.invalid:4780", "at", "0,0"),
}


def refusals(machine):
    result = {what: refused(machine, *words) for what, words in REFUSED.items()}
    for what, words in UNREACHABLE.items():
        line = refused(machine, *words)
        result[what] = line.split(words[2])[0] + words[2] if words[2] in line else line
    return result


def trusts_the_system(here, windows, world):
    """A certificate is refused until Windows' store of roots has it."""
    with tempfile.TemporaryDirectory(prefix="talus-windows.") as name:
        folder = pathlib.Path(name)
        pem, key = certificate(folder)
        der = subprocess.run(["openssl", "x509", "-in", pem, "-outform", "DER"], check=True, capture_output=True).stdout
        thumb = hashlib.sha1(der).digest()
        with here.served(world, folder / "data", TALUS_TLS_CERTIFICATE=str(pem), TALUS_TLS_KEY=str(key)) as address:
            words = (CLIENT, "--connect", f"localhost:{address.rsplit(':', 1)[1]}", "--tls", "at", "0,0")
            line = refused(windows, *words)
            if "certificate verify failed" not in line:
                sys.exit(f"windows: an unknown certificate: {line}")
            entry = "HKLM\\Software\\Microsoft\\SystemCertificates\\Root\\Certificates\\" + thumb.hex().upper()
            blob = struct.pack("<III", 3, 1, len(thumb)) + thumb + struct.pack("<III", 32, 1, len(der)) + der
            subprocess.run([WINE, "reg", "add", entry, "/v", "Blob", "/t", "REG_BINARY", "/d", blob.hex(), "/f"], check=True,
                           capture_output=True, timeout=120)
            try:
                windows.run(*words)
            finally:
                subprocess.run([WINE, "reg", "delete", entry, "/f"], check=True, capture_output=True, timeout=120)
    print("Windows' store of roots: refused without the certificate, trusted with it", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--here", default=HERE / "build/release", help="build folder of this machine")
    parser.add_argument("--world", default=HERE / "core/worlds/default.toml", type=pathlib.Path)
    parser.add_argument("zip", type=pathlib.Path, help="the package")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="talus-windows.") as folder:
        here, windows = Machine("here", options.here), Package(options.zip, pathlib.Path(folder))
        check_contents(windows)
        check_console(windows)
        same = compare("talus-gen", exported(here, options.world), exported(windows, options.world))
        same &= compare("names of files", named(here, options.world), named(windows, options.world))
        same &= compare("what is refused", refusals(here), refusals(windows))
        same &= compare("talus-client by TCP", played(here, here, options.world), played(here, windows, options.world))
        same &= compare("by TLS, and libtalus", streamed(here, here, options.world), streamed(here, windows, options.world))
        trusts_the_system(here, windows, options.world)
    sys.exit(0 if same else 1)


if __name__ == "__main__":
    main()
