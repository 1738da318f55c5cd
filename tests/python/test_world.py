"""World against a server that a test scripts: what goes wrong, and what must wait."""

import queue
import socket
import threading
import unittest
from unittest import mock

import numpy as np

import paths  # noqa: F401

import talus
from talus import edits, pace, protocol
from talus.protocol import ErrorAbout, ErrorCode

UNIFORM = bytes.fromhex("030001ac02")  # of the vectors
UNIFORM_HASH = protocol.Hash128(0x77FFA3CA1005EF6D, 0x8FD40E1B20C8F078)


def welcome(fields=None, **limits):
    """`fields`: of Welcome, in place of the usual ones."""
    given = dict(frame_bytes=65536, requests_in_flight=64, heights_per_request=2048, window_bytes=1 << 17)
    usual = dict(
        protocol=2,
        codec=4,
        fingerprint=protocol.Hash128(1, 2),
        store_id=protocol.Hash128(0, 0),
        chunk_size=32,
        max_y=320,
        spawn=(0, 64, 0),
        limits=protocol.Limits(**{**given, **limits}),
        looks=["", "desert"],
        fields=["height", "temperature"],
    )
    return protocol.Welcome(**{**usual, **(fields or {})})


class Peer:
    """The server's side of one connection."""

    def __init__(self, connection):
        self.socket = connection
        self.file = connection.makefile("rb")

    def receive(self):
        prefix = self.file.read(4)
        if len(prefix) < 4:
            return None
        return protocol.read(prefix + self.file.read(int.from_bytes(prefix, "little")))

    def send(self, message):
        self.socket.sendall(message if isinstance(message, bytes) else protocol.write(message))

    def greet(self, answer=None):
        hello = self.receive()
        self.send(answer or welcome())
        return hello

    def ids(self):
        return [request.id for request in self.receive().requests]


class Scripted(unittest.TestCase):
    """Runs `script`, a function of a Peer, for each connection."""

    def serve(self, script, connections=1):
        listener = socket.create_server(("127.0.0.1", 0))
        self.failures = []

        def run():
            for _ in range(connections):
                connection, _ = listener.accept()
                with connection:
                    try:
                        script(Peer(connection))
                    except Exception as error:
                        self.failures.append(error)

        thread = threading.Thread(target=run, daemon=True)
        thread.start()

        def end():
            thread.join(20)
            listener.close()
            self.assertFalse(thread.is_alive(), "the script did not end")
            self.assertEqual(self.failures, [])

        self.addCleanup(end)
        return f"127.0.0.1:{listener.getsockname()[1]}"

    def chunk(self, id, key, **fields):
        given = dict(id=id, key=protocol.ChunkKey(*key), hash=UNIFORM_HASH, codec=4, payload=UNIFORM)
        return protocol.Chunk(**{**given, **fields})


