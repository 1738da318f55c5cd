// Made from talus.h by client_sample/c_api/bindings/make.py.
#![allow(non_camel_case_types, non_snake_case)]

use std::os::raw::c_char;

// libtalus: the Talus client library for C, and for every language that calls C.
//
//   talus_client* client;
//   talus_create(&client);
//   talus_connect_options options = {.size = sizeof options, .host = "localhost"};
//   talus_connect(client, &options);
//   talus_event event = {.size = sizeof event};
//   while (talus_poll(client, &event, 1000) == TALUS_OK) ...        (examples/fly.c is a whole program)
//   talus_destroy(client);
//
// Space. Axes are x east, y up, z south. The unit of length is the base voxel. A chunk is 32 x 32 x 32 voxels
// of one level of detail, 0 to 6; a voxel of level l spans 2^l base voxels along each axis. Chunk coordinates
// count chunks of their level. Base voxel v lies in base chunk floor(v / 32). Dense voxels are uint16_t
// material ids, index (y * 32 + z) * 32 + x. Heights are in 1/256 base voxel above y = 0.
//
// Structs. Each begins with `size`, which the caller sets to sizeof the struct before every call. Fields are
// only ever appended. The library takes shorter structs of older programs, and longer ones of newer programs
// if the bytes that it does not know are 0. So set every unused field to 0, its default.
//
// Errors. A function that fails returns a negative status, changes nothing unless it says otherwise, and
// leaves a one-line message in talus_last_error(). No C++ exception leaves the library. After
// TALUS_OUT_OF_MEMORY and TALUS_INTERNAL the connection is closed, without a CLOSED event; the client may
// connect again. If not even 512 bytes can be allocated, the library may abort().
//
// Threads. A client may be used by one thread at a time, not always the same. Different clients are
// independent. Chunks are immutable: any thread may decode, retain and release them. The library makes no
// callbacks, and does network work only inside talus_poll(), except the look-up of host names, which runs in
// its own thread. With `generate` other threads make chunks.
//
// Ownership. Functions copy their arguments before they return. Pointers in an event stay valid until the
// next talus_poll(), talus_connect() or talus_destroy() of its client; talus_chunk_retain() keeps a chunk
// longer. Strings are UTF-8 with a terminating zero. The library never returns NULL strings; it takes NULL as
// the empty string.
//
// Tested on Linux on x86-64, on aarch64 and s390x in qemu, and for Windows in Wine.

// Version of this interface. A new minor version only adds; a new major version is another library,
// libtalus.so.MAJOR.
pub const TALUS_API_MAJOR: u32 = 1;
pub const TALUS_API_MINOR: u32 = 0;
/// voxels along each edge
pub const TALUS_CHUNK_SIZE: u32 = 32;
/// voxels
pub const TALUS_CHUNK_VOLUME: u32 = 32768;
/// each 0 to 31, inside the chunk
pub const fn TALUS_VOXEL_INDEX(x: usize, y: usize, z: usize) -> usize {
    (y * 32 + z) * 32 + x
}
pub const TALUS_DEFAULT_PORT: u32 = 4780;

pub type talus_status = i32;

