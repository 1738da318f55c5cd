// Effect of level-0 edits at coarser levels, by rule 1: level-0 voxel (x, y, z) is the sample of level l >= 1
// if x and z are 0 modulo 2^l and y is 2^(l-1) modulo 2^l; its override is then also the override of voxel
// (x, y, z) >> l at level l. This matches the generator, for which a column of level l is base column x << l,
// and y is the voxel's middle. So the overrides of level l are a subset of level 0's and can be recomputed
// from them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <talus/edits/chunk_overrides.h>
#include <talus/voxel/coords.h>

namespace talus::edits {

/// Number of the rule above. Stores record it, because another rule would give other coarse levels for the
/// same edits.
inline constexpr std::uint32_t kLevelRule = 1;

/// A voxel of a coarser level, in voxels of that level.
struct CoarseVoxel {
  Lod lod;
  VoxelPos voxel;
  bool operator==(const CoarseVoxel&) const = default;
};

/// The coarse voxel whose sample is the base voxel `voxel`; nullopt if there is none. There is at most one: y
/// is 2^(l-1) modulo 2^l only for l = 1 + its number of trailing zeros. Holds for negative coordinates too; y
/// = 0 is never a sample.
[[nodiscard]] std::optional<CoarseVoxel> sampled_by(VoxelPos voxel);

/// The base voxel that is the sample of `voxel` at level `lod`. REQUIRES: lod >= 1 (asserted).
[[nodiscard]] VoxelPos sample_of(Lod lod, VoxelPos voxel);

/// Writes to one chunk of any level, by ascending index, without duplicates.
struct ChunkWrites {
  ChunkKey key;
  std::vector<OverrideWrite> writes;
  bool operator==(const ChunkWrites&) const = default;
};

/// Converts `writes` to the base chunk `chunk` to levels 1 to Lod::kMax: one entry per level that changes, in
/// ascending order. REQUIRES: indices ascend without duplicates (asserted by ChunkOverrides::apply).
[[nodiscard]] std::vector<ChunkWrites> coarse_writes(ChunkCoord chunk, std::span<const OverrideWrite> writes);

}  // namespace talus::edits
