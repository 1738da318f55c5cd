"""libtalus by ctypes: load() has its functions. Made from talus.h by client_sample/c_api/bindings/make.py."""

import ctypes
import os
import sys

# libtalus: the Talus client library for C, and for every language that calls C.
#
#   talus_client* client;
#   talus_create(&client);
#   talus_connect_options options = {.size = sizeof options, .host = "localhost"};
#   talus_connect(client, &options);
#   talus_event event = {.size = sizeof event};
#   while (talus_poll(client, &event, 1000) == TALUS_OK) ...        (examples/fly.c is a whole program)
#   talus_destroy(client);
#
# Space. Axes are x east, y up, z south. The unit of length is the base voxel. A chunk is 32 x 32 x 32 voxels
# of one level of detail, 0 to 6; a voxel of level l spans 2^l base voxels along each axis. Chunk coordinates
# count chunks of their level. Base voxel v lies in base chunk floor(v / 32). Dense voxels are uint16_t
# material ids, index (y * 32 + z) * 32 + x. Heights are in 1/256 base voxel above y = 0.
#
# Structs. Each begins with `size`, which the caller sets to sizeof the struct before every call. Fields are
# only ever appended. The library takes shorter structs of older programs, and longer ones of newer programs
# if the bytes that it does not know are 0. So set every unused field to 0, its default.
#
# Errors. A function that fails returns a negative status, changes nothing unless it says otherwise, and
# leaves a one-line message in talus_last_error(). No C++ exception leaves the library. After
# TALUS_OUT_OF_MEMORY and TALUS_INTERNAL the connection is closed, without a CLOSED event; the client may
# connect again. If not even 512 bytes can be allocated, the library may abort().
#
# Threads. A client may be used by one thread at a time, not always the same. Different clients are
# independent. Chunks are immutable: any thread may decode, retain and release them. The library makes no
# callbacks, and does network work only inside talus_poll(), except the look-up of host names, which runs in
# its own thread. With `generate` other threads make chunks.
#
# Ownership. Functions copy their arguments before they return. Pointers in an event stay valid until the
# next talus_poll(), talus_connect() or talus_destroy() of its client; talus_chunk_retain() keeps a chunk
# longer. Strings are UTF-8 with a terminating zero. The library never returns NULL strings; it takes NULL as
# the empty string.
#
# Tested on Linux on x86-64, on aarch64 and s390x in qemu, and for Windows in Wine.


class Sized(ctypes.Structure):
    """Sets its own size; the other fields are 0."""

    def __init__(self, **fields):
        super().__init__(size=ctypes.sizeof(type(self)), **fields)

# Version of this interface. A new minor version only adds; a new major version is another library,
# libtalus.so.MAJOR.
TALUS_API_MAJOR = 1
TALUS_API_MINOR = 0
# voxels along each edge
TALUS_CHUNK_SIZE = 32
# voxels
TALUS_CHUNK_VOLUME = 32768


def TALUS_VOXEL_INDEX(x, y, z):
    """each 0 to 31, inside the chunk"""
    return (y * 32 + z) * 32 + x


TALUS_DEFAULT_PORT = 4780

