// A small world of chunks, as a client holds them.
#pragma once

#include <memory>
#include <vector>

#include <talus/client/chunk_store.h>
#include <talus/client/world_info.h>
#include <talus/voxel/chunk.h>

namespace talus::cli::testing {

inline constexpr MaterialId kStone{2};
inline constexpr MaterialId kGrass{3};
inline constexpr MaterialId kRedWool{300};  // as placeables are, beyond a byte

[[nodiscard]] inline std::vector<client::Material> materials() {
  using client::Phase;
  return {{kAir, "air", 0x000000, Phase::gas},
          {kWater, "water", 0x204080, Phase::liquid},
          {kStone, "stone", 0x808080, Phase::solid},
          {kGrass, "grass", 0x40A040, Phase::solid},
          {kRedWool, "red wool", 0xC02020, Phase::solid}};
}

/// `below` up to row `rows`, then `above`.
[[nodiscard]] inline Chunk flat(MaterialId below, int rows, MaterialId above) {
  Layers layers;
  layers.materials = {below, above};
  layers.tops.assign(kChunkArea, static_cast<std::uint8_t>(rows));
  return Chunk::from_layers(std::move(layers));
}

/// `bottom` up to row `first`, `middle` up to row `second`, then air.
[[nodiscard]] inline Chunk layered(MaterialId bottom, int first, MaterialId middle, int second) {
  Layers layers;
  layers.materials = {bottom, middle, kAir};
  layers.tops.assign(kChunkArea, static_cast<std::uint8_t>(first));
  layers.tops.insert(layers.tops.end(), kChunkArea, static_cast<std::uint8_t>(second));
  return Chunk::from_layers(std::move(layers));
}

[[nodiscard]] inline client::ReceivedChunk received(ChunkKey key, Chunk chunk) {
  return {key, 0, {}, std::make_shared<const Chunk>(std::move(chunk))};
}

[[nodiscard]] inline ChunkKey key_at(int x, int y, int z, int lod = 0) {
  return {{x, y, z}, Lod::of(lod)};
}

}  // namespace talus::cli::testing