class Requests(Scripted):
    def test_hello_offers_codec_4_and_carries_the_token(self):
        seen = queue.Queue()
        with talus.connect(self.serve(lambda peer: seen.put(peer.greet())), token="open sesame"):
            pass
        hello = seen.get(timeout=20)
        self.assertEqual((hello.codecs, hello.token, hello.protocol_min), (b"\4", "open sesame", 2))

    def test_answers_may_come_in_any_order(self):
        keys = [(x, 2, 3, 1) for x in range(5)]

        def script(peer):
            peer.greet()
            for id, key in sorted(zip(peer.ids(), keys), reverse=True):
                peer.send(self.chunk(id, key))

        with talus.connect(self.serve(script)) as world:
            self.assertEqual([tuple(chunk.key) for chunk in world.chunks(keys)], keys)

    def test_voxels_that_do_not_match_the_hash_are_refused(self):
        def script(peer):
            peer.greet()
            peer.send(self.chunk(peer.ids()[0], (0, 0, 0, 0), hash=protocol.Hash128(1, 1)))

        with talus.connect(self.serve(script)) as world:
            with self.assertRaises(talus.DecodeError) as raised:
                world.chunk(0, 0, 0).voxels
            self.assertEqual(raised.exception.reason, "wrong_hash")

    def test_an_overloaded_request_is_sent_again(self):
        def script(peer):
            peer.greet()
            for id in peer.ids():
                peer.send(protocol.Error(code=ErrorCode.overloaded, text="wait", request_id=id, retry_after_ms=1,
                                         about=ErrorAbout.request))
            for key in ((0, 0, 0, 0), (1, 0, 0, 0)):
                peer.send(self.chunk(peer.ids()[0], key))

        with talus.connect(self.serve(script)) as world:
            self.assertEqual([chunk.key.x for chunk in world.chunks([(0, 0, 0), (1, 0, 0)])], [0, 1])

    def test_another_error_is_raised_and_the_world_stays(self):
        def script(peer):
            peer.greet()
            peer.send(protocol.Error(code=ErrorCode.out_of_range, text="no", request_id=peer.ids()[0],
                                     about=ErrorAbout.request))
            peer.send(self.chunk(peer.ids()[0], (1, 1, 1, 0)))

        with talus.connect(self.serve(script)) as world:
            with self.assertRaisesRegex(talus.ServerError, r"out_of_range: chunk \(0, 0, 0, 7\): no"):
                world.chunk(0, 0, 0, lod=7)
            self.assertEqual(int(world.chunk(1, 1, 1).voxels[0, 0, 0]), 300)

    def test_requests_without_a_waiting_caller_are_cancelled(self):
        seen = queue.Queue()

        def script(peer):
            peer.greet()
            ids = peer.ids()
            peer.send(self.chunk(ids[0], (0, 0, 0, 0)))
            seen.put((ids, peer.receive()))
            for id in ids[1:] + peer.ids():
                peer.send(self.chunk(id, (7, 7, 7, 0)))

        with talus.connect(self.serve(script)) as world:
            chunks = world.chunks((x, 0, 0) for x in range(100))
            next(chunks)
            chunks.close()
            ids, cancel = seen.get(timeout=20)
            self.assertEqual(len(ids), 64)
            self.assertEqual(sorted(cancel.ids), ids[1:])
            # Those that were on their way already are not kept.
            self.assertEqual(int(world.chunk(7, 7, 7).voxels[0, 0, 0]), 300)
            self.assertEqual(world._answers, {})

    def test_columns_that_are_too_many_are_asked_for_in_halves(self):
        def script(peer):
            peer.greet()
            request = peer.receive()
            peer.send(protocol.Error(code=ErrorCode.too_large, text="tiles", request_id=request.id,
                                     about=ErrorAbout.request))
            for _ in range(2):
                request = peer.receive()
                peer.send(protocol.Heights(id=request.id, heights_fx=[256 * c.x + 128 for c in request.columns]))

        with talus.connect(self.serve(script)) as world:
            self.assertEqual(world.heights([(x, 0) for x in range(5)]).tolist(), [0.5, 1.5, 2.5, 3.5, 4.5])

    def test_columns_are_whole_numbers(self):
        def script(peer):
            peer.greet()
            request = peer.receive()
            peer.send(protocol.Heights(id=request.id, heights_fx=[256 * c.x for c in request.columns]))

        with talus.connect(self.serve(script)) as world:
            for column in [(0.5, 3), (0, 3.0), (np.float64(1), 0), ("1", 0), (float("nan"), 0)]:
                for call in (world.heights, world.places):
                    with self.assertRaisesRegex(TypeError, "is not an int; math.floor"):
                        call([(7, 7), column])
            columns = [(1, 0), (np.int64(-2), np.int32(0)), np.array([3, 0])]
            self.assertEqual(world.heights(columns).tolist(), [1, -2, 3])

    def test_a_place_within_a_voxel_is_that_voxels(self):
        seen = queue.Queue()

        def script(peer):
            peer.greet()
            request = peer.receive()
            seen.put(request.columns)
            peer.send(protocol.Heights(id=request.id, heights_fx=[-128]))
            seen.put(peer.receive().centre)

        with talus.connect(self.serve(script)) as world:
            world.view(-0.5, 7.9, 1)
            self.assertEqual(seen.get(timeout=20), [(-1, 7)])
            self.assertEqual(seen.get(timeout=20), (-1, -1, 7))

    def test_credit_is_given_by_the_half_window(self):
        noise = bytes.fromhex("0402") + bytes(65536)
        seen = queue.Queue()

        def script(peer):
            peer.greet()
            sent = 0
            for key in ((0, 0, 0, 0), (1, 0, 0, 0)):
                message = protocol.write(self.chunk(peer.ids()[0], key, payload=noise))
                sent += len(message)
                peer.send(message)
                seen.put((peer.receive().total_bytes, sent))

        with talus.connect(self.serve(script)) as world:
            world.chunk(0, 0, 0)
            world.chunk(1, 0, 0)
        for _ in range(2):
            self.assertEqual(*seen.get(timeout=20))

    def test_after_a_long_silence_the_session_is_begun_again(self):
        def script(peer):
            peer.greet(welcome(idle_timeout_ms=1))
            request = peer.receive()
            if request:  # of the second connection
                peer.send(self.chunk(request.requests[0].id, (0, 0, 0, 0)))

        with talus.connect(self.serve(script, connections=2)) as world:
            world._connection.sent_at -= 1
            self.assertEqual(world.chunk(0, 0, 0).payload, UNIFORM)