TALUS_OK = 0
# talus_poll(): no event in time
TALUS_NO_EVENT = 1
# NULL, a wrong size or count, an unknown flag, an index beyond a list
TALUS_INVALID_ARGUMENT = -1
# the connection is closed
TALUS_OUT_OF_MEMORY = -2
# a fault of the library; the connection is closed
TALUS_INTERNAL = -3
# by this build of the library, or by the server
TALUS_UNSUPPORTED = -4
# call talus_disconnect() first
TALUS_ALREADY_CONNECTED = -5
# more than 2^18 events are queued; poll them first
TALUS_TOO_MANY_EVENTS = -6
# the name does not resolve, or nothing listens there
TALUS_UNREACHABLE = -16
# the server rejects this client: version, token, too many connections
TALUS_REFUSED = -17
# TLS: the server's certificate was not accepted
TALUS_UNTRUSTED = -18
# the connection broke, or the server closed it
TALUS_DISCONNECTED = -19
# no answer in time while connecting, or silence afterwards
TALUS_TIMED_OUT = -20
# after a reconnect the server had another world
TALUS_WORLD_CHANGED = -21
# the server violated the protocol
TALUS_BROKEN_PROTOCOL = -22
# a chunk failed to decode, or does not match its hash
TALUS_BAD_CHUNK = -23
# a coordinate, radius or list exceeds the world's or the server's limits
TALUS_OUT_OF_RANGE = -24
# the server asks for a retry after `retry_after_ms`
TALUS_OVERLOADED = -25
# talus_cancel() came before the answer
TALUS_CANCELLED = -26
# the server could not answer; a retry may succeed
TALUS_SERVER_FAILED = -27
# called before JOINED, or after CLOSED or talus_disconnect()
TALUS_NOT_CONNECTED = -28
# a guard of the edit does not hold; nothing was applied
TALUS_CONFLICT = -29
# the edit was not applied, but a later one was
TALUS_NOT_APPLIED = -30
# The edit was sent and may have been applied: the client gave up before an answer, or the server no longer
# knows the editor.
TALUS_OUTCOME_UNKNOWN = -31
# chunks cannot be made here (talus_connect_options.generate)
TALUS_CANNOT_GENERATE = -32


class talus_connect_options(Sized):
    """Options of a connection. The number 0 means the default."""

    _fields_ = [
        ("size", ctypes.c_uint32),
        # TALUS_TLS, TALUS_TLS_NO_VERIFY, TALUS_WEBSOCKET
        ("flags", ctypes.c_uint32),
        # a name or an address; not empty
        ("host", ctypes.c_char_p),
        # issued by the server's operator; empty: no token
        ("token", ctypes.c_char_p),
        # for the server's log; empty: "libtalus"
        ("client_name", ctypes.c_char_p),
        # PEM file of trusted certificates; empty: the system's
        ("tls_ca_file", ctypes.c_char_p),
        # name that the certificate must have; empty: `host`
        ("tls_server_name", ctypes.c_char_p),
        # maximum chunk bytes in flight; default 1 MiB
        ("window_bytes", ctypes.c_uint64),
        # Maximum bytes of decoded chunks kept after they left the View while the game retained them: if they
        # return unchanged, they are not sent again. Default 32 MiB.
        ("keep_bytes", ctypes.c_uint64),
        # default TALUS_DEFAULT_PORT
        ("port", ctypes.c_uint32),
        # name lookup, TCP and TLS; default 5,000
        ("connect_timeout_ms", ctypes.c_uint32),
        # from there to JOINED; default 5,000
        ("handshake_timeout_ms", ctypes.c_uint32),
        # maximum; default 20,000
        ("ping_interval_ms", ctypes.c_uint32),
        # without a byte from the server it counts as lost; default 60,000
        ("silence_timeout_ms", ctypes.c_uint32),
        # consecutive failures until it gives up; 0: never reconnects
        ("reconnect_attempts", ctypes.c_uint32),
        # doubles with each failure; delays are random below; default 500
        ("reconnect_first_delay_ms", ctypes.c_uint32),
        # default 10,000
        ("reconnect_max_delay_ms", ctypes.c_uint32),
        # "HOST:PORT,HOST:PORT": other servers of the same world, may be empty. If one cannot be reached, goes away
        # or disconnects, the next is tried, then around again.
        ("more_servers", ctypes.c_char_p),
        # TALUS_GENERATE_AUTO makes a published world's chunks here and receives only edits. Events are the same.
        # Chunks of talus_get_chunk() still come from the server.
        ("generate", ctypes.c_uint32),
        # default: one less than the machine's processors
        ("generate_threads", ctypes.c_uint32),
    ]


# Before the world is open, chunks are received. Some chunks are compared with the server's. If one differs,
# or the world cannot be made by this library, AUTO receives chunks from then on, again those made here, and
# ERROR says why, by TALUS_CANNOT_GENERATE; ALWAYS ends by CLOSED.
TALUS_GENERATE_NEVER = 0
TALUS_GENERATE_AUTO = 1
TALUS_GENERATE_ALWAYS = 2

# TLS 1.3; the server's certificate is checked
TALUS_TLS = 1
# the certificate is not checked: any server is accepted
TALUS_TLS_NO_VERIFY = 2
# ws://host:port/v1/stream; `port` is talusd's HTTP port, or a proxy's
TALUS_WEBSOCKET = 4


