/* libtalus: the Talus client library for C, and for every language that calls C.
 *
 *   talus_client* client;
 *   talus_create(&client);
 *   talus_connect_options options = {.size = sizeof options, .host = "localhost"};
 *   talus_connect(client, &options);
 *   talus_event event = {.size = sizeof event};
 *   while (talus_poll(client, &event, 1000) == TALUS_OK) ...        (examples/fly.c is a whole program)
 *   talus_destroy(client);
 *
 * Space. Axes are x east, y up, z south. The unit of length is the base voxel. A chunk is 32 x 32 x 32 voxels
 * of one level of detail, 0 to 6; a voxel of level l spans 2^l base voxels along each axis. Chunk coordinates
 * count chunks of their level. Base voxel v lies in base chunk floor(v / 32). Dense voxels are uint16_t
 * material ids, index (y * 32 + z) * 32 + x. Heights are in 1/256 base voxel above y = 0.
 *
 * Structs. Each begins with `size`, which the caller sets to sizeof the struct before every call. Fields are
 * only ever appended. The library takes shorter structs of older programs, and longer ones of newer programs
 * if the bytes that it does not know are 0. So set every unused field to 0, its default.
 *
 * Errors. A function that fails returns a negative status, changes nothing unless it says otherwise, and
 * leaves a one-line message in talus_last_error(). No C++ exception leaves the library. After
 * TALUS_OUT_OF_MEMORY and TALUS_INTERNAL the connection is closed, without a CLOSED event; the client may
 * connect again. If not even 512 bytes can be allocated, the library may abort().
 *
 * Threads. A client may be used by one thread at a time, not always the same. Different clients are
 * independent. Chunks are immutable: any thread may decode, retain and release them. The library makes no
 * callbacks, and does network work only inside talus_poll(), except the look-up of host names, which runs in
 * its own thread. With `generate` other threads make chunks.
 *
 * Ownership. Functions copy their arguments before they return. Pointers in an event stay valid until the
 * next talus_poll(), talus_connect() or talus_destroy() of its client; talus_chunk_retain() keeps a chunk
 * longer. Strings are UTF-8 with a terminating zero. The library never returns NULL strings; it takes NULL as
 * the empty string.
 *
 * Tested on Linux on x86-64, on aarch64 and s390x in qemu, and for Windows in Wine. */
#ifndef TALUS_H
#define TALUS_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(TALUS_BUILDS_LIBRARY)
#define TALUS_API __declspec(dllexport)
#elif defined(_WIN32)
#define TALUS_API __declspec(dllimport)
#else
#define TALUS_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this interface. A new minor version only adds; a new major version is another library,
 * libtalus.so.MAJOR. */
#define TALUS_API_MAJOR 1
#define TALUS_API_MINOR 0

#define TALUS_CHUNK_SIZE 32                                    /* voxels along each edge */
#define TALUS_CHUNK_VOLUME 32768                               /* voxels */
#define TALUS_VOXEL_INDEX(x, y, z) (((y)*32 + (z)) * 32 + (x)) /* each 0 to 31, inside the chunk */
#define TALUS_DEFAULT_PORT 4780

typedef int32_t talus_status;
enum {
  TALUS_OK = 0,
  TALUS_NO_EVENT = 1, /* talus_poll(): no event in time */
  /* Errors of the call: */
  TALUS_INVALID_ARGUMENT = -1,  /* NULL, a wrong size or count, an unknown flag, an index beyond a list */
  TALUS_OUT_OF_MEMORY = -2,     /* the connection is closed */
  TALUS_INTERNAL = -3,          /* a fault of the library; the connection is closed */
  TALUS_UNSUPPORTED = -4,       /* by this build of the library, or by the server */
  TALUS_ALREADY_CONNECTED = -5, /* call talus_disconnect() first */
  TALUS_TOO_MANY_EVENTS = -6,   /* more than 2^18 events are queued; poll them first */
  /* Errors of the connection and the server: */
  TALUS_UNREACHABLE = -16,     /* the name does not resolve, or nothing listens there */
  TALUS_REFUSED = -17,         /* the server rejects this client: version, token, too many connections */
  TALUS_UNTRUSTED = -18,       /* TLS: the server's certificate was not accepted */
  TALUS_DISCONNECTED = -19,    /* the connection broke, or the server closed it */
  TALUS_TIMED_OUT = -20,       /* no answer in time while connecting, or silence afterwards */
  TALUS_WORLD_CHANGED = -21,   /* after a reconnect the server had another world */
  TALUS_BROKEN_PROTOCOL = -22, /* the server violated the protocol */
  TALUS_BAD_CHUNK = -23,       /* a chunk failed to decode, or does not match its hash */
  TALUS_OUT_OF_RANGE = -24,    /* a coordinate, radius or list exceeds the world's or the server's limits */
  TALUS_OVERLOADED = -25,      /* the server asks for a retry after `retry_after_ms` */
  TALUS_CANCELLED = -26,       /* talus_cancel() came before the answer */
  TALUS_SERVER_FAILED = -27,   /* the server could not answer; a retry may succeed */
  TALUS_NOT_CONNECTED = -28,   /* called before JOINED, or after CLOSED or talus_disconnect() */
  TALUS_CONFLICT = -29,        /* a guard of the edit does not hold; nothing was applied */
  TALUS_NOT_APPLIED = -30,     /* the edit was not applied, but a later one was */
  /* The edit was sent and may have been applied: the client gave up before an answer, or the server no longer
   * knows the editor. */
  TALUS_OUTCOME_UNKNOWN = -31,
  TALUS_CANNOT_GENERATE = -32 /* chunks cannot be made here (talus_connect_options.generate) */
};

