/* libtalus-local: Talus worlds in this process, without a server: chunks, edits, and saves of one player.
 *
 *   talus_local_world* world;
 *   talus_world_options options = {.size = sizeof options};
 *   talus_world_open(&options, &world);
 *   talus_workspace* workspace;
 *   talus_workspace_create(world, 0, &workspace);
 *   talus_chunk_key key = {0, 4, 0, 0};
 *   talus_generate(workspace, &key, 1, 0, voxels, NULL);
 *
 * These options are the built-in world's. examples/single_player.c is a whole program.
 *
 * Space, structs with `size`, statuses and strings are as talus.h says, which declares the types used here;
 * none of its functions is in this library, nor needed. A program may link both.
 *
 * Equal worlds (equal fingerprints) have equal voxels on every machine, to the bit, and the same ones as on a
 * server.
 *
 * Errors. A function that fails returns a negative status, changes nothing unless it says otherwise, and
 * leaves a one-line message in talus_local_error() of its thread. No C++ exception leaves the library.
 *
 * Threads. Any thread may use a world at any time, also while others do. A workspace is one thread's memory:
 * use each by one thread at a time. The library has no threads of its own. Callbacks come on the calling
 * thread.
 *
 * Ownership. Functions copy their arguments before they return. A world lives until it is closed and its last
 * workspace is destroyed. Strings of a world live as long as the world. */
#ifndef TALUS_LOCAL_H
#define TALUS_LOCAL_H

#include "talus.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this interface, as TALUS_API_MAJOR and MINOR: libtalus-local.so.MAJOR. */
#define TALUS_LOCAL_API_MAJOR 1
#define TALUS_LOCAL_API_MINOR 0

/* Further statuses. */
enum {
  TALUS_BAD_WORLD = -48,   /* the world's file is refused: the message names line, key, fault and remedy */
  TALUS_FILE_FAILED = -49, /* a file is missing, there already, read-only, or the disk is full or broken */
  TALUS_FILE_IN_USE = -50, /* another program has the save open */
  TALUS_BAD_SAVE = -51,    /* the file is no save, or is damaged */
  TALUS_OTHER_SAVE = -52   /* the save is of another format, generator version or fingerprint */
};

/* An open world with the edits made in it, and the save that keeps them, if any. */
typedef struct talus_local_world talus_local_world;
/* The memory in which one thread generates chunks. */
typedef struct talus_workspace talus_workspace;

/* Reads a file that a world names, such as a model: stores its bytes, which must stay valid until the next
 * call or the end of talus_world_open(), and returns 0; anything else: there is no such file. */
typedef int32_t (*talus_read_file)(void* user, const char* name, const void** bytes, size_t* count);

typedef struct talus_world_options {
  uint32_t size;
  uint32_t flags;   /* TALUS_SETTLES */
  const char* toml; /* the world's file, toml_bytes long; NULL: the built-in world */
  uint64_t toml_bytes;
  const char* folder;        /* where files are that the world names; NULL: none, or read_file's */
  talus_read_file read_file; /* instead of folder; may be NULL */
  void* user;                /* for read_file */
} talus_world_options;

/* Flags of talus_world_options, the first alone, and of talus_world_info. */
enum {
  TALUS_SETTLES = 1,  /* loose material falls and slides after an edit, as on a server with edits.settle */
  TALUS_HAS_SAVE = 2, /* a save keeps the edits */
  TALUS_UNSAVED = 4   /* there are edits that talus_save_commit() has not kept */
};

typedef struct talus_world_info {
  uint32_t size;
  uint32_t flags; /* TALUS_SETTLES, TALUS_HAS_SAVE, TALUS_UNSAVED */
  uint64_t fingerprint_low, fingerprint_high;
  int64_t min_y, max_y;              /* as generated: one rock below min_y, air from max_y up */
  int64_t spawn_x, spawn_y, spawn_z; /* base voxel of the feet: the first free one above dry ground */
  uint64_t revision;                 /* raised by each edit that changes something */
  uint64_t hash_low, hash_high;      /* of all edits: equal if all edited voxels are */
  uint32_t material_count;           /* talus_world_get_material() */
  uint32_t generator_version;
} talus_world_info;

/* A chunk by its coordinates, in chunks of its level. */
typedef struct talus_chunk_key {
  int32_t x, y, z;
  uint32_t level; /* 0 to 6 */
} talus_chunk_key;

typedef struct talus_edit_result {
  uint32_t size;
  int32_t conflict;        /* the first guard that does not hold, or -1 */
  uint32_t changed_voxels; /* of level 0, settled ones included */
  uint32_t chunk_count;
  const talus_chunk_key* chunks; /* that changed, of all levels; until the workspace is used again */
  uint64_t revision;             /* after the edit */
} talus_edit_result;

/* ---- The library ---- */