class talus_view(Sized):
    """The chunks that a player wants around it: level 0 within the radii, coarser levels farther out."""

    _fields_ = [
        ("size", ctypes.c_uint32),
        # TALUS_VIEW_HORIZON
        ("flags", ctypes.c_uint32),
        # base voxels
        ("centre_x", ctypes.c_int64),
        ("centre_y", ctypes.c_int64),
        ("centre_z", ctypes.c_int64),
        # of sight, any length; 0: no preference
        ("direction_x", ctypes.c_float),
        ("direction_y", ctypes.c_float),
        ("direction_z", ctypes.c_float),
        # base chunks; 0: the centre's column alone
        ("horizontal_radius", ctypes.c_uint16),
        # base chunks
        ("vertical_radius", ctypes.c_uint16),
        # Levels 1 to 6, in base chunks, each wider than the finer ones; 0: no ring of this level.
        ("ring_radius", ctypes.c_uint16 * 6),
        # 0
        ("reserved", ctypes.c_uint32),
    ]


# Flag of talus_view: rings include every row in which ground can lie. Requires talus_world.has_horizon.
TALUS_VIEW_HORIZON = 1


class talus_world(Sized):
    """The server's description of its world."""

    _fields_ = [
        ("size", ctypes.c_uint32),
        # talus_get_material()
        ("material_count", ctypes.c_uint32),
        # equal fingerprints: equal voxels everywhere
        ("fingerprint_low", ctypes.c_uint64),
        ("fingerprint_high", ctypes.c_uint64),
        # revisions of one store are comparable
        ("store_low", ctypes.c_uint64),
        ("store_high", ctypes.c_uint64),
        # as generated: one rock below min_y, air from max_y up
        ("min_y", ctypes.c_int64),
        ("max_y", ctypes.c_int64),
        # base voxel of the feet: the first free one above dry ground
        ("spawn_x", ctypes.c_int64),
        ("spawn_y", ctypes.c_int64),
        ("spawn_z", ctypes.c_int64),
        # its name and version
        ("server", ctypes.c_char_p),
        # talus_look_name(), talus_field_name()
        ("look_count", ctypes.c_uint32),
        ("field_count", ctypes.c_uint32),
        # of a View, base chunks; 2^l times as many for a ring of level l
        ("max_horizontal_radius", ctypes.c_uint32),
        # base chunks
        ("max_vertical_radius", ctypes.c_uint32),
        # of all levels in one View
        ("max_view_chunks", ctypes.c_uint32),
        # in one talus_get_heights()
        ("max_columns", ctypes.c_uint32),
        # 1: Views may have TALUS_VIEW_HORIZON
        ("has_horizon", ctypes.c_uint32),
        # 0
        ("reserved", ctypes.c_uint32),
    ]



class talus_material(Sized):
    _fields_ = [
        ("size", ctypes.c_uint32),
        # as in voxels; 0 is air, 1 water
        ("id", ctypes.c_uint32),
        # 0xRRGGBB, sRGB
        ("colour", ctypes.c_uint32),
        # TALUS_GAS, TALUS_LIQUID, TALUS_SOLID
        ("phase", ctypes.c_uint32),
        # valid as long as the world's pointers: see talus_get_world()
        ("name", ctypes.c_char_p),
    ]


TALUS_GAS = 0
TALUS_LIQUID = 1
TALUS_SOLID = 2