pub const TALUS_OK: talus_status = 0;
/// talus_poll(): no event in time
pub const TALUS_NO_EVENT: talus_status = 1;
/// NULL, a wrong size or count, an unknown flag, an index beyond a list
pub const TALUS_INVALID_ARGUMENT: talus_status = -1;
/// the connection is closed
pub const TALUS_OUT_OF_MEMORY: talus_status = -2;
/// a fault of the library; the connection is closed
pub const TALUS_INTERNAL: talus_status = -3;
/// by this build of the library, or by the server
pub const TALUS_UNSUPPORTED: talus_status = -4;
/// call talus_disconnect() first
pub const TALUS_ALREADY_CONNECTED: talus_status = -5;
/// more than 2^18 events are queued; poll them first
pub const TALUS_TOO_MANY_EVENTS: talus_status = -6;
/// the name does not resolve, or nothing listens there
pub const TALUS_UNREACHABLE: talus_status = -16;
/// the server rejects this client: version, token, too many connections
pub const TALUS_REFUSED: talus_status = -17;
/// TLS: the server's certificate was not accepted
pub const TALUS_UNTRUSTED: talus_status = -18;
/// the connection broke, or the server closed it
pub const TALUS_DISCONNECTED: talus_status = -19;
/// no answer in time while connecting, or silence afterwards
pub const TALUS_TIMED_OUT: talus_status = -20;
/// after a reconnect the server had another world
pub const TALUS_WORLD_CHANGED: talus_status = -21;
/// the server violated the protocol
pub const TALUS_BROKEN_PROTOCOL: talus_status = -22;
/// a chunk failed to decode, or does not match its hash
pub const TALUS_BAD_CHUNK: talus_status = -23;
/// a coordinate, radius or list exceeds the world's or the server's limits
pub const TALUS_OUT_OF_RANGE: talus_status = -24;
/// the server asks for a retry after `retry_after_ms`
pub const TALUS_OVERLOADED: talus_status = -25;
/// talus_cancel() came before the answer
pub const TALUS_CANCELLED: talus_status = -26;
/// the server could not answer; a retry may succeed
pub const TALUS_SERVER_FAILED: talus_status = -27;
/// called before JOINED, or after CLOSED or talus_disconnect()
pub const TALUS_NOT_CONNECTED: talus_status = -28;
/// a guard of the edit does not hold; nothing was applied
pub const TALUS_CONFLICT: talus_status = -29;
/// the edit was not applied, but a later one was
pub const TALUS_NOT_APPLIED: talus_status = -30;
/// The edit was sent and may have been applied: the client gave up before an answer, or the server no longer
/// knows the editor.
pub const TALUS_OUTCOME_UNKNOWN: talus_status = -31;
/// chunks cannot be made here (talus_connect_options.generate)
pub const TALUS_CANNOT_GENERATE: talus_status = -32;

/// One client, its connection, and its queued events.
#[repr(C)]
pub struct talus_client {
    _opaque: [u8; 0],
}

/// A chunk's immutable voxels, reference-counted by talus_chunk_retain() and talus_chunk_release().
#[repr(C)]
pub struct talus_chunk {
    _opaque: [u8; 0],
}

/// Options of a connection. The number 0 means the default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct talus_connect_options {
    pub size: u32,
    /// TALUS_TLS, TALUS_TLS_NO_VERIFY, TALUS_WEBSOCKET
    pub flags: u32,
    /// a name or an address; not empty
    pub host: *const c_char,
    /// issued by the server's operator; empty: no token
    pub token: *const c_char,
    /// for the server's log; empty: "libtalus"
    pub client_name: *const c_char,
    /// PEM file of trusted certificates; empty: the system's
    pub tls_ca_file: *const c_char,
    /// name that the certificate must have; empty: `host`
    pub tls_server_name: *const c_char,
    /// maximum chunk bytes in flight; default 1 MiB
    pub window_bytes: u64,
    /// Maximum bytes of decoded chunks kept after they left the View while the game retained them: if they
    /// return unchanged, they are not sent again. Default 32 MiB.
    pub keep_bytes: u64,
    /// default TALUS_DEFAULT_PORT
    pub port: u32,
    /// name lookup, TCP and TLS; default 5,000
    pub connect_timeout_ms: u32,
    /// from there to JOINED; default 5,000
    pub handshake_timeout_ms: u32,
    /// maximum; default 20,000
    pub ping_interval_ms: u32,
    /// without a byte from the server it counts as lost; default 60,000
    pub silence_timeout_ms: u32,
    /// consecutive failures until it gives up; 0: never reconnects
    pub reconnect_attempts: u32,
    /// doubles with each failure; delays are random below; default 500
    pub reconnect_first_delay_ms: u32,
    /// default 10,000
    pub reconnect_max_delay_ms: u32,
    /// "HOST:PORT,HOST:PORT": other servers of the same world, may be empty. If one cannot be reached, goes away
    /// or disconnects, the next is tried, then around again.
    pub more_servers: *const c_char,
    /// TALUS_GENERATE_AUTO makes a published world's chunks here and receives only edits. Events are the same.
    /// Chunks of talus_get_chunk() still come from the server.
    pub generate: u32,
    /// default: one less than the machine's processors
    pub generate_threads: u32,
}

impl Default for talus_connect_options {
    /// Its size; the other fields are 0.
    fn default() -> Self {
        // Numbers and pointers may all be 0.
        Self { size: std::mem::size_of::<Self>() as u32, ..unsafe { std::mem::zeroed() } }
    }
}

