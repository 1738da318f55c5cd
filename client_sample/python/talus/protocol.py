"""The wire: messages of protocol/schema/talus.fbs as Python objects, and frames of them as bytes.

    write(Ping(nonce=5))            # the bytes of a frame
    read(frame)                     # a message; raises ProtocolError if it is invalid

A message has the fields of its table by their names in the schema, with defaults 0, False, "", (), b"" for lists of
bytes, and None for tables and structs. Structs are named tuples. This module reads and writes FlatBuffers itself: the
schema needs little of it, and its library for Python does not verify.
"""

import collections
import enum
import struct

# Frame bytes include the length prefix.
MIN_FRAME_BYTES = 12
MAX_FRAME_BYTES = 262_144

_MAX_TABLES = 2048
_MAX_COPIES = 4  # bytes of lists and strings per byte of a frame, as they may overlap


class ProtocolError(ConnectionError):
    """The peer violated the protocol."""


class ErrorCode(enum.IntEnum):
    none = 0
    version = 1
    malformed = 2
    unexpected = 3
    too_large = 4
    too_many_requests = 5
    out_of_range = 6
    cancelled = 7
    unsupported = 8
    unauthorized = 9
    overloaded = 10
    timeout = 11
    duplicate_id = 12
    internal = 13
    forbidden = 14
    conflict = 15
    expired = 16
    not_applied = 17


class ErrorAbout(enum.IntEnum):
    unspecified = 0
    connection = 1
    request = 2
    repeated_request = 3
    view = 4
    view_chunk = 5
    ping = 6
    attach = 7


class Phase(enum.IntEnum):
    gas = 0
    liquid = 1
    solid = 2


# ---- kinds of fields ---------------------------------------------------------------------------------------------


class _Scalar:
    def __init__(self, code, default=0, convert=None):
        self.struct = struct.Struct("<" + code)
        self.size = self.align = self.struct.size
        self.default = default
        self.convert = convert

    def pack(self, value):
        return self.struct.pack(value)

    def unpack(self, data, at):
        return self.struct.unpack_from(data, at)[0]


class _Enum(_Scalar):
    """Read as a member of the enumeration, or as a number if a newer peer has more members."""

    def __init__(self, code, members):
        super().__init__(code, members(0))
        self.known = {member.value: member for member in members}

    def unpack(self, data, at):
        value = super().unpack(data, at)
        return self.known.get(value, value)


class _Struct:
    """A struct of scalars and structs, laid out as C does."""

    default = None

    def __init__(self, name, **members):
        self.members = list(members.values())
        self.type = collections.namedtuple(name, members)
        self.type.__doc__ = f"struct {name}"
        self.offsets = []
        size = 0
        for member in self.members:
            size += -size % member.align
            self.offsets.append(size)
            size += member.size
        self.align = max(member.align for member in self.members)
        self.size = size + -size % self.align

    def pack(self, value):
        data = bytearray(self.size)
        for member, offset, part in zip(self.members, self.offsets, value):
            data[offset : offset + member.size] = member.pack(part)
        return bytes(data)

    def unpack(self, data, at):
        return self.type(*(member.unpack(data, at + offset) for member, offset in zip(self.members, self.offsets)))


class _Text:
    default = ""


class _List:
    def __init__(self, element):
        self.element = element
        self.default = b"" if element is U8 else ()


class _Table:
    default = None

    def __init__(self, message):
        self.message = message


class Message:
    """Base of all messages and of the tables in them."""

    FIELDS = {}

    def __init__(self, **fields):
        for name, kind in self.FIELDS.items():
            setattr(self, name, fields.pop(name, kind.default))
        if fields:
            raise TypeError(f"{type(self).__name__} has no field {next(iter(fields))}; it has {', '.join(self.FIELDS)}")

    def __eq__(self, other):
        return type(self) is type(other) and vars(self) == vars(other)

    def __repr__(self):
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in vars(self).items())})"


BOOL = _Scalar("?", False)
U8, U16, U32, U64 = (_Scalar(code) for code in "BHIQ")
I32, I64 = (_Scalar(code) for code in "iq")
F32 = _Scalar("f", 0.0)
TEXT = _Text()

# ---- the schema --------------------------------------------------------------------------------------------------

