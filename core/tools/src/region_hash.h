// A hash of a region's chunks, for comparing machines, builds and thread counts.
#pragma once

#include <cstdint>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/voxel/content_hash.h>

#include <talus/progress/progress_bar.h>

namespace talus::tools {

struct HashOptions {
  int threads = 0;       // 0: one per core
  int patch_chunks = 4;  // chunks along each edge of a patch generated at once; never changes the hash
};

/// The region hash, defined so that it streams:
///
/// - It covers every chunk column that contains a column of `region`, at the region's level.
/// - A column hash is the XXH3-128 of the column's chunks from row -1 up to the row of the highest possible
///   voxel of the world (height_range, shifted to the level). Each chunk contributes x, y, z and level as
///   int32, the payload's length as uint32, and the payload written by `encode`.
/// - The region hash is the XXH3-128 of the column hashes (low64, then high64), z slowest, then x.
///
/// All numbers are little-endian. Memory: 16 bytes per chunk along the region's width, and a few patches per
/// thread.
[[nodiscard]] ContentHash hash_region(const terrain::World& world, const terrain::Region& region,
                                      const HashOptions& options, ProgressBar& progress);

}  // namespace talus::tools
