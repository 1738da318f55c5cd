"""What make.py and test_compatibility.py share: where kept data is, a talusd on it, and what a client sees there."""

import base64
import hashlib
import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / folder) for folder in ("python", "balancer", "deployment")]

import paths  # noqa: E402

import talus  # noqa: E402
from farm import until  # noqa: E402, F401
from nats import STORE, Nats  # noqa: E402
from nats_client import NatsClient  # noqa: E402
from server import TALUSD, Server  # noqa: E402


def settings(folder, data):
    """Of a talusd in the world of `folder`."""
    return {
        "TALUS_WORLD": str(folder / "world.toml"),
        "TALUS_DATA": str(data),
        "TALUS_ACCESS_WITHOUT_TOKEN": "read,edit",
        "TALUS_EDITS_SETTLE": "true",
        "TALUS_THREADS_IO": "1",
        "TALUS_THREADS_GENERATOR": "1",
    }


def talusd(*words, **environment):
    """Runs a command of talusd, and returns what it printed."""
    inherited = {name: value for name, value in os.environ.items() if not name.startswith("TALUS_")}
    done = subprocess.run([TALUSD, *map(str, words)], env={**inherited, **environment}, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"talusd {' '.join(map(str, words))} ended with {done.returncode}: {done.stderr}")
    return done.stdout


def serve(folder, data, **more):
    return Server(**settings(folder, data), **more)


def seen(world, keys):
    """What a client receives: {"X Y Z LOD": [revision, content hash of the voxels]}."""
    chunks = zip(keys, world.chunks(keys))
    return {" ".join(map(str, key)): [chunk.revision, f"{talus.content_hash(chunk.voxels):032x}"] for key, chunk in chunks}


def keys_of(chunks):
    return [tuple(map(int, key.split())) for key in chunks]


def stored(data):
    """What the store of a stopped talusd holds."""
    return json.loads(talusd("store", "stat", "--json", "--data", data))


class Log:
    """Three nats-servers with the log of the world of these settings, by their client's protocol."""

    def __init__(self, scratch, settings):
        self.nats = Nats(pathlib.Path(scratch), 3, settings, store=STORE)
        self.settings = {**settings, **self.nats.settings}
        self.client = NatsClient(self.nats.servers[0].port)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.client.close()
        self.nats.stop()

    def api(self, what, **question):
        answer = self.client.ask(f"$JS.API.STREAM.{what}.{self.nats.stream}", **question)
        if "error" in answer:
            raise AssertionError(f"{what}: {answer['error']}")
        return answer

    def messages(self):
        last = self.api("INFO")["state"]["last_seq"]
        return [base64.b64decode(self.api("MSG.GET", seq=number)["message"]["data"]) for number in range(1, last + 1)]

    def replace(self, messages):
        """Makes the stream anew, with these messages in it."""
        config = self.api("INFO")["config"]
        self.api("DELETE")
        self.api("CREATE", **config)
        for number, message in enumerate(messages, 1):
            answer = json.loads(self.client.request(config["subjects"][0], message)[1])
            if answer.get("seq") != number:
                raise AssertionError(f"message {number}: {answer}")


def vectors():
    """A digest of each payload and frame of the vectors: what decoders of other releases were given."""
    lines = (paths.ROOT / "core/voxel/vectors/payloads.txt").read_text().splitlines()
    frames = json.loads((paths.ROOT / "protocol/vectors/frames.json").read_text())["frames"]
    vectors = [line for line in lines if line.startswith("chunk ")]
    vectors += [f"frame {frame['kind']} {frame['hex']}" for frame in frames]
    return [" ".join([*vector.split()[:2], hashlib.sha256(vector.encode()).hexdigest()]) for vector in vectors]