/* TALUS_LOCAL_API_MAJOR << 16 | TALUS_LOCAL_API_MINOR of the loaded library. */
TALUS_API uint32_t talus_local_api_version(void);
/* The release of Talus that the library was built from: "0.2.0". */
TALUS_API const char* talus_local_version(void);
/* Message of this thread's last failed call, in one line; empty if no call failed. Valid until the next
 * failing call. */
TALUS_API const char* talus_local_error(void);

/* ---- Worlds ---- */

/* Opens a world in *world; close it by talus_world_close(). */
TALUS_API talus_status talus_world_open(const talus_world_options* options, talus_local_world** world);
/* Edits that talus_save_commit() has not kept are lost. NULL is ignored. */
TALUS_API void talus_world_close(talus_local_world* world);
TALUS_API talus_status talus_world_get_info(talus_local_world* world, talus_world_info* info);
/* `index` below info.material_count: what the world generates, then what may be placed only. */
TALUS_API talus_status talus_world_get_material(talus_local_world* world, uint32_t index,
                                                talus_material* material);

/* ---- Chunks ---- */

/* Creates a workspace in *workspace; free it by talus_workspace_destroy(). It takes some 10 MB, and up to
 * `memory_bytes` of ground that neighbouring chunks share; 0: 64 MiB. */
TALUS_API talus_status talus_workspace_create(talus_local_world* world, uint64_t memory_bytes,
                                              talus_workspace** workspace);
/* NULL is ignored. */
TALUS_API void talus_workspace_destroy(talus_workspace* workspace);

/* Chunks as generated, without edits. A flag of the functions below. */
enum { TALUS_WITHOUT_EDITS = 1 };

/* Makes chunks with their edits. `voxels`: TALUS_CHUNK_VOLUME ids for each, in the order of the keys, or
 * NULL. `uniform_materials`: for each the id of all its voxels, or -1 if they differ; or NULL. Chunks near
 * each other share work if they are asked for together. TALUS_CANCELLED: some are not made, those whose
 * uniform material is -2. */
TALUS_API talus_status talus_generate(talus_workspace* workspace, const talus_chunk_key* keys, size_t count,
                                      uint32_t flags, uint16_t* voxels, int32_t* uniform_materials);

/* Takes chunk `index` of the keys. `voxels` are valid until it returns. The callback may call
 * talus_apply_edit() with another workspace. */
typedef void (*talus_take_chunk)(void* user, size_t index, int32_t uniform_material, const uint16_t* voxels);
/* Gives each chunk to `take` when it is made, neighbours together, in no order to rely on. */
TALUS_API talus_status talus_generate_each(talus_workspace* workspace, const talus_chunk_key* keys,
                                           size_t count, uint32_t flags, talus_take_chunk take, void* user);
/* From any thread: the running call to generate, or else the next one, returns TALUS_CANCELLED soon. */
TALUS_API void talus_cancel_generate(talus_workspace* workspace);

/* Ground as generated of width * depth columns from x, z on, in voxels of `level`, x fastest: the top of the
 * topmost solid material, without trees and other objects, in 1/256 voxel of the level. The highest voxel of
 * ground is at y = ((height + 127) >> 8) - 1. `count` is width * depth, at most 2^22. */
TALUS_API talus_status talus_heights(talus_local_world* world, int64_t x, int64_t z, uint32_t width,
                                     uint32_t depth, uint32_t level, int32_t* heights_fx, size_t count);

/* ---- Edits ---- */

/* Applies an edit to the workspace's world, completely or not at all; `subject` is not used. TALUS_CONFLICT:
 * a guard does not hold, result->conflict says which. TALUS_OUT_OF_RANGE: the world forbids it. `result` may
 * be NULL. */
TALUS_API talus_status talus_apply_edit(talus_workspace* workspace, const talus_edit* edit,
                                        talus_edit_result* result);
/* Stores up to `capacity` chunks of level 0 that differ from the generated ones, by rising x, y, z, and in
 * *count how many there are. */
TALUS_API talus_status talus_get_changed_chunks(talus_local_world* world, talus_chunk_key* chunks,
                                                size_t capacity, size_t* count);

/* ---- Saves: one file each, which holds the world and its edits, and may be copied while no program has it
 * open ---- */

/* Keeps the world's edits in a new file from now on, those made so far included. */
TALUS_API talus_status talus_save_create(talus_local_world* world, const char* file);
/* Opens a save's world, with its edits, in *world. `flags`: TALUS_READ_ONLY. */
TALUS_API talus_status talus_save_open(const char* file, uint32_t flags, talus_local_world** world);
enum { TALUS_READ_ONLY = 1 };
/* Returns when all edits made before are on the disk, and neither a crash nor a power cut can lose them.
 * After an error none of them is; they stay in the world, and the next call tries again. */
TALUS_API talus_status talus_save_commit(talus_local_world* world);

#ifdef __cplusplus
}
#endif

#endif