class Views(Scripted):
    def test_columns_chunks_and_chunks_that_were_given_up_make_a_view(self):
        def script(peer):
            peer.greet()
            view = peer.receive()
            # More rows than the view has, a chunk of another view and one twice: nothing of this may show.
            runs = [protocol.UniformRun(-(1 << 31), 1, 7), protocol.UniformRun(4, (1 << 31) - 1, 9)]
            peer.send(protocol.UniformColumn(x=0, z=0, runs=runs))
            for y in (2, 2, 90):
                peer.send(self.chunk(0, (0, y, 0, 0)))
            peer.send(protocol.Error(code=ErrorCode.internal, about=ErrorAbout.view_chunk, view_number=view.number,
                                     chunk=protocol.ChunkKey(0, 3, 0, 0)))
            peer.send(protocol.ViewComplete(number=view.number))
            peer.send(self.chunk(peer.ids()[0], (0, 3, 0, 0)))

        with talus.connect(self.serve(script)) as world:
            chunks = list(world.view(0, 0, 0, y=64, vertical_radius=1))
        self.assertEqual([tuple(chunk.key) for chunk in chunks], [(0, y, 0, 0) for y in (1, 2, 3)])
        self.assertEqual([int(chunk.voxels.max()) for chunk in chunks], [7, 300, 300])

    def test_a_view_that_is_left_is_switched_off(self):
        seen = queue.Queue()

        def script(peer):
            peer.greet()
            peer.receive()
            peer.send(self.chunk(0, (0, 2, 0, 0)))
            seen.put(peer.receive())

        with talus.connect(self.serve(script)) as world:
            for _ in world.view(0, 0, 0, y=64, vertical_radius=1):
                break
        self.assertEqual(seen.get(timeout=20).centre.x, 1 << 40)

    def test_a_view_that_is_refused_for_now_is_asked_for_again(self):
        def script(peer):
            peer.greet()
            view = peer.receive()
            peer.send(protocol.Error(code=ErrorCode.overloaded, text="wait", retry_after_ms=1, about=ErrorAbout.view,
                                     view_number=view.number))
            again = peer.receive()
            peer.send(protocol.ViewComplete(number=view.number))  # of the first: says nothing
            peer.send(self.chunk(0, (0, 0, 0, 0)))
            peer.send(protocol.ViewComplete(number=again.number))

        with talus.connect(self.serve(script)) as world:
            self.assertEqual(len(list(world.view(0, 0, 0, y=0, vertical_radius=0))), 1)

    def test_a_view_that_is_refused_is_raised(self):
        def script(peer):
            peer.greet()
            peer.send(protocol.Error(code=ErrorCode.too_large, text="radius is 999", about=ErrorAbout.view,
                                     view_number=peer.receive().number))

        with talus.connect(self.serve(script)) as world, self.assertRaisesRegex(talus.ServerError, "radius is 999"):
            next(world.view(0, 0, 999, y=0))


