"""What servers say in the log that they share: server/cluster/FORMAT.md, as far as the tests here need it."""

import collections
import json
import struct
import sys
import threading

import farm as farms

sys.path.insert(0, str(farms.ROOT / "tests/deployment"))

from nats_client import NatsClient, RefusedError, status  # noqa: E402

Batch = collections.namedtuple("Batch", "publisher number revision hash edits")
Edit = collections.namedtuple("Edit", "editor epoch sequence voxel")  # voxel: the first that it names


class _Reader:
    def __init__(self, data, at=0):
        self.data, self.at = data, at

    def number(self):
        value = shift = 0
        while True:
            byte = self.data[self.at]
            self.at += 1
            value |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return value

    def signed(self):
        value = self.number()
        return value >> 1 ^ -(value & 1)

    def unpack(self, form):
        values = struct.unpack_from(form, self.data, self.at)
        self.at += struct.calcsize(form)
        return values


def read_batch(message, with_edits=True):
    """None: it is no batch."""
    if message[:2] != b"\1\1":
        return None
    reader = _Reader(message, 34)
    (publisher,) = reader.unpack("<Q")
    number, _ = reader.number(), reader.number()
    revision, low, high = reader.unpack("<QQQ")
    edits = []
    if with_edits:
        if reader.unpack("B")[0]:
            for _ in range(2 * reader.number()):
                reader.number()
        for _ in range(reader.number()):
            length = reader.number()
            entry = _Reader(message, reader.at)
            reader.at += length
            if message[entry.at:entry.at + 2] == b"\1\1":
                entry.at += 2
                edits.append(_read_edit(entry))
    return Batch(publisher, number, revision, high << 64 | low, edits)


def _read_edit(entry):
    editor, epoch, sequence = entry.unpack("<QQ"), entry.number(), entry.number()
    subject = entry.number()
    entry.at += subject + 1  # and the flags
    voxel = None
    for _ in range(3):  # guards, writes, fills
        if entry.number() and voxel is None:
            voxel = (entry.signed(), entry.signed(), entry.signed())
            break
    return Edit(editor, epoch, sequence, voxel)


class Tail(threading.Thread):
    """Listens to the log, by whichever of these nats-servers says anything, and holds each S that a server says against what others
    said for the same revision. While no server answers it hears nothing. `heard` is called with each batch."""

    def __init__(self, servers, store, heard=None, with_edits=False):
        super().__init__(daemon=True)
        self.servers, self.subject, self.heard, self.with_edits = servers, f"talus.{store}.tail", heard, with_edits
        self.messages = self.compared = self.unlike = 0
        self.last = {}  # by publisher, the revision that it said last
        self._said = collections.OrderedDict()  # by revision: S, and one who said it
        self._ends = False
        self.subscribed = threading.Event()

    def run(self):
        turn = 0
        while not self._ends:
            server = self.servers[turn % len(self.servers)]
            turn += 1
            try:
                with NatsClient(server.port, host=server.address, timeout=2) as client:
                    client.subscribe(self.subject, 1)
                    self.subscribed.set()
                    while not self._ends:
                        message = client.next()
                        if message != "PONG":
                            self._take(read_batch(message[2], self.with_edits))
            except (OSError, RefusedError):  # or it has heard nothing for a time, and may be cut off from the others
                pass

    def stop(self):
        self._ends = True
        self.join()

    def said(self, revision):
        """The S that some server said for it, in 32 hexadecimal digits."""
        hash, _ = self._said.get(revision, (None, None))
        return None if hash is None else f"{hash:032x}"

    def _take(self, batch):
        if batch is None:
            return
        self.messages += 1
        self.last[batch.publisher] = batch.revision
        said = self._said.setdefault(batch.revision, (batch.hash, batch.publisher))
        if said[1] != batch.publisher:
            self.compared += 1
            self.unlike += said[0] != batch.hash
        while len(self._said) > 100_000:
            self._said.popitem(last=False)
        if self.heard:
            self.heard(batch)


def read_log(server, store):
    """Every message of the log, by its sequence, as Batch; what is no batch as None."""
    batches = []
    with NatsClient(server.port, host=server.address) as client:
        state = client.ask(f"$JS.API.STREAM.INFO.TALUS_{store}")["state"]
        client.subscribe(client.inbox + ".*", 7)
        asked, step = state["first_seq"], 500
        while asked <= state["last_seq"]:
            end = min(state["last_seq"], asked + step - 1)
            for sequence in range(asked, end + 1):
                client.publish(f"$JS.API.DIRECT.GET.TALUS_{store}", json.dumps({"seq": sequence}).encode(), f"{client.inbox}.{sequence}")
            answers = {}
            while len(answers) < end + 1 - asked:
                message = client.next()
                if message != "PONG":
                    answers[int(message[0].rsplit(".", 1)[1])] = message
            for sequence in range(asked, end + 1):
                _, head, payload = answers[sequence]
                if status(head) is not None:
                    raise AssertionError(f"message {sequence} of the log is not to be had: {head!r}")
                batches.append(read_batch(payload))
            asked = end + 1
    return batches
