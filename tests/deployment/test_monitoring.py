"""Alerts and dashboard by Debian's own Prometheus: rules, what each alert makes of series, and every query of the dashboard."""

import json
import pathlib
import re
import subprocess
import tempfile
import time
import unittest
import urllib.error
import urllib.parse
import urllib.request

import yaml

from nats_servers import free_ports

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).parent
ALERTS = {group["name"]: group["rules"] for group in yaml.safe_load((ROOT / "docker/alerts.yml").read_text())["groups"]}


def promtool(*arguments):
    return subprocess.run(["promtool", *arguments], capture_output=True, text=True, cwd=HERE, timeout=300)


class Alerts(unittest.TestCase):
    def test_prometheus_takes_the_configurations(self):
        for name in ["prometheus.yml", "prometheus.cluster.yml"]:
            checked = promtool("check", "config", ROOT / "docker" / name)
            self.assertEqual(checked.returncode, 0, checked.stderr)

    def test_each_fires_when_it_should_and_else_not(self):
        tested = promtool("test", "rules", "alerts_test.yml", "alerts_days_test.yml")
        self.assertEqual(tested.returncode, 0, tested.stdout + tested.stderr)

    def test_each_of_the_cluster_has_a_test_in_which_it_fires(self):
        fired = set()
        for file in ["alerts_test.yml", "alerts_days_test.yml"]:
            for test in yaml.safe_load((HERE / file).read_text())["tests"]:
                fired |= {case["alertname"] for case in test["alert_rule_test"] if case.get("exp_alerts")}
        self.assertLessEqual({rule["alert"] for rule in ALERTS["talus-cluster"]}, fired)

    def test_each_has_a_runbook(self):
        reference = (ROOT / "docs/REFERENCE.md").read_text()
        for rule in ALERTS["talus-cluster"]:
            self.assertTrue(re.search(rf"(?m)^\| `{rule['alert']}` \|.*\| \S[^|]* \|$", reference), rule["alert"])

    def test_runbooks_are_of_alerts_that_exist(self):
        names = {rule["alert"] for rules in ALERTS.values() for rule in rules}
        reference = (ROOT / "docs/REFERENCE.md").read_text()
        self.assertLessEqual(set(re.findall(r"(?m)^\| `(Talus[A-Za-z]+)` \|", reference)), names)


class Queries(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="talus-prometheus-")
        cls.addClassCleanup(cls.scratch.cleanup)
        folder = pathlib.Path(cls.scratch.name)
        (folder / "prometheus.yml").write_text("{}\n")
        [port] = free_ports(1)
        cls.url = f"http://127.0.0.1:{port}"
        with open(folder / "log", "wb") as log:
            cls.process = subprocess.Popen(["prometheus", f"--config.file={folder}/prometheus.yml", f"--storage.tsdb.path={folder}/data",
                                            f"--web.listen-address=127.0.0.1:{port}"], stdout=log, stderr=log)
        cls.addClassCleanup(cls.process.wait)
        cls.addClassCleanup(cls.process.kill)
        until = time.monotonic() + 60
        while True:
            try:
                urllib.request.urlopen(f"{cls.url}/-/ready", timeout=5)
                return
            except OSError:
                assert cls.process.poll() is None and time.monotonic() < until, (folder / "log").read_text()
                time.sleep(0.05)

    def ask(self, query):
        body = urllib.parse.urlencode({"query": query}).encode()
        try:
            return json.load(urllib.request.urlopen(f"{self.url}/api/v1/query", body, timeout=10))
        except urllib.error.HTTPError as refused:
            return json.load(refused)

    def test_the_dashboards_queries(self):
        dashboard = json.loads((ROOT / "docker/grafana/talus.json").read_text())
        queries = [target["expr"] for panel in dashboard["panels"] for target in panel.get("targets", [])]
        self.assertGreater(len(queries), 30)
        for query in queries:
            with self.subTest(query):
                answer = self.ask(query.replace("$__rate_interval", "1m").replace("$instance", ".*"))
                self.assertEqual(answer["status"], "success", answer)

    def test_a_wrong_query_is_found(self):
        self.assertEqual(self.ask("sum(rate(talus_x[1m])")["status"], "error")

    def test_the_adapters_queries(self):
        [rule] = yaml.safe_load((ROOT / "docker/kubernetes/adapter-values.yaml").read_text())["rules"]["custom"]
        query = rule["metricsQuery"].replace("<<.Series>>", "talus_sessions").replace("<<.GroupBy>>", "pod")
        for asked in [rule["seriesQuery"], query.replace("<<.LabelMatchers>>", 'namespace="default",pod=~"talus-0|talus-1"')]:
            self.assertEqual(self.ask(asked)["status"], "success", asked)

    def test_panels_do_not_lie_on_each_other(self):
        panels = json.loads((ROOT / "docker/grafana/talus.json").read_text())["panels"]
        self.assertEqual(len({panel["id"] for panel in panels}), len(panels))
        taken = {}
        for panel in panels:
            at = panel["gridPos"]
            for x in range(at["x"], at["x"] + at["w"]):
                for y in range(at["y"], at["y"] + at["h"]):
                    self.assertLess(x, 24)
                    self.assertNotIn((x, y), taken, f"{panel['title']} lies on {taken.get((x, y))}")
                    taken[x, y] = panel["title"]


if __name__ == "__main__":
    unittest.main()
