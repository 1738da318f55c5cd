// What edits of level 0 are at coarser levels: rule 1. Level-0 voxel (x, y, z) is the sample of level l >= 1
// where x and z are 0 modulo 2^l and y is 2^(l-1) modulo 2^l; its override is also that of voxel (x, y, z) >>
// l of level l. This continues the generator's rule, by which a column of level l is base column x << l, and
// y is the voxel's middle. So the overrides of level l are a subset of level 0's, and can be made anew from
// them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <talus/edits/chunk_overrides.h>
#include <talus/voxel/coords.h>

namespace talus::edits {

/// The number of the rule above. A store keeps it: another rule would make other coarse levels of the same
/// edits.
inline constexpr std::uint32_t kLevelRule = 1;

/// A voxel of a coarser level, in voxels of that level.
struct CoarseVoxel {
  Lod lod;
  VoxelPos voxel;
  bool operator==(const CoarseVoxel&) const = default;
};

/// The voxel of which the base voxel `voxel` is the sample, or none. There is at most one: y has 2^(l-1)
/// modulo 2^l at one l alone, the count of its trailing zeros and one. Negative coordinates as any; y = 0 is
/// no sample.
[[nodiscard]] std::optional<CoarseVoxel> sampled_by(VoxelPos voxel);

/// The base voxel that is the sample of `voxel` of level `lod`. REQUIRES: lod >= 1 (asserted).
[[nodiscard]] VoxelPos sample_of(Lod lod, VoxelPos voxel);

/// Writes to one chunk of any level, by rising index, each index once.
struct ChunkWrites {
  ChunkKey key;
  std::vector<OverrideWrite> writes;
  bool operator==(const ChunkWrites&) const = default;
};

/// What `writes` to the base chunk `chunk` are at levels 1 to Lod::kMax: one entry for each level that
/// changes, by rising level. REQUIRES: indices rise, each once (asserted by ChunkOverrides::apply).
[[nodiscard]] std::vector<ChunkWrites> coarse_writes(ChunkCoord chunk, std::span<const OverrideWrite> writes);

}  // namespace talus::edits
