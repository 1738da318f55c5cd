// The Generator of a terrain::World.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/heights.h>
#include <talus/terrain/stacks.h>
#include <talus/terrain/world.h>

#include "generation/generator.h"

namespace talus::server {

class TerrainGenerator final : public Generator {
 public:
  /// Patches have `patch_tiles` tiles along each edge, a power of two.
  TerrainGenerator(std::shared_ptr<const terrain::World> world, int patch_tiles);

  [[nodiscard]] EncodedChunkPtr instant(ChunkKey key) const override;
  /// `material` is one of the world's.
  [[nodiscard]] EncodedChunkPtr uniform(MaterialId material) const override;
  [[nodiscard]] MixedRows mixed_rows_anywhere(Lod lod) const override;
  [[nodiscard]] MixedRows mixed_rows(const terrain::Stacks& stacks, ChunkKey key) const override;
  [[nodiscard]] bool make_patch(const PatchKey& patch, terrain::Stacks& stacks,
                                const GoOn& go_on) const override;
  [[nodiscard]] EncodedChunkPtr make_chunk(const terrain::Stacks& stacks, ChunkKey key) const override;
  [[nodiscard]] std::optional<std::vector<std::int32_t>> heights(std::span<const terrain::BaseColumn> columns,
                                                                 const GoOn& go_on) const override;

 private:
  [[nodiscard]] std::unique_ptr<terrain::Generator> take_generator() const;

  const std::shared_ptr<const terrain::World> world_;
  const int patch_tiles_;
  std::array<MixedRows, Lod::kMax + 1> rows_anywhere_;  // by level
  std::vector<EncodedChunkPtr> uniform_;                // by material id
  mutable std::mutex idle_mutex_;
  mutable std::vector<std::unique_ptr<terrain::Generator>> idle_;
};

}  // namespace talus::server
