"""The settings that compose files, manifests and units give talusd, told to a real one: it knows each, and takes them together."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import yaml

from nats_servers import ROOT, certificates
from test_compose import CLUSTER, compose

TALUSD = ROOT / os.environ.get("BUILD", "build/release") / "server/talusd"


class Settings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="talus-settings-")
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        certificates(cls.folder)
        (cls.folder / "signing_key").write_text("four and twenty letters and twenty more, 44")
        token = subprocess.run([TALUSD, "token", "--key-file", cls.folder / "signing_key", "--subject", "peers", "--rights", "read,admin",
                                "--valid", "8760h"], capture_output=True, text=True, check=True)
        (cls.folder / "peers_token").write_text(token.stdout)
        for name, copy in [("talusd.pem", "certificate.pem"), ("talusd-key.pem", "key.pem")]:
            (cls.folder / copy).write_bytes((cls.folder / name).read_bytes())
        for file in cls.folder.iterdir():
            file.chmod(0o600)

    def check(self, settings, *flags):
        here = {key: re.sub(r"^(/run/(secrets|tls|talus)|%d)/", f"{self.folder}/", str(value)) for key, value in settings.items()
                if key.startswith("TALUS_")}
        self.assertGreater(len(here), 0)
        run = subprocess.run([TALUSD, "--check-config", *flags], capture_output=True, text=True, timeout=120,
                             env={"PATH": "/usr/bin:/bin", "TALUS_DATA": str(self.folder / "data"), **here, "TALUS_LOG_FORMAT": "text"})
        said = run.stdout + run.stderr
        self.assertEqual(run.returncode, 0, said)
        for key in here:  # unknown, or wrong
            self.assertNotIn(key, said)

    def test_compose(self):
        self.check(yaml.safe_load(compose(ROOT / "docker/compose.yaml", "config").stdout)["services"]["talusd"]["environment"])
        services = yaml.safe_load(compose(CLUSTER, "config").stdout)["services"]
        for name in ["talus-0", "talus-1", "talus-2", "cluster-init"]:
            with self.subTest(name):
                self.check(services[name]["environment"])

    def test_kubernetes(self):
        for file in ["talus.yaml", "cluster/talus.yaml"]:
            for document in yaml.safe_load_all((ROOT / "docker/kubernetes" / file).read_text()):
                if document["kind"] == "ConfigMap":
                    with self.subTest(file):
                        self.check(document["data"])

    def test_systemd(self):
        text = (ROOT / "docker/systemd/cluster/talusd.conf").read_text()
        settings = dict(re.findall(r"(?m)^Environment=(\w+)=(.*)$", text))
        loaded = dict(re.findall(r"(?m)^LoadCredential=([^:]+):(.*)$", text))
        for value in settings.values():
            self.assertIn(value.removeprefix("%d/"), loaded)
        # As CLUSTER.md has the rest.
        self.check({**settings, "TALUS_CLUSTER_NATS": "tls://nats-0:4222, tls://nats-1:4222, tls://nats-2:4222",
                    "TALUS_CLUSTER_STORE": "0123456789abcdef0123456789abcdef",
                    "TALUS_CLUSTER_PEERS": "http://nats-0:4781, http://nats-1:4781, http://nats-2:4781"})

    def test_a_variable_that_talusd_does_not_know_is_found(self):
        with self.assertRaises(AssertionError):
            self.check({"TALUS_CLUSTER_NATZ": "tls://nats-0:4222"})


if __name__ == "__main__":
    unittest.main()
