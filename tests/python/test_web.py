"""WebWorld against an HTTP server that a test scripts, and columns against hostile bytes."""

import http.server
import json
import os
import random
import socket
import struct
import threading
import unittest

import paths  # noqa: F401

import talus
from talus import web

from test_decoder import mutate

WORLD = {
    "fingerprint": "0123456789abcdef0123456789abcdef",
    "codec": 4,
    "min_y": 0,
    "max_y": 320,
    "spawn": [1, 2, 3],
    "materials": [{"id": 0, "name": "air", "colour": "#bad7ec", "phase": "gas"}],
}
UNIFORM = bytes.fromhex("030001ac02")  # of the vectors
LIMIT = 1 << 31


def column(*runs):
    body = struct.pack("<BBH", 1, 0, len(runs))
    return body + b"".join(struct.pack("<iII", first, count, len(payload)) + payload for first, count, payload in runs)


WHOLE = column((-LIMIT, LIMIT, UNIFORM), (0, 2, b"\3\0\1\7"), (2, LIMIT - 2, b"\3\0\1\0"))


class Scripted(unittest.TestCase):
    """`answers`: by path, a list of (status, body) in turn, of which the last stays. A third part is Talus-Revision."""

    def serve(self, answers):
        test, self.requests = self, []

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_GET(self):
                test.requests.append((self.path, self.headers.get("Authorization")))
                known = answers.get(self.path, [(404, b"")])
                status, body, *said = known.pop(0) if len(known) > 1 else known[0]
                self.send_response(status)
                for revision in said:
                    self.send_header("Talus-Revision", revision)
                if status == 307:
                    self.send_header("Location", body.decode())
                    body = b""
                self.send_header("Content-Length", str(len(body)))
                self.end_headers()
                self.wfile.write(body)

            def log_message(self, *_):
                pass

        answers.setdefault("/v1/world", [(200, json.dumps(WORLD).encode())])
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        thread = threading.Thread(target=server.serve_forever, args=(0.01,), daemon=True)
        thread.start()
        self.addCleanup(server.server_close)
        self.addCleanup(thread.join)
        self.addCleanup(server.shutdown)
        return f"http://127.0.0.1:{server.server_port}"

    def refusal(self, code, **more):
        return json.dumps({"error": {"code": code, "text": "so it is", **more}}).encode()

    PATH = f"/v1/{WORLD['fingerprint']}/4"

    def test_names_of_fields_are_asked_for_whole(self):
        names = ["red rock", "a,b", "H\u00f6he", "+&="]
        path = "/v1/heights?columns=1,-2;3,4&fields=red%20rock,a%2Cb,H%C3%B6he,%2B%26%3D"
        found = {"subvoxels_per_voxel": 256, "heights": [256, 0], "fields": {name: [1, 2] for name in names}}
        with talus.connect(self.serve({path: [(200, json.dumps(found).encode())]})) as world:
            self.assertEqual(set(world.get_places([(1, -2), (3, 4)], False, names).fields), set(names))

    def test_chunks_are_asked_for_by_their_path_with_the_token(self):
        address = self.serve({f"{self.PATH}/2/-1/0/7": [(200, UNIFORM)]})
        with talus.connect(address, token="open sesame") as world:
            self.assertEqual(int(world.chunk(-1, 0, 7, lod=2).voxels[0, 0, 0]), 300)
            self.assertEqual(world.materials[0].colour, 0xBAD7EC)
        self.assertEqual(self.requests[1], (f"{self.PATH}/2/-1/0/7", "Bearer open sesame"))

    def test_edits_need_a_connection(self):
        with talus.connect(self.serve({})) as world:
            for call in (lambda: world.edit([((0, 0, 0), "air")], subject="x"), lambda: world.edit(guards=())):
                with self.assertRaisesRegex(NotImplementedError, "edits need a connection"):
                    call()

    def test_an_overloaded_request_is_sent_again(self):
        path = f"{self.PATH}/0/0/0/0"
        later = self.refusal("overloaded", retry_after_ms=1)
        with talus.connect(self.serve({path: [(503, later), (429, later), (200, UNIFORM)]})) as world:
            self.assertEqual(world.chunk(0, 0, 0).payload, UNIFORM)

    def test_another_refusal_is_raised(self):
        with talus.connect(self.serve({f"{self.PATH}/0/0/0/0": [(401, self.refusal("unauthorized"))]})) as world:
            with self.assertRaisesRegex(talus.ServerError, "unauthorized: .*/0/0/0/0: so it is"):
                world.chunk(0, 0, 0)
            with self.assertRaisesRegex(talus.ServerError, "HTTP status 404"):
                world.chunk(1, 0, 0)

    STORE = "2" * 32
    WITH_STORE = {"/v1/world": [(200, json.dumps({**WORLD, "store_id": STORE}).encode())]}
    EDITED = f"/v1/{WORLD['fingerprint']}/{STORE}"

    def edits(self, *columns):
        return struct.pack("<BBH", 1, 0, len(columns)) + b"".join(
            struct.pack("<HQ", z % 32 * 32 + x % 32, revision) for x, z, revision in columns
        )

    def test_edited_columns_come_by_their_revision_and_others_as_generated(self):
        answers = {
            **self.WITH_STORE,
            f"{self.EDITED}/edits/0/-1/0": [(200, self.edits((-1, 3, 7)))],
            f"{self.EDITED}/4/0/-1/3@7": [(307, b"3@8")],
            f"{self.EDITED}/4/0/-1/3@8": [(200, WHOLE)],
            f"{self.PATH}/0/-2/3": [(200, WHOLE)],
            f"{self.EDITED}/4/0/-1/5/3@7": [(307, b"3@0")],
            f"{self.EDITED}/4/0/-1/5/3@0": [(200, UNIFORM)],
        }
        with talus.connect(self.serve(answers)) as world:
            self.assertEqual(world.edited_columns(-1, 0), {(-1, 3): 7})
            self.assertEqual(world.column(-1, 3).revision, 8)
            self.assertEqual(world.column(-1, 3).chunk(1).revision, 8)
            self.assertEqual(world.column(-2, 3).revision, 0)
            self.assertEqual(world.chunk(-1, 5, 3).revision, 0)

    def test_land_that_is_edited_just_now_says_of_which_revision_it_is(self):
        answers = {
            **self.WITH_STORE,
            f"{self.EDITED}/edits/0/-1/0": [(200, self.edits((-1, 3, 7)))],
            f"{self.EDITED}/4/0/-1/3@7": [(307, b"3@8"), (200, WHOLE, "9")],
            f"{self.EDITED}/4/0/-1/3@8": [(200, WHOLE, "12")],
            f"{self.EDITED}/4/0/-1/5/3@7": [(200, UNIFORM, "nine")],
        }
        with talus.connect(self.serve(answers)) as world:
            self.assertEqual(world.column(-1, 3).revision, 12)
            self.assertEqual(world.column(-1, 3).revision, 9)
            with self.assertRaisesRegex(talus.ProtocolError, "revision 'nine'"):
                world.chunk(-1, 5, 3)

    def test_a_square_comes_by_the_greatest_revision_and_a_call_asks_for_a_region_once(self):
        square = struct.pack("<BBH", 1, 2, 0) + 4 * (struct.pack("<I", len(WHOLE)) + WHOLE)
        answers = {
            **self.WITH_STORE,
            f"{self.EDITED}/edits/0/0/0": [(200, self.edits((3, 2, 7), (2, 3, 9)))],
            f"{self.EDITED}/4/0/2/2/2x2@9": [(200, square)],
        }
        with talus.connect(self.serve(answers)) as world:
            self.assertEqual([column.revision for column in world.square(2, 2, 2)], [9] * 4)
        self.assertEqual(len(self.requests), 3)

    def test_redirections_lead_to_another_revision_and_nowhere_else(self):
        for location in (b"http://127.0.0.2/v1/3@8", b"4@8", b"3@8x", b"3", b"", b"/3@8", b"3@\xb2"):
            answers = {
                **self.WITH_STORE,
                f"{self.EDITED}/edits/0/0/0": [(200, self.edits((0, 3, 7)))],
                f"{self.EDITED}/4/0/0/3@7": [(307, location if location.isascii() else b"3@-1")],
            }
            with self.subTest(location), talus.connect(self.serve(answers), token="secret") as world:
                with self.assertRaisesRegex(talus.ProtocolError, "leads to"):
                    world.column(0, 3)
                self.assertEqual(len(self.requests), 3)

    def test_invalid_edited_columns(self):
        good = self.edits((1, 1, 5))
        for wrong in (b"", good[:-1], b"\2" + good[1:], good[:4] + b"\0\4" + good[6:]):
            answers = {**self.WITH_STORE, f"{self.EDITED}/edits/0/0/0": [(200, wrong)]}
            with self.subTest(wrong), talus.connect(self.serve(answers)) as world:
                with self.assertRaises(talus.ProtocolError):
                    world.column(0, 0)

    def test_a_body_without_end_is_not_read(self):
        with talus.connect(self.serve({f"{self.PATH}/0/0/0": [(200, bytes((4 << 20) + 1))]})) as world:
            with self.assertRaisesRegex(talus.ProtocolError, "over 4194304 bytes"):
                world.column(0, 0)

    def test_an_answer_that_is_not_http(self):
        listener = socket.create_server(("127.0.0.1", 0))
        self.addCleanup(listener.close)

        def answer():
            connection, _ = listener.accept()
            with connection:
                connection.recv(4096)
                connection.sendall(b"\x2c\0\0\0 what is this\n")

        thread = threading.Thread(target=answer, daemon=True)
        thread.start()
        with self.assertRaisesRegex(talus.ProtocolError, "not answered by HTTP"):
            talus.connect(f"http://127.0.0.1:{listener.getsockname()[1]}")
        thread.join()

    def test_heights_that_no_world_has(self):
        world = json.dumps({**WORLD, "max_y": (1 << 17) + 1}).encode()
        with self.assertRaisesRegex(talus.ProtocolError, "heights from 0 to 131073"):
            talus.connect(self.serve({"/v1/world": [(200, world)]}))

    def test_an_answer_that_is_not_json(self):
        with self.assertRaisesRegex(talus.ProtocolError, "not answered by JSON"):
            talus.connect(self.serve({"/v1/world": [(200, b"<html>")]}))

    def test_squares(self):
        square = struct.pack("<BBH", 1, 2, 0) + 4 * (struct.pack("<I", len(WHOLE)) + WHOLE)
        answers = {f"{self.PATH}/0/2/4/2x2": [(200, square), (200, square[:-1]), (200, square + b"\0")]}
        with talus.connect(self.serve(answers)) as world:
            self.assertEqual([(c.x, c.z) for c in world.square(2, 4, 2)], [(2, 4), (3, 4), (2, 5), (3, 5)])
            for _ in range(2):
                with self.assertRaises(talus.ProtocolError):
                    world.square(2, 4, 2)