HASH128 = _Struct("Hash128", low=U64, high=U64)
CHUNK_KEY = _Struct("ChunkKey", x=I32, y=I32, z=I32, lod=U8)
VOXEL = _Struct("Voxel", x=I64, y=I64, z=I64)
DIRECTION = _Struct("Direction", x=F32, y=F32, z=F32)
COLUMN_POS = _Struct("ColumnPos", x=I64, z=I64)
LOD_RING = _Struct("LodRing", lod=U8, radius=U16)
KNOWN_CHUNK = _Struct("KnownChunk", key=CHUNK_KEY, hash=HASH128)
CHUNK_REQUEST = _Struct("ChunkRequest", id=U32, key=CHUNK_KEY, has_known=BOOL, known=HASH128)
VOXEL_WRITE = _Struct("VoxelWrite", voxel=VOXEL, material=U16)
FILL = _Struct("Fill", first=VOXEL, last=VOXEL, material=U16, only=U16, flags=U8)
UNIFORM_RUN = _Struct("UniformRun", first_y=I32, last_y=I32, material=U16)

Hash128, ChunkKey, Voxel, Direction = HASH128.type, CHUNK_KEY.type, VOXEL.type, DIRECTION.type
ColumnPos, LodRing, KnownChunk, ChunkRequest = COLUMN_POS.type, LOD_RING.type, KNOWN_CHUNK.type, CHUNK_REQUEST.type
VoxelWrite, Fill, UniformRun = VOXEL_WRITE.type, FILL.type, UNIFORM_RUN.type


class Hello(Message):
    FIELDS = dict(
        protocol_min=U16, protocol_max=U16, codecs=_List(U8), token=TEXT, client=TEXT, window_bytes=U64
    )


class View(Message):
    FIELDS = dict(
        centre=VOXEL,
        direction=DIRECTION,
        horizontal_radius=U16,
        vertical_radius=U16,
        rings=_List(LOD_RING),
        known=_List(KNOWN_CHUNK),
        number=U32,
        horizon=BOOL,
        has_base=BOOL,
    )


class GetChunks(Message):
    FIELDS = dict(requests=_List(CHUNK_REQUEST))


class Cancel(Message):
    FIELDS = dict(ids=_List(U32))


class GetHeights(Message):
    FIELDS = dict(id=U32, columns=_List(COLUMN_POS), looks=BOOL, fields=_List(U8))


class GetFile(Message):
    FIELDS = dict(id=U32, name=TEXT, offset=U64)


class Credit(Message):
    FIELDS = dict(total_bytes=U64)


class Paste(Message):
    FIELDS = dict(origin=VOXEL, payload=_List(U8), with_air=BOOL)


class Edit(Message):
    FIELDS = dict(
        id=U32,
        writes=_List(VOXEL_WRITE),
        sequence=U64,
        guards=_List(VOXEL_WRITE),
        fills=_List(FILL),
        paste=_Table(Paste),
        subject=TEXT,
    )


class Attach(Message):
    FIELDS = dict(editor=HASH128, seen_revision=U64)


class Ping(Message):
    FIELDS = dict(nonce=U64)


class Material(Message):
    FIELDS = dict(id=U16, name=TEXT, colour=U32, phase=_Enum("B", Phase))


class Rates(Message):
    FIELDS = dict(chunks=U64, bytes=U64, requests=U64, burst_ms=U32)


class Limits(Message):
    FIELDS = dict(
        frame_bytes=U32,
        requests_in_flight=U32,
        heights_per_request=U32,
        view_horizontal_radius=U16,
        view_vertical_radius=U16,
        view_chunks=U32,
        window_bytes=U64,
        idle_timeout_ms=U32,
        session_rates=_Table(Rates),
        address_rates=_Table(Rates),
        view_horizon=BOOL,
        view_base=BOOL,
    )


class Welcome(Message):
    FIELDS = dict(
        protocol=U16,
        codec=U8,
        fingerprint=HASH128,
        store_id=HASH128,
        chunk_size=U16,
        materials=_List(_Table(Material)),
        min_y=I64,
        max_y=I64,
        spawn=VOXEL,
        limits=_Table(Limits),
        server=TEXT,
        looks=_List(TEXT),
        fields=_List(TEXT),
        world_file=TEXT,
    )


class Chunk(Message):
    FIELDS = dict(id=U32, key=CHUNK_KEY, revision=U64, hash=HASH128, codec=U8, payload=_List(U8))


class Unchanged(Message):
    FIELDS = dict(id=U32, key=CHUNK_KEY, revision=U64, hash=HASH128)


class UniformColumn(Message):
    FIELDS = dict(x=I32, z=I32, lod=U8, revision=U64, runs=_List(UNIFORM_RUN))


class Heights(Message):
    FIELDS = dict(id=U32, heights_fx=_List(I32), looks=_List(U8), values=_List(F32))


class FilePart(Message):
    FIELDS = dict(id=U32, size=U64, bytes=_List(U8))


class Error(Message):
    FIELDS = dict(
        code=_Enum("H", ErrorCode),
        text=TEXT,
        request_id=U32,
        retry_after_ms=U32,
        about=_Enum("B", ErrorAbout),
        repeated_id=U32,
        view_number=U32,
        chunk=CHUNK_KEY,
    )


