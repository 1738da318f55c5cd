// Made from talus.h by client_sample/c_api/bindings/make.py.
using System;
using System.Runtime.InteropServices;
using System.Text;

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

public static class Talus
{
    private const string Library = "talus";

    /// <summary>A string of the library; null if there is none.</summary>
    public static string Text(IntPtr text)
    {
        if (text == IntPtr.Zero) return null;
        int length = 0;
        while (Marshal.ReadByte(text, length) != 0) ++length;
        var bytes = new byte[length];
        Marshal.Copy(text, bytes, 0, length);
        return Encoding.UTF8.GetString(bytes);
    }

    /// <summary>A string for the library, to be freed by Marshal.FreeHGlobal().</summary>
    public static IntPtr Allocate(string text)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(text + "\0");
        IntPtr copy = Marshal.AllocHGlobal(bytes.Length);
        Marshal.Copy(bytes, 0, copy, bytes.Length);
        return copy;
    }

    // Version of this interface. A new minor version only adds; a new major version is another library,
    // libtalus.so.MAJOR.
    public const uint TALUS_API_MAJOR = 1;
    public const uint TALUS_API_MINOR = 0;
    /// <summary>voxels along each edge</summary>
    public const uint TALUS_CHUNK_SIZE = 32;
    /// <summary>voxels</summary>
    public const uint TALUS_CHUNK_VOLUME = 32768;
    /// <summary>each 0 to 31, inside the chunk</summary>
    public static int TALUS_VOXEL_INDEX(int x, int y, int z) { return (y * 32 + z) * 32 + x; }
    public const uint TALUS_DEFAULT_PORT = 4780;

    public const int TALUS_OK = 0;
    /// <summary>talus_poll(): no event in time</summary>
    public const int TALUS_NO_EVENT = 1;
    /// <summary>NULL, a wrong size or count, an unknown flag, an index beyond a list</summary>
    public const int TALUS_INVALID_ARGUMENT = -1;
    /// <summary>the connection is closed</summary>
    public const int TALUS_OUT_OF_MEMORY = -2;
    /// <summary>a fault of the library; the connection is closed</summary>
    public const int TALUS_INTERNAL = -3;
    /// <summary>by this build of the library, or by the server</summary>
    public const int TALUS_UNSUPPORTED = -4;
    /// <summary>call talus_disconnect() first</summary>
    public const int TALUS_ALREADY_CONNECTED = -5;
    /// <summary>more than 2^18 events are queued; poll them first</summary>
    public const int TALUS_TOO_MANY_EVENTS = -6;
    /// <summary>the name does not resolve, or nothing listens there</summary>
    public const int TALUS_UNREACHABLE = -16;
    /// <summary>the server rejects this client: version, token, too many connections</summary>
    public const int TALUS_REFUSED = -17;
    /// <summary>TLS: the server's certificate was not accepted</summary>
    public const int TALUS_UNTRUSTED = -18;
    /// <summary>the connection broke, or the server closed it</summary>
    public const int TALUS_DISCONNECTED = -19;
    /// <summary>no answer in time while connecting, or silence afterwards</summary>
    public const int TALUS_TIMED_OUT = -20;
    /// <summary>after a reconnect the server had another world</summary>
    public const int TALUS_WORLD_CHANGED = -21;
    /// <summary>the server violated the protocol</summary>
    public const int TALUS_BROKEN_PROTOCOL = -22;
    /// <summary>a chunk failed to decode, or does not match its hash</summary>
    public const int TALUS_BAD_CHUNK = -23;
    /// <summary>a coordinate, radius or list exceeds the world's or the server's limits</summary>
    public const int TALUS_OUT_OF_RANGE = -24;
    /// <summary>the server asks for a retry after `retry_after_ms`</summary>
    public const int TALUS_OVERLOADED = -25;
    /// <summary>talus_cancel() came before the answer</summary>
    public const int TALUS_CANCELLED = -26;
    /// <summary>the server could not answer; a retry may succeed</summary>
    public const int TALUS_SERVER_FAILED = -27;
    /// <summary>called before JOINED, or after CLOSED or talus_disconnect()</summary>
    public const int TALUS_NOT_CONNECTED = -28;
    /// <summary>a guard of the edit does not hold; nothing was applied</summary>
    public const int TALUS_CONFLICT = -29;
    /// <summary>the edit was not applied, but a later one was</summary>
    public const int TALUS_NOT_APPLIED = -30;
    /// <summary>The edit was sent and may have been applied: the client gave up before an answer, or the server no longer
    /// knows the editor.</summary>
    public const int TALUS_OUTCOME_UNKNOWN = -31;
    /// <summary>chunks cannot be made here (talus_connect_options.generate)</summary>
    public const int TALUS_CANNOT_GENERATE = -32;

    /// <summary>Options of a connection. The number 0 means the default.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct talus_connect_options
    {
        public uint size;
        /// <summary>TALUS_TLS, TALUS_TLS_NO_VERIFY, TALUS_WEBSOCKET</summary>
        public uint flags;
        /// <summary>a name or an address; not empty</summary>
        public IntPtr host;
        /// <summary>issued by the server's operator; empty: no token</summary>
        public IntPtr token;
        /// <summary>for the server's log; empty: "libtalus"</summary>
        public IntPtr client_name;
        /// <summary>PEM file of trusted certificates; empty: the system's</summary>
        public IntPtr tls_ca_file;
        /// <summary>name that the certificate must have; empty: `host`</summary>
        public IntPtr tls_server_name;
        /// <summary>maximum chunk bytes in flight; default 1 MiB</summary>
        public ulong window_bytes;
        /// <summary>Maximum bytes of decoded chunks kept after they left the View while the game retained them: if they
        /// return unchanged, they are not sent again. Default 32 MiB.</summary>
        public ulong keep_bytes;
        /// <summary>default TALUS_DEFAULT_PORT</summary>
        public uint port;
        /// <summary>name lookup, TCP and TLS; default 5,000</summary>
        public uint connect_timeout_ms;
        /// <summary>from there to JOINED; default 5,000</summary>
        public uint handshake_timeout_ms;
        /// <summary>maximum; default 20,000</summary>
        public uint ping_interval_ms;
        /// <summary>without a byte from the server it counts as lost; default 60,000</summary>
        public uint silence_timeout_ms;
        /// <summary>consecutive failures until it gives up; 0: never reconnects</summary>
        public uint reconnect_attempts;
        /// <summary>doubles with each failure; delays are random below; default 500</summary>
        public uint reconnect_first_delay_ms;
        /// <summary>default 10,000</summary>
        public uint reconnect_max_delay_ms;
        /// <summary>"HOST:PORT,HOST:PORT": other servers of the same world, may be empty. If one cannot be reached, goes away
        /// or disconnects, the next is tried, then around again.</summary>
        public IntPtr more_servers;
        /// <summary>TALUS_GENERATE_AUTO makes a published world's chunks here and receives only edits. Events are the same.
        /// Chunks of talus_get_chunk() still come from the server.</summary>
        public uint generate;
        /// <summary>default: one less than the machine's processors</summary>
        public uint generate_threads;

        private static readonly uint Size = (uint)Marshal.SizeOf(typeof(talus_connect_options));
        /// <summary>With its size; the other fields are 0.</summary>
        public static talus_connect_options Create() { return new talus_connect_options { size = Size }; }
    }

    // Before the world is open, chunks are received. Some chunks are compared with the server's. If one differs,
    // or the world cannot be made by this library, AUTO receives chunks from then on, again those made here, and
    // ERROR says why, by TALUS_CANNOT_GENERATE; ALWAYS ends by CLOSED.
    public const uint TALUS_GENERATE_NEVER = 0;
    public const uint TALUS_GENERATE_AUTO = 1;
    public const uint TALUS_GENERATE_ALWAYS = 2;

    /// <summary>TLS 1.3; the server's certificate is checked</summary>
    public const uint TALUS_TLS = 1;
    /// <summary>the certificate is not checked: any server is accepted</summary>
    public const uint TALUS_TLS_NO_VERIFY = 2;
    /// <summary>ws://host:port/v1/stream; `port` is talusd's HTTP port, or a proxy's</summary>
    public const uint TALUS_WEBSOCKET = 4;

    /// <summary>The chunks that a player wants around it: level 0 within the radii, coarser levels farther out.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct talus_view
    {
        public uint size;
        /// <summary>TALUS_VIEW_HORIZON</summary>
        public uint flags;
        /// <summary>base voxels</summary>
        public long centre_x;
        public long centre_y;
        public long centre_z;
        /// <summary>of sight, any length; 0: no preference</summary>
        public float direction_x;
        public float direction_y;
        public float direction_z;
        /// <summary>base chunks; 0: the centre's column alone</summary>
        public ushort horizontal_radius;
        /// <summary>base chunks</summary>
        public ushort vertical_radius;
        /// <summary>Levels 1 to 6, in base chunks, each wider than the finer ones; 0: no ring of this level.</summary>
        public ushort ring_radius_1, ring_radius_2, ring_radius_3, ring_radius_4, ring_radius_5, ring_radius_6;
        /// <summary>0</summary>
        public uint reserved;

        private static readonly uint Size = (uint)Marshal.SizeOf(typeof(talus_view));
        /// <summary>With its size; the other fields are 0.</summary>
        public static talus_view Create() { return new talus_view { size = Size }; }
    }

    // Flag of talus_view: rings include every row in which ground can lie. Requires talus_world.has_horizon.
    public const uint TALUS_VIEW_HORIZON = 1;

    /// <summary>The server's description of its world.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct talus_world
    {
        public uint size;
        /// <summary>talus_get_material()</summary>
        public uint material_count;
        /// <summary>equal fingerprints: equal voxels everywhere</summary>
        public ulong fingerprint_low;
        public ulong fingerprint_high;
        /// <summary>revisions of one store are comparable</summary>
        public ulong store_low;
        public ulong store_high;
        /// <summary>as generated: one rock below min_y, air from max_y up</summary>
        public long min_y;
        public long max_y;
        /// <summary>base voxel of the feet: the first free one above dry ground</summary>
        public long spawn_x;
        public long spawn_y;
        public long spawn_z;
        /// <summary>its name and version</summary>
        public IntPtr server;
        /// <summary>talus_look_name(), talus_field_name()</summary>
        public uint look_count;
        public uint field_count;
        /// <summary>of a View, base chunks; 2^l times as many for a ring of level l</summary>
        public uint max_horizontal_radius;
        /// <summary>base chunks</summary>
        public uint max_vertical_radius;
        /// <summary>of all levels in one View</summary>
        public uint max_view_chunks;
        /// <summary>in one talus_get_heights()</summary>
        public uint max_columns;
        /// <summary>1: Views may have TALUS_VIEW_HORIZON</summary>
        public uint has_horizon;
        /// <summary>0</summary>
        public uint reserved;

        private static readonly uint Size = (uint)Marshal.SizeOf(typeof(talus_world));
        /// <summary>With its size; the other fields are 0.</summary>
        public static talus_world Create() { return new talus_world { size = Size }; }
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct talus_material
    {
        public uint size;
        /// <summary>as in voxels; 0 is air, 1 water</summary>
        public uint id;
        /// <summary>0xRRGGBB, sRGB</summary>
        public uint colour;
        /// <summary>TALUS_GAS, TALUS_LIQUID, TALUS_SOLID</summary>
        public uint phase;
        /// <summary>valid as long as the world's pointers: see talus_get_world()</summary>
        public IntPtr name;

        private static readonly uint Size = (uint)Marshal.SizeOf(typeof(talus_material));
        /// <summary>With its size; the other fields are 0.</summary>
        public static talus_material Create() { return new talus_material { size = Size }; }
    }

    public const uint TALUS_GAS = 0;
    public const uint TALUS_LIQUID = 1;
    public const uint TALUS_SOLID = 2;

    /// <summary>An edit. If all guards hold, writes, fills and the paste are applied in this order, each on the result of
    /// the previous ones; the edit is applied completely or not at all. Voxels are base voxels, stored as x, y, z
    /// of the first, then of the next.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct talus_edit
    {
        public uint size;
        /// <summary>TALUS_PASTE_AIR</summary>
        public uint flags;
        /// <summary>guard_count voxels that must have guard_materials</summary>
        public IntPtr guard_voxels;
        public IntPtr guard_materials;
        /// <summary>write_count voxels that get write_materials</summary>
        public IntPtr write_voxels;
        public IntPtr write_materials;
        /// <summary>fill_count boxes: lowest corner, then highest; both included</summary>
        public IntPtr fill_corners;
        /// <summary>TALUS_AS_GENERATED undoes edits</summary>
        public IntPtr fill_materials;
        /// <summary>fills only this material; TALUS_ANY: any; NULL: TALUS_ANY for all</summary>
        public IntPtr fill_only;
        /// <summary>TALUS_CHUNK_VOLUME ids, index TALUS_VOXEL_INDEX(x, y, z); NULL: no paste</summary>
        public IntPtr paste_voxels;
        /// <summary>target of the paste's voxel (0, 0, 0)</summary>
        public long paste_x;
        public long paste_y;
        public long paste_z;
        /// <summary>Player for whom a game server with the right "gateway" edits; empty: the token's own subject.</summary>
        public IntPtr subject;
        public uint guard_count;
        public uint write_count;
        public uint fill_count;
        /// <summary>0</summary>
        public uint reserved;

        private static readonly uint Size = (uint)Marshal.SizeOf(typeof(talus_edit));
        /// <summary>With its size; the other fields are 0.</summary>
        public static talus_edit Create() { return new talus_edit { size = Size }; }
    }
    /// <summary>the paste's air is written too; otherwise it is skipped</summary>
    public const uint TALUS_PASTE_AIR = 1;

    public const int TALUS_AS_GENERATED = -1;
    public const int TALUS_ANY = -1;

    /// <summary>Running totals since talus_connect().</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct talus_stats
    {
        public uint size;
        /// <summary>0</summary>
        public uint reserved;
        /// <summary>everything the server sent</summary>
        public ulong received_bytes;
        public ulong sent_bytes;
        public ulong chunk_frames;
        /// <summary>of chunk frames</summary>
        public ulong chunk_bytes;
        /// <summary>received as whole columns</summary>
        public ulong uniform_chunks;
        /// <summary>of a View, already held and not sent again</summary>
        public ulong kept_chunks;
        /// <summary>failed to decode, or did not match their hash</summary>
        public ulong bad_chunks;
        public ulong connections;
        /// <summary>of Views, made here (talus_connect_options.generate)</summary>
        public ulong made_chunks;
        /// <summary>chunks made here that were compared with the server's</summary>
        public ulong proofs;
        /// <summary>and differed</summary>
        public ulong failed_proofs;
        /// <summary>of the world's files, received</summary>
        public ulong file_bytes;

        private static readonly uint Size = (uint)Marshal.SizeOf(typeof(talus_stats));
        /// <summary>With its size; the other fields are 0.</summary>
        public static talus_stats Create() { return new talus_stats { size = Size }; }
    }

    // Event types and their fields. New minor versions may add types: ignore unknown ones.
    /// <summary>The server accepted the client; talus_get_world() is available.</summary>
    public const uint TALUS_EVENT_JOINED = 1;
    /// <summary>A chunk of the View arrived or changed: x, y, z, level, revision, hash, chunk, uniform_material.</summary>
    public const uint TALUS_EVENT_CHUNK = 2;
    /// <summary>A chunk delivered by CHUNK left the View: x, y, z, level.</summary>
    public const uint TALUS_EVENT_CHUNK_LEFT = 3;
    /// <summary>All chunks of the newest View arrived, except any reported by ERROR.</summary>
    public const uint TALUS_EVENT_VIEW_COMPLETE = 4;
    /// <summary>Answer to talus_get_chunk(): request, status, and the fields of CHUNK.</summary>
    public const uint TALUS_EVENT_CHUNK_ANSWER = 5;
    /// <summary>Answer to talus_get_heights() or talus_get_places(): request, status, column_count, heights_fx; looks,
    /// values.</summary>
    public const uint TALUS_EVENT_HEIGHTS = 6;
    /// <summary>Answer to talus_ping(): request, status, round_trip_ns.</summary>
    public const uint TALUS_EVENT_PONG = 7;
    /// <summary>An error that the connection survives, such as a bad chunk or a refused View: status, message.</summary>
    public const uint TALUS_EVENT_ERROR = 8;
    /// <summary>The connection broke, and the client is reconnecting: status, message.</summary>
    public const uint TALUS_EVENT_RECONNECTING = 9;
    /// <summary>Reconnected to the same world. CHUNK follows for all chunks of the View; open requests are sent again.</summary>
    public const uint TALUS_EVENT_RECONNECTED = 10;
    /// <summary>Answer to talus_send_edit(), once the edit is stored or rejected: request, status; revision of the world
    /// after it, changed_voxels.</summary>
    public const uint TALUS_EVENT_EDITED = 12;
    /// <summary>The last event: the connection ended or was never established: status, message.</summary>
    public const uint TALUS_EVENT_CLOSED = 11;

    /// <summary>One event. Fields that its type does not have are 0, NULL, or "" for strings.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct talus_event
    {
        public uint size;
        /// <summary>TALUS_EVENT_...</summary>
        public uint type;
        /// <summary>TALUS_OK or an error</summary>
        public int status;
        /// <summary>the request that this answers</summary>
        public uint request;
        /// <summary>the chunk's coordinates, in chunks of `level`</summary>
        public int x;
        public int y;
        public int z;
        /// <summary>of detail, 0 to 6</summary>
        public uint level;
        /// <summary>of the chunk; 0: as generated; higher is newer</summary>
        public ulong revision;
        /// <summary>XXH3-128 of the voxels as little-endian uint16.</summary>
        public ulong hash_low;
        public ulong hash_high;
        /// <summary>The voxels. NULL in an answer: unchanged since the hash passed as `known`, or an error.</summary>
        public IntPtr chunk;
        /// <summary>one line for humans, if status is an error</summary>
        public IntPtr message;
        /// <summary>The material id of all voxels of the chunk. -1: they differ, or there is no chunk.</summary>
        public int uniform_material;
        /// <summary>delay that the server asks for; 0: no delay</summary>
        public uint retry_after_ms;
        /// <summary>ground at column_count columns, 1/256 voxel above y = 0</summary>
        public IntPtr heights_fx;
        /// <summary>per column, index for talus_look_name(); NULL if not requested</summary>
        public IntPtr looks;
        /// <summary>field_count values per column, in the order of the request</summary>
        public IntPtr values;
        public uint column_count;
        public uint field_count;
        public ulong round_trip_ns;
        /// <summary>by the edit; 0: they already had these materials</summary>
        public uint changed_voxels;
        /// <summary>0</summary>
        public uint reserved;

        private static readonly uint Size = (uint)Marshal.SizeOf(typeof(talus_event));
        /// <summary>With its size; the other fields are 0.</summary>
        public static talus_event Create() { return new talus_event { size = Size }; }
    }

    // ---- The library ----
    /// <summary>TALUS_API_MAJOR &lt;&lt; 16 | TALUS_API_MINOR of the loaded library; its minor version may be higher than the
    /// header's.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern uint talus_api_version();
    /// <summary>The release of Talus that the library was built from: "0.2.0".</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr talus_version();
    /// <summary>"TALUS_REFUSED" for TALUS_REFUSED; "unknown status" for any other value. Valid for ever.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr talus_status_name(int status);

    // ---- Clients ----
    /// <summary>Creates an unconnected client in *client; free it with talus_destroy().</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_create(out IntPtr client);
    /// <summary>Closes the connection and frees the client and everything its last event points to, except retained chunks.
    /// NULL is ignored. May wait for a pending look-up of a host name.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern void talus_destroy(IntPtr client);
    /// <summary>Message of this client's last failed call, in one line; empty if no call failed. Valid until the next
    /// failing call. With NULL: of this thread's last failed call without a client.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr talus_last_error(IntPtr client);
    /// <summary>Begins to connect and returns at once. JOINED or CLOSED reports the result.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_connect(IntPtr client, ref talus_connect_options options);
    /// <summary>Closes the connection. Queued events and open answers are dropped, and CLOSED is not sent. No effect
    /// without a connection. May wait for a pending look-up of a host name.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_disconnect(IntPtr client);
    /// <summary>Stores the next event in *event. Waits at most timeout_ms milliseconds; 0: not at all, negative: without
    /// limit. TALUS_NO_EVENT: no event in time. TALUS_NOT_CONNECTED: no event can come without a connection. All
    /// work is done in here: call it at least every few seconds, each time until it returns TALUS_NO_EVENT.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_poll(IntPtr client, ref talus_event @event, int timeout_ms);

    // ---- The world: available after JOINED ----
    /// <summary>Its pointers, and names, stay valid until talus_poll() returns RECONNECTED, or until talus_connect(),
    /// talus_disconnect() or talus_destroy().</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_get_world(IntPtr client, ref talus_world world);
    /// <summary>`index` below world.material_count.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_get_material(IntPtr client, uint index, ref talus_material material);
    /// <summary>A biome's name; index 0, "", means no biome. `index` below world.look_count; NULL otherwise.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr talus_look_name(IntPtr client, uint index);
    /// <summary>The name of a quantity such as temperature. `index` below world.field_count; NULL otherwise.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern IntPtr talus_field_name(IntPtr client, uint index);

    // ---- Chunks around a player ----
    /// <summary>Replaces the View. Cheap: call it every frame. TALUS_OUT_OF_RANGE keeps the previous View. Requires JOINED;
    /// while reconnecting, the View is kept and sent later.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_set_view(IntPtr client, ref talus_view view);
    /// <summary>Number of chunks of the View, for a progress bar.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_count_view(IntPtr client, ref talus_view view, out ulong chunks);
    /// <summary>Sets ring_radius: rings of levels 1 to 6 from horizontal_radius out to `farthest` base chunks, each wider
    /// than the previous one by the same ratio. Needs no client.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_fill_rings(ref talus_view view, ushort farthest);

    // ---- Requests: each is answered by one event with the number stored in *request, unless NULL ----
    /// <summary>Requests a chunk. `known`: low and high half of the hash of the caller's copy, or NULL. Any number of
    /// requests may be open.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_get_chunk(IntPtr client, int x, int y, int z, uint level, ulong[] known, out uint request);
    /// <summary>Requests the ground at `count` base columns, 1 to world.max_columns. `columns`: 2 * count numbers, x and z
    /// of each.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_get_heights(IntPtr client, long[] columns, UIntPtr count, out uint request);
    /// <summary>Requests heights, the biome of each column, and its values of the named fields: at most 16.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_get_places(IntPtr client, long[] columns, UIntPtr count, IntPtr[] fields, UIntPtr field_count, out uint request);
    /// <summary>Changes voxels. Edits are applied in the order of the calls, each once, however often the connection
    /// breaks; one that the server refuses temporarily is sent again, and may then be applied after later ones.
    /// Changed chunks of the View arrive by CHUNK, before or after EDITED.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_send_edit(IntPtr client, ref talus_edit edit, out uint request);
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_ping(IntPtr client, out uint request);
    /// <summary>Cancels a talus_get_chunk(). It is still answered, with TALUS_CANCELLED, or with the chunk if it was in
    /// flight. No effect on other or answered requests.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_cancel(IntPtr client, uint request);
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_get_stats(IntPtr client, ref talus_stats stats);

    // ---- Voxels: any thread ----
    /// <summary>Writes all voxels of a chunk, index TALUS_VOXEL_INDEX(x, y, z). `count` is TALUS_CHUNK_VOLUME.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_decode(IntPtr chunk, [Out] ushort[] voxels, UIntPtr count);
    /// <summary>Writes all voxels of a chunk, index TALUS_VOXEL_INDEX(x, y, z). `count` is TALUS_CHUNK_VOLUME.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern int talus_decode(IntPtr chunk, IntPtr voxels, UIntPtr count);
    /// <summary>Keeps a chunk beyond its event; release it once per retain. Both ignore NULL.</summary>
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern void talus_chunk_retain(IntPtr chunk);
    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
    public static extern void talus_chunk_release(IntPtr chunk);
}

