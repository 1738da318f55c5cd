"""nats-server processes with JetStream, as the hosts of a cluster of talusd have them."""

import json
import shutil
import subprocess

from farm import PATIENCE_S, TALUSD, fetch, free_port, until

STORE = "0123456789abcdef0123456789abcdef"


class NatsServer:
    """A nats-server that may be ended and started again, on the same ports. It is reached at `address`, by the others and by
    talusd at `inner`; `command` goes before its own, to start it elsewhere."""

    def __init__(self, name, folder, address="127.0.0.1", inner=None, command=()):
        if shutil.which("nats-server") is None:
            raise AssertionError("nats-server is not installed; ./dev deps test")
        self.name, self.folder, self.log = name, folder, folder / f"{name}.log"
        self.address, self.inner, self.command = address, inner or address, list(command)
        self.port, self.route, self.monitor = free_port(), free_port(), free_port()
        self.url = f"nats://{self.inner}:{self.port}"
        self.process = None

    def configure(self, servers):
        """As one of these. What is not an address is as in docker/nats/nats-server.conf."""
        routes = ", ".join(f'"nats://{server.inner}:{server.route}"' for server in servers)
        listen = self.inner if self.inner == self.address else "0.0.0.0"
        (self.folder / f"{self.name}.conf").write_text(
            f'server_name: "{self.name}"\nlisten: "{listen}:{self.port}"\nhttp: "{self.address}:{self.monitor}"\n'
            f'jetstream {{ store_dir: "{self.folder}/{self.name}", max_memory_store: 0, max_file_store: 40GB }}\n'
            f'cluster {{ name: "talus", listen: "{self.inner}:{self.route}", routes: [{routes}], no_advertise: true }}\n'
            'max_payload: 1MB\nping_interval: "5s"\nping_max: 2\n'
        )

    def start(self):
        with open(self.log, "ab") as log:
            self.process = subprocess.Popen([*self.command, "nats-server", "-c", self.folder / f"{self.name}.conf"], stdout=log,
                                            stderr=log)

    def is_healthy(self):
        try:
            return fetch(f"http://{self.address}:{self.monitor}/healthz", timeout_s=2)[0] == 200 and self.page("/jsz")["meta_cluster"]["leader"]
        except (OSError, ValueError, KeyError):
            return False

    def page(self, path):
        return json.loads(fetch(f"http://{self.address}:{self.monitor}{path}", timeout_s=2)[1])

    def serves(self, address):
        """Whether somebody from there is connected."""
        return any(each["ip"] == address for each in self.page("/connz")["connections"])

    def leads(self, stream):
        """Whether it says that it leads it: only the leader's word counts."""
        try:
            streams = [each for account in self.page("/jsz?streams=true").get("account_details", [])
                       for each in account.get("stream_detail", [])]
        except (OSError, ValueError):
            return False
        return any(each["name"] == stream and each.get("cluster", {}).get("leader") == self.name for each in streams)

    def signal(self, number):
        self.process.send_signal(number)

    def wait(self):
        return self.process.wait(PATIENCE_S)

    def stop(self):
        if self.process is not None and self.process.poll() is None:
            self.process.terminate()
            self.process.wait(PATIENCE_S)


class Nats:
    """`count` servers that know each other, and in them the log of the world of these settings. `make`: makes a server of its
    name and folder."""

    def __init__(self, folder, count, settings, make=NatsServer, store=STORE, command=()):
        self.servers = [make(f"nats-{number}", folder) for number in range(count)]
        self.stream = f"TALUS_{store}"
        try:
            for server in self.servers:
                server.configure(self.servers)
                server.start()
            for server in self.servers:
                until(server.is_healthy, "nats-server is healthy")
            urls = ",".join(server.url for server in self.servers)
            self.settings = {"TALUS_CLUSTER_NATS": urls, "TALUS_CLUSTER_STORE": store}
            environment = {**settings, **self.settings}
            init = [*command, TALUSD, "cluster", "init"]
            until(lambda: subprocess.run(init, env=environment, capture_output=True, check=False).returncode == 0, "the log is made")
        except BaseException:
            self.stop()
            raise

    def leader(self):
        """The server that leads the log; None: there is none just now."""
        return next((server for server in self.servers if server.process.poll() is None and server.leads(self.stream)), None)

    def stop(self):
        for server in self.servers:
            if server.process is not None and server.process.poll() is None:
                server.process.terminate()
        for server in self.servers:
            server.stop()