/* One client, its connection, and its queued events. */
typedef struct talus_client talus_client;

/* A chunk's immutable voxels, reference-counted by talus_chunk_retain() and talus_chunk_release(). */
typedef struct talus_chunk talus_chunk;

/* Options of a connection. The number 0 means the default. */
typedef struct talus_connect_options {
  uint32_t size;
  uint32_t flags;              /* TALUS_TLS, TALUS_TLS_NO_VERIFY, TALUS_WEBSOCKET */
  const char* host;            /* a name or an address; not empty */
  const char* token;           /* issued by the server's operator; empty: no token */
  const char* client_name;     /* for the server's log; empty: "libtalus" */
  const char* tls_ca_file;     /* PEM file of trusted certificates; empty: the system's */
  const char* tls_server_name; /* name that the certificate must have; empty: `host` */
  uint64_t window_bytes;       /* maximum chunk bytes in flight; default 1 MiB */
  /* Maximum bytes of decoded chunks kept after they left the View while the game retained them: if they
   * return unchanged, they are not sent again. Default 32 MiB. */
  uint64_t keep_bytes;
  uint32_t port;                     /* default TALUS_DEFAULT_PORT */
  uint32_t connect_timeout_ms;       /* name lookup, TCP and TLS; default 5,000 */
  uint32_t handshake_timeout_ms;     /* from there to JOINED; default 5,000 */
  uint32_t ping_interval_ms;         /* maximum; default 20,000 */
  uint32_t silence_timeout_ms;       /* without a byte from the server it counts as lost; default 60,000 */
  uint32_t reconnect_attempts;       /* consecutive failures until it gives up; 0: never reconnects */
  uint32_t reconnect_first_delay_ms; /* doubles with each failure; delays are random below; default 500 */
  uint32_t reconnect_max_delay_ms;   /* default 10,000 */
  /* "HOST:PORT,HOST:PORT": other servers of the same world, may be empty. If one cannot be reached, goes away
   * or disconnects, the next is tried, then around again. */
  const char* more_servers;
  /* TALUS_GENERATE_AUTO makes a published world's chunks here and receives only edits. Events are the same.
   * Chunks of talus_get_chunk() still come from the server. */
  uint32_t generate;
  uint32_t generate_threads; /* default: one less than the machine's processors */
} talus_connect_options;

/* Before the world is open, chunks are received. Some chunks are compared with the server's. If one differs,
 * or the world cannot be made by this library, AUTO receives chunks from then on, again those made here, and
 * ERROR says why, by TALUS_CANNOT_GENERATE; ALWAYS ends by CLOSED. */
enum { TALUS_GENERATE_NEVER = 0, TALUS_GENERATE_AUTO = 1, TALUS_GENERATE_ALWAYS = 2 };

enum {
  TALUS_TLS = 1,           /* TLS 1.3; the server's certificate is checked */
  TALUS_TLS_NO_VERIFY = 2, /* the certificate is not checked: any server is accepted */
  TALUS_WEBSOCKET = 4      /* ws://host:port/v1/stream; `port` is talusd's HTTP port, or a proxy's */
};

