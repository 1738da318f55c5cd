#!/usr/bin/env python3
"""What it costs that servers share nothing: players in groups, on one server, on several anywhere, on several with each
group together, and so by HAProxy's ports for places. CPU seconds, chunks generated, and how often a chunk was in a cache."""

import argparse

from cost import cost
from farm import say

arguments = argparse.ArgumentParser(description=__doc__)
arguments.add_argument("--players", type=int, default=200)
arguments.add_argument("--groups", type=int, nargs="*", default=[10, 50, 200], help="numbers of groups; as many as players: loners")
arguments.add_argument("--servers", type=int, default=4)
arguments.add_argument("--radius", type=int, default=6)
arguments.add_argument("--seconds", type=float, default=20)
arguments.add_argument("--model", default="fly")
options = arguments.parse_args()

say(f"{options.players} players ({options.model}), radius {options.radius}, {options.seconds:.0f} s")
say(f"{'':38}{'CPU s':>8}{'a M sent':>10}{'generated':>11}{'patches':>9}{'sent':>9}{'hits %':>8}{'p99 ms':>8}")
for groups in options.groups:
    for name, servers, together, places in (
        ("1 server", 1, False, False),
        (f"{options.servers} servers, anywhere", options.servers, False, False),
        (f"{options.servers} servers, groups together", options.servers, True, False),
        (f"{options.servers} servers, a port a place", options.servers, True, True),
    ):
        seen = cost(servers, "--players", options.players, "--groups", groups, "--model", options.model, "--radius", options.radius,
                    "--vertical", 2, "--duration", options.seconds, *(["--groups-together"] if together else []), places=places)
        say(f"{groups:>4} groups, {name:<26}{seen['cpu']:>8.2f}{1e6 * seen['cpu'] / seen['sent']:>10.1f}{seen['generated']:>11.0f}"
            f"{seen['patches']:>9.0f}{seen['sent']:>9.0f}{seen['hits']:>8.1f}{seen['p99']:>8.0f}"
            + ("" if seen["unanswered"] == 0 else f"  {seen['unanswered']:.0f} never came"))