class Silence(Scripted):
    def test_a_client_that_waits_sends_pings(self):
        seen = queue.Queue()

        def script(peer):
            peer.greet()
            id = peer.ids()[0]
            seen.put(peer.receive())  # only then the answer
            peer.send(self.chunk(id, (0, 0, 0, 0)))

        with mock.patch("talus.connection.PING_AFTER_S", 0.01), talus.connect(self.serve(script)) as world:
            world.chunk(0, 0, 0)
        self.assertIsInstance(seen.get(timeout=20), protocol.Ping)

    def test_it_pings_before_the_servers_limit(self):
        seen = queue.Queue()

        def script(peer):
            peer.greet(welcome(idle_timeout_ms=30))
            id = peer.ids()[0]
            seen.put(peer.receive())  # only then the answer
            peer.send(self.chunk(id, (0, 0, 0, 0)))

        with mock.patch("talus.connection.PING_AFTER_S", 3600), talus.connect(self.serve(script)) as world:
            world.chunk(0, 0, 0)
        self.assertIsInstance(seen.get(timeout=20), protocol.Ping)

    def test_pings_are_a_third_of_the_limit_apart_and_never_a_flood(self):
        for limit_ms, seconds in ((0, 20), (3000, 1), (90_000, 20), (1, 0.005)):
            with talus.connect(self.serve(lambda peer: peer.greet(welcome(idle_timeout_ms=limit_ms)))) as world:
                self.assertEqual(world._connection.ping_after_s, seconds)
                self.assertEqual(world._connection.socket.gettimeout(), seconds)

    def test_a_client_that_waits_for_its_pace_sends_pings(self):
        seen = queue.Queue()

        def script(peer):
            peer.greet(welcome(idle_timeout_ms=15))
            about = dict(about=ErrorAbout.request, request_id=peer.ids()[0])
            peer.send(protocol.Error(code=ErrorCode.overloaded, retry_after_ms=500, **about))
            message = peer.receive()
            seen.put(message)
            while isinstance(message, protocol.Ping):
                message = peer.receive()
            peer.send(self.chunk(message.requests[0].id, (0, 0, 0, 0)))

        with talus.connect(self.serve(script)) as world:
            world.chunk(0, 0, 0)
        self.assertIsInstance(seen.get(timeout=20), protocol.Ping)

    def test_a_server_that_says_nothing_for_long_is_dead(self):
        def script(peer):
            peer.greet()
            while peer.receive():
                pass

        quick = mock.patch.multiple("talus.connection", PING_AFTER_S=0.01, DEAD_AFTER_S=0.05)
        with quick, mock.patch.object(edits, "KEEP_TRYING_S", 0):
            with talus.connect(self.serve(script)) as world, self.assertRaisesRegex(TimeoutError, "said nothing"):
                world.chunk(0, 0, 0)


class Uniform(unittest.TestCase):
    def test_chunks_of_one_material(self):
        for material in (0, 1, 127, 128, 300, 16383, 16384, 65535):
            chunk = talus.Chunk.uniform((1, 2, 3, 1), material)
            self.assertTrue(chunk.is_uniform)
            self.assertEqual((int(chunk.voxels.min()), int(chunk.voxels.max())), (material, material))
            self.assertEqual(chunk.origin, (64, 128, 192))


class Welcomes(Scripted):
    def refuses(self, text, **fields):
        with self.assertRaisesRegex(protocol.ProtocolError, text):
            talus.connect(self.serve(lambda peer: peer.greet(welcome(fields)))).close()

    def test_a_welcome_that_this_client_cannot_use_is_refused(self):
        self.refuses("16 voxels along an edge", chunk_size=16)
        for protocol_version in (1, 3):
            self.refuses(f"protocol version {protocol_version}, which was not offered", protocol=protocol_version)
        self.refuses("codec 3, which was not offered", codec=3)
        self.refuses("whole Welcome", spawn=None)
        self.refuses("unknown phase", materials=[protocol.Material(id=1, name="dark matter", phase=9)])

    def test_heights_that_no_world_has_are_refused(self):
        for low, high in ((0, (1 << 17) + 1), (-(1 << 62), 1 << 62), (1, 0), (1 << 36, (1 << 36) + 1)):
            self.refuses(f"heights from {low} to {high}", min_y=low, max_y=high)
        with talus.connect(self.serve(lambda peer: peer.greet(welcome(dict(max_y=1 << 17))))) as world:
            self.assertEqual(world.welcome.max_y, 1 << 17)

    def test_if_no_request_is_allowed_one_is_sent_at_once(self):
        def script(peer):
            peer.greet(welcome(requests_in_flight=0))
            for x in range(2):
                (id,) = peer.ids()
                peer.send(self.chunk(id, (x, 0, 0, 0)))

        with talus.connect(self.serve(script)) as world:
            self.assertEqual([chunk.key[0] for chunk in world.chunks([(0, 0, 0), (1, 0, 0)])], [0, 1])


