#!/usr/bin/env python3
"""Edits at a rate over several talusd that share a log by three nats-servers, beside bare JetStream's acknowledgements of as many
edits, by turns on the same nats-servers: how much longer an edit takes, and when players at other servers see it. The ratio to bare
JetStream by one publisher is judged; that to as many publishers as there are talusd, each with one message in flight, is told.

Ends with 1 where an edit was lost, or a limit is passed."""

import argparse
import contextlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import farm as farms
from farm import ROOT, TALUSD, Server, figures, load, say
from nats import Nats

BENCH_STREAM = os.environ.get("BENCH_STREAM", str(ROOT / "build/release/tests/bench/bench_stream"))
BARE_STORE = "f" * 32

arguments = argparse.ArgumentParser(description=__doc__)
arguments.add_argument("--servers", type=int, default=3)
arguments.add_argument("--rate", type=int, default=10000, help="edits a second in all")
arguments.add_argument("--players", type=int, default=60)
arguments.add_argument("--edit-group", type=int, default=2, help="players at a place, anywhere on the servers")
arguments.add_argument("--seconds", type=int, default=20, help="of a turn")
arguments.add_argument("--turns", type=int, default=2)
arguments.add_argument("--times", type=float, default=3, help="bare JetStream's p99 that an edit's may be")
arguments.add_argument("--seen-ms", type=float, default=40, help="p99 until players at other servers see it")
options = arguments.parse_args()

SETTINGS = {
    "TALUS_WORLD": str(ROOT / "core/worlds/classic.toml"),
    "TALUS_THREADS_IO": "1",
    "TALUS_THREADS_GENERATOR": "1",
    "TALUS_PROXIES": "",
    "TALUS_ACCESS_WITHOUT_TOKEN": "read,edit",
    "TALUS_RATES_ADDRESS_VOXELS": "0",
    "TALUS_LOG_LEVEL": "warning",
}

rows = []
failures = []
with tempfile.TemporaryDirectory(prefix="talus-rate-") as scratch, contextlib.ExitStack() as stack:
    folder = pathlib.Path(scratch)
    nats = Nats(folder, 3, SETTINGS)
    stack.callback(nats.stop)
    subprocess.run([TALUSD, "cluster", "init"], env={**SETTINGS, **nats.settings, "TALUS_CLUSTER_STORE": BARE_STORE}, check=True,
                   capture_output=True)
    servers = [Server(f"talus-{number}", folder, {**SETTINGS, **nats.settings, "TALUS_DATA": str(folder / f"data-{number}")})
               for number in range(options.servers)]
    for server in servers:
        stack.callback(server.stop)
        server.start()
    addresses = ",".join(f"127.0.0.1:{server.port}" for server in servers)
    say(f"{options.rate} edits/s by {options.players} players in groups of {options.edit_group} on {options.servers} servers, R3, "
        f"{options.seconds} s a turn; ms")
    say(f"{'':14}{'edits/s':>9}{'ack p50':>9}{'p99':>9}{'bare p50':>10}{'p99':>9}{'ratio':>7}{'by one p50':>12}{'p99':>9}{'ratio':>7}"
        f"{'seen elsewhere p50':>20}{'p99':>9}{'CPU s each':>12}")

    def bare_times(publishers):
        """p50 and p99."""
        urls = nats.settings["TALUS_CLUSTER_NATS"]
        command = [BENCH_STREAM, "bare", options.seconds, urls, BARE_STORE, options.rate, publishers]
        said = subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True).stdout
        return [float(time) for time in re.search(r"edit p50 ([0-9.]+) p99 ([0-9.]+) ms", said).groups()]

    for turn in range(options.turns):
        bare, by_one = (bare_times(publishers) for publishers in (options.servers, 1))
        before = [server.metrics()["process_cpu_seconds_total"] for server in servers]
        process = load(addresses, "--players", options.players, "--edits", options.rate / options.players, "--edit-group", options.edit_group,
                       "--radius", 2, "--vertical", 1, "--ramp-up", 2, "--warm-up", 2, "--duration", options.seconds, "--drain", 30, "--verify", 0,
                       "--from-addresses", 16, "--seed", turn + 1, json_file=folder / "load.json")
        output, _ = process.communicate()
        seen = figures(folder / "load.json")
        cpu = [server.metrics()["process_cpu_seconds_total"] - then for server, then in zip(servers, before)]
        ratio = seen["edit_ack_p99_ms"] / by_one[1]
        rows.append((ratio, seen["edit_other_server_p99_ms"]))
        say(f"turn {turn + 1:<9}{seen['edits_per_s']:>9.0f}{seen['edit_ack_p50_ms']:>9.2f}{seen['edit_ack_p99_ms']:>9.2f}{bare[0]:>10.2f}"
            f"{bare[1]:>9.2f}{seen['edit_ack_p99_ms'] / bare[1]:>7.2f}{by_one[0]:>12.2f}{by_one[1]:>9.2f}{ratio:>7.2f}"
            f"{seen['edit_other_server_p50_ms']:>20.2f}{seen['edit_other_server_p99_ms']:>9.2f}{sum(cpu) / len(cpu):>12.2f}")
        if process.returncode != 0 or seen["edits_missing"] or seen["edits_unknown"] or seen["wrong"]:
            failures.append(output)
ratio, elsewhere = (min(column) for column in zip(*rows))  # the turn that the machine disturbed least
if ratio > options.times:
    failures.append(f"an edit's p99 is {ratio:.2f} times bare JetStream's, over {options.times}")
if elsewhere > options.seen_ms:
    failures.append(f"seen at other servers after {elsewhere:.1f} ms (p99), over {options.seen_ms}")
for failure in failures:
    print(f"edits_at_rate: {failure}", file=sys.stderr)
sys.exit(1 if failures else 0)
