// A hash of a region's chunks, to compare machines, builds and thread counts.
#pragma once

#include <cstdint>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/voxel/content_hash.h>

#include <talus/progress/progress_bar.h>

namespace talus::tools {

struct HashOptions {
  int threads = 0;       // 0: one a core
  int patch_chunks = 4;  // chunks along each edge of what is generated together; never changes the hash
};

/// The region hash, defined so that it streams:
///
/// - It covers every chunk column that holds a column of `region`, at the region's level.
/// - A column hash is XXH3-128 over that column's chunks from row -1 up to the row of the highest voxel
///   that the world can have (height_range, shifted to the level). Each chunk gives x, y, z and level as
///   int32, the payload's length as uint32, then the payload that `encode` makes.
/// - The region hash is XXH3-128 over the column hashes (low64, then high64), z slowest, then x.
///
/// All numbers little endian. Memory: 16 bytes a chunk along the region's width, and some patches a thread.
[[nodiscard]] ContentHash hash_region(const terrain::World& world, const terrain::Region& region,
                                      const HashOptions& options, ProgressBar& progress);

}  // namespace talus::tools
