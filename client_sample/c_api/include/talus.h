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
 * where the bytes that it does not know are 0. So set all fields that you do not use to 0; that is their
 * default.
 *
 * Errors. A function that fails returns a negative status, changes nothing unless it says otherwise, and
 * leaves a line for people in talus_last_error(). No C++ exception leaves the library. After
 * TALUS_OUT_OF_MEMORY and TALUS_INTERNAL the connection is closed, without a CLOSED event; the client may
 * connect again. Where memory is so short that not even 512 bytes are to be had, the library may abort().
 *
 * Threads. A client is for one thread at a time; which one may change. Different clients do not know each
 * other. Chunks are immutable: any thread may decode, retain and release them. The library calls nothing
 * back, and works for the network only inside talus_poll(), but for the look-up of host names: that runs in a
 * thread of its own.
 *
 * Ownership. What is given to a function is copied before it returns. Pointers in an event stay valid until
 * the next talus_poll(), talus_connect() or talus_destroy() of its client; talus_chunk_retain() keeps a chunk
 * for longer. Texts are UTF-8, end in a zero byte and are never NULL where the library gives them; where it
 * takes them, NULL is the empty text.
 *
 * Tested on Linux on x86-64. */
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

/* The version of this interface. A new minor version only adds; a new major version is another library,
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
  TALUS_NO_EVENT = 1, /* talus_poll(): none came in time */
  /* The call: */
  TALUS_INVALID_ARGUMENT = -1,  /* NULL, a wrong size or count, an unknown flag, an index beyond a list */
  TALUS_OUT_OF_MEMORY = -2,     /* the connection is closed */
  TALUS_INTERNAL = -3,          /* a fault of the library; the connection is closed */
  TALUS_UNSUPPORTED = -4,       /* this build of the library, or the server, does not have it */
  TALUS_ALREADY_CONNECTED = -5, /* talus_disconnect() comes first */
  TALUS_TOO_MANY_EVENTS = -6,   /* more than 2^18 events wait; poll them first */
  /* The connection and the server: */
  TALUS_UNREACHABLE = -16,   /* the name does not resolve, or nobody answers there */
  TALUS_REFUSED = -17,       /* the server will not have this client: version, token, too many connections */
  TALUS_UNTRUSTED = -18,     /* by TLS: the server could not prove that it is who it should be */
  TALUS_DISCONNECTED = -19,  /* the connection broke, or the server closed it */
  TALUS_TIMED_OUT = -20,     /* no answer in time while connecting, or silence afterwards */
  TALUS_WORLD_CHANGED = -21, /* a reconnect met a server with another world */
  TALUS_BROKEN_PROTOCOL = -22, /* the server sent what the protocol does not allow */
  TALUS_BAD_CHUNK = -23,       /* a chunk that does not decode, or is not what its hash says */
  TALUS_OUT_OF_RANGE = -24,    /* a coordinate, radius or list beyond the world's or the server's limits */
  TALUS_OVERLOADED = -25,      /* the server asks to come back after `retry_after_ms` */
  TALUS_CANCELLED = -26,       /* talus_cancel() was faster than the answer */
  TALUS_SERVER_FAILED = -27,   /* the server could not answer; repeating may help */
  TALUS_NOT_CONNECTED = -28,   /* asked before JOINED, or after CLOSED or talus_disconnect() */
  TALUS_CONFLICT = -29,        /* a guard of the edit does not hold; nothing happened */
  TALUS_NOT_APPLIED = -30,     /* the edit did not happen, and a later one did */
  /* The edit was sent and may have happened: the client gave up before an answer came, or the server has
   * forgotten who sent it. */
  TALUS_OUTCOME_UNKNOWN = -31
};

/* One client, its connection, and the events that wait to be polled. */
typedef struct talus_client talus_client;

/* A chunk's voxels, immutable, counted by talus_chunk_retain() and talus_chunk_release(). */
typedef struct talus_chunk talus_chunk;

