#include "edit_site.h"

#include <algorithm>
#include <cmath>

namespace talus::load {
namespace {

constexpr std::int64_t kAboveGround = 2;

VoxelPos lowest_corner(const glm::dvec3& ground, std::uint32_t builders) {
  const auto aligned = [](double at) {
    return floor_div(static_cast<std::int64_t>(std::floor(at)), EditSite::kEdge) * EditSite::kEdge;
  };
  const auto row = static_cast<std::int64_t>(std::floor(ground.y)) - kAboveGround;
  return {aligned(ground.x), row - builders / 2, aligned(ground.z)};
}

}  // namespace

EditSite::EditSite(const glm::dvec3& ground, std::uint32_t builders, MaterialId building)
    : corner_{lowest_corner(ground, builders)},
      ground_{corner_.y + builders / 2},
      building_{building},
      cells_(builders * kFloor) {
  for (std::size_t index = 0; index < cells_.size(); ++index) {
    const VoxelPos at = voxel(index);
    const ChunkCoord chunk{static_cast<std::int32_t>(floor_div(at.x, kChunkSize)),
                           static_cast<std::int32_t>(floor_div(at.y, kChunkSize)),
                           static_cast<std::int32_t>(floor_div(at.z, kChunkSize))};
    auto part = std::ranges::find(parts_, chunk, &Part::chunk);
    if (part == parts_.end()) part = parts_.insert(parts_.end(), Part{chunk, {}});
    part->cells.emplace_back(static_cast<std::uint16_t>(voxel_index(local_pos(at))),
                             static_cast<std::uint32_t>(index));
  }
  for (Part& part : parts_) std::ranges::sort(part.cells);
}

VoxelPos EditSite::voxel(std::size_t index) const {
  const auto place = static_cast<std::int64_t>(index);
  return {corner_.x + place % kEdge, corner_.y + place / (kEdge * kEdge), corner_.z + place / kEdge % kEdge};
}

MaterialId EditSite::next(std::size_t index) const {
  const Cell& cell = cells_[index];
  const bool solid = cell.is_written ? cell.written != kAir : voxel(index).y < ground_;
  return solid ? kAir : building_;
}

}  // namespace talus::load
