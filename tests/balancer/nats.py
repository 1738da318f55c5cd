"""nats-server processes with JetStream, as the hosts of a cluster of talusd have them."""

import re
import shutil
import subprocess

from farm import PATIENCE_S, TALUSD, fetch, free_port, until

STORE = "0123456789abcdef0123456789abcdef"


class Nats:
    """`count` servers that know each other, and in them the log of the world of these settings."""

    def __init__(self, folder, count, settings):
        if shutil.which("nats-server") is None:
            raise AssertionError("nats-server is not installed; ./dev deps test")
        self.processes = []
        ports = [(free_port(), free_port(), free_port()) for _ in range(count)]
        routes = ", ".join(f'"nats://127.0.0.1:{route}"' for _, route, _ in ports)
        try:
            for number, (port, route, monitor) in enumerate(ports):
                configuration = folder / f"nats-{number}.conf"
                configuration.write_text(
                    f'server_name: "nats-{number}"\nlisten: "127.0.0.1:{port}"\nhttp: "127.0.0.1:{monitor}"\n'
                    f'jetstream {{ store_dir: "{folder}/nats-{number}" }}\n'
                    f'cluster {{ name: "talus", listen: "127.0.0.1:{route}", routes: [{routes}] }}\n'
                )
                with open(folder / f"nats-{number}.log", "ab") as log:
                    self.processes.append(subprocess.Popen(["nats-server", "-c", configuration], stdout=log, stderr=log))
            for _, _, monitor in ports:
                until(lambda monitor=monitor: _healthy(monitor), "nats-server is healthy")
            urls = ",".join(f"nats://127.0.0.1:{port}" for port, _, _ in ports)
            self.settings = {"TALUS_CLUSTER_NATS": urls, "TALUS_CLUSTER_STORE": STORE}
            environment = {**settings, **self.settings}
            until(lambda: subprocess.run([TALUSD, "cluster", "init"], env=environment, capture_output=True, check=False).returncode == 0,
                  "the log is made")
        except BaseException:
            self.stop()
            raise

    def stop(self):
        for process in self.processes:
            process.terminate()
        for process in self.processes:
            process.wait(PATIENCE_S)
        self.processes = []


def _healthy(monitor):
    try:
        status, _ = fetch(f"http://127.0.0.1:{monitor}/healthz")
        leader = re.search(rb'"leader": *"[^"]', fetch(f"http://127.0.0.1:{monitor}/jsz")[1])
        return status == 200 and leader
    except OSError:
        return False
