"""Edits, each applied once even if the connection breaks: PROTOCOL.md, "Edit" and "After a lost connection"."""

import collections
import random
import time

from . import protocol
from .errors import OutcomeUnknown, ServerError, WorldChanged, again_later
from .protocol import ErrorCode

KEEP_TRYING_S = 60  # maximum time of retries of an edit that gets no answer or that the server puts off
FIRST_DELAY_S, LONGEST_DELAY_S = 0.1, 5

_NOBODY = protocol.Hash128(0, 0)
_OF_ANY, _AS_GENERATED = 1, 2  # flags of a Fill

EditDone = collections.namedtuple("EditDone", "revision changed")
EditDone.__doc__ = "The edit is stored: the world's revision after it, and how many voxels it changed."

Fill = collections.namedtuple("Fill", "first last material only", defaults=(None, None))
Fill.__doc__ = """Every voxel of the box between two corners, both included and in any order. `material`: id or name; None: as
generated, which undoes edits. `only`: voxels of other materials stay; None: of any."""


def edit_message(materials, writes, guards, fills, paste, subject):
    """Converts world.edit()'s arguments to an Edit."""
    ids = {material.name: material.id for material in materials}

    def id_of(material):
        if not isinstance(material, str):
            return material
        if material not in ids:
            raise ValueError(f"this world has no material {material!r}; it has {', '.join(ids)}")
        return ids[material]

    def fill(given):
        given = Fill(*given)
        first, last = (tuple(pick(pair) for pair in zip(given.first, given.last)) for pick in (min, max))
        flags = _OF_ANY * (given.only is None) | _AS_GENERATED * (given.material is None)
        return protocol.Fill(first, last, id_of(given.material or 0), id_of(given.only or 0), flags)

    def pasted(given):
        if not isinstance(given, (tuple, list)) or len(given) not in (2, 3):
            raise TypeError(f"paste: (origin, payload[, with_air]) is needed, not {type(given).__name__}")
        origin, payload, with_air = (*given, False)[:3]
        if not isinstance(payload, (bytes, bytearray, memoryview)):
            raise TypeError(f"paste: the payload is the bytes of a Chunk's, not {type(payload).__name__}")
        if not isinstance(origin, (tuple, list)) or len(origin) != 3:
            raise TypeError("paste: the origin is (x, y, z)")
        return protocol.Paste(origin=tuple(origin), payload=bytes(payload), with_air=bool(with_air))

    return protocol.Edit(
        guards=[(tuple(voxel), id_of(material)) for voxel, material in guards],
        writes=[(tuple(voxel), id_of(material)) for voxel, material in writes],
        fills=[fill(each) for each in fills],
        paste=None if paste is None else pasted(paste),
        subject=subject,
    )


class Editor:
    """A world's editor, across all its connections.

    `link` connects and sends: attach(message) and send_edit(message) send a message and return its answer, reconnect()
    begins a new connection, connection is the current one, store_id its world's store, and has_others is true if the
    next connection is to another server.
    """

    def __init__(self, link):
        self._link = link
        self._id = _NOBODY
        self._store_id = None
        self._last_sequence = 0
        self._seen_revision = 0
        self._attached_by = None  # the connection

    def saw(self, revision):
        self._seen_revision = max(self._seen_revision, revision)

    def edit(self, message):
        """Sends an edit until its outcome is known, or for KEEP_TRYING_S. Raises ServerError if it was not applied, and
        OutcomeUnknown if that can no longer be known."""
        message.sequence = 0
        sent = False  # and so it may have happened
        unanswered = False  # since its connection broke
        give_up = None
        while True:
            try:
                try:
                    known = self._attach()
                except ServerError as refused:
                    raise self._outcome(refused, unanswered) from refused
                if not known and sent:
                    raise OutcomeUnknown("the server has forgotten who sent the edit: it may have happened")
                if message.sequence == 0:
                    self._last_sequence += 1
                    message.sequence = self._last_sequence
                again, sent = sent, True
                answer = self._link.send_edit(message)
            except protocol.ProtocolError:
                raise
            except OSError as error:
                unanswered = sent
                give_up = self._reconnect(error, sent, give_up)
                continue
            if isinstance(answer, protocol.EditResult):
                self.saw(answer.revision)
                return EditDone(answer.revision, answer.changed)
            error = ServerError(answer.code, answer.text, answer.retry_after_ms)
            if again_later(error):
                give_up = give_up or time.monotonic() + KEEP_TRYING_S
                if time.monotonic() >= give_up:
                    raise self._outcome(error, unanswered)
            elif error.code == ErrorCode.expired:
                self._attached_by = None
            elif error.code == ErrorCode.not_applied:
                message.sequence, sent, unanswered = 0, False, False
            else:
                raise self._outcome(error, again and error.code != ErrorCode.conflict)

    @staticmethod
    def _outcome(error, unknown):
        if not unknown:
            return error
        return OutcomeUnknown(f"{error}; the edit was sent before, and its outcome is unknown")

    def _attach(self):
        """Returns true if the server knows the editor of earlier connections."""
        if self._attached_by is self._link.connection:
            return True
        if self._store_id != self._link.store_id:
            self._id, self._seen_revision, self._last_sequence = _NOBODY, 0, 0
            self._store_id = self._link.store_id
        give_up = time.monotonic() + KEEP_TRYING_S
        while True:
            answer = self._link.attach(protocol.Attach(editor=self._id, seen_revision=self._seen_revision))
            if isinstance(answer, protocol.Attached):
                break
            error = ServerError(answer.code, answer.text, answer.retry_after_ms)
            if not again_later(error) or time.monotonic() >= give_up:
                raise error
        self._id = answer.editor or _NOBODY
        self._last_sequence = max(self._last_sequence if answer.known else 0, answer.last_sequence)
        self._attached_by = self._link.connection
        self.saw(answer.revision)
        return answer.known

    def _reconnect(self, error, sent, give_up):
        """Begins a new connection; returns the time to give up. `give_up`: that time, unless this is the first try."""
        give_up = give_up or time.monotonic() + KEEP_TRYING_S
        try:
            come_back(self._link, error, give_up)
        except (OSError, ServerError) as failed:
            if not sent:
                raise
            raise OutcomeUnknown(f"{failed}; the edit was sent, and may have happened") from failed
        return give_up


def come_back(link, error, give_up=None):
    """Begins a new connection after `error`; raises the last error at `give_up`, or if trying is useless."""
    give_up = give_up or time.monotonic() + KEEP_TRYING_S
    delay = FIRST_DELAY_S
    while True:
        # A delay requested by a server applies to this server, not to the next one.
        asked = 0 if link.has_others else getattr(error, "retry_after_ms", 0) / 1000
        # Random, so that the clients of one server do not return all at once.
        time.sleep(min(max(random.uniform(0, delay), asked), LONGEST_DELAY_S))
        if time.monotonic() > give_up:
            raise error
        delay = min(2 * delay, LONGEST_DELAY_S)
        try:
            link.reconnect()
            return
        except WorldChanged:
            raise
        except ServerError as refused:
            if not again_later(refused):
                raise
            error = refused
        except OSError as failed:
            error = failed
