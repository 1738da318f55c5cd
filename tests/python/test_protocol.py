"""Messages and frames against protocol/vectors, the schema and hostile bytes."""

import json
import os
import random
import re
import unittest

from paths import ROOT

from test_decoder import mutate

from talus import protocol

FRAMES = json.loads((ROOT / "protocol/vectors/frames.json").read_text())["frames"]


def plain(value):
    """A message as frames.json writes it."""
    if isinstance(value, protocol.Message):
        return {name: plain(part) for name, part in vars(value).items()}
    if hasattr(value, "_asdict"):
        return {name: plain(part) for name, part in value._asdict().items()}
    if hasattr(value, "name"):
        return value.name
    if isinstance(value, (tuple, list, bytes)):
        return [plain(part) for part in value]
    if isinstance(value, int) and not isinstance(value, bool) and abs(value) > 2**53 - 1:
        return str(value)
    return value


class Vectors(unittest.TestCase):
    def test_every_kind_of_message_is_there(self):
        self.assertEqual([(f["kind"], f["number"]) for f in FRAMES],
                         [(body.__name__, i) for i, body in enumerate(protocol.BODIES, 1)])

    def test_frames_are_read(self):
        for frame in FRAMES:
            with self.subTest(frame["kind"]):
                message = protocol.read(bytes.fromhex(frame["hex"]))
                self.assertEqual(type(message).__name__, frame["kind"])
                self.assertEqual(plain(message), frame["message"])

    def test_a_written_message_is_read_as_the_same(self):
        for frame in FRAMES:
            with self.subTest(frame["kind"]):
                message = protocol.read(bytes.fromhex(frame["hex"]))
                self.assertEqual(protocol.read(protocol.write(message)), message)
                empty = type(message)()
                self.assertEqual(protocol.read(protocol.write(empty)), empty)

    def test_fields_and_their_order_match_the_schema(self):
        schema = re.sub(r"//.*", "", (ROOT / "protocol/schema/talus.fbs").read_text())
        for kind, name, body in re.findall(r"(table|struct) (\w+) \{(.*?)\}", schema, re.DOTALL):
            names = re.findall(r"(\w+):", body)
            if name != "Message":
                ours = getattr(protocol, name)
                self.assertEqual(list(ours.FIELDS if kind == "table" else ours._fields), names, name)
        for name, body in re.findall(r"enum (\w+) : \w+ \{(.*?)\}", schema, re.DOTALL):
            members = {m: int(n) for m, n in re.findall(r"(\w+) = (\d+)", body)}
            self.assertEqual({m.name: m.value for m in getattr(protocol, name)}, members)
        union = re.search(r"union Body \{(.*?)\}", schema, re.DOTALL).group(1)
        self.assertEqual(re.findall(r"\w+", union), [body.__name__ for body in protocol.BODIES])


class Writing(unittest.TestCase):
    def test_64_bit_fields_and_structs_are_aligned_from_the_prefix_on(self):
        ping = protocol.write(protocol.Ping(nonce=0x1122334455667788))
        self.assertEqual(ping.index(bytes.fromhex("8877665544332211")) % 8, 0)
        view = protocol.write(protocol.View(centre=(0x1122334455667788, 0, 0), number=7, horizon=True))
        self.assertEqual(view.index(bytes.fromhex("8877665544332211")) % 8, 0)
        columns = protocol.write(protocol.GetHeights(id=1, columns=[(0x1122334455667788, 3)], looks=True))
        self.assertEqual(columns.index(bytes.fromhex("8877665544332211")) % 8, 0)

    def test_a_field_that_there_is_not_is_refused_by_name(self):
        with self.assertRaisesRegex(TypeError, "Ping has no field once; it has nonce"):
            protocol.Ping(once=1)

    def test_a_value_that_does_not_fit_is_refused_by_name(self):
        with self.assertRaisesRegex(ValueError, "horizontal_radius of View does not fit"):
            protocol.write(protocol.View(horizontal_radius=65536))
        with self.assertRaisesRegex(ValueError, "columns of GetHeights does not fit"):
            protocol.write(protocol.GetHeights(columns=[(1.5, 0)]))


class Hostile(unittest.TestCase):
    def test_lengths_are_bounded_before_anything_is_read(self):
        for length in (0, 7, 262_141, 0xFFFFFFFF):
            with self.assertRaises(protocol.ProtocolError):
                protocol.frame_length(length.to_bytes(4, "little"))
        self.assertEqual(protocol.frame_length(bytes([8, 0, 0, 0])), 12)

    def test_mutated_frames_are_read_or_refused(self):
        seed = int(os.environ.get("TALUS_SEED", random.randrange(1 << 32)))
        rounds = int(os.environ.get("TALUS_ROUNDS", 300))
        print(f"\nTALUS_SEED={seed}", flush=True)
        rng = random.Random(seed)
        for frame in FRAMES:
            for turn in range(rounds):
                body = mutate(bytes.fromhex(frame["hex"])[4:], rng)
                hostile = len(body).to_bytes(4, "little") + body
                try:
                    protocol.read(hostile)
                except protocol.ProtocolError:
                    pass
                except Exception as error:
                    raise AssertionError(f"{frame['kind']}, turn {turn}, seed {seed}: {hostile.hex()}") from error

    def test_every_cut_into_a_frame_is_refused(self):
        padding = 3  # bytes at most that a frame ends with and no field has
        for frame in FRAMES:
            body = bytes.fromhex(frame["hex"])[4:]
            for length in range(len(body) - padding):
                with self.assertRaises(protocol.ProtocolError, msg=f"{frame['kind']} cut to {length}"):
                    protocol.read(length.to_bytes(4, "little") + body[:length])

    def test_a_misaligned_message_is_refused(self):
        frame = bytearray(protocol.write(protocol.Ping(nonce=5)))
        table = Inside(frame).body()
        slot = table - int.from_bytes(frame[table : table + 4], "little", signed=True) + 4
        self.assertEqual(frame[slot], 4)
        frame[slot] = 3
        with self.assertRaisesRegex(protocol.ProtocolError, "refers to bytes"):
            protocol.read(frame)

    def test_a_table_that_a_list_has_many_times_takes_no_memory(self):
        frame = same_everywhere(protocol.Welcome(materials=[protocol.Material(id=1)] * 9_000), "materials")
        with self.assertRaisesRegex(protocol.ProtocolError, "a frame with over 2048 tables"):
            protocol.read(frame)

    def test_a_text_that_a_list_has_1_000_times_takes_no_memory(self):
        frame = same_everywhere(protocol.Welcome(looks=["x" * 20_000] + ["y"] * 1000), "looks")
        with self.assertRaisesRegex(protocol.ProtocolError, "lie over one another"):
            protocol.read(frame)


class Inside(protocol._Reader):
    def body(self):
        return self.follow(self.slots(self.follow(4))[1])


def same_everywhere(message, field):
    """The message's frame, with the first element of the list at all its places."""
    frame = bytearray(protocol.write(message))
    inside = Inside(bytes(frame))
    at = inside.follow(inside.slots(inside.body())[list(message.FIELDS).index(field)])
    first = inside.follow(at + 4)
    for place in range(at + 4, at + 4 + 4 * len(getattr(message, field)), 4):
        frame[place : place + 4] = (first - place).to_bytes(4, "little")
    return bytes(frame)


if __name__ == "__main__":
    unittest.main()
