"""A world over a stream of frames: one connection, with calls that block until they are answered."""

import collections
import itertools
import math
import time

import numpy as np

from . import protocol
from .chunk import Chunk
from .connection import Connection
from .edits import Editor, come_back, edit_message
from .errors import ServerError, ServerLeaving, WorldChanged, again_later
from .pace import Pace
from .protocol import ChunkKey, ChunkRequest, ErrorAbout
from .queries import Places, Queries
from .view_shape import CHUNK_SIZE, level_boxes, world_heights

_PROTOCOL = 2
_CODEC = 4
_REQUESTS_AT_ONCE = 64
# Small enough for the kernel's buffer: a server never waits for a program that computes between chunks.
_WINDOW_BYTES = 128 * 1024
_NOWHERE = protocol.View(centre=(1 << 40, 0, 0))


class World(Queries):
    """Created by talus.connect(). Use it from one thread at a time, and close it, or use `with`."""

    def __init__(self, servers, token="", context=None, timeout=10):
        """`servers`: (host, port) of each server of one world."""
        self._servers = itertools.cycle(servers)
        self.has_others = len(servers) > 1
        self._open_connection = lambda: Connection(*next(self._servers), context, _WINDOW_BYTES, timeout)
        self._token = token
        self._view = None
        self._next_id = self._view_number = 0
        self._attached = None
        self._editor = Editor(self)
        for last in range(len(servers) - 1, -1, -1):
            try:
                self._join()
                break
            except OSError:
                if last == 0:
                    raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self._connection.close()

    @property
    def materials(self):
        """Materials by id, with id, name, colour (0xRRGGBB) and phase."""
        return {material.id: material for material in self.welcome.materials}

    @property
    def heights_per_request(self):
        return self.welcome.limits.heights_per_request

    @property
    def spawn(self):
        """Base voxel (x, y, z) for a player's feet."""
        return self.welcome.spawn

    def ping(self):
        """Returns the round-trip time in seconds."""
        self._wake()
        nonce = self._new_id()
        self._ponged = None
        while self._ponged != nonce:
            try:
                if self._ponged is None:
                    self._ponged = 0
                    self._pace.wait(1)
                    began = time.monotonic()
                    self._connection.send(protocol.Ping(nonce=nonce))
                self._receive()
            except OSError as error:
                self._come_back(error)
                self._ponged = None
        return time.monotonic() - began

    def view(self, x, z, radius, *, y=None, vertical_radius=4, rings=(), horizon=False, direction=(0, 0, 0)):
        """Yields every Chunk around base voxel (x, y, z), nearest first, and ends when all have arrived.

        `radius` and `vertical_radius` are in chunks of level 0; `y` defaults to the ground. `rings`, (lod, radius)
        each, add coarser levels farther out, `horizon` extends them to all rows in which the world has anything, and
        chunks in `direction` come first. A world has one view at a time: a new one ends the previous one.
        """
        if y is None:
            y = self.heights([(math.floor(x), math.floor(z))])[0]
        if horizon and not self.welcome.limits.view_horizon:
            raise ValueError("this server knows no horizon; ask for a view without")
        self._wake()
        message = protocol.View(
            centre=(math.floor(x), math.floor(y), math.floor(z)),
            direction=tuple(direction),
            horizontal_radius=radius,
            vertical_radius=vertical_radius,
            rings=[tuple(ring) for ring in rings],
            number=self._new_view_number(),
            horizon=horizon,
        )
        heights = (self.welcome.min_y, self.welcome.max_y) if horizon else None
        view = _View(message, level_boxes(message.centre, radius, vertical_radius, rings, heights))
        if self._viewing:
            # The server sends a chunk again for the next view only if it left in between.
            self._send_view(_NOWHERE)
        self._view = view
        self._send_view(message)
        return self._follow(view)

    def edit(self, writes=(), *, guards=(), fills=(), paste=None, subject=""):
        """Changes voxels, once, even if the connection breaks meanwhile. Returns an EditDone when it is stored.

        `writes` and `guards`: ((x, y, z), material) each, in base voxels; if a guard's voxel has another material,
        nothing is applied. `fills`: a Fill each. `paste`: (origin, payload) or (origin, payload, with_air), with a
        Chunk's payload. Materials are ids or names. `subject`: the player that edits, if the token has the right
        "gateway". Raises ServerError if the edit was not applied (`conflict`: a guard does not hold; `overloaded`: the
        server took no edits for a minute), and OutcomeUnknown if that can no longer be known.
        """
        message = edit_message(self.welcome.materials, writes, guards, fills, paste, subject)
        if self.store_id == protocol.Hash128(0, 0):
            raise ServerError(protocol.ErrorCode.unsupported, "this server stores no edits")
        self._wake()
        return self._editor.edit(message)

    # ---- how it works ----

    @property
    def connection(self):
        return self._connection

    @property
    def store_id(self):
        return self.welcome.store_id

    def reconnect(self):
        self._connection.close()
        fingerprint, view = self.welcome.fingerprint, self._view
        self._join()
        if self.welcome.fingerprint != fingerprint:
            raise WorldChanged("the server has another world now; connect again")
        if view:
            self._view = view  # chunks received for it are kept
            if not view.complete:
                view.message.number = self._new_view_number()
                self._send_view(view.message)

    def _come_back(self, error):
        """Reconnects; unanswered requests must then be sent again."""
        if isinstance(error, protocol.ProtocolError):
            raise error
        come_back(self, error)

    def attach(self, message):
        self._pace.wait(1)
        self._attached = None
        self._connection.send(message)
        while self._attached is None:
            self._receive()
        return self._attached

    def send_edit(self, message):
        self._pace.wait(1)
        message.id = self._new_id()
        self._unanswered.add(message.id)
        self._connection.send(message)
        while message.id not in self._answers:
            self._receive()
        answer = self._answers.pop(message.id)
        if not isinstance(answer, (protocol.EditResult, protocol.Error)):
            raise protocol.ProtocolError("the answer to an Edit is not an EditResult")
        return answer

    def _join(self):
        self._connection = self._open_connection()
        self._credit = self._credited = 0
        self._unanswered, self._answers = set(), {}
        self._viewing, self._ponged = False, 0
        hello = protocol.Hello(
            protocol_min=_PROTOCOL,
            protocol_max=_PROTOCOL,
            codecs=bytes([_CODEC]),
            token=self._token,
            client="talus for Python",
            window_bytes=_WINDOW_BYTES,
        )
        try:
            self._connection.send(hello)
            welcome, _ = self._connection.receive()
            if isinstance(welcome, protocol.Error):
                raise ServerError(welcome.code, welcome.text, welcome.retry_after_ms)
            _check_welcome(welcome)
        except BaseException:
            self._connection.close()
            raise
        self.welcome = welcome
        self._connection.obey_idle_timeout(welcome.limits.idle_timeout_ms)
        self._pace = Pace(welcome.limits, sleep=self._connection.sleep)

    def _wake(self):
        """Reconnects if the client was idle for so long that the server has ended the session."""
        limit_ms = self.welcome.limits.idle_timeout_ms
        if limit_ms and self._connection.idle_s() * 1000 > 0.9 * limit_ms and not self._view:
            self.reconnect()

    def _new_id(self):
        self._next_id = self._next_id % 0xFFFFFFFF + 1
        return self._next_id

    def _new_view_number(self):
        self._view_number = self._view_number % 0xFFFFFFFF + 1
        return self._view_number

    def get_chunks(self, keys):
        self._wake()
        keys = iter(keys)
        asked = collections.deque()  # (id, key), in order
        to_ask = collections.deque()
        most = max(1, min(_REQUESTS_AT_ONCE, self.welcome.limits.requests_in_flight))
        try:
            while True:
                try:
                    # Half of them at once: messages with many requests are cheaper.
                    if len(asked) <= most // 2:
                        to_ask.extend(itertools.islice(keys, most - len(asked) - len(to_ask)))
                        asked += self._ask_for(list(to_ask))
                        to_ask.clear()
                        if not asked:
                            return
                    id, key = asked[0]
                    while id not in self._answers:
                        self._receive()
                    answer = self._answers.pop(id)
                    if isinstance(answer, protocol.Error):
                        error = ServerError(answer.code, f"chunk {key}: {answer.text}", answer.retry_after_ms)
                        if not again_later(error):
                            raise error
                        asked[0] = self._ask_for([key])[0]
                        continue
                except OSError as error:
                    to_ask.extendleft(key for _, key in reversed(asked))
                    asked.clear()
                    self._come_back(error)
                    continue
                asked.popleft()
                if not isinstance(answer, protocol.Chunk) or answer.key != key:
                    raise protocol.ProtocolError(f"the answer to a request for chunk {key} is not a chunk")
                yield _chunk(answer)
        finally:
            self._forget(id for id, _ in asked)

    def _ask_for(self, keys):
        asked = []
        while len(asked) < len(keys):
            count = self._pace.wait(len(keys) - len(asked))
            now = [(self._new_id(), key) for key in keys[len(asked) : len(asked) + count]]
            self._unanswered.update(id for id, _ in now)
            requests = [ChunkRequest(id, ChunkKey(*key), False, protocol.Hash128(0, 0)) for id, key in now]
            self._connection.send(protocol.GetChunks(requests=requests))
            asked += now
        return asked

    def _forget(self, ids):
        """Drops requests whose answers are not needed."""
        ids = list(ids)
        for id in ids:
            self._answers.pop(id, None)
        open_ids = [id for id in ids if id in self._unanswered]
        self._unanswered.difference_update(open_ids)
        if open_ids:
            try:
                self._connection.send(protocol.Cancel(ids=open_ids))
            except OSError:
                pass  # the next call will report it

    def get_places(self, columns, looks, fields):
        self._wake()
        known = list(self.welcome.fields)
        for field in fields:
            if field not in known:
                raise ValueError(f"this world has no field {field!r}; it has {', '.join(known)}")
        message = protocol.GetHeights(columns=columns, looks=looks, fields=bytes(known.index(f) for f in fields))
        answer = None
        while answer is None:
            try:
                self._pace.wait(1)
                message.id = self._new_id()
                self._unanswered.add(message.id)
                self._connection.send(message)
                while message.id not in self._answers:
                    self._receive()
            except OSError as error:
                self._come_back(error)
                continue
            answer = self._answers.pop(message.id)
            if isinstance(answer, protocol.Error):
                error = ServerError(answer.code, answer.text, answer.retry_after_ms)
                if not again_later(error):
                    raise error
                answer = None
        return self._places(answer, len(columns), looks, fields)

    def _places(self, answer, count, looks, fields):
        names = self.welcome.looks
        expected = (count, count if looks and names else 0, count * len(fields))
        if (
            not isinstance(answer, protocol.Heights)
            or (len(answer.heights_fx), len(answer.looks), len(answer.values)) != expected
            or any(look >= len(names) for look in answer.looks)
        ):
            raise protocol.ProtocolError("the answer to GetHeights is not what was asked for")
        values = np.array(answer.values, np.float32).reshape(count, len(fields))
        return Places(
            np.array(answer.heights_fx, float) / 256,
            [names[look] for look in answer.looks] or [""] * (count if looks else 0),
            {field: values[:, i] for i, field in enumerate(fields)},
        )

    def _send_view(self, message):
        self._pace.wait(1)
        self._connection.send(message)
        self._viewing = message is not _NOWHERE

    def _follow(self, view):
        try:
            while True:
                if self._view is not view:
                    raise RuntimeError("a newer view has ended this one")
                while view.ready:
                    yield view.ready.popleft()
                    if self._view is not view:
                        break
                    self._carry_on(self._connection.keep_alive)
                else:
                    if view.lost:  # the server could not make them for the view
                        yield from self.chunks([view.lost.popleft()])
                    elif view.complete:
                        return
                    else:
                        self._carry_on(self._receive)
        finally:
            if self._view is view:
                self._view = None
                if not view.complete:
                    try:
                        self._send_view(_NOWHERE)
                    except OSError:
                        pass

    def _carry_on(self, work):
        try:
            work()
        except OSError as error:
            self._come_back(error)

    def _receive(self):
        """Receives one message and stores it for the waiting call."""
        message, size = self._connection.receive()
        kind = type(message)
        if kind in (protocol.Chunk, protocol.Unchanged, protocol.EditBroadcast):
            self._editor.saw(message.revision)
        if kind is protocol.Chunk:
            if message.key is None or message.hash is None:
                raise protocol.ProtocolError("a Chunk without key or hash")
            self._take_credit(size)
        if kind in (protocol.Chunk, protocol.Unchanged, protocol.Heights, protocol.EditResult) and message.id:
            self._answer(message.id, message)
        elif kind is protocol.Chunk:
            if self._view:
                self._view.put(_chunk(message))
        elif kind is protocol.UniformColumn:
            if self._view:
                self._view.put_column(message)
        elif kind is protocol.ViewComplete:
            if self._view and self._view.message.number == message.number:
                self._view.complete = True
        elif kind is protocol.Pong:
            self._ponged = message.nonce
        elif kind is protocol.GoAway:
            raise ServerLeaving(message.reason, message.retry_after_ms)
        elif kind is protocol.Attached:
            self._attached = message
        elif kind is protocol.Error:
            self._receive_error(message)
        elif kind is not protocol.EditBroadcast:
            raise protocol.ProtocolError(f"the server sent a {kind.__name__} that was not requested")

    def _answer(self, id, message):
        if id in self._unanswered:  # otherwise given up
            self._unanswered.discard(id)
            self._answers[id] = message

    def _receive_error(self, message):
        error = ServerError(message.code, message.text, message.retry_after_ms)
        if again_later(error) and message.about != ErrorAbout.connection:
            self._pace.refused(message.retry_after_ms)
        if message.about == ErrorAbout.request:
            self._answer(message.request_id, message)
        elif message.about == ErrorAbout.view:
            view = self._view
            if again_later(error):
                if message.view_number == 0:
                    self._send_view(_NOWHERE)
                if view and message.view_number in (0, view.message.number):
                    # With a new number: a completed View may lack the chunks for which this one was refused.
                    view.message.number = self._new_view_number()
                    self._send_view(view.message)
            elif view and view.message.number == message.view_number:
                self._view = None
                raise error
        elif message.about == ErrorAbout.attach:
            self._attached = message
        elif message.about == ErrorAbout.view_chunk:
            if self._view and self._view.message.number == message.view_number and message.chunk:
                self._view.lose(message.chunk)
        elif message.about == ErrorAbout.ping and again_later(error):
            self._ponged = None
        else:
            raise error

    def _take_credit(self, size):
        self._credit += size
        # Everything received is kept until it is taken, bounded by the view's number of chunks.
        if self._credit - self._credited >= self.welcome.limits.window_bytes // 2:
            self._credited = self._credit
            self._connection.send(protocol.Credit(total_bytes=self._credit))


