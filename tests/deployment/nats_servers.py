"""Real nats-servers with the configuration that ships, changed in its addresses and folders alone."""

import pathlib
import re
import shutil
import socket
import subprocess
import time
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHIPPED = ROOT / "docker/nats"


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports


def certificates(folder, *hosts, **environment):
    subprocess.run([SHIPPED / "certificates.sh", folder, *hosts], check=True, stdout=subprocess.DEVNULL,
                   env={"PATH": "/usr/bin:/bin", **environment})


class NatsServer:
    def __init__(self, folder, number, ports, routes):
        self.name = f"nats-{number}"
        self.folder = folder / self.name
        self.port, self.route_port, self.monitor_port = ports
        self.environment = {"NATS_NAME": self.name, "NATS_MONITOR": f"127.0.0.1:{self.monitor_port}",
                            "PATH": "/usr/sbin:/usr/bin:/bin"}
        self.file = self.folder / "nats-server.conf"
        self.process = None
        tls = self.folder / "tls"
        tls.mkdir(parents=True, exist_ok=True)
        for source, target in [("ca.pem", "ca.pem"), (f"{self.name}.pem", "certificate.pem"), (f"{self.name}-key.pem", "key.pem")]:
            shutil.copy(folder / "tls" / source, tls / target)
        shutil.copy(SHIPPED / "permissions.conf", self.folder)
        text = (SHIPPED / "nats-server.conf").read_text()
        for old, new in [("0.0.0.0:4222", f"127.0.0.1:{self.port}"), ("0.0.0.0:6222", f"127.0.0.1:{self.route_port}"),
                         ("/etc/nats/tls", str(tls)), ("/var/lib/nats", str(self.folder / "data"))]:
            assert old in text, old
            text = text.replace(old, new)
        text, replaced = re.subn(r'"tls://nats-(\d):6222"', lambda m: f'"tls://localhost:{routes[int(m[1])]}"', text)
        assert replaced == 3
        self.file.write_text(text)

    def check(self):
        return subprocess.run(["nats-server", "-t", "-c", self.file], env=self.environment, capture_output=True, text=True)

    def start(self):
        self.log = open(self.folder / "log", "ab")
        self.process = subprocess.Popen(["nats-server", "-c", self.file], env=self.environment, stdout=self.log, stderr=self.log)

    def healthy(self):
        try:
            return urllib.request.urlopen(f"http://127.0.0.1:{self.monitor_port}/healthz", timeout=5).status == 200
        except OSError:
            return False

    def kill(self):
        if self.process:
            self.process.kill()
            self.process.wait()
            self.log.close()
            self.process = None


def start_cluster(folder):
    """Three servers that have found each other and chosen a leader."""
    certificates(folder / "tls", *(f"nats-{i},localhost" for i in range(3)))
    ports = free_ports(9)
    servers = [NatsServer(folder, i, ports[3 * i:3 * i + 3], ports[1::3]) for i in range(3)]
    for server in servers:
        server.start()
    until = time.monotonic() + 60
    while not all(server.healthy() for server in servers):
        if time.monotonic() > until or any(server.process.poll() is not None for server in servers):
            for server in servers:
                server.kill()
            raise RuntimeError("the cluster did not start:\n" + "".join((s.folder / "log").read_text()[-2000:] for s in servers))
        time.sleep(0.05)
    return servers
