#!/usr/bin/env python3
"""Hosts of a cluster are cut from the others for a time, under editors and flying viewers on both sides: a talusd with its
nats-server, a talusd alone, a nats-server alone; the nats-server is the one that leads the log. At last the routes of a nats-server
alone, which its talusd does not see. Wants root.

Prints what went on meanwhile and how soon all was well after. Ends with 1 where an edit was answered otherwise than it had to be, is
lost or happened twice, chunks stopped, or S was not equal on all in time."""

import argparse
import json
import pathlib
import sys
import tempfile
import threading
import time

from cluster import Cluster, until
from farm import say
from nats import STORE
from nats_client import NatsClient, RefusedError, status

arguments = argparse.ArgumentParser(description=__doc__)
arguments.add_argument("--seconds", type=float, default=60)
arguments.add_argument("--only", action="append", choices=["both", "talusd", "nats", "routes"], help="of the four cuts; may be given again")
arguments.add_argument("--rate", type=float, default=200, help="edits a second on each side")
arguments.add_argument("--viewers", type=int, default=4, help="at each talusd")
arguments.add_argument("--well-s", type=float, default=5, help="until S is equal on all, after the cut")
arguments.add_argument("--chunks-s", type=float, default=2, help="in which viewers at each server must get chunks")
arguments.add_argument("--seed", type=int, default=1)
arguments.add_argument("--out", type=pathlib.Path)
options = arguments.parse_args()
folder = options.out or pathlib.Path(tempfile.mkdtemp(prefix="talus-partitions-"))
folder.mkdir(parents=True, exist_ok=True)
failures = []


class Bare(threading.Thread):
    """A client of one nats-server with nothing of talusd: after which time the message of that number can be read there, of any
    replica and of the log's leader, and one would be stored that is published. It is for a stream of another name, which the leader
    refuses before its replicas hear of it."""

    def __init__(self, nats, sequence):
        super().__init__(daemon=True)
        self.nats, self.sequence, self.began = nats, sequence, time.monotonic()
        self.read_s = self.led_s = self.published_s = None
        self.ended = threading.Event()
        self.start()

    def run(self):
        while None in (self.published_s, self.led_s, self.read_s) and not self.ended.is_set():
            try:
                with NatsClient(self.nats.port, host=self.nats.address, timeout=0.5) as client:
                    while not self._reads(client) and not self.ended.wait(0.02):
                        pass
                    while not self._hears_leader(client) and not self.ended.wait(0.02):
                        pass
                    while not self._publishes(client) and not self.ended.wait(0.02):
                        pass
            except (OSError, RefusedError):  # nothing within half a second, or no server: asked again, as talusd does
                self.ended.wait(0.02)

    def end(self):
        """Gives it a minute, and returns what it could not do, if anything."""
        self.join(60)
        self.ended.set()
        self.join(10)
        if self.published_s is not None:
            return []
        return [f"a client with nothing of talusd could not {'read' if self.read_s is None else 'publish'} at {self.nats.name} for a minute"]

    def _reads(self, client):
        if self.read_s is not None:
            return True
        head, _ = client.request(f"$JS.API.DIRECT.GET.TALUS_{STORE}", b'{"seq":%d}' % self.sequence)
        if status(head) is None:
            self.read_s = time.monotonic() - self.began
        return self.read_s is not None

    def _hears_leader(self, client):
        if self.led_s is not None:
            return True
        _, answer = client.request(f"$JS.API.STREAM.MSG.GET.TALUS_{STORE}", b'{"seq":%d}' % self.sequence)
        if json.loads(answer or b"{}").get("message"):
            self.led_s = time.monotonic() - self.began
        return self.led_s is not None

    def _publishes(self, client):
        if self.published_s is not None:
            return True
        _, answer = client.request(f"talus.{STORE}.log", headers={"Nats-Expected-Stream": "none"})
        if json.loads(answer or b"{}").get("error", {}).get("err_code") == 10060:  # another stream is expected
            self.published_s = time.monotonic() - self.began
        return self.published_s is not None


def seconds(value):
    return "never" if value is None else f"{value:.2f} s"


class Chunks:
    """Whether each server goes on sending them."""

    def __init__(self, cluster):
        self.cluster = cluster
        self.sent, self.since = cluster.chunks_sent(), [time.monotonic()] * cluster.count
        self.longest = [0.0] * cluster.count

    def check(self):
        for number, sent in enumerate(self.cluster.chunks_sent()):
            if sent != self.sent[number]:
                self.sent[number], self.since[number] = sent, time.monotonic()
            self.longest[number] = max(self.longest[number], time.monotonic() - self.since[number])