class talus_edit(Sized):
    """An edit. If all guards hold, writes, fills and the paste are applied in this order, each on the result of
the previous ones; the edit is applied completely or not at all. Voxels are base voxels, stored as x, y, z
of the first, then of the next."""

    _fields_ = [
        ("size", ctypes.c_uint32),
        # TALUS_PASTE_AIR
        ("flags", ctypes.c_uint32),
        # guard_count voxels that must have guard_materials
        ("guard_voxels", ctypes.POINTER(ctypes.c_int64)),
        ("guard_materials", ctypes.POINTER(ctypes.c_uint16)),
        # write_count voxels that get write_materials
        ("write_voxels", ctypes.POINTER(ctypes.c_int64)),
        ("write_materials", ctypes.POINTER(ctypes.c_uint16)),
        # fill_count boxes: lowest corner, then highest; both included
        ("fill_corners", ctypes.POINTER(ctypes.c_int64)),
        # TALUS_AS_GENERATED undoes edits
        ("fill_materials", ctypes.POINTER(ctypes.c_int32)),
        # fills only this material; TALUS_ANY: any; NULL: TALUS_ANY for all
        ("fill_only", ctypes.POINTER(ctypes.c_int32)),
        # TALUS_CHUNK_VOLUME ids, index TALUS_VOXEL_INDEX(x, y, z); NULL: no paste
        ("paste_voxels", ctypes.POINTER(ctypes.c_uint16)),
        # target of the paste's voxel (0, 0, 0)
        ("paste_x", ctypes.c_int64),
        ("paste_y", ctypes.c_int64),
        ("paste_z", ctypes.c_int64),
        # Player for whom a game server with the right "gateway" edits; empty: the token's own subject.
        ("subject", ctypes.c_char_p),
        ("guard_count", ctypes.c_uint32),
        ("write_count", ctypes.c_uint32),
        ("fill_count", ctypes.c_uint32),
        # 0
        ("reserved", ctypes.c_uint32),
    ]

# the paste's air is written too; otherwise it is skipped
TALUS_PASTE_AIR = 1

TALUS_AS_GENERATED = -1
TALUS_ANY = -1


class talus_stats(Sized):
    """Running totals since talus_connect()."""

    _fields_ = [
        ("size", ctypes.c_uint32),
        # 0
        ("reserved", ctypes.c_uint32),
        # everything the server sent
        ("received_bytes", ctypes.c_uint64),
        ("sent_bytes", ctypes.c_uint64),
        ("chunk_frames", ctypes.c_uint64),
        # of chunk frames
        ("chunk_bytes", ctypes.c_uint64),
        # received as whole columns
        ("uniform_chunks", ctypes.c_uint64),
        # of a View, already held and not sent again
        ("kept_chunks", ctypes.c_uint64),
        # failed to decode, or did not match their hash
        ("bad_chunks", ctypes.c_uint64),
        ("connections", ctypes.c_uint64),
        # of Views, made here (talus_connect_options.generate)
        ("made_chunks", ctypes.c_uint64),
        # chunks made here that were compared with the server's
        ("proofs", ctypes.c_uint64),
        # and differed
        ("failed_proofs", ctypes.c_uint64),
        # of the world's files, received
        ("file_bytes", ctypes.c_uint64),
    ]


# Event types and their fields. New minor versions may add types: ignore unknown ones.
# The server accepted the client; talus_get_world() is available.
TALUS_EVENT_JOINED = 1
# A chunk of the View arrived or changed: x, y, z, level, revision, hash, chunk, uniform_material.
TALUS_EVENT_CHUNK = 2
# A chunk delivered by CHUNK left the View: x, y, z, level.
TALUS_EVENT_CHUNK_LEFT = 3
# All chunks of the newest View arrived, except any reported by ERROR.
TALUS_EVENT_VIEW_COMPLETE = 4
# Answer to talus_get_chunk(): request, status, and the fields of CHUNK.
TALUS_EVENT_CHUNK_ANSWER = 5
# Answer to talus_get_heights() or talus_get_places(): request, status, column_count, heights_fx; looks,
# values.
TALUS_EVENT_HEIGHTS = 6
# Answer to talus_ping(): request, status, round_trip_ns.
TALUS_EVENT_PONG = 7
# An error that the connection survives, such as a bad chunk or a refused View: status, message.
TALUS_EVENT_ERROR = 8
# The connection broke, and the client is reconnecting: status, message.
TALUS_EVENT_RECONNECTING = 9
# Reconnected to the same world. CHUNK follows for all chunks of the View; open requests are sent again.
TALUS_EVENT_RECONNECTED = 10
# Answer to talus_send_edit(), once the edit is stored or rejected: request, status; revision of the world
# after it, changed_voxels.
TALUS_EVENT_EDITED = 12
# The last event: the connection ended or was never established: status, message.
TALUS_EVENT_CLOSED = 11


