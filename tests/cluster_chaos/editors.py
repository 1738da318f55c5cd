"""Editors who know what each of their edits must do: talus-chaos-editors as a process, its orders and its answers."""

import collections
import json
import os
import queue
import subprocess
import threading

import farm as farms

EDITORS = os.environ.get("TALUS_CHAOS_EDITORS", str(farms.ROOT / "build/release/tests/cluster_chaos/talus-chaos-editors"))


class Editors:
    def __init__(self, addresses, log, *arguments):
        with open(log, "ab") as errors:
            self.process = subprocess.Popen([EDITORS, "--connect", ",".join(addresses), *map(str, arguments)], stdin=subprocess.PIPE,
                                            stdout=subprocess.PIPE, stderr=errors, text=True)
        self.lost = []  # connections, as they broke
        self.mistakes = []
        self._answers = collections.defaultdict(queue.Queue)
        threading.Thread(target=self._read, daemon=True).start()
        self.joined = self.await_answer("joined")

    def _read(self):
        for line in self.process.stdout:
            said = json.loads(line)
            if said["event"] == "lost":
                self.lost.append(said)
            elif said["event"] in ("mistake", "gave up"):
                self.mistakes.append(said)
            else:
                self._answers[said["event"]].put(said)

    def order(self, text):
        self.process.stdin.write(text + "\n")
        self.process.stdin.flush()

    def await_answer(self, event, patience_s=farms.PATIENCE_S):
        try:
            return self._answers[event].get(timeout=patience_s)
        except queue.Empty:
            raise AssertionError(f"the editors did not say '{event}' within {patience_s} s") from None

    def go(self):
        self.order("go")

    def pause(self):
        """Returns when all edits are answered."""
        self.order("pause")
        return self.await_answer("paused")

    def figures(self):
        self.order("figures")
        return self.await_answer("figures")

    def verify(self, address):
        """How many voxels that server has otherwise than was acknowledged."""
        self.order(f"verify {address}")
        said = self.await_answer("verified")
        if said["failed"]:
            raise AssertionError(f"{address}: {said['failed']}")
        return said["wrong"]

    def stop(self):
        if self.process.poll() is None:
            self.process.stdin.close()
            self.process.wait(farms.PATIENCE_S)