/// <summary>TALUS_OK and so on; errors are below 0.</summary>
public enum TalusStatus
{
    Ok = 0,
    /// <summary>talus_poll(): no event in time</summary>
    NoEvent = 1,
    /// <summary>NULL, a wrong size or count, an unknown flag, an index beyond a list</summary>
    InvalidArgument = -1,
    /// <summary>the connection is closed</summary>
    OutOfMemory = -2,
    /// <summary>a fault of the library; the connection is closed</summary>
    Internal = -3,
    /// <summary>by this build of the library, or by the server</summary>
    Unsupported = -4,
    /// <summary>call talus_disconnect() first</summary>
    AlreadyConnected = -5,
    /// <summary>more than 2^18 events are queued; poll them first</summary>
    TooManyEvents = -6,
    /// <summary>the name does not resolve, or nothing listens there</summary>
    Unreachable = -16,
    /// <summary>the server rejects this client: version, token, too many connections</summary>
    Refused = -17,
    /// <summary>TLS: the server's certificate was not accepted</summary>
    Untrusted = -18,
    /// <summary>the connection broke, or the server closed it</summary>
    Disconnected = -19,
    /// <summary>no answer in time while connecting, or silence afterwards</summary>
    TimedOut = -20,
    /// <summary>after a reconnect the server had another world</summary>
    WorldChanged = -21,
    /// <summary>the server violated the protocol</summary>
    BrokenProtocol = -22,
    /// <summary>a chunk failed to decode, or does not match its hash</summary>
    BadChunk = -23,
    /// <summary>a coordinate, radius or list exceeds the world's or the server's limits</summary>
    OutOfRange = -24,
    /// <summary>the server asks for a retry after `retry_after_ms`</summary>
    Overloaded = -25,
    /// <summary>talus_cancel() came before the answer</summary>
    Cancelled = -26,
    /// <summary>the server could not answer; a retry may succeed</summary>
    ServerFailed = -27,
    /// <summary>called before JOINED, or after CLOSED or talus_disconnect()</summary>
    NotConnected = -28,
    /// <summary>a guard of the edit does not hold; nothing was applied</summary>
    Conflict = -29,
    /// <summary>the edit was not applied, but a later one was</summary>
    NotApplied = -30,
    /// <summary>The edit was sent and may have been applied: the client gave up before an answer, or the server no longer
    /// knows the editor.</summary>
    OutcomeUnknown = -31,
    /// <summary>chunks cannot be made here (talus_connect_options.generate)</summary>
    CannotGenerate = -32,
}

