// Whole stores of edits for tests: made of a map of voxels, and read back into one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include <talus/progress/progress_bar.h>
#include <talus/store/read_only_store.h>
#include <talus/store/store_builder.h>

#include "commands/store/store_figures.h"

namespace talus::server {

using Voxels = std::map<std::pair<ChunkCoord, std::uint16_t>, MaterialId>;

inline constexpr ContentHash kWorld{1, 2};
inline const std::map<std::string, MaterialId> kMaterials{{"air", MaterialId{0}},
                                                          {"glass", MaterialId{257}},
                                                          {"planks", MaterialId{256}},
                                                          {"stone", MaterialId{2}}};

/// Makes a store of these overrides in a data directory.
inline void make_store(const std::filesystem::path& path, const Voxels& voxels,
                       ContentHash fingerprint = kWorld,
                       const std::map<std::string, MaterialId>& materials = kMaterials) {
  std::filesystem::create_directories(path);
  const auto builder = store::StoreBuilder::create(path, {{3, 4}, fingerprint}, 10, 11);
  REQUIRE(builder.has_value());
  std::map<ChunkCoord, std::vector<Override>> chunks;
  for (const auto& [at, material] : voxels) chunks[at.first].push_back({at.second, material});
  for (const auto& [chunk, overrides] : chunks) REQUIRE((*builder)->add(chunk, 5, overrides).has_value());
  for (const auto& [name, id] : materials) REQUIRE((*builder)->add(name, id).has_value());
  REQUIRE((*builder)->finish(6, 1'700'000'000'000).has_value());
}

/// What a data directory holds, once it is sound in every respect.
inline Voxels voxels_of(const std::filesystem::path& path) {
  const auto store = store::ReadOnlyStore::open(path);
  INFO((store ? "" : store.error()));
  REQUIRE(store.has_value());
  ProgressBar progress{"", ""};
  const auto figures = read_figures(**store, progress);
  REQUIRE(figures.has_value());
  const auto verified = verify(**store, *figures);
  INFO((verified ? "" : verified.error()));
  REQUIRE(verified.has_value());
  Voxels voxels;
  REQUIRE((*store)->for_each_base_chunk([&](ChunkCoord chunk, const store::StoredChunk& stored) {
    for (const Override& voxel : stored.voxels) voxels.emplace(std::pair{chunk, voxel.index}, voxel.material);
    return true;
  }));
  return voxels;
}

}  // namespace talus::server
