"""What players on one or several talusd, without a balancer, cost their servers."""

import pathlib
import tempfile

import farm as farms
from farm import Farm, Server, figures, load, until

SETTINGS = {
    "TALUS_WORLD": str(farms.ROOT / "core/worlds/classic.toml"),
    "TALUS_THREADS_IO": "1",
    "TALUS_THREADS_GENERATOR": "1",
    "TALUS_PROXIES": "",
    "TALUS_LOG_LEVEL": "warning",
}


def cost(servers, *arguments, places=False):
    """Of so many fresh servers under talus-load with these arguments; `places`: by the ports of HAProxy for places."""
    with tempfile.TemporaryDirectory(prefix="talus-cost-") as scratch:
        folder = pathlib.Path(scratch)
        if places:
            with Farm(folder, servers, {**SETTINGS, "TALUS_PROXIES": farms.PROXY}) as farm:
                addresses = ",".join(f"127.0.0.1:{farm.places + place}" for place in range(farms.PLACES))
                return _cost(folder, farm.servers, addresses, arguments)
        alone = [Server(f"talus-{number}", folder, SETTINGS) for number in range(servers)]
        try:
            for server in alone:
                server.start()
            return _cost(folder, alone, ",".join(f"127.0.0.1:{server.port}" for server in alone), arguments)
        finally:
            for server in alone:
                server.stop()


def _cost(folder, servers, addresses, arguments):
    before = [server.metrics() for server in servers]
    process = load(addresses, "--verify", 0, "--drain", 120, "--from-addresses", 16, *arguments, json_file=folder / "load.json")
    output, _ = process.communicate()
    if process.returncode != 0:
        raise AssertionError(output)
    until(lambda: sum(server.players() for server in servers) == 0, "all have left")
    after = [server.metrics() for server in servers]
    seen = figures(folder / "load.json")

    def grown(name):
        return sum(now[name] - then[name] for then, now in zip(before, after))

    return {
        "cpu": grown("process_cpu_seconds_total"),
        "generated": grown("talus_chunks_generated_total"),
        "patches": grown("talus_patches_generated_total"),
        "sent": grown("talus_chunks_sent_total"),
        "hits": 100 * grown("talus_cache_hits_total") / max(1, grown("talus_cache_hits_total") + grown("talus_cache_misses_total")),
        "p99": seen["p99_ms"],
        "unanswered": seen["unanswered"],
    }