/* The chunks that a player wants around it: level 0 within the radii, coarser levels farther out. */
typedef struct talus_view {
  uint32_t size;
  uint32_t flags;                              /* TALUS_VIEW_HORIZON */
  int64_t centre_x, centre_y, centre_z;        /* base voxels */
  float direction_x, direction_y, direction_z; /* of sight, any length; 0: no preference */
  uint16_t horizontal_radius;                  /* base chunks; 0: the centre's column alone */
  uint16_t vertical_radius;                    /* base chunks */
  /* Levels 1 to 6, in base chunks, each wider than the finer ones; 0: no ring of this level. */
  uint16_t ring_radius[6];
  uint32_t reserved; /* 0 */
} talus_view;

/* Flag of talus_view: rings include every row in which ground can lie. Requires talus_world.has_horizon. */
enum { TALUS_VIEW_HORIZON = 1 };

/* The server's description of its world. */
typedef struct talus_world {
  uint32_t size;
  uint32_t material_count;                    /* talus_get_material() */
  uint64_t fingerprint_low, fingerprint_high; /* equal fingerprints: equal voxels everywhere */
  uint64_t store_low, store_high;             /* revisions of one store are comparable */
  int64_t min_y, max_y;                       /* as generated: one rock below min_y, air from max_y up */
  int64_t spawn_x, spawn_y, spawn_z; /* base voxel of the feet: the first free one above dry ground */
  const char* server;                /* its name and version */
  uint32_t look_count, field_count;  /* talus_look_name(), talus_field_name() */
  uint32_t max_horizontal_radius;    /* of a View, base chunks; 2^l times as many for a ring of level l */
  uint32_t max_vertical_radius;      /* base chunks */
  uint32_t max_view_chunks;          /* of all levels in one View */
  uint32_t max_columns;              /* in one talus_get_heights() */
  uint32_t has_horizon;              /* 1: Views may have TALUS_VIEW_HORIZON */
  uint32_t reserved;                 /* 0 */
} talus_world;

typedef struct talus_material {
  uint32_t size;
  uint32_t id;      /* as in voxels; 0 is air, 1 water */
  uint32_t colour;  /* 0xRRGGBB, sRGB */
  uint32_t phase;   /* TALUS_GAS, TALUS_LIQUID, TALUS_SOLID */
  const char* name; /* valid as long as the world's pointers: see talus_get_world() */
} talus_material;

enum { TALUS_GAS = 0, TALUS_LIQUID = 1, TALUS_SOLID = 2 };

/* An edit. If all guards hold, writes, fills and the paste are applied in this order, each on the result of
 * the previous ones; the edit is applied completely or not at all. Voxels are base voxels, stored as x, y, z
 * of the first, then of the next. */
typedef struct talus_edit {
  uint32_t size;
  uint32_t flags;              /* TALUS_PASTE_AIR */
  const int64_t* guard_voxels; /* guard_count voxels that must have guard_materials */
  const uint16_t* guard_materials;
  const int64_t* write_voxels; /* write_count voxels that get write_materials */
  const uint16_t* write_materials;
  const int64_t* fill_corners;   /* fill_count boxes: lowest corner, then highest; both included */
  const int32_t* fill_materials; /* TALUS_AS_GENERATED undoes edits */
  const int32_t* fill_only;      /* fills only this material; TALUS_ANY: any; NULL: TALUS_ANY for all */
  const uint16_t* paste_voxels; /* TALUS_CHUNK_VOLUME ids, index TALUS_VOXEL_INDEX(x, y, z); NULL: no paste */
  int64_t paste_x, paste_y, paste_z; /* target of the paste's voxel (0, 0, 0) */
  /* Player for whom a game server with the right "gateway" edits; empty: the token's own subject. */
  const char* subject;
  uint32_t guard_count, write_count, fill_count;
  uint32_t reserved; /* 0 */
} talus_edit;

enum { TALUS_PASTE_AIR = 1 /* the paste's air is written too; otherwise it is skipped */ };
enum { TALUS_AS_GENERATED = -1, TALUS_ANY = -1 };

/* Running totals since talus_connect(). */
typedef struct talus_stats {
  uint32_t size;
  uint32_t reserved;       /* 0 */
  uint64_t received_bytes; /* everything the server sent */
  uint64_t sent_bytes;
  uint64_t chunk_frames;
  uint64_t chunk_bytes;    /* of chunk frames */
  uint64_t uniform_chunks; /* received as whole columns */
  uint64_t kept_chunks;    /* of a View, already held and not sent again */
  uint64_t bad_chunks;     /* failed to decode, or did not match their hash */
  uint64_t connections;
  uint64_t made_chunks;   /* of Views, made here (talus_connect_options.generate) */
  uint64_t proofs;        /* chunks made here that were compared with the server's */
  uint64_t failed_proofs; /* and differed */
  uint64_t file_bytes;    /* of the world's files, received */
} talus_stats;

