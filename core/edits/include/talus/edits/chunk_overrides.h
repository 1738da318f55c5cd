// The overrides of one chunk: its voxels whose material differs from the base, which is the chunk as
// generated. A value; may be read by any number of threads while nobody changes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <talus/voxel/chunk.h>

namespace talus::edits {

/// What a voxel becomes: an override, or as generated. `index` is its voxel_index(), below kChunkVolume.
struct OverrideWrite {
  std::uint16_t index = 0;
  std::optional<MaterialId> material;  // none: the override goes

  /// A voxel that shall be of `material`, where the base has `base`: writing the base's material removes.
  [[nodiscard]] static OverrideWrite of(std::uint16_t index, MaterialId material, MaterialId base) {
    return material == base ? OverrideWrite{index, {}} : OverrideWrite{index, material};
  }
  bool operator==(const OverrideWrite&) const = default;
};

/// Four bytes a voxel, by rising index, each index once.
class ChunkOverrides {
 public:
  ChunkOverrides() = default;
  /// REQUIRES: indices rise, each once, below kChunkVolume (asserted), as decode_runs() returns them.
  explicit ChunkOverrides(std::vector<Override> voxels);

  /// The override at `index`, or none where the voxel is as generated.
  [[nodiscard]] std::optional<MaterialId> find(std::uint16_t index) const;

  /// Makes every write true. Few writes into many overrides cost their moves, many cost one merge.
  /// REQUIRES: indices rise, each once, below kChunkVolume (asserted).
  void apply(std::span<const OverrideWrite> writes);

  /// `base` with these voxels; as Chunk::with_overrides has it.
  [[nodiscard]] Chunk merged_over(const Chunk& base) const { return base.with_overrides(voxels_); }

  [[nodiscard]] std::span<const Override> voxels() const { return voxels_; }
  [[nodiscard]] std::size_t size() const { return voxels_.size(); }
  [[nodiscard]] bool empty() const { return voxels_.empty(); }
  bool operator==(const ChunkOverrides&) const = default;

 private:
  std::vector<Override> voxels_;
};

}  // namespace talus::edits
