// Definition of talus_chunk.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include <talus.h>
#include <talus/voxel/chunk.h>

struct talus_chunk {
  explicit talus_chunk(std::shared_ptr<const talus::Chunk> of) : voxels{std::move(of)} {}

  std::shared_ptr<const talus::Chunk> voxels;
  mutable std::atomic<std::uint64_t> holders{1};  // the event is the first
};

namespace talus::c_api {

struct ReleaseChunk {
  void operator()(const talus_chunk* chunk) const { talus_chunk_release(chunk); }
};
using ChunkHandle = std::unique_ptr<const talus_chunk, ReleaseChunk>;

}  // namespace talus::c_api