/* Event types and their fields. New minor versions may add types: ignore unknown ones. */
enum {
  /* The server accepted the client; talus_get_world() is available. */
  TALUS_EVENT_JOINED = 1,
  /* A chunk of the View arrived or changed: x, y, z, level, revision, hash, chunk, uniform_material. */
  TALUS_EVENT_CHUNK = 2,
  /* A chunk delivered by CHUNK left the View: x, y, z, level. */
  TALUS_EVENT_CHUNK_LEFT = 3,
  /* All chunks of the newest View arrived, except any reported by ERROR. */
  TALUS_EVENT_VIEW_COMPLETE = 4,
  /* Answer to talus_get_chunk(): request, status, and the fields of CHUNK. */
  TALUS_EVENT_CHUNK_ANSWER = 5,
  /* Answer to talus_get_heights() or talus_get_places(): request, status, column_count, heights_fx; looks,
   * values. */
  TALUS_EVENT_HEIGHTS = 6,
  /* Answer to talus_ping(): request, status, round_trip_ns. */
  TALUS_EVENT_PONG = 7,
  /* An error that the connection survives, such as a bad chunk or a refused View: status, message. */
  TALUS_EVENT_ERROR = 8,
  /* The connection broke, and the client is reconnecting: status, message. */
  TALUS_EVENT_RECONNECTING = 9,
  /* Reconnected to the same world. CHUNK follows for all chunks of the View; open requests are sent again. */
  TALUS_EVENT_RECONNECTED = 10,
  /* Answer to talus_send_edit(), once the edit is stored or rejected: request, status; revision of the world
   * after it, changed_voxels. */
  TALUS_EVENT_EDITED = 12,
  /* The last event: the connection ended or was never established: status, message. */
  TALUS_EVENT_CLOSED = 11
};

/* One event. Fields that its type does not have are 0, NULL, or "" for strings. */
typedef struct talus_event {
  uint32_t size;
  uint32_t type;       /* TALUS_EVENT_... */
  talus_status status; /* TALUS_OK or an error */
  uint32_t request;    /* the request that this answers */
  int32_t x, y, z;     /* the chunk's coordinates, in chunks of `level` */
  uint32_t level;      /* of detail, 0 to 6 */
  uint64_t revision;   /* of the chunk; 0: as generated; higher is newer */
  /* XXH3-128 of the voxels as little-endian uint16. */
  uint64_t hash_low, hash_high;
  /* The voxels. NULL in an answer: unchanged since the hash passed as `known`, or an error. */
  const talus_chunk* chunk;
  const char* message; /* one line for humans, if status is an error */
  /* The material id of all voxels of the chunk. -1: they differ, or there is no chunk. */
  int32_t uniform_material;
  uint32_t retry_after_ms;   /* delay that the server asks for; 0: no delay */
  const int32_t* heights_fx; /* ground at column_count columns, 1/256 voxel above y = 0 */
  const uint8_t* looks;      /* per column, index for talus_look_name(); NULL if not requested */
  const float* values;       /* field_count values per column, in the order of the request */
  uint32_t column_count;
  uint32_t field_count;
  uint64_t round_trip_ns;
  uint32_t changed_voxels; /* by the edit; 0: they already had these materials */
  uint32_t reserved;       /* 0 */
} talus_event;

/* ---- The library ---- */

/* TALUS_API_MAJOR << 16 | TALUS_API_MINOR of the loaded library; its minor version may be higher than the
 * header's. */
TALUS_API uint32_t talus_api_version(void);
/* The release of Talus that the library was built from: "0.2.0". */
TALUS_API const char* talus_version(void);
/* "TALUS_REFUSED" for TALUS_REFUSED; "unknown status" for any other value. Valid for ever. */
TALUS_API const char* talus_status_name(talus_status status);

/* ---- Clients ---- */

/* Creates an unconnected client in *client; free it with talus_destroy(). */
TALUS_API talus_status talus_create(talus_client** client);
/* Closes the connection and frees the client and everything its last event points to, except retained chunks.
 * NULL is ignored. May wait for a pending look-up of a host name. */
TALUS_API void talus_destroy(talus_client* client);

/* Message of this client's last failed call, in one line; empty if no call failed. Valid until the next
 * failing call. With NULL: of this thread's last failed call without a client. */
TALUS_API const char* talus_last_error(const talus_client* client);