class EditResult(Message):
    FIELDS = dict(id=U32, revision=U64, changed=U32)


class EditLimits(Message):
    FIELDS = dict(voxels=U32, chunks=U32, unanswered=U32, voxels_per_second=U64)


class Attached(Message):
    FIELDS = dict(
        editor=HASH128,
        epoch=U64,
        last_sequence=U64,
        known=BOOL,
        revision=U64,
        limits=_Table(EditLimits),
    )


class EditBroadcast(Message):
    FIELDS = dict(key=CHUNK_KEY, revision=U64, previous_revision=U64, writes=_List(VOXEL_WRITE), runs=_List(U8))


class Pong(Message):
    FIELDS = dict(nonce=U64)


class GoAway(Message):
    FIELDS = dict(reason=TEXT, retry_after_ms=U32)


class ViewComplete(Message):
    FIELDS = dict(number=U32)


# The union Body: a message's number is its position here, from 1.
BODIES = (
    Hello,
    View,
    GetChunks,
    Cancel,
    GetHeights,
    Credit,
    Edit,
    Ping,
    Welcome,
    Chunk,
    Unchanged,
    UniformColumn,
    Heights,
    Error,
    EditResult,
    EditBroadcast,
    Pong,
    GoAway,
    ViewComplete,
    Attach,
    Attached,
    GetFile,
    FilePart,
)


# ---- reading -----------------------------------------------------------------------------------------------------


def frame_length(prefix):
    """Length of the complete frame whose first four bytes are `prefix`. Raises ProtocolError if it is not allowed."""
    if prefix == b"HTTP":
        raise ProtocolError("an HTTP server answers there; connect to http://HOST:PORT, or to talusd's --listen")
    length = int.from_bytes(prefix, "little") + 4
    if not MIN_FRAME_BYTES <= length <= MAX_FRAME_BYTES:
        raise ProtocolError(f"a frame of {length} bytes; they have {MIN_FRAME_BYTES} to {MAX_FRAME_BYTES}")
    return length


def read(frame):
    """The message of a complete frame with its length prefix; None if its kind is newer than this client."""
    if frame_length(frame[:4]) != len(frame):
        raise ProtocolError(f"a frame of {len(frame)} bytes does not have the length that it says")
    reader = _Reader(frame)
    try:
        return reader.message()
    except UnicodeDecodeError:
        raise ProtocolError("a text in a frame is not UTF-8") from None


class _Reader:
    """Checks that everything read lies in the frame, is aligned, and that the total is not much larger than it."""

    def __init__(self, frame):
        self.frame = frame
        self.tables_left = _MAX_TABLES
        self.bytes_left = _MAX_COPIES * len(frame)

    def check(self, at, size, align):
        if at < 4 or at + size > len(self.frame) or at % align:
            raise ProtocolError(f"a frame of {len(self.frame)} bytes refers to bytes {at} to {at + size}")

    def number(self, kind, at):
        self.check(at, kind.size, kind.align)
        return kind.unpack(self.frame, at)

    def follow(self, at):
        return at + self.number(U32, at)

    def message(self):
        slots = self.slots(self.follow(4))
        kind = self.number(U8, slots[0]) if slots and slots[0] else 0
        if kind == 0:
            raise ProtocolError("a message without a body")
        if kind > len(BODIES):
            return None
        if len(slots) < 2 or not slots[1]:
            raise ProtocolError(f"a {BODIES[kind - 1].__name__} without its table")
        return self.table(BODIES[kind - 1], self.follow(slots[1]))

    def slots(self, at):
        """Position of each field of the table at `at`; 0: absent."""
        self.tables_left -= 1
        if self.tables_left < 0:
            raise ProtocolError(f"a frame with over {_MAX_TABLES} tables")
        vtable = at - self.number(I32, at)
        size = self.number(U16, vtable)
        self.check(vtable, size, 2)
        if size < 4 or size % 2:
            raise ProtocolError("a table's layout has no right length")
        offsets = struct.unpack_from(f"<{size // 2 - 2}H", self.frame, vtable + 4)
        return [at + offset if offset else 0 for offset in offsets]

    def table(self, message, at):
        slots = self.slots(at)
        return message(
            **{
                name: self.field(kind, slot)
                for (name, kind), slot in zip(message.FIELDS.items(), slots)
                if slot  # absent fields, and fields that the peer's schema lacks, have their default
            }
        )

    def field(self, kind, at):
        if isinstance(kind, _Text):
            return self.text(self.follow(at))
        if isinstance(kind, _Table):
            return self.table(kind.message, self.follow(at))
        if isinstance(kind, _List):
            return self.list(kind.element, self.follow(at))
        return self.number(kind, at)

    def span(self, at, size_of_each, align):
        """Start and number of the elements of a list."""
        count = self.number(U32, at)
        self.check(at + 4, count * size_of_each, align)
        self.bytes_left -= count * size_of_each
        if self.bytes_left < 0:
            raise ProtocolError("lists and texts of a frame lie over one another")
        return at + 4, count

    def text(self, at):
        begin, count = self.span(at, 1, 1)
        return bytes(self.frame[begin : begin + count]).decode()

    def list(self, element, at):
        if isinstance(element, (_Text, _Table)):
            begin, count = self.span(at, 4, 4)
            return [self.field(element, begin + 4 * i) for i in range(count)]
        begin, count = self.span(at, element.size, element.align)
        if element is U8:
            return bytes(self.frame[begin : begin + count])
        if isinstance(element, _Struct):
            return [element.unpack(self.frame, begin + element.size * i) for i in range(count)]
        return struct.unpack_from(f"<{count}{element.struct.format[1:]}", self.frame, begin)


