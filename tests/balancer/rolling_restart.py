#!/usr/bin/env python3
"""All of several servers behind HAProxy end and start again, one after the other, under players; then players are balanced.

Prints what players waited, and ends with 1 where a chunk or an edit was lost, or a wait was over its limit. The settings are
those that ship, but for the limits of one address."""

import argparse
import contextlib
import pathlib
import sys
import tempfile
import time

import farm as farms
from farm import Farm, figures, load, restart, say, until
from nats import Nats

arguments = argparse.ArgumentParser(description=__doc__)
arguments.add_argument("--players", type=int, default=500)
arguments.add_argument("--servers", type=int, default=3)
arguments.add_argument("--radius", type=int, default=4)
arguments.add_argument("--model", default="walk")
arguments.add_argument("--edits", type=float, default=0, help="a second, of each player, who stand then: the servers share a log by three nats-server")
arguments.add_argument("--ramp-up", type=float, default=20)
arguments.add_argument("--pause", type=float, default=10, help="seconds between a restart and the next")
arguments.add_argument("--lead", type=int, default=5000)
arguments.add_argument("--drain", type=int, default=10000)
arguments.add_argument("--session", type=int, default=60000)
arguments.add_argument("--per-second", type=int, default=10)
arguments.add_argument("--back-ms", type=float, default=2000, help="a player's Welcome, Pong and Attached")
arguments.add_argument("--full-ms", type=float, default=10000, help="a player's whole View")
arguments.add_argument("--setting", action="append", default=[], metavar="NAME=VALUE", help="of every talusd; %%d: its number")
arguments.add_argument("--out", type=pathlib.Path)
options = arguments.parse_args()

folder = options.out or pathlib.Path(tempfile.mkdtemp(prefix="talus-rolling-"))
folder.mkdir(parents=True, exist_ok=True)
settings = {
    "TALUS_WORLD": str(farms.ROOT / "core/worlds/classic.toml"),
    "TALUS_THREADS_IO": "1",
    "TALUS_THREADS_GENERATOR": "1",
    "TALUS_SHUTDOWN_LEAD_MS": str(options.lead),
    "TALUS_SHUTDOWN_DRAIN_MS": str(options.drain),
    "TALUS_BALANCE_SESSION_MS": str(options.session),
    "TALUS_BALANCE_PER_SECOND": str(options.per_second),
}


def of_server(number):
    extra = dict(setting.split("=", 1) for setting in options.setting)
    if nats:
        data = {"TALUS_DATA": str(folder / f"data-{number}"), "TALUS_ACCESS_WITHOUT_TOKEN": "read,edit"}
        extra = {**nats.settings, **data, **extra}
    return {**settings, **{name: value.replace("%d", str(number)) for name, value in extra.items()}}


nats = Nats(folder, 3, settings) if options.edits else None
with contextlib.ExitStack() as stack:
    if nats:
        stack.callback(nats.stop)
    farm = stack.enter_context(Farm(folder, options.servers, of_server))
    count = options.players
    motion = ["--edits", options.edits, "--edit-group", 5] if options.edits else ["--model", options.model]
    vertical = 1 if options.edits else 2
    command = [*motion, "--players", count, "--radius", options.radius, "--vertical", vertical, "--ramp-up", options.ramp_up,
               "--verify", 0.5, "--duration", 86000, "--drain", 60, "--from-addresses", 16]
    # It ends by a signal when all is done, and reports then.
    process = load(f"127.0.0.1:{farm.port}", *command, json_file=folder / "load.json")

    def greeted():
        if process.poll() is not None:
            raise AssertionError(process.communicate()[0])
        return farm.players()

    def all_there():
        return sum(greeted()) == count

    try:
        until(all_there, "all players are there", 300)
        time.sleep(options.pause)  # under way, and not all new
        say(f"{count} players on {options.servers} servers: {greeted()}")
        began = time.monotonic()
        for server in farm.servers:
            at = time.monotonic()
            restart(farm, server)
            until(all_there, "all players are there again", 300)
            say(f"{server.name} again after {time.monotonic() - at:.1f} s: {greeted()}")
            time.sleep(options.pause)
        most = -(-count // options.servers)
        most += -(-most // 10)
        at = time.monotonic()
        before = sum(server.metrics()["talus_sessions_sent_elsewhere_total"] for server in farm.servers)
        until(lambda: sum(greeted()) == count and max(greeted()) <= most, "players are balanced again", 600)
        sent = sum(server.metrics()["talus_sessions_sent_elsewhere_total"] for server in farm.servers)
        say(f"balanced {time.monotonic() - at:.1f} s after the last restart: {greeted()}; {sent:.0f} were sent elsewhere")
        time.sleep(options.pause)  # and are served there
        settled = sum(server.metrics()["talus_sessions_sent_elsewhere_total"] for server in farm.servers)
        say(f"{time.monotonic() - began:.0f} s in all; sent elsewhere since: {settled - sent:.0f}")
    finally:
        process.terminate()
        output, _ = process.communicate()
    say(output)
    seen = figures(folder / "load.json")

# An Error `overloaded` is how an Attach waits until the next server has come as far as the last.
failures = [f"{name}: {seen.get(name, 0):.0f}" for name in ("wrong", "unanswered", "edits_missing", "edits_unknown") if seen.get(name, 0)]
for name, limit in (("back_max_ms", options.back_ms), ("full_again_max_ms", options.full_ms)):
    if seen.get(name, 0) > limit:
        failures.append(f"{name}: {seen[name]:.0f}, over {limit:.0f}")
if seen["reconnects"] < count:
    failures.append(f"only {seen['reconnects']:.0f} of {count} players lost their server")
for failure in failures:
    print(f"rolling_restart: {failure}", file=sys.stderr)
sys.exit(1 if failures else 0)