// Before the world is open, chunks are received. Some chunks are compared with the server's. If one differs,
// or the world cannot be made by this library, AUTO receives chunks from then on, again those made here, and
// ERROR says why, by TALUS_CANNOT_GENERATE; ALWAYS ends by CLOSED.
pub const TALUS_GENERATE_NEVER: u32 = 0;
pub const TALUS_GENERATE_AUTO: u32 = 1;
pub const TALUS_GENERATE_ALWAYS: u32 = 2;

/// TLS 1.3; the server's certificate is checked
pub const TALUS_TLS: u32 = 1;
/// the certificate is not checked: any server is accepted
pub const TALUS_TLS_NO_VERIFY: u32 = 2;
/// ws://host:port/v1/stream; `port` is talusd's HTTP port, or a proxy's
pub const TALUS_WEBSOCKET: u32 = 4;

/// The chunks that a player wants around it: level 0 within the radii, coarser levels farther out.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct talus_view {
    pub size: u32,
    /// TALUS_VIEW_HORIZON
    pub flags: u32,
    /// base voxels
    pub centre_x: i64,
    pub centre_y: i64,
    pub centre_z: i64,
    /// of sight, any length; 0: no preference
    pub direction_x: f32,
    pub direction_y: f32,
    pub direction_z: f32,
    /// base chunks; 0: the centre's column alone
    pub horizontal_radius: u16,
    /// base chunks
    pub vertical_radius: u16,
    /// Levels 1 to 6, in base chunks, each wider than the finer ones; 0: no ring of this level.
    pub ring_radius: [u16; 6],
    /// 0
    pub reserved: u32,
}

impl Default for talus_view {
    /// Its size; the other fields are 0.
    fn default() -> Self {
        // Numbers and pointers may all be 0.
        Self { size: std::mem::size_of::<Self>() as u32, ..unsafe { std::mem::zeroed() } }
    }
}

// Flag of talus_view: rings include every row in which ground can lie. Requires talus_world.has_horizon.
pub const TALUS_VIEW_HORIZON: u32 = 1;

/// The server's description of its world.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct talus_world {
    pub size: u32,
    /// talus_get_material()
    pub material_count: u32,
    /// equal fingerprints: equal voxels everywhere
    pub fingerprint_low: u64,
    pub fingerprint_high: u64,
    /// revisions of one store are comparable
    pub store_low: u64,
    pub store_high: u64,
    /// as generated: one rock below min_y, air from max_y up
    pub min_y: i64,
    pub max_y: i64,
    /// base voxel of the feet: the first free one above dry ground
    pub spawn_x: i64,
    pub spawn_y: i64,
    pub spawn_z: i64,
    /// its name and version
    pub server: *const c_char,
    /// talus_look_name(), talus_field_name()
    pub look_count: u32,
    pub field_count: u32,
    /// of a View, base chunks; 2^l times as many for a ring of level l
    pub max_horizontal_radius: u32,
    /// base chunks
    pub max_vertical_radius: u32,
    /// of all levels in one View
    pub max_view_chunks: u32,
    /// in one talus_get_heights()
    pub max_columns: u32,
    /// 1: Views may have TALUS_VIEW_HORIZON
    pub has_horizon: u32,
    /// 0
    pub reserved: u32,
}

