#!/usr/bin/env python3
"""CPU seconds a chunk of several servers with so many players each who are alone, against one with as many, by turns. One io and
one generator thread each."""

import argparse

from cost import cost
from farm import say

arguments = argparse.ArgumentParser(description=__doc__)
arguments.add_argument("--each", type=int, default=250)
arguments.add_argument("--servers", type=int, default=4)
arguments.add_argument("--radius", type=int, default=4)
arguments.add_argument("--seconds", type=float, default=25)
arguments.add_argument("--turns", type=int, default=2)
options = arguments.parse_args()

sums = {}
for turn in range(options.turns):
    for servers in (1, options.servers):
        seen = cost(servers, "--players", servers * options.each, "--model", "walk", "--radius", options.radius, "--vertical", 2,
                    "--ramp-up", 5, "--duration", options.seconds, "--groups", servers * options.each, "--groups-together",
                    "--seed", 1 + turn)
        cpu, sent = sums.get(servers, (0, 0))
        sums[servers] = (cpu + seen["cpu"], sent + seen["sent"])
        say(f"{servers} x {options.each}: {seen['cpu']:.2f} CPU s, {seen['sent']:.0f} chunks sent, {seen['generated']:.0f} generated, "
            f"{1e6 * seen['cpu'] / seen['sent']:.2f} CPU s a million sent; p99 {seen['p99']:.0f} ms")
one, many = (cpu / sent for cpu, sent in (sums[1], sums[options.servers]))
say(f"{options.servers} servers against one: {100 * (many / one - 1):+.1f} % CPU seconds a chunk")
