#!/usr/bin/env python3
"""A million players on paper: what docs/MILLION.md says of them, computed and simulated. Debian's python3 with numpy.

    tests/load/million.py            prints every table
    tests/load/million.py --check    compares them with those of docs/MILLION.md

All that was measured is in MEASURED, with where; all that is only supposed in SUPPOSED. Change a line and see what breaks first.
"""

import heapq
import pathlib
import sys

import numpy

MEASURED = {
    "cores_per_player": 0.74e-3,        # 1,000 loners: 26.3 thousand messages/s at 28.2 us (SPEED.md, Players who share nothing)
    "default_world_factor": 4.1,        # a cold View of the default world to one of classic.toml: 0.23 s to 0.056 (README)
    "flight_bits": 0.10e6,              # a near View in flight, bit/s (SPEED.md, A horizon)
    "own_land_cores": 0.22e-3,          # 1,000 players who make their land: 6.56 s of processor time in 30 (SPEED.md, Players who share nothing)
    "own_land_bits": 46 * 8,            # such a player in flight, bit/s (there)
    "horizon_bits": 0.28e6,             # the same with a horizon
    "join_bytes": 0.89e6,               # a View with a horizon, from nothing
    "edit_seconds": 9e-6,               # of processor time in the log, apply and record (SPEED.md, Edits)
    "override_bytes": 12,               # on disk: a checkpoint of 1 M overrides has 4 to 20 MB (design)
    "index_bytes": 512 << 20,           # the index of edited chunks may take (OPERATIONS.md, Memory)
    "chunk_index_bytes": 24 + 160 / 1.5 + 128 / 100,  # a chunk, its column, its region (the same), 1.5 chunks a column
    "editors": 65536,                   # who may have edited within a day (OPERATIONS.md)
    "log_messages": 10_000,             # a second of one stream of 3 replicas on 2 cores: a message an edit had p99 216 ms there (design)
    "log_seconds": 0.7e-3,              # a message's way through an idle log: 3 replicas, loopback, ack p50 0.9 ms (design)
}
SUPPOSED = {
    "players_per_server": 1000,
    "edits_per_player": 0.05,           # a second: one of ten builds, an edit every two seconds
    "entry_bytes": 120,                 # of an edit in the log: editor, sequence, operation, ground as generated
    "chunks_edited_per_player": 40,     # ever
    "overrides_per_player": 10_000,     # ever
    "builders_per_day": 0.5,            # of the players who are there at the busiest hour, as many build within a day
    "nats_hosts": 3,
    "host_bytes": 1.25e9,               # a second: 10 Gbit/s
    "balancer_players": 50_000,         # connections of one HAProxy, at half of the shipped maxconn
}
M, P = MEASURED, SUPPOSED


def edits(players):
    return players * P["edits_per_player"]


def fan_out(players):
    """Bytes a second that NATS sends: every server hears every edit."""
    return edits(players) * P["entry_bytes"] * players / P["players_per_server"]


def costs():
    rows = []
    for players in [1_000, 10_000, 100_000, 1_000_000]:
        servers = players / P["players_per_server"]
        rows.append([f"{players:,}", f"{servers:,.0f}", f"{players * M['cores_per_player']:,.1f}",
                     f"{players * M['cores_per_player'] * M['default_world_factor']:,.0f}",
                     f"{players * M['own_land_cores']:,.1f}", f"{edits(players) * M['edit_seconds']:.4f}",
                     f"{servers * edits(players) * M['edit_seconds']:,.1f}", f"{players * M['horizon_bits'] / 1e9:,.1f}", f"{players * M['own_land_bits'] / 1e9:,.3f}",
                     f"{fan_out(players) * 8 / 1e9:,.3f}", f"{players * P['overrides_per_player'] * M['override_bytes'] / 1e9:,.2f}"])
    return ["players", "servers", "land cores, classic", "default", "made by players", "edit cores, each", "all", "sent, Gbit/s",
            "made by players",             "NATS, Gbit/s", "store, GB"], rows


def breaks():
    """(players, what): where each thing is used up."""
    per = P["players_per_server"]
    found = [
        (M["editors"] / P["builders_per_day"], "65,536 editors a day: further ones may not build"),
        (M["index_bytes"] / M["chunk_index_bytes"] / P["chunks_edited_per_player"], "512 MiB for the index of edited chunks: only those may be edited"),
        (P["balancer_players"], "one HAProxy: the next one beside it, by DNS"),
        (M["log_messages"] / P["edits_per_player"], "one log's messages: from here on edits share them, and acknowledgements take longer with each server"),
        ((P["nats_hosts"] * P["host_bytes"] * per / (P["edits_per_player"] * P["entry_bytes"])) ** 0.5, "3 NATS hosts of 10 Gbit/s: every edit to every server"),
        (M["cores_per_player"] * per / (P["edits_per_player"] * M["edit_seconds"]), "a server takes longer for all edits than for its own players' land (classic)"),
        (M["own_land_cores"] * per / (P["edits_per_player"] * M["edit_seconds"]), "a server takes longer for all edits than for players who make their land"),
        (1 / (M["edit_seconds"] * P["edits_per_player"]), "the one thread that applies edits"),
    ]
    return ["players", "what is used up"], [[f"{players:,.0f}", what] for players, what in sorted(found)]