/// <summary>Flags of a connection.</summary>
[Flags]
public enum TalusConnectFlags
{
    None = 0,
    /// <summary>TLS 1.3; the server's certificate is checked</summary>
    Tls = 1,
    /// <summary>the certificate is not checked: any server is accepted</summary>
    TlsNoVerify = 2,
    /// <summary>ws://host:port/v1/stream; `port` is talusd's HTTP port, or a proxy's</summary>
    Websocket = 4,
}

/// <summary>Phase of a material.</summary>
public enum TalusPhase
{
    Gas = 0,
    Liquid = 1,
    Solid = 2,
}

/// <summary>TALUS_EVENT_JOINED and so on. New minor versions may add types: ignore unknown ones.</summary>
public enum TalusEventType
{
    /// <summary>The server accepted the client; talus_get_world() is available.</summary>
    Joined = 1,
    /// <summary>A chunk of the View arrived or changed: x, y, z, level, revision, hash, chunk, uniform_material.</summary>
    Chunk = 2,
    /// <summary>A chunk delivered by CHUNK left the View: x, y, z, level.</summary>
    ChunkLeft = 3,
    /// <summary>All chunks of the newest View arrived, except any reported by ERROR.</summary>
    ViewComplete = 4,
    /// <summary>Answer to talus_get_chunk(): request, status, and the fields of CHUNK.</summary>
    ChunkAnswer = 5,
    /// <summary>Answer to talus_get_heights() or talus_get_places(): request, status, column_count, heights_fx; looks,
    /// values.</summary>
    Heights = 6,
    /// <summary>Answer to talus_ping(): request, status, round_trip_ns.</summary>
    Pong = 7,
    /// <summary>An error that the connection survives, such as a bad chunk or a refused View: status, message.</summary>
    Error = 8,
    /// <summary>The connection broke, and the client is reconnecting: status, message.</summary>
    Reconnecting = 9,
    /// <summary>Reconnected to the same world. CHUNK follows for all chunks of the View; open requests are sent again.</summary>
    Reconnected = 10,
    /// <summary>Answer to talus_send_edit(), once the edit is stored or rejected: request, status; revision of the world
    /// after it, changed_voxels.</summary>
    Edited = 12,
    /// <summary>The last event: the connection ended or was never established: status, message.</summary>
    Closed = 11,
}
