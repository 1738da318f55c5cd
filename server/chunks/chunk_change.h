// What edits do to chunks, as those see it who serve them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

namespace talus::server {

/// A chunk of any level was changed by an edit, or by several.
struct ChunkChange {
  ChunkKey key;
  std::uint64_t previous = 0;  // its revision before
  std::uint64_t revision = 0;
};
using ChunkChangesPtr = std::shared_ptr<const std::vector<ChunkChange>>;

/// Voxels of a chunk by rising index, with their materials now, and the revision that they make.
struct ChangedVoxels {
  std::uint64_t revision = 0;
  std::vector<Override> voxels;
};

}  // namespace talus::server