class Broken(Scripted):
    def fails(self, sent, error, text):
        def script(peer):
            peer.greet()
            peer.receive()
            peer.send(sent)

        with mock.patch.object(edits, "KEEP_TRYING_S", 0), talus.connect(self.serve(script)) as world:
            with self.assertRaisesRegex(error, text):
                world.chunk(0, 0, 0)

    def test_bytes_that_are_not_frames(self):
        self.fails(b"HTTP/1.1 400 Bad Request\r\n\r\n", talus.ProtocolError, "an HTTP server answers there; connect to http://")

    def test_a_frame_that_is_cut_off(self):
        self.fails(protocol.write(protocol.Pong(nonce=1))[:-4], ConnectionError, "closed the connection")

    def test_a_message_of_the_clients_kind(self):
        self.fails(protocol.Ping(nonce=1), talus.ProtocolError, "sent a Ping")

    def test_a_server_that_leaves(self):
        self.fails(protocol.GoAway(reason="restart", retry_after_ms=5), talus.ServerLeaving, "restart")

    def test_a_server_that_leaves_is_followed_by_the_next(self):
        def leave(peer):
            peer.greet()
            keys = [request.key for request in peer.receive().requests]
            ids = range(1, 1 + len(keys))
            peer.send(self.chunk(ids[0], tuple(keys[0])))
            peer.send(protocol.GoAway(reason="an update", retry_after_ms=3_600_000))

        def stay(peer):
            peer.greet()
            for request in peer.receive().requests:
                peer.send(self.chunk(request.id, tuple(request.key)))
            peer.send(protocol.Pong(nonce=peer.receive().nonce))

        addresses = f"{self.serve(leave)},{self.serve(stay)}"
        keys = [(x, 0, 0, 0) for x in range(5)]
        with talus.connect(addresses) as world:
            self.assertEqual([tuple(chunk.key) for chunk in world.chunks(keys)], keys)
            world.ping()

    def test_a_view_goes_on_at_the_next_server(self):
        def leave(peer):
            peer.greet()
            peer.receive()
            peer.send(self.chunk(0, (0, 0, 0, 0)))

        def stay(peer):
            peer.greet()
            view = peer.receive()
            for x in (-1, 0, 1):
                for z in (-1, 0, 1):
                    peer.send(self.chunk(0, (x, 0, z, 0)))
            peer.send(protocol.ViewComplete(number=view.number))

        with talus.connect(f"{self.serve(leave)},{self.serve(stay)}") as world:
            seen = [tuple(chunk.key) for chunk in world.view(0, 0, 1, y=0, vertical_radius=0)]
        self.assertEqual((len(seen), len(set(seen)), seen[0]), (9, 9, (0, 0, 0, 0)))

    def test_if_the_first_server_is_away_the_next_is_tried(self):
        with socket.create_server(("127.0.0.1", 0)) as gone:
            port = gone.getsockname()[1]
        with talus.connect(f"127.0.0.1:{port},{self.serve(lambda peer: peer.greet())}"):
            pass
        with self.assertRaises(OSError):
            talus.connect(f"127.0.0.1:{port},127.0.0.1:{port}")

    def test_a_server_that_refuses_hello(self):
        address = self.serve(lambda peer: peer.greet(protocol.Error(code=ErrorCode.unauthorized, text="no token")))
        with self.assertRaisesRegex(talus.ServerError, "unauthorized: no token"):
            talus.connect(address)

    def test_an_invalid_address(self):
        with self.assertRaisesRegex(ValueError, "address 'localhost' is not HOST:PORT"):
            talus.connect("localhost")
        for address in ("http://me:hush@localhost", "me:hush@localhost", "localhost:1,me:hush@localhost:1"):
            with self.assertRaisesRegex(ValueError, "pass token= instead") as raised:
                talus.connect(address)
            self.assertNotIn("hush", str(raised.exception))


class Rates(unittest.TestCase):
    """By a clock that the test turns."""

    def setUp(self):
        self.time = 100.0

    def sleep(self, seconds):
        self.time += seconds

    def pace(self, **rates):
        return pace.Pace(protocol.Limits(session_rates=protocol.Rates(**rates)), lambda: self.time, self.sleep)

    def test_no_more_goes_than_the_rate(self):
        paced = self.pace(requests=8, burst_ms=2000)
        sent = 0
        while sent < 94:
            sent += paced.wait(94 - sent)
        self.assertAlmostEqual(self.time - 100, (94 - 14) / 8)

    def test_all_waits_for_what_was_refused(self):
        paced = self.pace(requests=1000, burst_ms=1000)
        paced.refused(3000)
        self.assertEqual((paced.wait(50), self.time), (1, 103.0))

    def test_no_server_makes_wait_for_days(self):
        paced = self.pace()
        paced.refused(0xFFFFFFFF)
        self.assertEqual((paced.wait(5), self.time), (5, 160.0))

    def test_no_rates_no_waiting(self):
        self.assertEqual((self.pace().wait(1000), self.time), (1000, 100.0))


if __name__ == "__main__":
    unittest.main()
