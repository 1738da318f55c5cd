"""HAProxy really in front of three talusd, with docker/haproxy/haproxy.cfg."""

import collections
import json
import pathlib
import re
import signal
import socket
import tempfile
import unittest

import farm as farms
from farm import Farm, fetch, figures, load, restart, until

CLASSIC = str(farms.ROOT / "core/worlds/classic.toml")
SETTINGS = {
    "TALUS_WORLD": CLASSIC,
    "TALUS_THREADS_IO": "1",
    "TALUS_THREADS_GENERATOR": "1",
    "TALUS_SHUTDOWN_LEAD_MS": "4000",
    "TALUS_SHUTDOWN_DRAIN_MS": "2000",
    "TALUS_BALANCE_SESSION_MS": "0",
    "TALUS_BALANCE_PER_SECOND": "100",
}


class HaproxyTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="talus-haproxy-")
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.farm = Farm(cls.folder, 3, SETTINGS)
        cls.farm.__enter__()
        cls.addClassCleanup(cls.farm.stop)
        cls.address = f"127.0.0.1:{cls.farm.port}"
        cls.web = f"http://127.0.0.1:{cls.farm.http}"

    def setUp(self):
        for server in self.farm.servers:
            if server.process.poll() is not None:  # after a test that failed
                server.start()
            until(lambda: self.farm.state(server) == "UP", f"{server.name} is up")
        until(lambda: sum(self.farm.players()) == 0, "nobody is there")

    def load(self, *arguments, **options):
        """talus-load that ends with the test."""
        process = load(*arguments, **options)

        def end():
            if process.poll() is None:
                process.terminate()
                process.communicate()

        self.addCleanup(end)
        return process

    def crowd(self, count, *arguments, there=0):
        """`count` idle connections that stay until the test ends, beside those that are `there`."""
        process = self.load(self.address, "--players", 1, "--model", "stand", "--radius", 1, "--vertical", 0, "--idle", count - 1,
                            "--duration", 600, *arguments)
        until(lambda: process.poll() is None and sum(self.farm.players()) == count + there, f"{count} players are there")
        return process

    def test_players_go_to_the_server_with_the_fewest_under_their_own_address(self):
        self.crowd(30, "--from-addresses", 4)
        self.assertEqual(sorted(self.farm.players()), [10, 10, 10])
        own = [f'"127.0.0.{number}"' for number in (1, 2, 3, 4)]
        until(lambda: all(address in "".join(server.flows() for server in self.farm.servers) for address in own),
              "all addresses are seen")

    def test_what_a_client_says_itself_of_proxies_counts_for_nothing(self):
        header = b"\r\n\r\n\0\r\nQUIT\n\x21\x11\0\x0c" + bytes([192, 0, 2, 7, 127, 0, 0, 1, 1, 2, 3, 4])
        with socket.create_connection(("127.0.0.1", self.farm.port)) as client:
            client.sendall(header)
            client.settimeout(30)
            answer = client.recv(4096)  # an Error: no frame is so long; or nothing
        self.assertNotIn("192.0.2.7", "".join(server.flows() for server in self.farm.servers))
        self.assertLess(len(answer), 4096)
        status, _ = fetch(f"{self.web}/v1/heights?columns=1,1", **{"X-Forwarded-For": "192.0.2.7"})
        self.assertEqual(status, 200)
        self.assertNotIn("192.0.2.7", "".join(server.flows() for server in self.farm.servers))

    def test_a_server_that_is_killed_costs_nobody_more_than_his_connection(self):
        victim = self.farm.servers[1]
        self.crowd(30)
        victim.signal(signal.SIGKILL)
        victim.wait()
        # HAProxy has not looked yet: who is sent there, those who were there among them, is sent on.
        self.crowd(20, there=30)
        self.assertEqual(victim.players(), 0)
        victim.start()

    def test_a_restart_loses_nobody_and_afterwards_players_are_balanced(self):
        count = 24
        json_file = self.folder / "restart.json"
        process = self.load(self.address, "--players", count, "--model", "walk", "--radius", 2, "--vertical", 1, "--verify", 5,
                            "--duration", 25, "--drain", 60, "--from-addresses", 4, json_file=json_file)
        until(lambda: sum(self.farm.players()) == count, "all are there")
        server = self.farm.servers[0]
        server.signal(signal.SIGTERM)
        until(lambda: server.ready() == 503, "it is not ready", beat_s=0.01)
        self.assertEqual(server.players(), count // 3)  # who is there stays for the lead
        self.assertEqual(server.wait(), 0)
        server.start()
        until(lambda: sum(self.farm.players()) == count and max(self.farm.players()) <= count // 3 + 1, "all are balanced again")
        output, _ = process.communicate()
        self.assertEqual(process.returncode, 0, output)
        seen = figures(json_file)
        self.assertEqual((seen["wrong"], seen["unanswered"], seen["errors"]), (0, 0, 0), output)
        self.assertGreaterEqual(seen["reconnects"], count // 3, output)

    def test_a_region_of_land_is_one_servers(self):
        world = json.loads(fetch(f"{self.web}/v1/world")[1])
        root = f"/v1/{world['fingerprint']}/4"

        def servers_of(paths):
            before = [server.http_answers() for server in self.farm.servers]
            for path in paths:
                self.assertEqual(fetch(self.web + path)[0], 200, path)
            after = [server.http_answers() for server in self.farm.servers]
            return [now - then for now, then in zip(after, before)]

        region = [f"{root}/0/{x}/{z}" for x in range(-32, -27) for z in range(27, 32)]
        region += [f"{root}/0/{x}/{x // 9}/31" for x in (-32, -1)] + [f"{root}/0/-4/28/4x4"]
        self.assertEqual(sorted(servers_of(region)), [0, 0, len(region)])
        spread = servers_of([f"{root}/0/{32 * x}/{32 * z}" for x in range(8) for z in range(8)])
        self.assertEqual(sum(spread), 64)
        self.assertGreater(min(spread), 5, spread)
        # Without one of them, the regions of the others stay where they are.
        owners = collections.defaultdict(list)
        for x in range(24):
            owner = servers_of([f"{root}/0/{32 * x}/-1"]).index(1)
            owners[owner].append(f"{root}/0/{32 * x + 1}/-2")
        gone = self.farm.servers[0]
        gone.signal(signal.SIGTERM)
        until(lambda: self.farm.state(gone, "land") == "DOWN", "nobody is sent there")
        for owner in (1, 2):
            before = self.farm.servers[owner].http_answers()
            for path in owners[owner]:
                self.assertEqual(fetch(self.web + path)[0], 200)
            self.assertEqual(self.farm.servers[owner].http_answers() - before, len(owners[owner]))
        gone.signal(signal.SIGTERM)
        gone.wait()
        gone.start()

    def test_players_of_a_place_are_on_one_server_and_no_server_has_too_many(self):
        count, groups = 96, 24
        places = ",".join(f"127.0.0.1:{self.farm.places + place}" for place in range(groups))
        process = self.load(places, "--players", count, "--groups", groups, "--groups-together", "--model", "stand", "--radius", 2,
                            "--vertical", 1, "--duration", 600, "--from-addresses", groups)  # each group has an address
        until(lambda: process.poll() is None and sum(self.farm.players()) == count, "all are there")
        self.assertLessEqual(max(self.farm.players()), 41)  # a quarter more than the share, rounded up
        sessions = re.findall(r"src=(127\.[0-9.]+):\S+ fe=places be=places srv=(\S+)", self.farm.tell("show sess"))
        self.assertEqual(len(sessions), count)
        servers_a_group = len(set(sessions)) / groups  # anywhere, it would be 2.4
        self.assertLess(servers_a_group, 2.1)

    def test_a_check_sends_away_those_of_its_ports_and_a_wrong_one_nobody(self):
        server = self.farm.servers[0]
        elsewhere = "talus_sessions_sent_elsewhere_total"
        crowd = self.load(f"127.0.0.1:{server.port}", "--players", 1, "--model", "stand", "--radius", 1, "--vertical", 0, "--idle", 5,
                          "--duration", 600)  # past HAProxy
        until(lambda: crowd.poll() is None and server.players() == 6, "6 players are there")

        def check(query):
            """As HAProxy's, of far too many players."""
            state = {"X-Haproxy-Server-State": "UP; weight=1/3; scur=300/300"}
            self.assertEqual(fetch(f"http://127.0.0.1:{server.admin}/-/ready{query}", **state)[0], 200)

        def told(part):
            return server.log.read_text().count(f"in its query '{part}' is not one of")

        before = server.metrics()[elsewhere]
        check("?ports=0")
        check("?ports=0-65535")
        for _ in range(3):
            check("?above_percent=25&port=4780")
        check("?ports=1,2")  # they are done in the order in which they come
        until(lambda: told("ports=1,2"), "the log tells of the last")
        self.assertEqual(told("port=4780"), 1)
        self.assertEqual(server.metrics()[elsewhere], before)
        check("")
        until(lambda: server.metrics()[elsewhere] > before, "a check that names no ports sends some away")

    def test_players_by_websocket(self):
        json_file = self.folder / "websocket.json"
        process = self.load(f"ws://127.0.0.1:{self.farm.http}", "--players", 9, "--model", "fly", "--radius", 2, "--vertical", 1,
                            "--verify", 20, "--duration", 2, "--drain", 60, json_file=json_file)
        output, _ = process.communicate()
        seen = figures(json_file)
        self.assertEqual((seen["wrong"], seen["unanswered"], seen["disconnects"]), (0, 0, 0), output)

    def test_what_is_no_protocol_harms_nobody(self):
        for port in (self.farm.port, self.farm.http):
            for bytes_ in (b"\xff" * 100, b"GET / HTTP/1.1\r\n\r\n", b"\0" * 20000, b"\x16\x03\x01\x02\0\x01"):
                with socket.create_connection(("127.0.0.1", port)) as client:
                    try:
                        client.sendall(bytes_)
                        client.shutdown(socket.SHUT_WR)
                        client.settimeout(30)
                        while client.recv(65536):
                            pass
                    except OSError:
                        pass
        self.crowd(3)
        self.assertEqual([server.ready() for server in self.farm.servers], [200] * 3)

    def test_servers_one_after_the_other(self):
        for server in self.farm.servers:
            restart(self.farm, server)
        self.crowd(6)
        self.assertEqual(self.farm.players(), [2, 2, 2])


@unittest.skipUnless(farms.HAPROXY, "haproxy is not installed; ./dev deps test")
class TlsTest(unittest.TestCase):
    def test_tls_passes_through(self):
        import subprocess

        with tempfile.TemporaryDirectory(prefix="talus-haproxy-") as name:
            folder = pathlib.Path(name)
            certificate, key = folder / "certificate.pem", folder / "key.pem"
            subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes",
                            "-days", "2", "-subj", "/CN=localhost", "-addext", "subjectAltName=DNS:localhost,IP:127.0.0.1",
                            "-keyout", key, "-out", certificate], check=True, capture_output=True)
            settings = {**SETTINGS, "TALUS_TLS_CERTIFICATE": str(certificate), "TALUS_TLS_KEY": str(key), "TALUS_HTTP_TLS": "false"}
            with Farm(folder, 2, settings) as farm:
                json_file = folder / "tls.json"
                process = load(f"127.0.0.1:{farm.port}", "--players", 4, "--model", "stand", "--radius", 2, "--vertical", 1,
                               "--duration", 2, "--drain", 60, "--verify", 20, "--ca", certificate, json_file=json_file)
                output, _ = process.communicate()
                seen = figures(json_file)
                self.assertEqual((seen["wrong"], seen["unanswered"], seen["disconnects"]), (0, 0, 0), output)
                self.assertEqual(sum(server.metrics()['talus_tls_handshakes_total{result="done"}'] for server in farm.servers), 5)


if __name__ == "__main__":
    unittest.main()
