// Changes of chunks by edits, for the code that serves chunks.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

namespace talus::server {

/// A change of a chunk of any level by one or more edits.
struct ChunkChange {
  ChunkKey key;
  std::uint64_t previous = 0;  // its revision before the change
  std::uint64_t revision = 0;
};
using ChunkChangesPtr = std::shared_ptr<const std::vector<ChunkChange>>;

/// Changed voxels of a chunk by ascending index, with their current materials, and the resulting revision.
struct ChangedVoxels {
  std::uint64_t revision = 0;
  std::vector<Override> voxels;
};

}  // namespace talus::server