def log(servers, edits_per_second, random, seconds=4.0):
    """One log, each server with one message in flight that takes all that waits: waits of edits for their acknowledgement."""
    service = 1 / M["log_messages"]
    each = edits_per_second / servers
    arrivals = [numpy.cumsum(random.exponential(1 / each, max(4, int(each * seconds * 1.2) + 20))) for _ in range(servers)]
    sent = [0] * servers
    events = [(times[0], server) for server, times in enumerate(arrivals)]  # when a server may send next
    heapq.heapify(events)
    free_at, waits, messages = 0.0, [], 0
    while events:
        now, server = heapq.heappop(events)
        if now > seconds:
            continue
        times = arrivals[server]
        first = sent[server]
        last = min(int(numpy.searchsorted(times, now, side="right")), first + 1024)
        if last == first:
            if first < len(times):
                heapq.heappush(events, (float(times[first]), server))
            continue
        free_at = max(free_at, now) + service
        acked = free_at + M["log_seconds"]
        if now > seconds / 4:  # from when the queue is as it stays
            waits.append(acked - times[first:last])
            messages += 1
        sent[server] = last
        heapq.heappush(events, (acked, server))
    waits = numpy.concatenate(waits) * 1e3
    return messages / (0.75 * seconds), len(waits) / messages, numpy.percentile(waits, 50), numpy.percentile(waits, 99)


def logs():
    rows = []
    for servers in [3, 10, 30, 100, 300, 1000]:
        rate = edits(servers * P["players_per_server"])
        messages, batch, p50, p99 = log(servers, rate, numpy.random.default_rng(servers))
        rows.append([f"{servers:,}", f"{rate:,.0f}", f"{messages:,.0f}", f"{batch:.1f}", f"{p50:.1f}", f"{p99:.1f}"])
    return ["servers", "edits/s", "messages/s", "edits a message", "ack p50, ms", "ack p99, ms"], rows


def places(random, players=1_000_000, towns=20_000, side=4096.0):
    """Where players are, in chunks: half of them in towns, of which the n-th has 1/n of the first's; half anywhere."""
    weights = 1 / numpy.arange(1, towns + 1)
    town = random.choice(towns, players // 2, p=weights / weights.sum())
    centres = random.uniform(0, side, (towns, 2))
    crowd = centres[town] + random.normal(0, 8, (players // 2, 2))
    return numpy.concatenate([crowd, random.uniform(0, side, (players - players // 2, 2))]) % side, side


def regions():
    """The log cut by regions of the world, each server following those that its players see: what it has to apply."""
    random = numpy.random.default_rng(1)
    at, side = places(random)
    players = len(at)
    servers = players // P["players_per_server"]
    view = 8
    rows = []
    for cut in [1, 4, 16, 64]:
        size = side / cut
        corners = [((at + numpy.array(step)) % side // size).astype(numpy.int64) for step in [(-view, -view), (-view, view), (view, -view), (view, view)]]
        seen = numpy.stack([c[:, 0] * cut + c[:, 1] for c in corners])
        own = (at // size).astype(numpy.int64)
        own = own[:, 0] * cut + own[:, 1]
        rate = numpy.bincount(own, minlength=cut * cut) * P["edits_per_player"]
        row = [f"{cut * cut:,}", f"{rate.max():,.0f}"]
        # By place: along rows of squares of 64 chunks, one way and back; as many to each server.
        squares = (at // 64).astype(numpy.int64)
        along = numpy.where(squares[:, 0] % 2 == 0, squares[:, 1], 63 - squares[:, 1])
        for order in [random.permutation(players), numpy.lexsort((along, squares[:, 0]))]:
            followed = [numpy.unique(seen[:, group]) for group in numpy.array_split(order, servers)]
            applied = numpy.array([rate[f].sum() for f in followed])
            row += [f"{numpy.mean([len(f) for f in followed]):,.0f}", f"{applied.mean():,.0f}", f"{applied.max():,.0f}"]
        rows.append(row)
    return ["logs", "busiest, edits/s", "anywhere: logs", "edits/s", "at most", "by place: logs", "edits/s", "at most"], rows


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|" + " --- |" * len(head), *("| " + " | ".join(row) + " |" for row in rows)])


def main():
    text = (pathlib.Path(__file__).resolve().parents[2] / "docs/MILLION.md").read_text() if "--check" in sys.argv[1:] else None
    wrong = []
    for name, part in [("costs", costs), ("breaks", breaks), ("logs", logs), ("regions", regions)]:
        made = table(*part())
        if text is None:
            print(f"{name}\n\n{made}\n")
        elif made not in text:
            wrong.append(name)
    if wrong:
        sys.exit(f"docs/MILLION.md has other tables than tests/load/million.py makes: {', '.join(wrong)}")


if __name__ == "__main__":
    main()
