#!/usr/bin/env python3
"""A cluster under editors and flying viewers, with whose processes and network random things happen, one after the other. Wants root.

Each line of its log is one of them: what, how many edits were answered meanwhile, their longest pause, and when all servers were well
again. Now and then the editors pause, and every voxel and every server's S are compared. Ends with 1 at the first thing that is wrong."""

import argparse
import collections
import json
import pathlib
import random
import signal
import statistics
import sys
import tempfile
import time

from cluster import Cluster, now, until
from farm import say

arguments = argparse.ArgumentParser(description=__doc__)
arguments.add_argument("--seconds", type=float, default=3600)
arguments.add_argument("--rate", type=float, default=400, help="edits a second")
arguments.add_argument("--viewers", type=int, default=12)
arguments.add_argument("--compare", type=float, default=240, help="seconds between comparisons of all voxels and S")
arguments.add_argument("--patience", type=float, default=300, help="seconds in which all servers must be well again")
arguments.add_argument("--only", action="append", help="this happens, and what else is named so; else all kinds do")
arguments.add_argument("--seed", type=int, default=random.randrange(1 << 32))
arguments.add_argument("--out", type=pathlib.Path)
options = arguments.parse_args()
folder = options.out or pathlib.Path(tempfile.mkdtemp(prefix="talus-chaos-"))
folder.mkdir(parents=True, exist_ok=True)
chance = random.Random(options.seed)


class Chaos:
    def __init__(self, cluster):
        self.cluster = cluster
        kinds = [(4, self.talusd_killed), (2, self.talusd_restarted), (2, self.talusd_frozen), (3, self.nats_killed), (2, self.leader_killed),
                 (2, self.nats_restarted), (2, self.nats_frozen), (1, self.two_nats_killed), (2, self.host_killed), (2, self.host_cut_off),
                 (2, self.talusd_cut_off), (2, self.nats_cut_off), (1, self.all_restarted), (3, self.empty_disk)]
        kinds = [kind for kind in kinds if not options.only or kind[1].__name__ in options.only]
        self.weights, self.kinds = zip(*kinds)
        self.started_again = 0

    def happens(self):
        """Something; returns its name and what it happened to."""
        (kind,) = chance.choices(self.kinds, self.weights)
        return kind.__name__.replace("_", " "), kind()

    def is_well(self):
        """Starts servers again that ended with 75, as another server's store is to take the place of theirs, as systemd would.
        Whoever ended otherwise has failed."""
        for server in self.cluster.servers:
            status = server.process.poll()
            if status == 75:
                self.cluster.launch(server)
                self.started_again += 1
            elif status is not None:
                raise AssertionError(f"{server.name} ended with {status}")
        for nats in self.cluster.nats.servers:
            if nats.process.poll() is not None:
                raise AssertionError(f"{nats.name} ended with {nats.process.poll()}")
        return self.cluster.is_well()

    def a_server(self):
        return chance.choice(self.cluster.servers)

    def a_nats(self):
        return chance.choice(self.cluster.nats.servers)

    def wait(self, least, most):
        time.sleep(chance.uniform(least, most))

    def talusd_killed(self):
        server = self.a_server()
        self.cluster.kill(server)
        self.wait(0, 5)
        self.cluster.launch(server)
        return server.name

    def talusd_restarted(self, server=None):
        server = server or self.a_server()
        server.signal(signal.SIGTERM)
        status = server.wait()
        if status != 0:
            raise AssertionError(f"{server.name} ended with {status} after SIGTERM")
        self.cluster.launch(server)
        return server.name

    def talusd_frozen(self):
        return self._freeze(self.a_server())

    def nats_killed(self, nats=None):
        nats = nats or self.a_nats()
        self.cluster.kill(nats)
        self.wait(0, 10)
        nats.start()
        return nats.name

    def leader_killed(self):
        return self.nats_killed(self.cluster.nats.leader())

    def nats_restarted(self):
        nats = self.a_nats()
        nats.stop()
        self.wait(0, 5)
        nats.start()
        return nats.name

    def nats_frozen(self):
        return self._freeze(self.a_nats())

    def two_nats_killed(self):
        two = chance.sample(self.cluster.nats.servers, 2)
        for nats in two:
            self.cluster.kill(nats)
        self.wait(0, 10)
        for nats in two:
            nats.start()
        return " ".join(nats.name for nats in two)

    def host_killed(self):
        server, nats = self.a_server(), self.a_nats()
        self.cluster.kill(server)
        self.cluster.kill(nats)
        self.wait(0, 10)
        nats.start()
        self.cluster.launch(server)
        return f"{server.name} {nats.name}"

    def host_cut_off(self):
        return self._cut(self.a_server(), self.a_nats())

    def talusd_cut_off(self):
        return self._cut(self.a_server())

    def nats_cut_off(self):
        return self._cut(self.a_nats())

    def all_restarted(self):
        for server in self.cluster.servers:
            self.talusd_restarted(server)
            until(lambda: self.cluster.farm.state(server) == "UP", f"{server.name} is up again for HAProxy")
        return "one after the other"

    def empty_disk(self):
        server = self.a_server()
        self.cluster.kill(server)
        self.cluster.empty(server)
        self.cluster.launch(server)
        return server.name

    def _freeze(self, process):
        self.cluster.freeze(process)
        self.wait(1, 15)
        self.cluster.thaw(process)
        return process.name

    def _cut(self, *hosts):
        self.cluster.network.cut([host.name for host in hosts])
        self.wait(5, 20)
        self.cluster.network.heal()
        return " ".join(host.name for host in hosts)


