#include "plot.h"

#include <algorithm>
#include <set>

namespace talus::chaos {
namespace {

constexpr std::size_t kMaxWrites = 12;
constexpr std::int64_t kLongestEdge = 6;  // of a fill

}  // namespace

Plot::Plot(VoxelPos corner, std::vector<MaterialId> palette, std::uint64_t seed)
    : corner_{corner},
      palette_{std::move(palette)},
      voxels_(static_cast<std::size_t>(kEdge * kEdge * kEdge), kAir),
      random_{seed} {}

std::size_t Plot::below(std::size_t bound) {
  return std::uniform_int_distribution<std::size_t>{0, bound - 1}(random_);
}

MaterialId Plot::any_material() {
  const std::size_t choice = below(palette_.size() + 1);
  return choice == palette_.size() ? kAir : palette_[choice];
}

VoxelPos Plot::voxel(std::size_t index) const {
  const auto at = static_cast<std::int64_t>(index);
  return {corner_.x + at % kEdge, corner_.y + at / (kEdge * kEdge), corner_.z + at / kEdge % kEdge};
}

Plot::Step Plot::next() {
  Step step;
  // Guards are of what the plot is before the edit.
  if (below(2) == 0) add_guards(step);
  if (below(4) == 0) {
    add_fill(step);
  } else {
    add_writes(step);
  }
  for (const auto& [index, material] : step.voxels) step.changed += voxels_[index] == material ? 0 : 1;
  return step;
}

void Plot::take(const Step& step) {
  for (const auto& [index, material] : step.voxels) voxels_[index] = material;
}

void Plot::add_writes(Step& step) {
  std::set<std::size_t> chosen;  // each once
  for (std::size_t count = 1 + below(kMaxWrites); count > 0; --count) chosen.insert(below(voxels_.size()));
  for (const std::size_t index : chosen) {
    const MaterialId material = any_material();
    step.edit.writes.push_back({voxel(index), material});
    step.voxels.emplace_back(index, material);
  }
}

void Plot::add_fill(Step& step) {
  VoxelPos first;
  VoxelPos last;
  const auto choose = [&](std::int64_t& low, std::int64_t& high) {
    low = static_cast<std::int64_t>(below(kEdge));
    high = std::min(kEdge - 1, low + static_cast<std::int64_t>(below(kLongestEdge)));
  };
  choose(first.x, last.x);
  choose(first.y, last.y);
  choose(first.z, last.z);
  client::Edit& edit = step.edit;
  edit.fills.push_back({{corner_.x + first.x, corner_.y + first.y, corner_.z + first.z},
                        {corner_.x + last.x, corner_.y + last.y, corner_.z + last.z},
                        any_material(),
                        {}});
  auto& fill = edit.fills.back();
  if (below(4) == 0) fill.only = any_material();
  const MaterialId material = *fill.material;
  // As generated is air, here.
  if (material == kAir && below(2) == 0) fill.material.reset();
  for (std::int64_t y = first.y; y <= last.y; ++y) {
    for (std::int64_t z = first.z; z <= last.z; ++z) {
      for (std::int64_t x = first.x; x <= last.x; ++x) {
        const auto index = static_cast<std::size_t>((y * kEdge + z) * kEdge + x);
        if (!fill.only || voxels_[index] == *fill.only) step.voxels.emplace_back(index, material);
      }
    }
  }
}

void Plot::add_guards(Step& step) {
  for (std::size_t count = 1 + below(3); count > 0; --count) {
    const std::size_t index = below(voxels_.size());
    MaterialId holds = voxels_[index];
    if (below(10) == 0) holds = any_material();
    step.conflicts = step.conflicts || holds != voxels_[index];
    step.edit.guards.push_back({voxel(index), holds});
  }
}

}  // namespace talus::chaos