impl Default for talus_world {
    /// Its size; the other fields are 0.
    fn default() -> Self {
        // Numbers and pointers may all be 0.
        Self { size: std::mem::size_of::<Self>() as u32, ..unsafe { std::mem::zeroed() } }
    }
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct talus_material {
    pub size: u32,
    /// as in voxels; 0 is air, 1 water
    pub id: u32,
    /// 0xRRGGBB, sRGB
    pub colour: u32,
    /// TALUS_GAS, TALUS_LIQUID, TALUS_SOLID
    pub phase: u32,
    /// valid as long as the world's pointers: see talus_get_world()
    pub name: *const c_char,
}

impl Default for talus_material {
    /// Its size; the other fields are 0.
    fn default() -> Self {
        // Numbers and pointers may all be 0.
        Self { size: std::mem::size_of::<Self>() as u32, ..unsafe { std::mem::zeroed() } }
    }
}

pub const TALUS_GAS: u32 = 0;
pub const TALUS_LIQUID: u32 = 1;
pub const TALUS_SOLID: u32 = 2;

/// An edit. If all guards hold, writes, fills and the paste are applied in this order, each on the result of
/// the previous ones; the edit is applied completely or not at all. Voxels are base voxels, stored as x, y, z
/// of the first, then of the next.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct talus_edit {
    pub size: u32,
    /// TALUS_PASTE_AIR
    pub flags: u32,
    /// guard_count voxels that must have guard_materials
    pub guard_voxels: *const i64,
    pub guard_materials: *const u16,
    /// write_count voxels that get write_materials
    pub write_voxels: *const i64,
    pub write_materials: *const u16,
    /// fill_count boxes: lowest corner, then highest; both included
    pub fill_corners: *const i64,
    /// TALUS_AS_GENERATED undoes edits
    pub fill_materials: *const i32,
    /// fills only this material; TALUS_ANY: any; NULL: TALUS_ANY for all
    pub fill_only: *const i32,
    /// TALUS_CHUNK_VOLUME ids, index TALUS_VOXEL_INDEX(x, y, z); NULL: no paste
    pub paste_voxels: *const u16,
    /// target of the paste's voxel (0, 0, 0)
    pub paste_x: i64,
    pub paste_y: i64,
    pub paste_z: i64,
    /// Player for whom a game server with the right "gateway" edits; empty: the token's own subject.
    pub subject: *const c_char,
    pub guard_count: u32,
    pub write_count: u32,
    pub fill_count: u32,
    /// 0
    pub reserved: u32,
}

impl Default for talus_edit {
    /// Its size; the other fields are 0.
    fn default() -> Self {
        // Numbers and pointers may all be 0.
        Self { size: std::mem::size_of::<Self>() as u32, ..unsafe { std::mem::zeroed() } }
    }
}
/// the paste's air is written too; otherwise it is skipped
pub const TALUS_PASTE_AIR: u32 = 1;

pub const TALUS_AS_GENERATED: i32 = -1;
pub const TALUS_ANY: i32 = -1;

/// Running totals since talus_connect().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct talus_stats {
    pub size: u32,
    /// 0
    pub reserved: u32,
    /// everything the server sent
    pub received_bytes: u64,
    pub sent_bytes: u64,
    pub chunk_frames: u64,
    /// of chunk frames
    pub chunk_bytes: u64,
    /// received as whole columns
    pub uniform_chunks: u64,
    /// of a View, already held and not sent again
    pub kept_chunks: u64,
    /// failed to decode, or did not match their hash
    pub bad_chunks: u64,
    pub connections: u64,
    /// of Views, made here (talus_connect_options.generate)
    pub made_chunks: u64,
    /// chunks made here that were compared with the server's
    pub proofs: u64,
    /// and differed
    pub failed_proofs: u64,
    /// of the world's files, received
    pub file_bytes: u64,
}

impl Default for talus_stats {
    /// Its size; the other fields are 0.
    fn default() -> Self {
        // Numbers and pointers may all be 0.
        Self { size: std::mem::size_of::<Self>() as u32, ..unsafe { std::mem::zeroed() } }
    }
}

// Event types and their fields. New minor versions may add types: ignore unknown ones.
/// The server accepted the client; talus_get_world() is available.
pub const TALUS_EVENT_JOINED: u32 = 1;
/// A chunk of the View arrived or changed: x, y, z, level, revision, hash, chunk, uniform_material.
pub const TALUS_EVENT_CHUNK: u32 = 2;
/// A chunk delivered by CHUNK left the View: x, y, z, level.
pub const TALUS_EVENT_CHUNK_LEFT: u32 = 3;
/// All chunks of the newest View arrived, except any reported by ERROR.
pub const TALUS_EVENT_VIEW_COMPLETE: u32 = 4;
/// Answer to talus_get_chunk(): request, status, and the fields of CHUNK.
pub const TALUS_EVENT_CHUNK_ANSWER: u32 = 5;
/// Answer to talus_get_heights() or talus_get_places(): request, status, column_count, heights_fx; looks,
/// values.
pub const TALUS_EVENT_HEIGHTS: u32 = 6;
/// Answer to talus_ping(): request, status, round_trip_ns.
pub const TALUS_EVENT_PONG: u32 = 7;
/// An error that the connection survives, such as a bad chunk or a refused View: status, message.
pub const TALUS_EVENT_ERROR: u32 = 8;
/// The connection broke, and the client is reconnecting: status, message.
pub const TALUS_EVENT_RECONNECTING: u32 = 9;
/// Reconnected to the same world. CHUNK follows for all chunks of the View; open requests are sent again.
pub const TALUS_EVENT_RECONNECTED: u32 = 10;
/// Answer to talus_send_edit(), once the edit is stored or rejected: request, status; revision of the world
/// after it, changed_voxels.
pub const TALUS_EVENT_EDITED: u32 = 12;
/// The last event: the connection ended or was never established: status, message.
pub const TALUS_EVENT_CLOSED: u32 = 11;

