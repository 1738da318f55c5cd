"""A cluster to be broken: three nats-servers, three talusd and HAProxy, each on a host of its own (network.py), editors and
viewers. What talusd and HAProxy are told is what ships, but for rates of one address."""

import concurrent.futures
import json
import pathlib
import shutil
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "balancer"))

import farm as farms  # noqa: E402
from farm import TALUSD, Farm, Server, load, until  # noqa: E402
from nats import STORE, Nats, NatsServer  # noqa: E402

from editors import Editors  # noqa: E402
from log_reader import Tail  # noqa: E402
from network import Network  # noqa: E402

SETTINGS = {
    "TALUS_WORLD": str(farms.ROOT / "core/worlds/classic.toml"),
    "TALUS_THREADS_IO": "1",
    "TALUS_THREADS_GENERATOR": "1",
    "TALUS_ACCESS_WITHOUT_TOKEN": "read,edit",
    "TALUS_SHUTDOWN_LEAD_MS": "3000",
    "TALUS_SHUTDOWN_DRAIN_MS": "3000",
    "TALUS_RATES_SESSION_VOXELS": "0",
    "TALUS_RATES_ADDRESS_VOXELS": "0",
    "TALUS_RATES_SESSION_REQUESTS": "0",
}


class Cluster:
    def __init__(self, folder, count=3, settings=None):
        self.folder = pathlib.Path(folder)
        self.network = Network([f"{kind}-{number}" for kind in ("nats", "talus") for number in range(count)])
        self.settings = {**SETTINGS, **(settings or {})}
        self.nats = self.farm = None
        self.count = count
        self.frozen = []
        self._to_end = []  # editors and viewers

    def __enter__(self):
        signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # all that runs is ended then, too
        self.network.__enter__()
        try:
            self._secrets()
            talus_0 = self.network.command("talus-0")  # from where the nats-servers are reached
            self.nats = Nats(self.folder, self.count, self.settings, make=self._make_nats, command=talus_0)
            self.farm = Farm(self.folder, self.count, self._of_server, make=self._make_server, proxy=self.network.balancer)
            peers = ",".join(f"http://{self.network.inner(server.name)}:{server.admin}" for server in self.servers)
            for server in self.servers:
                server.environment["TALUS_CLUSTER_PEERS"] = peers
                self.launch(server)
            for server in self.servers:
                until(server.is_ready, f"{server.name} is ready")
            self.farm.start_haproxy()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        for process in self.frozen:
            process.signal(signal.SIGCONT)
        for each in self._to_end:
            each.stop()
        if self.farm is not None:
            self.farm.stop()
        if self.nats is not None:
            self.nats.stop()
        self.network.__exit__()

    @property
    def servers(self):
        return self.farm.servers

    def _secrets(self):
        key, token = self.folder / "key", self.folder / "peers_token"
        key.write_text("0123456789abcdef0123456789abcdef\n")
        made = subprocess.run([TALUSD, "token", "--key-file", key, "--subject", "peers", "--rights", "read,admin", "--valid", "24h"],
                              capture_output=True, text=True, check=True)
        token.write_text(made.stdout)
        for path in (key, token):
            path.chmod(0o600)
        self.settings |= {"TALUS_ACCESS_SIGNING_KEY_FILE": str(key), "TALUS_CLUSTER_PEERS_TOKEN_FILE": str(token),
                          "TALUS_PROXIES": self.network.balancer}

    def _of_server(self, number):
        return {**self.settings, **self.nats.settings, "TALUS_DATA": str(self.folder / f"data-{number}")}

    def _make_nats(self, name, folder):
        return NatsServer(name, folder, self.network.address(name), self.network.inner(name), self.network.command(name))

    def _make_server(self, name, folder, settings):
        return Server(name, folder, settings, self.network.address(name), self.network.command(name))

    def launch(self, server):
        server.launch(listen="0.0.0.0")

    def data_of(self, server):
        return pathlib.Path(server.environment["TALUS_DATA"])

    def number_of(self, server):
        """Upper half of the publisher in what it says in the log."""
        return int((self.data_of(server) / "server_number").read_text(), 16)

    def address_of(self, server):
        return f"{server.address}:{server.port}"

    def editors(self, *arguments, servers=None):
        these = [self.address_of(server) for server in servers or self.servers]
        made = Editors(these, self.folder / "editors.log", *arguments)
        self._to_end.append(made)
        return made

    def viewers(self, name, address, *arguments):
        made = Viewers(self.folder / f"viewers-{name}", address, *arguments)
        self._to_end.append(made)
        return made

    def tail(self, heard=None, with_edits=False):
        made = Tail(self.nats.servers, STORE, heard, with_edits)
        made.start()
        made.subscribed.wait(farms.PATIENCE_S)
        self._to_end.append(made)
        return made

    def is_well(self, at_one_place=False):
        """Whether all servers are ready, with the log's quorum; `at_one_place`: and equally far, which wants that nobody edits."""
        try:
            metrics = [server.metrics() for server in self.servers if server.ready() == 200]
        except OSError:
            return False
        return (len(metrics) == self.count and all(each["talus_cluster_quorum"] == 1 for each in metrics)
                and (not at_one_place or len({each["talus_cluster_sequence"] for each in metrics}) == 1))

    def states(self):
        """Revision and S of each server, by reading all that it stores."""
        def stat(server):
            done = subprocess.run([TALUSD, "store", "stat", "--json", "--data", self.data_of(server)], capture_output=True, text=True,
                                  check=False)
            if done.returncode != 0:
                raise AssertionError(f"{server.name}: {done.stderr}")
            said = json.loads(done.stdout)
            return said["revision"], said["hash"]

        with concurrent.futures.ThreadPoolExecutor() as pool:
            return list(pool.map(stat, self.servers))

    def agreed(self, editors):
        """All edits of these editors are answered, nobody else edits: compares what every server has with that, and all servers
        with each other. Returns lines of what is wrong, and the revision."""
        paused = [each.pause() for each in editors]
        revision = sum(each["revisions"] for each in paused)
        until(lambda: self.is_well(at_one_place=True) and all(server.metrics()["talus_edits_revision"] >= revision for server in self.servers),
              "all servers have all edits")
        wrong = [f"{each['mistakes']} mistakes, {each['unknown']} unknown: {each['first_mistake']}" for each in paused
                 if each["mistakes"] or each["unknown"]]
        states = self.states()
        if len(set(states)) != 1:
            wrong.append(f"the servers' revision and S differ: {states}")
        if states[0][0] != revision:
            wrong.append(f"{revision} edits changed something, and the servers are at revision {states[0][0]}")
        for server in self.servers:
            for each in editors:
                voxels = each.verify(self.address_of(server))
                if voxels:
                    wrong.append(f"{server.name} has {voxels} voxels otherwise than was acknowledged")
        return wrong, revision

    def kill(self, process):
        process.signal(signal.SIGKILL)
        process.wait()

    def freeze(self, process):
        process.signal(signal.SIGSTOP)
        self.frozen.append(process)

    def thaw(self, process):
        process.signal(signal.SIGCONT)
        self.frozen.remove(process)

    def empty(self, server):
        """Its disk."""
        shutil.rmtree(self.data_of(server))

    def chunks_sent(self):
        """By each server, since it started."""
        return [server.metrics()["talus_chunks_sent_total"] for server in self.servers]


class Viewers:
    """talus-load's flying players, who verify what they get, until stop()."""

    def __init__(self, path, address, *arguments):
        self.json = path.with_suffix(".json")
        self.process = load(address, "--model", "fly", "--verify", 2, "--duration", 86000, "--drain", 60, *arguments, json_file=self.json)
        self.output = None

    def stop(self):
        """What they saw."""
        if self.output is None:
            self.process.terminate()
            self.output, _ = self.process.communicate()
        return farms.figures(self.json)


def now():
    return time.strftime("%H:%M:%S", time.gmtime())
