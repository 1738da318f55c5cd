"""Edits: what is sent again, and as what, whatever the connection does; and against a real talusd."""

import os
import pathlib
import signal
import socket
import tempfile
import unittest
from unittest import mock

import paths  # noqa: F401
from server import Server, needs_programs
from test_world import Scripted, welcome

import talus
from talus import edits, protocol
from talus.protocol import ErrorAbout, ErrorCode

EDITOR = protocol.Hash128(7, 9)
WRITE = ([((1, 2, 3), 5)],)


def greeting(store=3):
    message = welcome()
    message.store_id = protocol.Hash128(store, 4)
    message.materials = [protocol.Material(id=0, name="air"), protocol.Material(id=5, name="stone")]
    return message


def attached(known=False, last_sequence=0, revision=0):
    limits = protocol.EditLimits(unanswered=64)
    return protocol.Attached(
        editor=EDITOR, epoch=1, last_sequence=last_sequence, known=known, revision=revision, limits=limits
    )


def error(id, code, **more):
    return protocol.Error(code=code, text="so it is", request_id=id, about=ErrorAbout.request, **more)


class Edits(Scripted):
    def setUp(self):
        patch = mock.patch.multiple(edits, FIRST_DELAY_S=0.001, LONGEST_DELAY_S=0.01)
        patch.start()
        self.addCleanup(patch.stop)

    def attach(self, peer, **how):
        asked = peer.receive()
        self.assertIs(type(asked), protocol.Attach)
        peer.send(attached(**how))
        return asked

    def test_an_edit_is_sent_as_it_is_given(self):
        def script(peer):
            self.assertEqual(peer.greet(greeting()).protocol_max, 2)
            self.assertEqual(self.attach(peer, last_sequence=20).editor, protocol.Hash128(0, 0))
            sent = peer.receive()
            self.assertEqual(sent.sequence, 21)
            self.assertEqual([tuple(write.voxel) + (write.material,) for write in sent.writes], [(1, 2, 3, 5)])
            self.assertEqual([tuple(guard.voxel) + (guard.material,) for guard in sent.guards], [(4, 5, 6, 0)])
            boxes = [(tuple(f.first), tuple(f.last), f.material, f.only, f.flags) for f in sent.fills]
            self.assertEqual(boxes, [((0, 0, 0), (7, 8, 9), 5, 0, 1), ((0, 0, 0), (1, 1, 1), 0, 5, 2)])
            self.assertEqual((tuple(sent.paste.origin), sent.paste.payload, sent.paste.with_air), ((9, 9, 9), b"\1\2", False))
            self.assertEqual(sent.subject, "bob")
            peer.send(protocol.EditResult(id=sent.id, revision=8, changed=2))
            again = peer.receive()
            self.assertEqual(again.sequence, 22)
            peer.send(protocol.EditResult(id=again.id, revision=8, changed=0))

        with talus.connect(self.serve(script)) as world:
            fills = [talus.Fill((7, 0, 9), (0, 8, 0), "stone"), ((0, 0, 0), (1, 1, 1), None, "stone")]
            done = world.edit(*WRITE, guards=[((4, 5, 6), "air")], fills=fills, paste=((9, 9, 9), b"\1\2"), subject="bob")
            self.assertEqual(done, talus.EditDone(8, 2))
            self.assertEqual(world.edit(*WRITE).changed, 0)
            for wrong in (b"", (b"\1", (0, 0, 0)), ((0, 0, 0),), ((0, 0), b"\1"), [[[1]]], "abc"):
                with self.assertRaisesRegex(TypeError, "^paste: "):
                    world.edit(paste=wrong)
            with self.assertRaisesRegex(ValueError, "no material 'gold'; it has air, stone"):
                world.edit([((0, 0, 0), "gold")])

    def test_after_a_lost_connection_it_goes_again_with_its_sequence(self):
        turns = []

        def script(peer):
            peer.greet(greeting())
            asked = self.attach(peer, known=bool(turns), last_sequence=len(turns))
            sent = peer.receive()
            turns.append((asked.editor, asked.seen_revision, sent.sequence))
            if len(turns) == 1:
                peer.send(protocol.EditBroadcast(key=protocol.ChunkKey(0, 0, 0, 0), revision=30, previous_revision=1))
                return  # the connection breaks
            peer.send(protocol.EditResult(id=sent.id, revision=31, changed=1))

        with talus.connect(self.serve(script, connections=2)) as world:
            self.assertEqual(world.edit(*WRITE).revision, 31)
        self.assertEqual(turns, [(protocol.Hash128(0, 0), 0, 1), (EDITOR, 30, 1)])

    def forgotten(self, second_greeting):
        """What becomes of an edit without an answer, where the next connection does not know its editor."""
        greetings = [greeting(), second_greeting]

        def script(peer):
            peer.greet(greetings.pop(0))
            self.attach(peer, known=False)
            if greetings:
                peer.receive()  # the edit; then the connection breaks

        with talus.connect(self.serve(script, connections=2)) as world:
            with self.assertRaises(talus.OutcomeUnknown):
                world.edit(*WRITE)

    def test_if_the_server_has_forgotten_the_editor_the_outcome_is_unknown(self):
        self.forgotten(greeting())

    def test_in_another_store_the_outcome_is_unknown(self):
        self.forgotten(greeting(store=4))

    def test_a_refused_edit_is_sent_again_and_one_not_applied_as_new(self):
        def script(peer):
            peer.greet(greeting())
            self.attach(peer)
            sent = peer.receive()
            peer.send(error(sent.id, ErrorCode.overloaded, retry_after_ms=1))
            again = peer.receive()
            self.assertEqual(again.sequence, sent.sequence)
            peer.send(error(again.id, ErrorCode.not_applied))
            fresh = peer.receive()
            self.assertEqual(fresh.sequence, sent.sequence + 1)
            peer.send(error(fresh.id, ErrorCode.expired))
            self.attach(peer, known=True, last_sequence=fresh.sequence)
            last = peer.receive()
            self.assertEqual(last.sequence, fresh.sequence)
            peer.send(protocol.EditResult(id=last.id, revision=1, changed=1))

        with talus.connect(self.serve(script)) as world:
            self.assertEqual(world.edit(*WRITE).changed, 1)

    def test_a_conflict_is_said_and_a_refusal_of_what_was_sent_before_is_not_believed(self):
        def script(peer):
            peer.greet(greeting())
            self.attach(peer)
            peer.send(error(peer.receive().id, ErrorCode.conflict))
            peer.send(error(peer.receive().id, ErrorCode.forbidden))
            peer.send(error(peer.receive().id, ErrorCode.overloaded, retry_after_ms=1))
            peer.send(error(peer.receive().id, ErrorCode.forbidden))

        with talus.connect(self.serve(script)) as world:
            for code in ("conflict", "forbidden"):
                with self.assertRaises(talus.ServerError) as raised:
                    world.edit(*WRITE)
                self.assertEqual(raised.exception.code.name, code)
            with self.assertRaisesRegex(talus.OutcomeUnknown, "forbidden: so it is; the edit was sent before"):
                world.edit(*WRITE)

    def test_a_refused_attach_is_said(self):
        def script(peer):
            peer.greet(greeting())
            peer.receive()
            peer.send(protocol.Error(code=ErrorCode.forbidden, text="no right", about=ErrorAbout.attach))

        with talus.connect(self.serve(script)) as world:
            with self.assertRaisesRegex(talus.ServerError, "forbidden: no right"):
                world.edit(*WRITE)

    def test_a_server_that_never_comes_back_leaves_the_outcome_unknown(self):
        def script(peer):
            peer.greet(greeting())
            self.attach(peer)
            peer.receive()

        with mock.patch.object(edits, "KEEP_TRYING_S", 0.05), talus.connect(self.serve(script)) as world:
            world._open_connection = mock.Mock(side_effect=ConnectionRefusedError("nobody"))
            with self.assertRaisesRegex(talus.OutcomeUnknown, "nobody; the edit was sent"):
                world.edit(*WRITE)

    def test_a_server_that_takes_no_edits_is_not_waited_for_without_end(self):
        attaches = False
        put_off = {"code": ErrorCode.overloaded, "text": "so it is", "retry_after_ms": 1}

        def script(peer):
            peer.greet(greeting())
            while message := peer.receive():
                if type(message) is protocol.Edit:
                    peer.send(protocol.Error(request_id=message.id, about=ErrorAbout.request, **put_off))
                elif attaches:
                    peer.send(attached())
                else:
                    peer.send(protocol.Error(about=ErrorAbout.attach, **put_off))

        with mock.patch.object(edits, "KEEP_TRYING_S", 0.05), talus.connect(self.serve(script)) as world:
            for attaches in (False, True):
                with self.assertRaisesRegex(talus.ServerError, "overloaded: so it is"):
                    world.edit(*WRITE)

    def test_a_refusal_after_a_lost_connection_leaves_the_outcome_unknown(self):
        answers = [attached(), protocol.Error(code=ErrorCode.forbidden, text="no right", about=ErrorAbout.attach)]

        def script(peer):
            peer.greet(greeting())
            peer.receive()
            peer.send(answers.pop(0))
            if answers:
                peer.receive()  # the edit; then the connection breaks

        with talus.connect(self.serve(script, connections=2)) as world:
            with self.assertRaisesRegex(talus.OutcomeUnknown, "no right; the edit was sent before"):
                world.edit(*WRITE)

    def test_a_server_that_stores_nothing_takes_no_edits(self):
        with talus.connect(self.serve(lambda peer: peer.greet())) as world:
            with self.assertRaisesRegex(talus.ServerError, "stores no edits"):
                world.edit(*WRITE)


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as probe:
        return probe.getsockname()[1]


