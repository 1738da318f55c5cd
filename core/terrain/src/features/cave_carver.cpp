#include "features/cave_carver.h"

#include <algorithm>
#include <cassert>

#include <talus/terrain/boundary_row.h>

namespace talus::terrain {

CaveCarver::CaveCarver(const CavePlan& plan, const World& world, InstructionSet set)
    : plan_{plan},
      kernels_{cave_kernels(set)},
      shape_{plan_, set},
      shore_{world.sea_fx() ? 1 : 0},
      sea_fx_{world.sea_fx().value_or(0)},
      erodes_{world.spec().method == Method::erosion} {
  for (const LooseSpec& loose : world.loose()) loose_thickness_fx_.push_back(loose.t_fx);
}

void CaveCarver::start(const Region& region, int around, int open_ring) {
  const int level = region.lod.value();
  region_ = region;
  open_ring_ = open_ring;
  span_ = plan_.span_at(region.lod);
  loose_fx_ = 0;
  for (const std::int32_t t_fx : loose_thickness_fx_) loose_fx_ += t_fx >> level;
  // At least two rows, so that the topmost can be loose material with rock under it.
  min_rows_ = std::max(2, ((plan_.roof_fx >> level) + kSubvoxels - 1) / kSubvoxels);
  const std::int32_t lowest = boundary_row(std::max(kSubvoxels, shape_.lowest_floor_fx() >> level));
  min_fx_ = (lowest + min_rows_ - 1) * kSubvoxels + loose_fx_;
  any_ = false;
  next_ = 0;
  entrances_.reshape(0, 0);
  pending_ = span_ != 0;
  if (!pending_) return;
  judged_ = around - shore_;
  assert(judged_ >= open_ring);

  const Region judged = region.expanded(judged_);
  const std::int64_t step = std::int64_t{1} << level;
  xs_.clear();
  for (int i = 0; i < judged.width; ++i) xs_.push_back((judged.x + i) * step);
  shape_.start(xs_, region.lod);
  floor_.reshape(judged.width, judged.depth);
  roof_.reshape(judged.width, judged.depth);
}

void CaveCarver::compute_rows(int count, const Field& height) {
  const Region judged = region_.expanded(judged_);
  const std::int64_t step = std::int64_t{1} << region_.lod.value();
  const int last = std::min(judged.depth, next_ + count);
  if (next_ == 0) airy_.assign(static_cast<std::size_t>(judged.depth), 0);
  for (; next_ < last; ++next_) {
    const bool air = shape_.row((judged.z + next_) * step, thick_enough(next_, height),
                                floor_.row(next_).data(), roof_.row(next_).data());
    airy_[static_cast<std::size_t>(next_)] = air ? 1 : 0;
    any_ |= air;
  }
  if (next_ < judged.depth) return;
  pending_ = false;
  if (any_) judge_all(height);
}

// The range of columns of the row whose ground is high enough for a cave and its roof: in many worlds seas
// and plains are not.
ColumnRange CaveCarver::thick_enough(int z, const Field& height) const {
  const auto row = height.row(z + shore_).subspan(static_cast<std::size_t>(shore_));
  const int level = region_.lod.value();
  const auto thick = [&](std::size_t x) { return row[x] >> level > min_fx_; };
  ColumnRange columns{0, static_cast<std::size_t>(floor_.width)};
  while (columns.first < columns.last && !thick(columns.first)) ++columns.first;
  while (columns.first < columns.last && !thick(columns.last - 1)) --columns.last;
  return columns;
}

void CaveCarver::judge_all(const Field& height) {
  const Region judged = region_.expanded(judged_);
  roof_row_.reshape(judged.width, judged.depth);
  rock_row_.reshape(judged.width, judged.depth);
  roofs_.start(judged.width, judged.depth);
  lowest_.clear();
  for (int z = 0; shore_ != 0 && z < height.depth; ++z) {
    lowest_.push_back(kernels_.lowest(height.row(z).data(), static_cast<std::size_t>(height.width)));
  }
  const auto airy = [&](int z) {
    return z >= 0 && z < judged.depth && airy_[static_cast<std::size_t>(z)] != 0;
  };
  for (int z = 0; z < judged.depth; ++z) {
    if (airy(z - 1) || airy(z) || airy(z + 1)) judge_row(z, height);
  }
  for (int z = 0; z < judged.depth; ++z) {
    if (airy(z) || airy(z + 1)) find_touching(z);
  }
  roofs_.find(judged_, judged_ + region_.depth, span_);
  find_entrances();
}

void CaveCarver::find_entrances() {
  const Region around = region_.expanded(open_ring_);
  const int ring = judged_ - open_ring_;
  bool any = false;
  for (int z = 0; z < around.depth; ++z) {
    const std::uint64_t* const open = roofs_.open().row(z + ring);
    for_set_bits(
        ring, ring + around.width, [=](std::size_t i) { return open[i]; },
        [&](int x) {
          if (!any) {
            entrances_.reshape(around.width, around.depth);
            std::fill(entrances_.values.begin(), entrances_.values.end(), kClosed);
            any = true;
          }
          entrances_.at(x - ring, z) = floor_.at(x, z + ring);
        });
  }
}

void CaveCarver::judge_row(int z, const Field& height) {
  const int level = region_.lod.value();
  const auto row = [&](int south) { return height.row(z + shore_ + south).data() + shore_; };
  const RoofRules rules{
      level, loose_fx_, erodes_ ? loose_fx_ : 0, min_rows_, shore_ != 0 && !all_dry(z), sea_fx_ >> level};
  HeightsAround heights;
  heights.own = row(0);
  if (rules.shore) {
    heights.north = row(-1);
    heights.south = row(1);
  }
  kernels_.judge(rules, heights, static_cast<std::size_t>(floor_.width),
                 {floor_.row(z).data(), roof_.row(z).data(), roof_row_.row(z).data(), rock_row_.row(z).data(),
                  roofs_.roofed().row(z), roofs_.open().row(z)});
}

// Finds columns of row z that touch the next column, or the next row's.
void CaveCarver::find_touching(int z) {
  const auto width = static_cast<std::size_t>(floor_.width);
  const std::int32_t* const roof = roof_row_.row(z).data();
  const std::int32_t* const rock = rock_row_.row(z).data();
  kernels_.touch(roof, rock, roof + 1, rock + 1, width - 1, roofs_.touches_east().row(z));
  if (z + 1 == floor_.depth) return;
  kernels_.touch(roof, rock, roof + width, rock + width, width, roofs_.touches_south().row(z));
}

// Returns true if even the lowest column of the row and the adjacent rows is above the sea.
bool CaveCarver::all_dry(int z) const {
  const auto first = lowest_.begin() + z;
  const int level = region_.lod.value();
  return (*std::min_element(first, first + 3) >> level) - (erodes_ ? loose_fx_ : 0) > sea_fx_ >> level;
}

void CaveCarver::take(CaveAir& air) const {
  if (!any_) return air.clear();
  air.floor.reshape(region_.width, region_.depth);
  air.roof.reshape(region_.width, region_.depth);
  bool any = false;
  for (int z = 0; z < region_.depth; ++z) {
    const int from = z + judged_;
    const auto floor = air.floor.row(z);
    const auto roof = air.roof.row(z);
    std::fill(floor.begin(), floor.end(), 0);
    std::fill(roof.begin(), roof.end(), 0);
    const std::uint64_t* const open = roofs_.open().row(from);
    const std::uint64_t* const carried = roofs_.carried().row(from);
    const auto hollow = [=](std::size_t i) { return open[i] | carried[i]; };
    for_set_bits(judged_, judged_ + region_.width, hollow, [&](int x) {
      floor[static_cast<std::size_t>(x - judged_)] = floor_.at(x, from);
      roof[static_cast<std::size_t>(x - judged_)] = roof_.at(x, from);
      any = true;
    });
  }
  if (!any) air.clear();
}

}  // namespace talus::terrain