/// One event. Fields that its type does not have are 0, NULL, or "" for strings.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct talus_event {
    pub size: u32,
    /// TALUS_EVENT_...
    pub type_: u32,
    /// TALUS_OK or an error
    pub status: talus_status,
    /// the request that this answers
    pub request: u32,
    /// the chunk's coordinates, in chunks of `level`
    pub x: i32,
    pub y: i32,
    pub z: i32,
    /// of detail, 0 to 6
    pub level: u32,
    /// of the chunk; 0: as generated; higher is newer
    pub revision: u64,
    /// XXH3-128 of the voxels as little-endian uint16.
    pub hash_low: u64,
    pub hash_high: u64,
    /// The voxels. NULL in an answer: unchanged since the hash passed as `known`, or an error.
    pub chunk: *const talus_chunk,
    /// one line for humans, if status is an error
    pub message: *const c_char,
    /// The material id of all voxels of the chunk. -1: they differ, or there is no chunk.
    pub uniform_material: i32,
    /// delay that the server asks for; 0: no delay
    pub retry_after_ms: u32,
    /// ground at column_count columns, 1/256 voxel above y = 0
    pub heights_fx: *const i32,
    /// per column, index for talus_look_name(); NULL if not requested
    pub looks: *const u8,
    /// field_count values per column, in the order of the request
    pub values: *const f32,
    pub column_count: u32,
    pub field_count: u32,
    pub round_trip_ns: u64,
    /// by the edit; 0: they already had these materials
    pub changed_voxels: u32,
    /// 0
    pub reserved: u32,
}

impl Default for talus_event {
    /// Its size; the other fields are 0.
    fn default() -> Self {
        // Numbers and pointers may all be 0.
        Self { size: std::mem::size_of::<Self>() as u32, ..unsafe { std::mem::zeroed() } }
    }
}

