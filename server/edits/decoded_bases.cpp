#include "edits/decoded_bases.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include <talus/voxel/codec.h>

namespace talus::server {
namespace {

std::size_t bytes_of(const Chunk& chunk) {
  if (chunk.dense() != nullptr) return sizeof(Chunk) + sizeof(DenseVoxels);
  const Layers* const layers = chunk.layers() != nullptr ? chunk.layers() : chunk.base();
  return sizeof(Chunk) + layers->tops.capacity() + layers->materials.capacity() * sizeof(MaterialId) +
         chunk.overrides().size() * sizeof(Override);
}

}  // namespace

void DecodedBases::set_capacity(std::size_t bytes) {
  if (bytes == capacity_bytes_) return;
  chunks_.set_capacity(capacity_bytes_ = bytes);
  std::size_t probes = SIZE_MAX;  // they are few
  (void)chunks_.fit(probes);
}

DecodedBasePtr DecodedBases::find(ChunkCoord chunk) {
  const DecodedBasePtr* const kept = chunks_.find({chunk, Lod{}});
  return kept == nullptr ? nullptr : *kept;
}

DecodedBasePtr DecodedBases::put(ChunkCoord chunk, const EncodedChunk& encoded) {
  auto decoded = decode(encoded.payload());
  if (!decoded) {
    throw std::runtime_error{"chunk " + to_string(chunk) +
                             " as generated: " + std::string{describe(decoded.error())}};
  }
  auto hidden = hidden_ ? hidden_(chunk, *decoded) : std::vector<Override>{};
  const std::size_t bytes = bytes_of(*decoded) + hidden.size() * sizeof(Override);
  auto shared = std::make_shared<const DecodedBase>(DecodedBase{*std::move(decoded), std::move(hidden)});
  chunks_.put({chunk, Lod{}}, shared, bytes);
  return shared;
}

std::vector<Override> among(std::span<const Override> voxels, std::span<const std::uint16_t> indices) {
  std::vector<Override> found;
  auto voxel = voxels.begin();
  for (const std::uint16_t index : indices) {
    while (voxel != voxels.end() && voxel->index < index) ++voxel;
    if (voxel != voxels.end() && voxel->index == index) found.push_back(*voxel);
  }
  return found;
}

std::vector<Override> voxels_at(const Chunk& chunk, std::span<const std::uint16_t> indices) {
  std::vector<Override> voxels;
  voxels.reserve(indices.size());
  constexpr std::size_t kMany = 64;  // about what copying all out costs
  if (indices.size() < kMany) {
    for (const std::uint16_t index : indices) voxels.push_back({index, chunk.at(local_of(index))});
    return voxels;
  }
  const auto dense = std::make_unique<DenseVoxels>();
  chunk.copy_to(*dense);
  for (const std::uint16_t index : indices) voxels.push_back({index, (*dense)[index]});
  return voxels;
}

}  // namespace talus::server
