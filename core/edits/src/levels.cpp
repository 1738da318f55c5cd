#include <talus/edits/levels.h>

#include <array>
#include <bit>
#include <cassert>
#include <utility>

namespace talus::edits {

std::optional<CoarseVoxel> sampled_by(VoxelPos voxel) {
  // Two's complement: a negative number has the trailing zeros and remainders of its absolute value. 0 has 64
  // trailing zeros.
  const int level = std::countr_zero(static_cast<std::uint64_t>(voxel.y)) + 1;
  if (level > Lod::kMax) return std::nullopt;
  const std::int64_t below = (std::int64_t{1} << level) - 1;
  if (((voxel.x | voxel.z) & below) != 0) return std::nullopt;
  return CoarseVoxel{Lod::of(level), {voxel.x >> level, voxel.y >> level, voxel.z >> level}};
}

VoxelPos sample_of(Lod lod, VoxelPos voxel) {
  assert(lod.value() >= 1);
  const std::int64_t size = std::int64_t{1} << lod.value();
  return {voxel.x * size, voxel.y * size + size / 2, voxel.z * size};
}

std::vector<ChunkWrites> coarse_writes(ChunkCoord chunk, std::span<const OverrideWrite> writes) {
  // A base chunk lies within one chunk of each level, in which voxels have the same order by index.
  std::array<std::vector<OverrideWrite>, Lod::kMax + 1> levels;
  for (const OverrideWrite& write : writes) {
    const auto coarse = sampled_by(voxel_at(chunk_origin(chunk), local_of(write.index)));
    if (!coarse) continue;
    const std::size_t index = voxel_index(local_pos(coarse->voxel));
    levels[static_cast<std::size_t>(coarse->lod.value())].push_back(
        {static_cast<std::uint16_t>(index), write.material});
  }
  std::vector<ChunkWrites> all;
  for (int level = 1; level <= Lod::kMax; ++level) {
    auto& of_level = levels[static_cast<std::size_t>(level)];
    if (of_level.empty()) continue;
    const ChunkCoord coarse{chunk.x >> level, chunk.y >> level, chunk.z >> level};
    all.push_back({{coarse, Lod::of(level)}, std::move(of_level)});
  }
  return all;
}

}  // namespace talus::edits