# ---- writing -----------------------------------------------------------------------------------------------------


def write(message):
    """The frame of a message. Fields with their default are omitted."""
    data = bytearray(8)  # the length, and the root's offset
    layout = [(U8, 0), (U32, 1)]  # of the table Message: body_type, body
    root, places = _put_layout(data, layout)
    struct.pack_into("<I", data, 4, root - 4)
    data[places[0]] = BODIES.index(type(message)) + 1
    _put_reference(data, places[1], _put_table(data, message))
    struct.pack_into("<I", data, 0, len(data) - 4)
    if len(data) > MAX_FRAME_BYTES:
        raise ValueError(f"a {type(message).__name__} of {len(data)} bytes; a frame has at most {MAX_FRAME_BYTES}")
    return bytes(data)


def _start_object(data):
    """Pads so that data 4 bytes on, after a table's or list's own number, is aligned for every type."""
    data += bytes((4 - len(data)) % 8)


def _put_layout(data, fields):
    """Writes a vtable and its table with room for `fields`, (kind, slot) each. Returns their positions."""
    fields = sorted(fields, key=lambda field: -field[0].align)
    offsets = []
    size = 4
    for kind, _ in fields:
        size += -size % kind.align if kind.align < 8 else (4 - size) % 8
        offsets.append(size)
        size += kind.size
    slots = [0] * (max((slot for _, slot in fields), default=-1) + 1)
    for (_, slot), offset in zip(fields, offsets):
        slots[slot] = offset
    data += bytes(len(data) % 2)
    vtable = len(data)
    data += struct.pack(f"<{2 + len(slots)}H", 4 + 2 * len(slots), size, *slots)
    _start_object(data)
    table = len(data)
    data += struct.pack("<i", table - vtable) + bytes(size - 4)
    return table, {slot: table + offset for slot, offset in enumerate(slots) if offset}


def _put_reference(data, at, target):
    struct.pack_into("<I", data, at, target - at)


def _put_table(data, message):
    fields = [
        (name, kind, slot)
        for slot, (name, kind) in enumerate(message.FIELDS.items())
        if not _is_default(kind, getattr(message, name))
    ]
    inline = [(kind if isinstance(kind, (_Scalar, _Struct)) else U32, slot) for _, kind, slot in fields]
    table, places = _put_layout(data, inline)
    for name, kind, slot in fields:
        at, value = places[slot], getattr(message, name)
        try:
            if isinstance(kind, (_Scalar, _Struct)):
                data[at : at + kind.size] = kind.pack(value)
            else:
                _put_reference(data, at, _put_object(data, kind, value))
        except struct.error as error:
            raise ValueError(f"{name} of {type(message).__name__} does not fit its type: {error}") from None
    return table


def _is_default(kind, value):
    if isinstance(kind, (_List, _Text)):
        return len(value) == 0
    return value is None if kind.default is None else value == kind.default


def _put_object(data, kind, value):
    if isinstance(kind, _Table):
        return _put_table(data, value)
    _start_object(data)
    at = len(data)
    if isinstance(kind, _Text):
        value = value.encode()
        data += struct.pack("<I", len(value)) + value + b"\0"
    elif isinstance(kind.element, (_Text, _Table)):
        data += struct.pack("<I", len(value)) + bytes(4 * len(value))
        for i, part in enumerate(value):
            _put_reference(data, at + 4 + 4 * i, _put_object(data, kind.element, part))
    else:
        data += struct.pack("<I", len(value)) + b"".join(kind.element.pack(part) for part in value)
    data += bytes(-len(data) % 4)
    return at
