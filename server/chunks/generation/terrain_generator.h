// The Generator of a terrain::World.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/ground_cache.h>
#include <talus/terrain/heights.h>
#include <talus/terrain/stacks.h>
#include <talus/terrain/world.h>

#include "chunks/generation/generator.h"

namespace talus::server {

class TerrainGenerator final : public Generator {
 public:
  /// Patches have `patch_tiles` tiles along each edge, a power of two. The memory of `max_idle` idle
  /// generators is kept. They share about `ground_bytes` of ground; 0: no ground is shared.
  TerrainGenerator(std::shared_ptr<const terrain::World> world, int patch_tiles, std::size_t max_idle = 1,
                   std::size_t ground_bytes = 0);

  [[nodiscard]] EncodedChunkPtr instant(ChunkKey key) const override;
  /// `material` is one of the world's.
  [[nodiscard]] EncodedChunkPtr uniform(MaterialId material) const override;
  [[nodiscard]] MixedRows mixed_rows_anywhere(Lod lod) const override;
  [[nodiscard]] MixedRows mixed_rows(const terrain::Stacks& stacks, ChunkKey key) const override;
  [[nodiscard]] std::unique_ptr<PatchBuild> start_patch(const PatchKey& patch,
                                                        terrain::Stacks memory) const override;
  [[nodiscard]] EncodedChunkPtr make_chunk(const terrain::Stacks& stacks, ChunkKey key) const override;
  [[nodiscard]] std::unique_ptr<HeightsBuild> start_heights(HeightsQuery query) const override;

 private:
  class PatchOfWorld;
  class HeightsOfWorld;
  class MapOfWorld;

  [[nodiscard]] std::unique_ptr<terrain::Generator> take_generator() const;
  void give_back(std::unique_ptr<terrain::Generator> generator) const;

  const std::shared_ptr<const terrain::World> world_;
  const int patch_tiles_;
  const std::size_t max_idle_;
  const std::shared_ptr<terrain::GroundCache> ground_;  // or null
  std::array<MixedRows, Lod::kMax + 1> rows_anywhere_;  // by level
  std::vector<EncodedChunkPtr> uniform_;                // by material id
  const std::vector<std::string> place_names_;
  mutable std::mutex idle_mutex_;
  mutable std::vector<std::unique_ptr<terrain::Generator>> idle_;
};

}  // namespace talus::server