class EditProgress:
    """Of editors: how many of their edits were answered, and how long none was, at most, since this was forgotten."""

    def __init__(self, editors):
        self.editors, self.longest_s = editors, 0.0

    def done(self):
        """By each program."""
        figures = [each.figures() for each in self.editors]
        self.longest_s = max(self.longest_s, *(each["longest_pause_ms"] / 1000 for each in figures))
        return [each["done"] for each in figures]

    def forget(self):
        self.done()
        self.longest_s = 0.0


with Cluster(folder) as cluster:
    say(f"{now()} seed {options.seed}")
    tail = cluster.tail()
    editors = [cluster.editors("--editors", 6, "--lanes", 8, "--rate", 0.8 * options.rate, "--seed", options.seed),
               cluster.editors("--editors", 4, "--lanes", 8, "--rate", 0.2 * options.rate, "--seed", options.seed, "--place", 1,
                               servers=[cluster.farm])]
    viewers = cluster.viewers("all", cluster.address_of(cluster.farm), "--players", options.viewers, "--radius", 4, "--vertical", 2)
    chaos, answers = Chaos(cluster), EditProgress(editors)
    pauses, recoveries = collections.defaultdict(list), collections.defaultdict(list)
    began = compared_at = time.monotonic()
    comparisons = 0
    failures = []
    for each in editors:
        each.go()
    try:
        while not failures and time.monotonic() - began < options.seconds:
            time.sleep(chance.uniform(2, 6))
            answers.forget()
            before = answers.done()
            name, what = chaos.happens()
            over, meanwhile = time.monotonic(), answers.done()
            until(lambda: chaos.is_well() and all(now_ > then for now_, then in zip(answers.done(), meanwhile)),
                  f"all servers are well and edits flow after '{name}' ({what})", options.patience)
            recovery, pause, done = time.monotonic() - over, answers.longest_s, sum(answers.done()) - sum(before)
            pauses[name].append(pause)
            recoveries[name].append(recovery)
            say(f"{now()} {name} ({what}): {done} edits, longest pause {pause:.1f} s, all well {recovery:.1f} s after")
            failures = [mistake["what"] for each in editors for mistake in each.mistakes if "what" in mistake]
            if tail.unlike:
                failures.append("servers say that S differs")
            if time.monotonic() - compared_at > options.compare:
                wrong, revision = cluster.agreed(editors)
                failures += wrong
                comparisons += 1
                compared_at = time.monotonic()
                say(f"{now()} revision {revision}: every voxel and S on all servers compared; {'wrong' if wrong else 'right'}")
                for each in editors:
                    each.go()
    except AssertionError as failure:
        failures.append(f"{failure}; /-/ready: {', '.join(f'{server.name} {server.ready_text()}' for server in cluster.servers if server.process.poll() is None)}")
    if not failures:
        wrong, revision = cluster.agreed(editors)
        failures += wrong
        comparisons += 1
    seconds = time.monotonic() - began
    figures = [each.figures() for each in editors]
    seen = viewers.stop()
    if seen["wrong"] or seen["unanswered"]:
        failures.append(f"viewers: {seen['wrong']:.0f} wrong, {seen['unanswered']:.0f} unanswered:\n{viewers.output}")

say(f"\n{now()} {seconds:.0f} s, {sum(map(len, pauses.values()))} things happened, seed {options.seed}")
say(f"{'':20}{'times':>6}{'longest pause of edits: median':>32}{'most':>8}{'well again after: median':>26}{'most':>8}")
for name in sorted(pauses):
    say(f"{name:20}{len(pauses[name]):>6}{statistics.median(pauses[name]):>30.1f} s{max(pauses[name]):>6.1f} s"
        f"{statistics.median(recoveries[name]):>24.1f} s{max(recoveries[name]):>6.1f} s")
total = {name: sum(each[name] for each in figures) for name in ("done", "revisions", "conflicts", "mistakes", "unknown", "connections_lost")}
say(f"edits: {total['done']} answered, {total['revisions']} of them changed something, {total['conflicts']} conflicts, as they had to be; "
    f"otherwise than they had to be: {total['mistakes']}, not known: {total['unknown']}; {total['connections_lost']} connections lost; "
    f"answered after {max(each['p50_ms'] for each in figures):.0f} ms (p50), {max(each['p99_ms'] for each in figures):.0f} ms (p99), "
    f"{max(each['max_ms'] for each in figures) / 1000:.1f} s (the longest)")
say(f"viewers: {seen['chunk_messages_per_s'] * seconds:.0f} messages with chunks, {seen['wrong']:.0f} wrong, {seen['unanswered']:.0f} never came, {seen['reconnects']:.0f} times reconnected")
say(f"all voxels and S of all servers compared {comparisons} times; S in the log held against another server's {tail.compared} times, {tail.unlike} unlike; "
    f"{chaos.started_again} servers ended to take another's store")
(folder / "figures.json").write_text(json.dumps({"edits": total, "pauses": pauses, "recoveries": recoveries, "viewers": seen}, indent=1))
for line in failures:
    print(f"chaos: {line}", file=sys.stderr)
sys.exit(1 if failures else 0)
