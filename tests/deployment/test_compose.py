"""compose.yaml and compose.cluster.yaml: valid by docker-compose's own schema, hardened, and with nothing in them missing."""

import os
import pathlib
import subprocess
import unittest

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
CLUSTER = ROOT / "docker/compose.cluster.yaml"
STORE = "0123456789abcdef0123456789abcdef"


def compose(file, *arguments, **environment):
    return subprocess.run(["docker-compose", "-f", file, *arguments], capture_output=True, text=True,
                          env={**os.environ, "TALUS_CLUSTER_STORE": STORE, **environment})


class ComposeFiles(unittest.TestCase):
    def test_docker_compose_takes_them(self):
        for file in [ROOT / "docker/compose.yaml", CLUSTER]:
            checked = compose(file, "config", "-q")
            self.assertEqual((checked.returncode, checked.stderr), (0, ""), file)

    def test_no_store_id_is_one_line_that_says_what_to_do(self):
        refused = compose(CLUSTER, "config", "-q", TALUS_CLUSTER_STORE="")
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("set it in docker/.env to 32 hexadecimal digits", refused.stderr)


class Cluster(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.file = yaml.safe_load(compose(CLUSTER, "config").stdout)
        cls.services = cls.file["services"]

    def test_has_all_parts(self):
        wanted = {f"{name}-{i}" for name in ["nats", "nats-exporter", "talus"] for i in range(3)}
        wanted |= {"nats-volumes", "cluster-init", "haproxy", "varnish", "prometheus", "grafana"}
        self.assertEqual(set(self.services), wanted)

    def test_none_is_root_or_writes_its_image(self):
        for name, service in self.services.items():
            with self.subTest(name):
                self.assertIs(service.get("read_only"), True)
                self.assertEqual(service["cap_drop"], ["ALL"])
                if name == "nats-volumes":  # it ends before the others start
                    self.assertEqual(service["cap_add"], ["CHOWN"])
                    self.assertEqual(service["network_mode"], "none")
                    continue
                self.assertRegex(service["user"], r"^[1-9][0-9]*:[0-9]+$")
                self.assertEqual(service["security_opt"], ["no-new-privileges:true"])
                self.assertNotIn("cap_add", service)
                self.assertIsNot(service.get("privileged"), True)

    def test_health_is_asked(self):
        # talusd's is the image's; an exporter's absence is a scrape that fails.
        for name, service in self.services.items():
            with self.subTest(name):
                if service.get("image") == "talus" or name.startswith("nats-exporter") or name == "nats-volumes":
                    continue
                self.assertIn("test", service["healthcheck"])

    def test_secrets_are_files_that_the_head_of_the_file_makes(self):
        text = CLUSTER.read_text()
        made = {"ca.pem", "signing_key", "peers_token"}
        for name in ["nats-0", "nats-1", "nats-2", "talusd", "talus-admin"]:
            made |= {f"{name}.pem", f"{name}-key.pem"}
        self.assertEqual(set(self.file["secrets"]), made)
        self.assertIn("certificates.sh docker/secrets nats-0 nats-1 nats-2", text)
        for service in self.services.values():
            for key, value in service.get("environment", {}).items():
                if any(word in key for word in ["PASSWORD", "SECRET", "TOKEN", "KEY"]) and key != "TALUS_ACCESS_WITHOUT_TOKEN":
                    self.assertTrue(str(value).startswith("/run/secrets/"), key)

    def test_only_init_may_make_the_log(self):
        holders = [name for name, service in self.services.items() if "talus-admin-key.pem" in str(service.get("secrets"))]
        self.assertEqual(holders, ["cluster-init"])

    def test_files_that_are_mounted_exist(self):
        for name, service in self.services.items():
            for volume in service.get("volumes", []):
                source = volume.split(":")[0]
                if source.startswith("/"):
                    self.assertTrue(pathlib.Path(source).exists(), f"{name}: {source}")

    def test_disks_are_of_one_each(self):
        data = [volume.split(":")[0] for name, service in self.services.items() if name != "nats-volumes"
                for volume in service.get("volumes", []) if not volume.startswith("/")]
        self.assertEqual(len(data), len(set(data)))
        self.assertEqual(set(data), set(self.file["volumes"]))

    def test_operators_ports_are_not_published_to_players(self):
        for name, service in self.services.items():
            for port in service.get("ports", []):
                if not str(port).startswith("127.0.0.1:"):
                    published = port["published"] if isinstance(port, dict) else int(port.split(":")[0])
                    self.assertIn((name, published), [("haproxy", 4780), *(("haproxy", place) for place in range(4800, 4864)), ("varnish", 4782)])

    def test_addresses_of_proxies_are_those_of_haproxy_and_varnish(self):
        addresses = {self.services[name]["networks"]["players"]["ipv4_address"] for name in ["haproxy", "varnish"]}
        for i in range(3):
            service = self.services[f"talus-{i}"]
            self.assertEqual({a.strip() for a in service["environment"]["TALUS_PROXIES"].split(",")}, addresses)
        # HAProxy and talusd meet in one network only, so that HAProxy's address there is the one that talusd sees.
        shared = set(self.services["haproxy"]["networks"]) & set(self.services["talus-0"]["networks"])
        self.assertEqual(shared, {"players"})


if __name__ == "__main__":
    unittest.main()