#[link(name = "talus")]
extern "C" {

    // ---- The library ----
    /// TALUS_API_MAJOR << 16 | TALUS_API_MINOR of the loaded library; its minor version may be higher than the
    /// header's.
    pub fn talus_api_version() -> u32;
    /// The release of Talus that the library was built from: "0.2.0".
    pub fn talus_version() -> *const c_char;
    /// "TALUS_REFUSED" for TALUS_REFUSED; "unknown status" for any other value. Valid for ever.
    pub fn talus_status_name(status: talus_status) -> *const c_char;

    // ---- Clients ----
    /// Creates an unconnected client in *client; free it with talus_destroy().
    pub fn talus_create(client: *mut *mut talus_client) -> talus_status;
    /// Closes the connection and frees the client and everything its last event points to, except retained chunks.
    /// NULL is ignored. May wait for a pending look-up of a host name.
    pub fn talus_destroy(client: *mut talus_client);
    /// Message of this client's last failed call, in one line; empty if no call failed. Valid until the next
    /// failing call. With NULL: of this thread's last failed call without a client.
    pub fn talus_last_error(client: *const talus_client) -> *const c_char;
    /// Begins to connect and returns at once. JOINED or CLOSED reports the result.
    pub fn talus_connect(client: *mut talus_client, options: *const talus_connect_options) -> talus_status;
    /// Closes the connection. Queued events and open answers are dropped, and CLOSED is not sent. No effect
    /// without a connection. May wait for a pending look-up of a host name.
    pub fn talus_disconnect(client: *mut talus_client) -> talus_status;
    /// Stores the next event in *event. Waits at most timeout_ms milliseconds; 0: not at all, negative: without
    /// limit. TALUS_NO_EVENT: no event in time. TALUS_NOT_CONNECTED: no event can come without a connection. All
    /// work is done in here: call it at least every few seconds, each time until it returns TALUS_NO_EVENT.
    pub fn talus_poll(client: *mut talus_client, event: *mut talus_event, timeout_ms: i32) -> talus_status;

    // ---- The world: available after JOINED ----
    /// Its pointers, and names, stay valid until talus_poll() returns RECONNECTED, or until talus_connect(),
    /// talus_disconnect() or talus_destroy().
    pub fn talus_get_world(client: *mut talus_client, world: *mut talus_world) -> talus_status;
    /// `index` below world.material_count.
    pub fn talus_get_material(client: *mut talus_client, index: u32, material: *mut talus_material) -> talus_status;
    /// A biome's name; index 0, "", means no biome. `index` below world.look_count; NULL otherwise.
    pub fn talus_look_name(client: *mut talus_client, index: u32) -> *const c_char;
    /// The name of a quantity such as temperature. `index` below world.field_count; NULL otherwise.
    pub fn talus_field_name(client: *mut talus_client, index: u32) -> *const c_char;

    // ---- Chunks around a player ----
    /// Replaces the View. Cheap: call it every frame. TALUS_OUT_OF_RANGE keeps the previous View. Requires JOINED;
    /// while reconnecting, the View is kept and sent later.
    pub fn talus_set_view(client: *mut talus_client, view: *const talus_view) -> talus_status;
    /// Number of chunks of the View, for a progress bar.
    pub fn talus_count_view(client: *mut talus_client, view: *const talus_view, chunks: *mut u64) -> talus_status;
    /// Sets ring_radius: rings of levels 1 to 6 from horizontal_radius out to `farthest` base chunks, each wider
    /// than the previous one by the same ratio. Needs no client.
    pub fn talus_fill_rings(view: *mut talus_view, farthest: u16) -> talus_status;

    // ---- Requests: each is answered by one event with the number stored in *request, unless NULL ----
    /// Requests a chunk. `known`: low and high half of the hash of the caller's copy, or NULL. Any number of
    /// requests may be open.
    pub fn talus_get_chunk(client: *mut talus_client, x: i32, y: i32, z: i32, level: u32, known: *const u64, request: *mut u32) -> talus_status;
    /// Requests the ground at `count` base columns, 1 to world.max_columns. `columns`: 2 * count numbers, x and z
    /// of each.
    pub fn talus_get_heights(client: *mut talus_client, columns: *const i64, count: usize, request: *mut u32) -> talus_status;
    /// Requests heights, the biome of each column, and its values of the named fields: at most 16.
    pub fn talus_get_places(client: *mut talus_client, columns: *const i64, count: usize, fields: *const *const c_char, field_count: usize, request: *mut u32) -> talus_status;
    /// Changes voxels. Edits are applied in the order of the calls, each once, however often the connection
    /// breaks; one that the server refuses temporarily is sent again, and may then be applied after later ones.
    /// Changed chunks of the View arrive by CHUNK, before or after EDITED.
    pub fn talus_send_edit(client: *mut talus_client, edit: *const talus_edit, request: *mut u32) -> talus_status;
    pub fn talus_ping(client: *mut talus_client, request: *mut u32) -> talus_status;
    /// Cancels a talus_get_chunk(). It is still answered, with TALUS_CANCELLED, or with the chunk if it was in
    /// flight. No effect on other or answered requests.
    pub fn talus_cancel(client: *mut talus_client, request: u32) -> talus_status;
    pub fn talus_get_stats(client: *mut talus_client, stats: *mut talus_stats) -> talus_status;

    // ---- Voxels: any thread ----
    /// Writes all voxels of a chunk, index TALUS_VOXEL_INDEX(x, y, z). `count` is TALUS_CHUNK_VOLUME.
    pub fn talus_decode(chunk: *const talus_chunk, voxels: *mut u16, count: usize) -> talus_status;
    /// Keeps a chunk beyond its event; release it once per retain. Both ignore NULL.
    pub fn talus_chunk_retain(chunk: *const talus_chunk);
    pub fn talus_chunk_release(chunk: *const talus_chunk);
}
