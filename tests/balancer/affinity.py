#!/usr/bin/env python3
"""What it costs that servers share nothing: players in groups, on one server, on several by turns, and on several with each
group together. CPU seconds, chunks generated, and how often a chunk was in a cache."""

import argparse
import pathlib
import tempfile

import farm as farms
from farm import Server, figures, load, say, until

arguments = argparse.ArgumentParser(description=__doc__)
arguments.add_argument("--players", type=int, default=200)
arguments.add_argument("--groups", type=int, nargs="*", default=[10, 50, 200], help="numbers of groups; as many as players: loners")
arguments.add_argument("--servers", type=int, default=4)
arguments.add_argument("--radius", type=int, default=6)
arguments.add_argument("--seconds", type=float, default=20)
arguments.add_argument("--model", default="fly")
options = arguments.parse_args()

SETTINGS = {
    "TALUS_WORLD": str(farms.ROOT / "core/worlds/classic.toml"),
    "TALUS_THREADS_IO": "1",
    "TALUS_THREADS_GENERATOR": "1",
    "TALUS_PROXIES": "",
    "TALUS_LOG_LEVEL": "warning",
}


def sum_of(before, after, name):
    return sum(now[name] - then[name] for then, now in zip(before, after))


def run(folder, groups, count, together):
    servers = [Server(f"talus-{number}", folder, SETTINGS) for number in range(count)]
    try:
        for server in servers:
            server.start()
        addresses = ",".join(f"127.0.0.1:{server.port}" for server in servers)
        before = [server.metrics() for server in servers]
        process = load(addresses, "--players", options.players, "--groups", groups, "--model", options.model, "--radius",
                       options.radius, "--vertical", 2, "--duration", options.seconds, "--drain", 120, "--verify", 0,
                       "--from-addresses", 16, *(["--groups-together"] if together else []), json_file=folder / "load.json")
        output, _ = process.communicate()
        if process.returncode != 0:
            raise AssertionError(output)
        until(lambda: sum(server.players() for server in servers) == 0, "all have left")
        after = [server.metrics() for server in servers]
    finally:
        for server in servers:
            server.stop()
    seen = figures(folder / "load.json")
    hits, misses = (sum_of(before, after, f"talus_cache_{what}_total") for what in ("hits", "misses"))
    return {
        "cpu": sum_of(before, after, "process_cpu_seconds_total"),
        "generated": sum_of(before, after, "talus_chunks_generated_total"),
        "patches": sum_of(before, after, "talus_patches_generated_total"),
        "sent": sum_of(before, after, "talus_chunks_sent_total"),
        "hits": 100 * hits / max(1, hits + misses),
        "p99": seen["p99_ms"],
        "unanswered": seen["unanswered"],
    }


say(f"{options.players} players ({options.model}), radius {options.radius}, {options.seconds:.0f} s")
say(f"{'':34}{'CPU s':>8}{'CPU s a M sent':>16}{'generated':>11}{'patches':>9}{'sent':>9}{'hits %':>8}{'p99 ms':>8}")
for groups in options.groups:
    for name, count, together in (
        ("1 server", 1, False),
        (f"{options.servers} servers, by turns", options.servers, False),
        (f"{options.servers} servers, groups together", options.servers, True),
    ):
        with tempfile.TemporaryDirectory(prefix="talus-affinity-") as scratch:
            seen = run(pathlib.Path(scratch), groups, count, together)
        say(f"{groups:>4} groups, {name:<22}{seen['cpu']:>8.2f}{1e6 * seen['cpu'] / seen['sent']:>16.1f}{seen['generated']:>11.0f}"
            f"{seen['patches']:>9.0f}{seen['sent']:>9.0f}{seen['hits']:>8.1f}{seen['p99']:>8.0f}"
            + ("" if seen["unanswered"] == 0 else f"  {seen['unanswered']:.0f} never came"))