class Columns(unittest.TestCase):
    def test_a_column_has_every_chunk_of_the_world(self):
        whole = web.Column(5, 6, 0, WHOLE)
        materials = {y: int(whole.chunk(y).voxels[0, 0, 0]) for y in (-LIMIT, -1, 0, 1, 2, LIMIT - 1)}
        self.assertEqual(materials, {-LIMIT: 300, -1: 300, 0: 7, 1: 7, 2: 0, LIMIT - 1: 0})
        self.assertEqual(tuple(whole.chunk(1).key), (5, 1, 6, 0))
        with self.assertRaises(IndexError):
            whole.chunk(LIMIT)

    def test_columns_with_gaps_are_refused(self):
        for wrong in (
            column((-LIMIT + 1, 2 * LIMIT - 1, UNIFORM)),
            column((-LIMIT, LIMIT, UNIFORM), (1, LIMIT - 1, UNIFORM)),
            column((-LIMIT, 0, UNIFORM), (-LIMIT, 2 * LIMIT - 1, UNIFORM)),
            column((-LIMIT, LIMIT, UNIFORM)),
            column(),
            WHOLE + b"\0",
            b"\2" + WHOLE[1:],
        ):
            with self.assertRaises(talus.ProtocolError, msg=wrong.hex()):
                web.Column(0, 0, 0, wrong)

    def test_mutated_columns_are_read_or_refused(self):
        seed = int(os.environ.get("TALUS_SEED", random.randrange(1 << 32)))
        print(f"\nTALUS_SEED={seed}", flush=True)
        rng = random.Random(seed)
        for _ in range(1000):
            hostile = mutate(WHOLE, rng)
            try:
                web.Column(0, 0, 0, hostile)
            except talus.ProtocolError:
                pass
            except Exception as error:
                raise AssertionError(f"seed {seed}: {hostile.hex()}") from error


if __name__ == "__main__":
    unittest.main()