/* How to connect. Numbers that are 0 stand for the default. */
typedef struct talus_connect_options {
  uint32_t size;
  uint32_t flags;              /* TALUS_TLS, TALUS_TLS_NO_VERIFY, TALUS_WEBSOCKET */
  const char* host;            /* a name or an address; not empty */
  const char* token;           /* what the server's operator gave out; empty: none */
  const char* client_name;     /* for the server's log; empty: "libtalus" */
  const char* tls_ca_file;     /* PEM: certificates to trust; empty: those that the system trusts */
  const char* tls_server_name; /* that the certificate must be for; empty: `host` */
  uint64_t window_bytes;       /* chunk bytes in flight at most; default 1 MiB */
  /* Of decoded chunks that left the View while the game retained them: where they come back the same, the
   * server only says so. Default 32 MiB. */
  uint64_t keep_bytes;
  uint32_t port;                     /* default TALUS_DEFAULT_PORT */
  uint32_t connect_timeout_ms;       /* resolving, connecting, and TLS; default 5,000 */
  uint32_t handshake_timeout_ms;     /* from there to JOINED; default 5,000 */
  uint32_t ping_interval_ms;         /* at most; default 20,000 */
  uint32_t silence_timeout_ms;       /* no byte from the server for this long: it is gone; default 60,000 */
  uint32_t reconnect_attempts;       /* failures in a row before it gives up; 0: never reconnects */
  uint32_t reconnect_first_delay_ms; /* doubles from failure to failure, each cut at random; default 500 */
  uint32_t reconnect_max_delay_ms;   /* default 10,000 */
  /* "HOST:PORT,HOST:PORT": other servers of the same world; empty: none. Where one cannot be reached, goes
   * away or breaks off, the next is tried, and around again. */
  const char* more_servers;
} talus_connect_options;

enum {
  TALUS_TLS = 1,           /* encrypted, by TLS 1.3, and the server proves who it is */
  TALUS_TLS_NO_VERIFY = 2, /* anybody may pose as the server */
  TALUS_WEBSOCKET = 4      /* in ws://host:port/v1/stream: `port` is talusd's for HTTP, or a proxy's */
};

/* What a player wants around it: all chunks of level 0 within the radii, and coarser ones farther out. */
typedef struct talus_view {
  uint32_t size;
  uint32_t flags;                              /* TALUS_VIEW_HORIZON */
  int64_t centre_x, centre_y, centre_z;        /* base voxels */
  float direction_x, direction_y, direction_z; /* looked along; of any length; 0: no preference */
  uint16_t horizontal_radius;                  /* base chunks; 0: the centre's column alone */
  uint16_t vertical_radius;                    /* base chunks */
  /* Of level 1, 2, ... 6 in base chunks, each wider than the finer ones; 0: no ring of this level. */
  uint16_t ring_radius[6];
  uint32_t reserved; /* 0 */
} talus_view;

/* Of talus_view.flags: the rings have all rows that ground can lie in. Only where talus_world.has_horizon. */
enum { TALUS_VIEW_HORIZON = 1 };

/* What the server told about its world. */
typedef struct talus_world {
  uint32_t size;
  uint32_t material_count;                    /* talus_get_material() */
  uint64_t fingerprint_low, fingerprint_high; /* worlds of one fingerprint have equal voxels everywhere */
  uint64_t store_low, store_high;             /* revisions of one store may be compared */
  int64_t min_y, max_y;              /* as generated: below min_y all is one rock, from max_y on air */
  int64_t spawn_x, spawn_y, spawn_z; /* base voxel: feet, the first free one above dry ground */
  const char* server;                /* its name and version */
  uint32_t look_count, field_count;  /* talus_look_name(), talus_field_name() */
  uint32_t max_horizontal_radius;    /* of a View, base chunks; of a ring of level l, 2^l times as many */
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
  const char* name; /* valid as long as the world is: talus_get_world() */
} talus_material;

enum { TALUS_GAS = 0, TALUS_LIQUID = 1, TALUS_SOLID = 2 };

/* What shall change: where all guards hold, writes, fills and the paste are done in this order, each on what
 * those before it left. It happens whole or not at all. Voxels are base voxels: x, y and z of each, one after
 * another. */
typedef struct talus_edit {
  uint32_t size;
  uint32_t flags;              /* TALUS_PASTE_AIR */
  const int64_t* guard_voxels; /* of guard_count voxels, which must be of guard_materials */
  const uint16_t* guard_materials;
  const int64_t* write_voxels; /* of write_count voxels, which become of write_materials */
  const uint16_t* write_materials;
  const int64_t* fill_corners;   /* of fill_count boxes: the lowest corner, then the highest; both included */
  const int32_t* fill_materials; /* TALUS_AS_GENERATED undoes edits */
  const int32_t* fill_only; /* voxels of other materials stay; TALUS_ANY: of any; NULL: TALUS_ANY for all */
  const uint16_t* paste_voxels; /* TALUS_CHUNK_VOLUME ids, index TALUS_VOXEL_INDEX(x, y, z); NULL: no paste */
  int64_t paste_x, paste_y, paste_z; /* voxel (0, 0, 0) of the paste comes there */
  /* For whom a game server edits, whose token has the right "gateway"; empty: for the token's own subject. */
  const char* subject;
  uint32_t guard_count, write_count, fill_count;
  uint32_t reserved; /* 0 */
} talus_edit;

enum { TALUS_PASTE_AIR = 1 /* the paste's air is written too; else it leaves what is there */ };
enum { TALUS_AS_GENERATED = -1, TALUS_ANY = -1 };

