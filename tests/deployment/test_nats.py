"""What the shipped configuration of nats-server lets each certificate do, and what it refuses, asked of three real servers."""

import base64
import json
import pathlib
import shutil
import socket
import ssl
import subprocess
import tempfile
import time
import unittest
import urllib.request

from nats_client import NatsClient, RefusedError, status
from nats_servers import certificates, start_cluster

STORE = "0123456789abcdef0123456789abcdef"
STREAM = f"TALUS_{STORE}"
LOG = f"talus.{STORE}.log"
TAIL = f"talus.{STORE}.tail"
# As the design has it; `talusd cluster init` asks the same.
SETTINGS = {"name": STREAM, "subjects": [LOG], "retention": "limits", "max_consumers": -1, "max_msgs": -1, "max_bytes": 16 << 30,
            "discard": "old", "max_age": 7 * 86400 * 10**9, "storage": "file", "num_replicas": 3, "allow_direct": True,
            "deny_delete": True, "deny_purge": True, "republish": {"src": LOG, "dest": TAIL}}


class ShippedConfiguration(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="talus-nats-")
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.tls = cls.folder / "tls"
        cls.servers = start_cluster(cls.folder)
        cls.addClassCleanup(cls.scratch.cleanup)
        for server in cls.servers:
            cls.addClassCleanup(server.kill)
        with cls.connect("talus-admin") as admin:
            # A leader of all has to be chosen first.
            until = time.monotonic() + 60
            while "error" in (made := admin.ask(f"$JS.API.STREAM.CREATE.{STREAM}", **SETTINGS)):
                assert time.monotonic() < until, made
            assert made["config"]["deny_purge"] and made["config"]["num_replicas"] == 3, made

    @classmethod
    def connect(cls, certificate, server=0, **options):
        return NatsClient(cls.servers[server].port, cls.tls, certificate, **options)

    def last(self):
        with self.connect("talusd") as talusd:
            return talusd.ask(f"$JS.API.STREAM.INFO.{STREAM}")["state"]["last_seq"]

    def test_nats_server_takes_the_files(self):
        for server in self.servers:
            checked = server.check()
            self.assertEqual(checked.returncode, 0, checked.stderr)

    def test_there_is_room_for_a_second_log(self):
        # As after `talusd store fork`: NATS sets aside what a log may take.
        settings = {**SETTINGS, "name": "TALUS_f", "subjects": ["talus.f.log"], "republish": {"src": "talus.f.log", "dest": "talus.f.tail"}}
        with self.connect("talus-admin") as admin:
            self.assertNotIn("error", admin.ask("$JS.API.STREAM.CREATE.TALUS_f", **settings))

    def test_talusd_adds_follows_and_reads(self):
        with self.connect("talusd", 0) as writer, self.connect("talusd", 1) as reader:
            reader.subscribe(TAIL, 1)
            head, payload = writer.request(LOG, b"an edit")
            acked = json.loads(payload)
            self.assertEqual(acked["stream"], STREAM)
            subject, head, payload = reader.next()
            self.assertEqual((subject, payload), (TAIL, b"an edit"))
            self.assertIn(f"Nats-Sequence: {acked['seq']}".encode(), head)
            stored = reader.ask(f"$JS.API.STREAM.MSG.GET.{STREAM}", seq=acked["seq"])
            self.assertEqual(base64.b64decode(stored["message"]["data"]), b"an edit")
            # Here any replica answers, those that are behind too.
            until = time.monotonic() + 10
            while status((answer := reader.request(f"$JS.API.DIRECT.GET.{STREAM}", json.dumps({"seq": acked["seq"]}).encode()))[0]):
                self.assertLess(time.monotonic(), until)
            self.assertEqual(answer[1], b"an edit")
            info = reader.ask(f"$JS.API.STREAM.INFO.{STREAM}")
            self.assertEqual(info["state"]["last_seq"], acked["seq"])

    def test_talusd_may_publish_nothing_else(self):
        before = self.last()
        for subject, question in [
            (f"$JS.API.STREAM.DELETE.{STREAM}", {}),
            (f"$JS.API.STREAM.PURGE.{STREAM}", {}),
            (f"$JS.API.STREAM.UPDATE.{STREAM}", {**SETTINGS, "max_age": 10**9}),
            ("$JS.API.STREAM.CREATE.TALUS_ffff", {**SETTINGS, "name": "TALUS_ffff", "subjects": ["talus.ffff.log"]}),
            (f"$JS.API.STREAM.MSG.DELETE.{STREAM}", {"seq": 1}),
            (f"$JS.API.STREAM.SNAPSHOT.{STREAM}", {"deliver_subject": "_INBOX.x"}),
            (f"$JS.API.STREAM.RESTORE.{STREAM}", {"config": SETTINGS}),
            (f"$JS.API.STREAM.LEADER.STEPDOWN.{STREAM}", {}),
            (f"$JS.API.STREAM.PEER.REMOVE.{STREAM}", {"peer": "nats-1"}),
            (f"$JS.API.CONSUMER.CREATE.{STREAM}", {}),
            (f"$JS.API.CONSUMER.DURABLE.CREATE.{STREAM}.x", {}),
            ("$JS.API.STREAM.LIST", {}),
            ("$SYS.REQ.SERVER.PING", {}),
            (TAIL, {"forged": 1}),
            ("_INBOX.of.another", {"forged": 1}),
            ("talus.log", {}),
            ("anything", {}),
        ]:
            with self.subTest(subject), self.connect("talusd") as talusd:
                with self.assertRaisesRegex(RefusedError, "Permissions Violation"):
                    talusd.ask(subject, **question)
        with self.connect("talusd") as talusd:
            info = talusd.ask(f"$JS.API.STREAM.INFO.{STREAM}")
        self.assertEqual(info["state"]["last_seq"], before)
        self.assertEqual(info["config"]["max_age"], SETTINGS["max_age"])

    def test_talusd_may_listen_to_nothing_else(self):
        for subject in [">", "*", "talus.>", LOG, "talus.*.*", "$JS.>", "$SYS.>", "$JS.API.>", "$JS.EVENT.>"]:
            with self.subTest(subject), self.connect("talusd") as talusd:
                with self.assertRaisesRegex(RefusedError, "Permissions Violation"):
                    talusd.subscribe(subject, 1)

    def test_nobody_deletes_the_log(self):
        before = self.last()
        for certificate in ["talus-admin", "nats-operator"]:
            for subject in [f"$JS.API.STREAM.DELETE.{STREAM}", f"$JS.API.STREAM.PURGE.{STREAM}"]:
                with self.subTest(subject, certificate=certificate), self.connect(certificate) as client:
                    client.publish(subject)
                    if certificate == "talus-admin":
                        with self.assertRaisesRegex(RefusedError, "Permissions Violation"):
                            client.flush()
                    else:  # his account is another, in which there is no such log
                        client.flush()
        self.assertEqual(self.last(), before)

    def test_strangers_do_not_get_in(self):
        # Another authority's certificate of the same name, and one of this authority that permissions.conf does not know.
        certificates(self.folder / "foreign")
        for name in ["talusd.pem", "talusd-key.pem"]:
            (self.tls / f"foreign-{name}").write_bytes((self.folder / "foreign" / name).read_bytes())
        self.addCleanup(lambda: [(self.tls / f"stranger{end}").unlink() for end in (".pem", "-key.pem")])
        self.issue("stranger", "/CN=stranger")
        for what, certificate, hello in [
            ("no certificate", None, {}),
            ("no certificate but a name", None, {"user": "CN=talusd", "pass": "x"}),
            ("another authority's", "foreign-talusd", {}),
            ("not in permissions.conf", "stranger", {}),
            ("not in permissions.conf, with another's name", "stranger", {"user": "CN=talusd", "pass": ""}),
            ("a host's own", "nats-0", {}),
        ]:
            with self.subTest(what), self.assertRaises(RefusedError):
                self.connect(certificate, hello=hello).close()

    def test_without_tls_nobody_gets_in(self):
        with socket.create_connection(("127.0.0.1", self.servers[0].port), timeout=10) as plain:
            plain.sendall(b'CONNECT {"verbose":false,"user":"CN=talusd","pass":""}\r\nPING\r\n')
            said = b""
            try:
                while data := plain.recv(4096):
                    said += data
            except ConnectionError:
                pass
            self.assertNotIn(b"PONG", said)

    def test_no_route_by_a_talusds_certificate(self):
        # Whoever is a route reads and writes all subjects of all accounts.
        for certificate in [None, "talusd", "talus-admin"]:
            with self.subTest(certificate), self.assertRaises(RefusedError):
                self.route(certificate)
        self.route("nats-1")

    def test_z_a_host_with_an_empty_disk_catches_up(self):
        # Last of all by its name: the others ask all three.
        with self.connect("talusd") as talusd:
            for i in range(20):
                talusd.request(LOG, b"before %d" % i)
            victim = self.servers[2]
            victim.kill()
            shutil.rmtree(victim.folder / "data")
            self.answer_of(lambda: talusd.request(LOG, b"without it"))
            victim.start()
            wanted = self.answer_of(lambda: talusd.ask(f"$JS.API.STREAM.INFO.{STREAM}"))["state"]
        until = time.monotonic() + 60
        while (state := self.state_at(victim)) != (wanted["first_seq"], wanted["last_seq"]):
            self.assertLess(time.monotonic(), until, state)
            time.sleep(0.05)

    def answer_of(self, question):
        """Asked again while nobody answers: it may have been the leader that was killed."""
        until = time.monotonic() + 60
        while True:
            try:
                return question()
            except RefusedError:
                if time.monotonic() > until:
                    raise

    @staticmethod
    def state_at(server):
        """First and last of the log, as that host has it on its disk."""
        try:
            page = json.load(urllib.request.urlopen(f"http://127.0.0.1:{server.monitor_port}/jsz?accounts=true&streams=true", timeout=5))
        except OSError:
            return None
        for account in page.get("account_details") or []:
            for stream in account.get("stream_detail") or []:
                if stream["name"] == STREAM:
                    return stream["state"]["first_seq"], stream["state"]["last_seq"]
        return None

    def route(self, certificate):
        """Greets as a host does, and is answered by a Pong or raises."""
        context = ssl.create_default_context(cafile=self.tls / "ca.pem")
        if certificate:
            context.load_cert_chain(self.tls / f"{certificate}.pem", self.tls / f"{certificate}-key.pem")
        try:
            # Unlike a client's port, a route's begins with TLS.
            with socket.create_connection(("localhost", self.servers[0].route_port), timeout=10) as plain:
                with context.wrap_socket(plain, server_hostname="localhost") as link:
                    link.sendall(b'CONNECT {"verbose":false,"tls_required":true,"name":"NX","cluster":"talus"}\r\n'
                                 b'INFO {"server_id":"NX","server_name":"x","version":"2.9.10","cluster":"talus","proto":1,'
                                 b'"headers":true,"tls_required":true,"max_payload":1048576}\r\nPING\r\n')
                    said = b""
                    while b"PONG" not in said:
                        data = link.recv(65536)
                        if not data or b"-ERR" in said + data:
                            raise RefusedError((said + data).decode(errors="replace"))
                        said += data
        except OSError as failure:
            raise RefusedError(str(failure)) from failure

    def issue(self, name, subject):
        """A client's certificate of the cluster's own authority."""
        key, request = self.tls / f"{name}-key.pem", self.tls / "request.tmp"
        quiet = {"check": True, "stderr": subprocess.DEVNULL}
        subprocess.run(["openssl", "req", "-new", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-subj",
                        subject, "-keyout", key, "-out", request], **quiet)
        subprocess.run(["openssl", "x509", "-req", "-in", request, "-CA", self.tls / "ca.pem", "-CAkey", self.tls / "ca-key.pem",
                        "-days", "1", "-out", self.tls / f"{name}.pem"], **quiet)
        request.unlink()


if __name__ == "__main__":
    unittest.main()
