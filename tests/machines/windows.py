#!/usr/bin/env python3
"""Windows' talus-gen, talus-client and libtalus (in Wine) beside this machine's, against this machine's talusd: the same bytes
by TCP and by TLS; names of files beyond ASCII; what is refused, and how; certificates that Windows trusts; the zip.

windows.py [--windows BUILD] [--here BUILD] [--world FILE] [--zip FILE]"""

import argparse
import hashlib
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zipfile

from agree import CLIENT, HERE, Machine, bytes_of, certificate, compare, exported, played, refused, streamed

WINE = HERE / ".cmake/windows/wine.sh"
GEN = "core/tools/talus-gen"


def of_zip(file, folder):
    """The programs of the package, and fly.c compiled with nothing but what is in it."""
    with zipfile.ZipFile(file) as package:
        package.extractall(folder)
    (root,) = folder.iterdir()
    subprocess.run(["x86_64-w64-mingw32-gcc-posix", "-std=c99", "-I", root / "include", root / "examples/fly.c",
                    root / "lib/libtalus.dll.a", "-o", root / "bin/fly.exe"], check=True)
    return Machine("zip", root / "bin", str(WINE), ".exe")


def packaged(file, here, world):
    """The package in a folder of its own."""
    with tempfile.TemporaryDirectory(prefix="talus-windows.") as name:
        folder = pathlib.Path(name)
        package = of_zip(file, folder / "unpacked")
        with here.served(world, folder / "data") as address:
            at = ("--connect", address, "at", "0,0")
            same = compare("the zip",
                           {"fly": here.run("client_sample/c_api/fly", *address.rsplit(":", 1)), "at": here.run(CLIENT, *at)},
                           {"fly": package.run("fly", *address.rsplit(":", 1)), "at": package.run("talus-client", *at)})
        print(package.run("talus-gen", "--version").strip(), flush=True)
    return same


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
    parser.add_argument("--windows", default=HERE / "build/windows", help="build folder for Windows")
    parser.add_argument("--world", default=HERE / "core/worlds/default.toml", type=pathlib.Path)
    parser.add_argument("--zip", type=pathlib.Path, help="the package, to be tried in a folder of its own")
    options = parser.parse_args()
    here, windows = Machine("here", options.here), Machine("windows", options.windows, str(WINE), ".exe")
    same = compare("talus-gen", exported(here, options.world), exported(windows, options.world))
    same &= compare("names of files", named(here, options.world), named(windows, options.world))
    same &= compare("what is refused", refusals(here), refusals(windows))
    same &= compare("talus-client by TCP", played(here, here, options.world), played(here, windows, options.world))
    same &= compare("by TLS, and libtalus", streamed(here, here, options.world), streamed(here, windows, options.world))
    trusts_the_system(here, windows, options.world)
    if options.zip:
        same &= packaged(options.zip, here, options.world)
    sys.exit(0 if same else 1)


if __name__ == "__main__":
    main()