@needs_programs
class Live(unittest.TestCase):
    def test_edits_are_stored_once_and_seen_though_the_server_is_killed(self):
        with tempfile.TemporaryDirectory() as folder:
            settings = {
                "TALUS_DATA": str(pathlib.Path(folder) / "data"),
                "TALUS_ACCESS_WITHOUT_TOKEN": "read,edit",
                "TALUS_LISTEN": f"127.0.0.1:{free_port()}",
            }
            server = Server(**settings)
            try:
                with talus.connect(server.address) as world:
                    x, y, z = world.spawn
                    y += 40
                    stone = next(m.name for m in world.materials.values() if m.phase == protocol.Phase.solid)
                    for i in range(8):
                        if i == 4:
                            os.kill(server.process.pid, signal.SIGKILL)
                            server.__exit__()
                            server = Server(**settings)
                        # Applied twice, its guard would not hold.
                        self.assertEqual(world.edit([((x + i, y, z), stone)], guards=[((x + i, y, z), "air")]).changed, 1)
                    for i in range(8):
                        at = (x + i) // 32, y // 32, z // 32
                        self.assertNotEqual(world.chunk(*at).voxels[y % 32, z % 32, (x + i) % 32], 0)
                    box = talus.Fill((x, y, z), (x + 7, y, z))
                    self.assertEqual(world.edit(fills=[box]).changed, 8)
                    payload = world.chunk(x // 32, y // 32, z // 32).payload
                    self.assertGreaterEqual(world.edit(paste=((x, y + 64, z), payload)).changed, 0)
            finally:
                server.__exit__()


if __name__ == "__main__":
    unittest.main()