class _View:
    """Chunks of a view received and not taken. Repeated chunks, and chunks outside the view, are dropped."""

    def __init__(self, message, boxes):
        self.message = message
        self.boxes = {box.lod: box for box in boxes}
        self.ready, self.lost = collections.deque(), collections.deque()
        self.seen = set()
        self.complete = False

    def put(self, chunk):
        box = self.boxes.get(chunk.key.lod)
        if box is not None and chunk.key in box and chunk.key not in self.seen:
            self.seen.add(chunk.key)
            self.ready.append(chunk)

    def lose(self, key):
        box = self.boxes.get(key.lod)
        if box is not None and key in box and key not in self.seen:
            self.seen.add(key)
            self.lost.append(key)

    def put_column(self, column):
        box = self.boxes.get(column.lod)
        if box is None or not box.has_column(column.x, column.z):
            return
        for run in column.runs:
            for y in range(max(run.first_y, box.y.start), min(run.last_y + 1, box.y.stop)):
                self.put(Chunk.uniform((column.x, y, column.z, column.lod), run.material))


def _chunk(message):
    return Chunk(message.key, message.payload, message.hash.high << 64 | message.hash.low, message.revision)


def _check_welcome(welcome):
    if not isinstance(welcome, protocol.Welcome) or not (welcome.limits and welcome.fingerprint and welcome.spawn):
        raise protocol.ProtocolError("the server did not answer Hello by a whole Welcome")
    if welcome.chunk_size != CHUNK_SIZE:
        raise protocol.ProtocolError(
            f"the server's chunks have {welcome.chunk_size} voxels along an edge; this client reads chunks of {CHUNK_SIZE}"
        )
    if welcome.protocol != _PROTOCOL:
        raise protocol.ProtocolError(f"Welcome picks protocol version {welcome.protocol}, which was not offered")
    if welcome.codec != _CODEC:
        raise protocol.ProtocolError(f"Welcome picks chunk codec {welcome.codec}, which was not offered")
    for material in welcome.materials:
        if not isinstance(material.phase, protocol.Phase):
            raise protocol.ProtocolError("Welcome has a material of an unknown phase")
    world_heights(welcome.min_y, welcome.max_y)