class talus_event(Sized):
    """One event. Fields that its type does not have are 0, NULL, or "" for strings."""

    _fields_ = [
        ("size", ctypes.c_uint32),
        # TALUS_EVENT_...
        ("type", ctypes.c_uint32),
        # TALUS_OK or an error
        ("status", ctypes.c_int32),
        # the request that this answers
        ("request", ctypes.c_uint32),
        # the chunk's coordinates, in chunks of `level`
        ("x", ctypes.c_int32),
        ("y", ctypes.c_int32),
        ("z", ctypes.c_int32),
        # of detail, 0 to 6
        ("level", ctypes.c_uint32),
        # of the chunk; 0: as generated; higher is newer
        ("revision", ctypes.c_uint64),
        # XXH3-128 of the voxels as little-endian uint16.
        ("hash_low", ctypes.c_uint64),
        ("hash_high", ctypes.c_uint64),
        # The voxels. NULL in an answer: unchanged since the hash passed as `known`, or an error.
        ("chunk", ctypes.c_void_p),
        # one line for humans, if status is an error
        ("message", ctypes.c_char_p),
        # The material id of all voxels of the chunk. -1: they differ, or there is no chunk.
        ("uniform_material", ctypes.c_int32),
        # delay that the server asks for; 0: no delay
        ("retry_after_ms", ctypes.c_uint32),
        # ground at column_count columns, 1/256 voxel above y = 0
        ("heights_fx", ctypes.POINTER(ctypes.c_int32)),
        # per column, index for talus_look_name(); NULL if not requested
        ("looks", ctypes.POINTER(ctypes.c_uint8)),
        # field_count values per column, in the order of the request
        ("values", ctypes.POINTER(ctypes.c_float)),
        ("column_count", ctypes.c_uint32),
        ("field_count", ctypes.c_uint32),
        ("round_trip_ns", ctypes.c_uint64),
        # by the edit; 0: they already had these materials
        ("changed_voxels", ctypes.c_uint32),
        # 0
        ("reserved", ctypes.c_uint32),
    ]


