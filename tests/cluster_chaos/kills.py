#!/usr/bin/env python3
"""A talusd is killed with -9 when an edit of its players is in the log and not yet answered, again and again. Wants root.

What the nats-servers say does not reach it any more; its next message with edits is awaited in the log's tail, and it is killed. Its
players go to other servers. At the end every edit must have been answered as it had to be, every server have every voxel so, one
revision an edit, and one S. Prints how often an answer had really not come; ends with 1 where something is wrong."""

import argparse
import collections
import contextlib
import pathlib
import queue
import random
import sys
import tempfile
import time

from cluster import STORE, Cluster, until
from farm import say
from log_reader import read_log

BETWEEN_PLOTS, PLOTS_IN_ROW = 20, 24  # as in editors.cpp
QUIET_S = 0.15

arguments = argparse.ArgumentParser(description=__doc__)
arguments.add_argument("--kills", type=int, default=200)
arguments.add_argument("--editors", type=int, default=6)
arguments.add_argument("--lanes", type=int, default=4)
arguments.add_argument("--rate", type=float, default=200, help="edits a second of all editors")
arguments.add_argument("--seed", type=int, default=1)
arguments.add_argument("--out", type=pathlib.Path)
options = arguments.parse_args()
folder = options.out or pathlib.Path(tempfile.mkdtemp(prefix="talus-kills-"))
folder.mkdir(parents=True, exist_ok=True)
chance = random.Random(options.seed)

wrong = []
killed = []  # publisher; connections that broke since
with Cluster(folder) as cluster:
    heard = queue.SimpleQueue()
    tail = cluster.tail(heard.put, with_edits=True)
    editors = cluster.editors("--editors", options.editors, "--lanes", options.lanes, "--rate", options.rate, "--seed", options.seed)
    editors.go()
    began = time.monotonic()
    while len(killed) < options.kills:
        time.sleep(chance.uniform(0.05, 0.3))
        victim = chance.choice([server for server in cluster.servers if server.players() > 0])
        number = cluster.number_of(victim)
        while not heard.empty():
            heard.get()
        cluster.network.deafen(victim.name, [nats.port for nats in cluster.nats.servers])
        # One message is in flight at a time: the last one that is heard is not acknowledged, or the next would come.
        batch = None
        with contextlib.suppress(queue.Empty):
            quiet = time.monotonic() + QUIET_S
            while time.monotonic() < quiet:
                each = heard.get(timeout=QUIET_S)
                if each.publisher >> 32 == number and each.edits:
                    batch, quiet = each, time.monotonic() + QUIET_S
        if batch is None:  # its players do nothing just now
            cluster.network.let_hear(victim.name)
            continue
        before = len(editors.lost)
        cluster.kill(victim)
        cluster.network.let_hear(victim.name)
        until(lambda: len(editors.lost) > before, "players lose their connection")
        cluster.launch(victim)
        until(cluster.is_well, "all servers are well again")
        killed.append((batch.publisher, editors.lost[before:]))
        if len(killed) % 20 == 0:
            say(f"{len(killed)} kills after {time.monotonic() - began:.0f} s")
    wrong, revision = cluster.agreed([editors])
    seen = editors.figures()
    log = read_log(cluster.nats.leader(), STORE)
    wrong += [f"{tail.unlike} times servers said another S"] if tail.unlike else []

# By the places where they build, the edits of each editor in the log. Those up to the last message of a server that was killed,
# beyond what was answered, were published and not answered.
corner = editors.joined["corner"]
of_editor = collections.defaultdict(dict)  # of each edit, the first place in the log
last_message = {}
for place, batch in enumerate(log):
    for edit in batch.edits if batch is not None else ():
        x, z = ((edit.voxel[axis] - corner[axis]) // BETWEEN_PLOTS for axis in (0, 2))
        of_editor[(z * PLOTS_IN_ROW + x) // options.lanes].setdefault((edit.editor, edit.sequence), place)
        last_message[batch.publisher] = place
aimed = doubtful = 0
for publisher, lost in killed:
    unanswered = sum(max(0, sum(place <= last_message[publisher] for place in of_editor[each["editor"]].values()) - each["done"])
                     for each in lost)
    doubtful += unanswered
    aimed += unanswered > 0

say(f"{len(killed)} kills; at {aimed} of them edits were in the log and not answered, {doubtful} in all")
say(f"{seen['done']} edits answered ({seen['conflicts']} of them conflicts, as they had to be), {seen['unknown']} not known, {seen['mistakes']} mistakes; "
    f"{seen['connections_lost']} connections lost; revision {revision}")
say(f"S of one server held against another's {tail.compared} times: {tail.unlike} unlike")
for line in wrong:
    print(f"kills: {line}", file=sys.stderr)
sys.exit(1 if wrong else 0)