def cut(cluster, name, talusd, nats, sides, tail):
    cut_off = [each.name for each in (talusd, nats) if each is not None]
    chunks = Chunks(cluster)
    before = [side.figures() for side in sides]
    cluster.network.cut(cut_off)
    began = time.monotonic()
    while time.monotonic() - began < options.seconds:
        time.sleep(0.25)
        chunks.check()
    texts = {server.name: server.ready_text() for server in cluster.servers}
    during = [side.figures() for side in sides]
    metrics = [server.metrics() for server in cluster.servers]
    sequence = max(each["talus_cluster_sequence"] for each in metrics)
    revision = max(each["talus_edits_revision"] for each in metrics)
    cluster.network.heal()
    healed = time.monotonic()
    bare = [Bare(each, int(sequence)) for each in cluster.nats.servers]

    def after():
        return time.monotonic() - healed

    def equal():
        """Each has an S that another has too, or has said, at a revision not before the end of the cut."""
        states = cluster.states()
        return all(mine[0] >= revision and (states.count(mine) == cluster.count or tail.said(mine[0]) == mine[1]) for mine in states)

    begins_after = None

    def caught_up_all():
        nonlocal begins_after
        now_ = [server.metrics()["talus_cluster_sequence"] for server in cluster.servers]
        if begins_after is None and min(now_) > min(each["talus_cluster_sequence"] for each in metrics):
            begins_after = after()
        return min(now_) >= sequence

    until(caught_up_all, "all have what there was", beat_s=0.02)
    caught_up = after()
    until(equal, "S is equal on all", beat_s=0.02)
    equal_after = after()
    until(cluster.is_well, "all are ready and have the quorum", beat_s=0.02)
    well = after()
    chunks.check()
    stuck = [line for each in bare for line in each.end()]
    differs = sum(server.metrics()["talus_cluster_state_differs"] for server in cluster.servers)
    wrong, revision = cluster.agreed(sides)
    say(f"{name}: {' and '.join(cut_off)} cut off for {options.seconds:.0f} s")
    for side, then, now_ in zip(("their side" if talusd else "all", "the other side"), before, during):
        say(f"  {side}: {now_['done'] - then['done']} edits answered meanwhile, longest pause {now_['longest_pause_ms'] / 1000:.1f} s")
    say(f"  longest without chunks: {', '.join(f'{server.name} {longest:.1f} s' for server, longest in zip(cluster.servers, chunks.longest))}")
    for server, text in texts.items():
        say(f"  {server} /-/ready at the end: {text}")
    say(f"  after it: the last begins to catch up after {seconds(begins_after)}, all have what was in the log after {caught_up:.2f} s, "
        f"an equal S after {equal_after:.2f} s, take edits after {well:.2f} s")
    say(f"  a client with nothing of talusd has that after {', '.join(f'{seconds(each.read_s)} at {each.nats.name}' for each in bare)}, of the leader after "
        f"{', '.join(seconds(each.led_s) for each in bare)}, and publishes after "
        f"{', '.join(seconds(each.published_s) for each in bare)}")
    say(f"  then every server has all voxels as acknowledged, one revision an edit ({revision}), and one S: {'no' if wrong else 'yes'}")
    wrong.extend(stuck)
    if differs or tail.unlike:
        wrong.append("servers have said that S differs")
    if equal_after > options.well_s:
        wrong.append(f"S was equal on all {equal_after:.1f} s after the cut, over {options.well_s} s")
    if max(chunks.longest) > options.chunks_s:
        wrong.append(f"no chunk for {max(chunks.longest):.1f} s, over {options.chunks_s} s")
    failures.extend(f"{name}: {line}" for line in wrong)
    for side in sides:
        side.go()


def cut_routes(cluster, talusd, sides):
    """Of the nats-server to which this talusd is connected, that to the other nats-servers alone: the talusd reaches all of them."""
    nats = next(each for each in cluster.nats.servers if each.serves(cluster.network.inner(talusd.name)))
    before = sides[0].figures()
    cluster.network.silence(nats.name, [each.route for each in cluster.nats.servers])
    began = time.monotonic()
    time.sleep(options.seconds)
    between = sides[0].figures()
    until(lambda: sides[0].figures()["done"] > between["done"], "edits flow", 60)
    flow = time.monotonic() - began
    cluster.network.let_hear(nats.name)
    until(cluster.is_well, "all are ready and have the quorum")
    wrong, revision = cluster.agreed(sides)
    say(f"a nats-server's routes: {nats.name} cut off from the other nats-servers, {talusd.name} from none")
    say(f"  {talusd.name}'s side: {between['done'] - before['done']} edits answered in {options.seconds:.0f} s, longest pause "
        f"{between['longest_pause_ms'] / 1000:.1f} s; they flow {flow:.1f} s after")
    say(f"  then every server has all voxels as acknowledged, one revision an edit ({revision}), and one S: {'no' if wrong else 'yes'}")
    failures.extend(f"routes: {line}" for line in wrong)
    for side in sides:
        side.go()


with Cluster(folder) as cluster:
    tail = cluster.tail()
    common = ["--editors", 4, "--lanes", 8, "--rate", options.rate, "--alone", "--seed", options.seed]
    sides = [cluster.editors(*common, "--place", 0, servers=cluster.servers[:1]), cluster.editors(*common, "--place", 1, servers=cluster.servers[1:])]
    viewers = [cluster.viewers(server.name, cluster.address_of(server), "--players", options.viewers, "--radius", 4, "--vertical", 2, "--seed", number)
               for number, server in enumerate(cluster.servers)] if options.viewers else []
    until(lambda: all(players > options.viewers for players in cluster.farm.players()), "viewers are there")
    for side in sides:
        side.go()
    time.sleep(3)
    cuts = {
        "both": lambda: cut(cluster, "a talusd with its nats-server", cluster.servers[0], cluster.nats.leader(), sides, tail),
        "talusd": lambda: cut(cluster, "a talusd alone", cluster.servers[0], None, sides, tail),
        "nats": lambda: cut(cluster, "a nats-server alone", None, cluster.nats.leader(), sides, tail),
        "routes": lambda: cut_routes(cluster, cluster.servers[0], sides),
    }
    for name in options.only or cuts:
        cuts[name]()
        time.sleep(3)
    for each in viewers:
        seen = each.stop()
        if seen["wrong"] or seen["unanswered"] or seen["disconnects"]:
            failures.append(f"viewers: {seen['wrong']:.0f} wrong, {seen['unanswered']:.0f} unanswered, {seen['disconnects']:.0f} disconnected:\n{each.output}")
    say(f"S of one server held against another's {tail.compared} times: {tail.unlike} unlike")
for line in failures:
    print(f"partitions: {line}", file=sys.stderr)
sys.exit(1 if failures else 0)
