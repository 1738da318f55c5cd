// Overrides of one chunk: its voxels whose material differs from the base, which is the chunk as generated. A
// value; any number of threads may read it while none modifies it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <talus/voxel/chunk.h>

namespace talus::edits {

/// New content of a voxel: an override, or as generated. `index` is its voxel_index(), below kChunkVolume.
struct OverrideWrite {
  std::uint16_t index = 0;
  std::optional<MaterialId> material;  // nullopt: the override is removed

  /// Sets a voxel to `material`, where the base has `base`: writing the base's material removes the override.
  [[nodiscard]] static OverrideWrite of(std::uint16_t index, MaterialId material, MaterialId base) {
    return material == base ? OverrideWrite{index, {}} : OverrideWrite{index, material};
  }
  bool operator==(const OverrideWrite&) const = default;
};

/// Four bytes per voxel, by ascending index, without duplicates.
class ChunkOverrides {
 public:
  ChunkOverrides() = default;
  /// REQUIRES: ascending indices without duplicates below kChunkVolume (asserted), as from decode_runs().
  explicit ChunkOverrides(std::vector<Override> voxels);

  /// The override at `index`; nullopt if the voxel is as generated.
  [[nodiscard]] std::optional<MaterialId> find(std::uint16_t index) const;

  /// Applies all writes. Few writes to many overrides move the tail each time; many writes are merged once.
  /// REQUIRES: indices ascend without duplicates, below kChunkVolume (asserted).
  void apply(std::span<const OverrideWrite> writes);

  /// Returns `base` with these voxels; see Chunk::with_overrides().
  [[nodiscard]] Chunk merged_over(const Chunk& base) const { return base.with_overrides(voxels_); }

  [[nodiscard]] std::span<const Override> voxels() const { return voxels_; }
  [[nodiscard]] std::size_t size() const { return voxels_.size(); }
  [[nodiscard]] bool empty() const { return voxels_.empty(); }
  bool operator==(const ChunkOverrides&) const = default;

 private:
  std::vector<Override> voxels_;
};

}  // namespace talus::edits