/* Begins to connect and returns at once. JOINED or CLOSED reports the result. */
TALUS_API talus_status talus_connect(talus_client* client, const talus_connect_options* options);
/* Closes the connection. Queued events and open answers are dropped, and CLOSED is not sent. No effect
 * without a connection. May wait for a pending look-up of a host name. */
TALUS_API talus_status talus_disconnect(talus_client* client);

/* Stores the next event in *event. Waits at most timeout_ms milliseconds; 0: not at all, negative: without
 * limit. TALUS_NO_EVENT: no event in time. TALUS_NOT_CONNECTED: no event can come without a connection. All
 * work is done in here: call it at least every few seconds, each time until it returns TALUS_NO_EVENT. */
TALUS_API talus_status talus_poll(talus_client* client, talus_event* event, int32_t timeout_ms);

/* ---- The world: available after JOINED ---- */

/* Its pointers, and names, stay valid until talus_poll() returns RECONNECTED, or until talus_connect(),
 * talus_disconnect() or talus_destroy(). */
TALUS_API talus_status talus_get_world(talus_client* client, talus_world* world);
/* `index` below world.material_count. */
TALUS_API talus_status talus_get_material(talus_client* client, uint32_t index, talus_material* material);
/* A biome's name; index 0, "", means no biome. `index` below world.look_count; NULL otherwise. */
TALUS_API const char* talus_look_name(talus_client* client, uint32_t index);
/* The name of a quantity such as temperature. `index` below world.field_count; NULL otherwise. */
TALUS_API const char* talus_field_name(talus_client* client, uint32_t index);

/* ---- Chunks around a player ---- */

/* Replaces the View. Cheap: call it every frame. TALUS_OUT_OF_RANGE keeps the previous View. Requires JOINED;
 * while reconnecting, the View is kept and sent later. */
TALUS_API talus_status talus_set_view(talus_client* client, const talus_view* view);
/* Number of chunks of the View, for a progress bar. */
TALUS_API talus_status talus_count_view(talus_client* client, const talus_view* view, uint64_t* chunks);
/* Sets ring_radius: rings of levels 1 to 6 from horizontal_radius out to `farthest` base chunks, each wider
 * than the previous one by the same ratio. Needs no client. */
TALUS_API talus_status talus_fill_rings(talus_view* view, uint16_t farthest);

/* ---- Requests: each is answered by one event with the number stored in *request, unless NULL ---- */

/* Requests a chunk. `known`: low and high half of the hash of the caller's copy, or NULL. Any number of
 * requests may be open. */
TALUS_API talus_status talus_get_chunk(talus_client* client, int32_t x, int32_t y, int32_t z, uint32_t level,
                                       const uint64_t known[2], uint32_t* request);
/* Requests the ground at `count` base columns, 1 to world.max_columns. `columns`: 2 * count numbers, x and z
 * of each. */
TALUS_API talus_status talus_get_heights(talus_client* client, const int64_t* columns, size_t count,
                                         uint32_t* request);
/* Requests heights, the biome of each column, and its values of the named fields: at most 16. */
TALUS_API talus_status talus_get_places(talus_client* client, const int64_t* columns, size_t count,
                                        const char* const* fields, size_t field_count, uint32_t* request);
/* Changes voxels. Edits are applied in the order of the calls, each once, however often the connection
 * breaks; one that the server refuses temporarily is sent again, and may then be applied after later ones.
 * Changed chunks of the View arrive by CHUNK, before or after EDITED. */
TALUS_API talus_status talus_send_edit(talus_client* client, const talus_edit* edit, uint32_t* request);
TALUS_API talus_status talus_ping(talus_client* client, uint32_t* request);
/* Cancels a talus_get_chunk(). It is still answered, with TALUS_CANCELLED, or with the chunk if it was in
 * flight. No effect on other or answered requests. */
TALUS_API talus_status talus_cancel(talus_client* client, uint32_t request);

TALUS_API talus_status talus_get_stats(talus_client* client, talus_stats* stats);

/* ---- Voxels: any thread ---- */

/* Writes all voxels of a chunk, index TALUS_VOXEL_INDEX(x, y, z). `count` is TALUS_CHUNK_VOLUME. */
TALUS_API talus_status talus_decode(const talus_chunk* chunk, uint16_t* voxels, size_t count);
/* Keeps a chunk beyond its event; release it once per retain. Both ignore NULL. */
TALUS_API void talus_chunk_retain(const talus_chunk* chunk);
TALUS_API void talus_chunk_release(const talus_chunk* chunk);

#ifdef __cplusplus
}
#endif

#endif