/* Running totals since talus_connect(). */
typedef struct talus_stats {
  uint32_t size;
  uint32_t reserved;       /* 0 */
  uint64_t received_bytes; /* everything the server sent */
  uint64_t sent_bytes;
  uint64_t chunk_frames;
  uint64_t chunk_bytes;    /* of chunk frames */
  uint64_t uniform_chunks; /* that came in whole columns */
  uint64_t kept_chunks;    /* of a View, held since before and not sent again */
  uint64_t bad_chunks;     /* that did not decode, or did not match their hash */
  uint64_t connections;
} talus_stats;

/* The kinds of event, and the fields that each has. New kinds may come with new minor versions: pass over
 * those that you do not know. */
enum {
  /* The server has let the client in: talus_get_world(). */
  TALUS_EVENT_JOINED = 1,
  /* A chunk of the View has come, or has changed: x, y, z, level, revision, hash, chunk, uniform_material. */
  TALUS_EVENT_CHUNK = 2,
  /* A chunk that CHUNK brought is no longer in the View: x, y, z, level. */
  TALUS_EVENT_CHUNK_LEFT = 3,
  /* All chunks of the newest View have come, but for those of which ERROR told. */
  TALUS_EVENT_VIEW_COMPLETE = 4,
  /* To talus_get_chunk(): request, status, and as CHUNK. */
  TALUS_EVENT_CHUNK_ANSWER = 5,
  /* To talus_get_heights() and talus_get_places(): request, status, column_count, heights_fx; looks, values.
   */
  TALUS_EVENT_HEIGHTS = 6,
  /* To talus_ping(): request, status, round_trip_ns. */
  TALUS_EVENT_PONG = 7,
  /* The connection survives it; a chunk that was bad, a View that was refused: status, message. */
  TALUS_EVENT_ERROR = 8,
  /* The connection broke, and the client tries to come back: status, message. */
  TALUS_EVENT_RECONNECTING = 9,
  /* To the same world. CHUNK comes again for all chunks of the View; open requests are asked again. */
  TALUS_EVENT_RECONNECTED = 10,
  /* To talus_send_edit(), when it is stored or did not happen: request, status; revision of the world after
   * it, changed_voxels. */
  TALUS_EVENT_EDITED = 12,
  /* The last event: why the connection is over, or never began: status, message. */
  TALUS_EVENT_CLOSED = 11
};

/* One thing that happened. Fields that its kind does not have are 0, NULL, or "" for texts. */
typedef struct talus_event {
  uint32_t size;
  uint32_t type;       /* TALUS_EVENT_... */
  talus_status status; /* TALUS_OK, or what went wrong */
  uint32_t request;    /* which request this answers */
  int32_t x, y, z;     /* the chunk's coordinates, in chunks of `level` */
  uint32_t level;      /* of detail, 0 to 6 */
  uint64_t revision;   /* of the chunk; 0: as generated; a higher one is newer */
  /* Of the voxels as little-endian uint16: XXH3-128. */
  uint64_t hash_low, hash_high;
  /* The voxels. NULL in an answer: unchanged since the hash that was given as known, or an error. */
  const talus_chunk* chunk;
  const char* message; /* one line for people, where status is an error */
  /* The id that all voxels of the chunk have. -1: they differ, or there is no chunk. */
  int32_t uniform_material;
  uint32_t retry_after_ms;   /* the server asks for this wait; 0: for none */
  const int32_t* heights_fx; /* of column_count columns: the ground, 1/256 voxel above y = 0 */
  const uint8_t* looks;      /* of each column: index for talus_look_name(); NULL where not asked for */
  const float* values;       /* of each column those of field_count fields, in the order of the request */
  uint32_t column_count;
  uint32_t field_count;
  uint64_t round_trip_ns;
  uint32_t changed_voxels; /* by the edit; 0: all was so before */
  uint32_t reserved;       /* 0 */
} talus_event;

/* ---- The library ---- */

/* TALUS_API_MAJOR << 16 | TALUS_API_MINOR of the library that runs; its minor version may be higher than the
 * header's. */
TALUS_API uint32_t talus_api_version(void);
/* The release of Talus that the library was built from: "0.2.0". */
TALUS_API const char* talus_version(void);
/* "TALUS_REFUSED" for TALUS_REFUSED; "unknown status" for what is none. Lives forever. */
TALUS_API const char* talus_status_name(talus_status status);

/* ---- Clients ---- */

/* A client that is not connected, in *client; destroy it by talus_destroy(). */
TALUS_API talus_status talus_create(talus_client** client);
/* Closes the connection and frees the client and what its last event points to, but for retained chunks. NULL
 * is fine. May wait for the look-up of a host name that is under way. */
TALUS_API void talus_destroy(talus_client* client);