FUNCTIONS = [
    # ---- The library ----
    # TALUS_API_MAJOR << 16 | TALUS_API_MINOR of the loaded library; its minor version may be higher than the
    # header's.
    ("talus_api_version", ctypes.c_uint32),
    # The release of Talus that the library was built from: "0.2.0".
    ("talus_version", ctypes.c_char_p),
    # "TALUS_REFUSED" for TALUS_REFUSED; "unknown status" for any other value. Valid for ever.
    ("talus_status_name", ctypes.c_char_p, ctypes.c_int32),
    # ---- Clients ----
    # Creates an unconnected client in *client; free it with talus_destroy().
    ("talus_create", ctypes.c_int32, ctypes.POINTER(ctypes.c_void_p)),
    # Closes the connection and frees the client and everything its last event points to, except retained chunks.
    # NULL is ignored. May wait for a pending look-up of a host name.
    ("talus_destroy", None, ctypes.c_void_p),
    # Message of this client's last failed call, in one line; empty if no call failed. Valid until the next
    # failing call. With NULL: of this thread's last failed call without a client.
    ("talus_last_error", ctypes.c_char_p, ctypes.c_void_p),
    # Begins to connect and returns at once. JOINED or CLOSED reports the result.
    ("talus_connect", ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(talus_connect_options)),
    # Closes the connection. Queued events and open answers are dropped, and CLOSED is not sent. No effect
    # without a connection. May wait for a pending look-up of a host name.
    ("talus_disconnect", ctypes.c_int32, ctypes.c_void_p),
    # Stores the next event in *event. Waits at most timeout_ms milliseconds; 0: not at all, negative: without
    # limit. TALUS_NO_EVENT: no event in time. TALUS_NOT_CONNECTED: no event can come without a connection. All
    # work is done in here: call it at least every few seconds, each time until it returns TALUS_NO_EVENT.
    ("talus_poll", ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(talus_event), ctypes.c_int32),
    # ---- The world: available after JOINED ----
    # Its pointers, and names, stay valid until talus_poll() returns RECONNECTED, or until talus_connect(),
    # talus_disconnect() or talus_destroy().
    ("talus_get_world", ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(talus_world)),
    # `index` below world.material_count.
    ("talus_get_material", ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint32, ctypes.POINTER(talus_material)),
    # A biome's name; index 0, "", means no biome. `index` below world.look_count; NULL otherwise.
    ("talus_look_name", ctypes.c_char_p, ctypes.c_void_p, ctypes.c_uint32),
    # The name of a quantity such as temperature. `index` below world.field_count; NULL otherwise.
    ("talus_field_name", ctypes.c_char_p, ctypes.c_void_p, ctypes.c_uint32),
    # ---- Chunks around a player ----
    # Replaces the View. Cheap: call it every frame. TALUS_OUT_OF_RANGE keeps the previous View. Requires JOINED;
    # while reconnecting, the View is kept and sent later.
    ("talus_set_view", ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(talus_view)),
    # Number of chunks of the View, for a progress bar.
    ("talus_count_view", ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(talus_view), ctypes.POINTER(ctypes.c_uint64)),
    # Sets ring_radius: rings of levels 1 to 6 from horizontal_radius out to `farthest` base chunks, each wider
    # than the previous one by the same ratio. Needs no client.
    ("talus_fill_rings", ctypes.c_int32, ctypes.POINTER(talus_view), ctypes.c_uint16),
    # ---- Requests: each is answered by one event with the number stored in *request, unless NULL ----
    # Requests a chunk. `known`: low and high half of the hash of the caller's copy, or NULL. Any number of
    # requests may be open.
    ("talus_get_chunk", ctypes.c_int32, ctypes.c_void_p, ctypes.c_int32, ctypes.c_int32, ctypes.c_int32, ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint64), ctypes.POINTER(ctypes.c_uint32)),
    # Requests the ground at `count` base columns, 1 to world.max_columns. `columns`: 2 * count numbers, x and z
    # of each.
    ("talus_get_heights", ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(ctypes.c_int64), ctypes.c_size_t, ctypes.POINTER(ctypes.c_uint32)),
    # Requests heights, the biome of each column, and its values of the named fields: at most 16.
    ("talus_get_places", ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(ctypes.c_int64), ctypes.c_size_t, ctypes.POINTER(ctypes.c_char_p), ctypes.c_size_t, ctypes.POINTER(ctypes.c_uint32)),
    # Changes voxels. Edits are applied in the order of the calls, each once, however often the connection
    # breaks; one that the server refuses temporarily is sent again, and may then be applied after later ones.
    # Changed chunks of the View arrive by CHUNK, before or after EDITED.
    ("talus_send_edit", ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(talus_edit), ctypes.POINTER(ctypes.c_uint32)),
    ("talus_ping", ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(ctypes.c_uint32)),
    # Cancels a talus_get_chunk(). It is still answered, with TALUS_CANCELLED, or with the chunk if it was in
    # flight. No effect on other or answered requests.
    ("talus_cancel", ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint32),
    ("talus_get_stats", ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(talus_stats)),
    # ---- Voxels: any thread ----
    # Writes all voxels of a chunk, index TALUS_VOXEL_INDEX(x, y, z). `count` is TALUS_CHUNK_VOLUME.
    ("talus_decode", ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(ctypes.c_uint16), ctypes.c_size_t),
    # Keeps a chunk beyond its event; release it once per retain. Both ignore NULL.
    ("talus_chunk_retain", None, ctypes.c_void_p),
    ("talus_chunk_release", None, ctypes.c_void_p),
]


def load(path=None):
    """The library at the path; otherwise beside this file or the program, or where the system finds it."""
    beside, name = ("talus.dll", "talus.dll") if sys.platform == "win32" else ("libtalus.so", "libtalus.so.1")
    # Absolute: otherwise Windows does not search a DLL's folder for what it needs.
    program = getattr(sys.modules["__main__"], "__file__", None) or __file__
    folders = [os.path.dirname(os.path.abspath(each)) for each in (__file__, program)]
    paths = [each for each in (os.path.join(folder, beside) for folder in folders) if os.path.exists(each)]
    library = ctypes.CDLL(path or (paths + [name])[0])
    for name, result, *parameters in FUNCTIONS:
        function = getattr(library, name)
        function.restype, function.argtypes = result, parameters
    return library