/* Why the last call that failed for this client did, in one line; empty where none has. Valid until the next
 * call that fails. With NULL: of the last call in this thread that failed without a client. */
TALUS_API const char* talus_last_error(const talus_client* client);

/* Begins to connect and returns at once. JOINED or CLOSED tells how it went. */
TALUS_API talus_status talus_connect(talus_client* client, const talus_connect_options* options);
/* Closes the connection. Events that wait, and answers that are open, never come; nor does CLOSED. Fine where
 * there is no connection. May wait for the look-up of a host name that is under way. */
TALUS_API talus_status talus_disconnect(talus_client* client);

/* The next event in *event. Waits for one at most timeout_ms milliseconds; 0: not at all, negative: without
 * limit. TALUS_NO_EVENT: none came. TALUS_NOT_CONNECTED: none can come, as there is no connection. All work
 * is done in here: call it often, at least every few seconds, and until it returns TALUS_NO_EVENT. */
TALUS_API talus_status talus_poll(talus_client* client, talus_event* event, int32_t timeout_ms);

/* ---- The world: known from JOINED on ---- */

/* Pointers in it, and names, stay valid until talus_poll() gives RECONNECTED, talus_connect(),
 * talus_disconnect() or talus_destroy(). */
TALUS_API talus_status talus_get_world(talus_client* client, talus_world* world);
/* `index` below world.material_count. */
TALUS_API talus_status talus_get_material(talus_client* client, uint32_t index, talus_material* material);
/* A biome's name; index 0 is no biome, "". `index` below world.look_count; NULL where it is not. */
TALUS_API const char* talus_look_name(talus_client* client, uint32_t index);
/* The name of a quantity such as temperature. `index` below world.field_count; NULL where it is not. */
TALUS_API const char* talus_field_name(talus_client* client, uint32_t index);

/* ---- Chunks around a player ---- */

/* Replaces the View. Cheap: call it every frame. TALUS_OUT_OF_RANGE leaves the View before. From JOINED on;
 * while reconnecting the View is kept and sent later. */
TALUS_API talus_status talus_set_view(talus_client* client, const talus_view* view);
/* How many chunks the View has, for a progress bar. */
TALUS_API talus_status talus_count_view(talus_client* client, const talus_view* view, uint64_t* chunks);
/* Writes ring_radius: rings of levels 1 to 6 from horizontal_radius out to `farthest` base chunks, all wider
 * than the one before by the same ratio. Needs no client. */
TALUS_API talus_status talus_fill_rings(talus_view* view, uint16_t farthest);

/* ---- Requests: each is answered by one event of its number, which *request gets unless it is NULL ---- */

/* One chunk. `known`, low and high half of the hash of what the caller holds, may be NULL. Any number may be
 * open. */
TALUS_API talus_status talus_get_chunk(talus_client* client, int32_t x, int32_t y, int32_t z, uint32_t level,
                                       const uint64_t known[2], uint32_t* request);
/* The ground at `count` base columns, x and z of each: 2 * count numbers. 1 to world.max_columns. */
TALUS_API talus_status talus_get_heights(talus_client* client, const int64_t* columns, size_t count,
                                         uint32_t* request);
/* The same with the look of each column, and its values of the fields of these names: at most 16. */
TALUS_API talus_status talus_get_places(talus_client* client, const int64_t* columns, size_t count,
                                        const char* const* fields, size_t field_count, uint32_t* request);
/* Changes voxels. Edits happen in the order of the calls, each once, however often the connection breaks
 * meanwhile; one that the server refuses for now is sent again, and may then happen behind later ones. Chunks
 * of the View change by CHUNK, before or after EDITED. */
TALUS_API talus_status talus_send_edit(talus_client* client, const talus_edit* edit, uint32_t* request);
TALUS_API talus_status talus_ping(talus_client* client, uint32_t* request);
/* Gives a talus_get_chunk() up. It is still answered, by TALUS_CANCELLED or by the chunk if that was on its
 * way. Other requests, and those answered, are left alone. */
TALUS_API talus_status talus_cancel(talus_client* client, uint32_t request);

TALUS_API talus_status talus_get_stats(talus_client* client, talus_stats* stats);

/* ---- Voxels: any thread ---- */

/* Writes all voxels of a chunk, index TALUS_VOXEL_INDEX(x, y, z). `count` is TALUS_CHUNK_VOLUME. */
TALUS_API talus_status talus_decode(const talus_chunk* chunk, uint16_t* voxels, size_t count);
/* Keeps a chunk beyond its event; for each, release it once. NULL is fine for both. */
TALUS_API void talus_chunk_retain(const talus_chunk* chunk);
TALUS_API void talus_chunk_release(const talus_chunk* chunk);

#ifdef __cplusplus
}
#endif

#endif
