#include "features/cave_carver.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include <talus/terrain/boundary_row.h>

namespace talus::terrain {
namespace {

constexpr std::int32_t kFarBelow = -(1 << 28);
constexpr int kNowhere = 1 << 20;  // farther than any span

}  // namespace

CaveCarver::CaveCarver(const CavePlan& plan, const World& world, InstructionSet set)
    : plan_{plan},
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
  // Two rows at least, so that the topmost can be of loose material and rock is under it.
  least_rows_ = std::max(2, ((plan_.roof_fx >> level) + kSubvoxels - 1) / kSubvoxels);
  const std::int32_t lowest = boundary_row(std::max(kSubvoxels, shape_.lowest_floor_fx() >> level));
  least_fx_ = (lowest + least_rows_ - 1) * kSubvoxels + loose_fx_;
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
  shape_.start(xs_);
  floor_.reshape(judged.width, judged.depth);
  roof_.reshape(judged.width, judged.depth);
}

void CaveCarver::compute_rows(int count, const Field& height) {
  const Region judged = region_.expanded(judged_);
  const std::int64_t step = std::int64_t{1} << region_.lod.value();
  const int last = std::min(judged.depth, next_ + count);
  if (next_ == 0) airy_.assign(static_cast<std::size_t>(judged.depth), 0);
  for (; next_ < last; ++next_) {
    const Hollow thick = thick_enough(next_, height);
    const bool air =
        shape_.row((judged.z + next_) * step, static_cast<std::size_t>(thick.first),
                   static_cast<std::size_t>(thick.last), floor_.row(next_).data(), roof_.row(next_).data());
    airy_[static_cast<std::size_t>(next_)] = air ? 1 : 0;
    any_ |= air;
  }
  if (next_ < judged.depth) return;
  pending_ = false;
  if (any_) judge_all(height);
}

// Columns of the row between which ground is high enough for a cave and its roof: many worlds' seas and
// plains are not.
CaveCarver::Hollow CaveCarver::thick_enough(int z, const Field& height) const {
  const auto row = height.row(z + shore_).subspan(static_cast<std::size_t>(shore_));
  const int level = region_.lod.value();
  const auto thick = [&](int x) { return row[static_cast<std::size_t>(x)] >> level > least_fx_; };
  Hollow columns{0, floor_.width};
  while (columns.first < columns.last && !thick(columns.first)) ++columns.first;
  while (columns.first < columns.last && !thick(columns.last - 1)) --columns.last;
  return columns;
}

void CaveCarver::judge_all(const Field& height) {
  const Region judged = region_.expanded(judged_);
  surface_.reshape(judged.width, judged.depth);
  roof_row_.reshape(judged.width, judged.depth);
  rock_row_.reshape(judged.width, judged.depth);
  kinds_.assign(judged.columns(), Kind::solid);
  hollows_.assign(static_cast<std::size_t>(judged.depth), {});
  lowest_.clear();
  for (int z = 0; shore_ != 0 && z < height.depth; ++z) {
    std::int32_t lowest = std::numeric_limits<std::int32_t>::max();
    for (const std::int32_t height_fx : height.row(z)) lowest = std::min(lowest, height_fx);
    lowest_.push_back(lowest);
  }
  const auto airy = [&](int z) {
    return z >= 0 && z < judged.depth && airy_[static_cast<std::size_t>(z)] != 0;
  };
  for (int z = 0; z < judged.depth; ++z) {
    if (airy(z - 1) || airy(z) || airy(z + 1)) judge_row(z, height);
  }
  find_carried();
  find_entrances();
}

void CaveCarver::find_entrances() {
  if (std::find(kinds_.begin(), kinds_.end(), Kind::open) == kinds_.end()) return;
  const Region around = region_.expanded(open_ring_);
  entrances_.reshape(around.width, around.depth);
  std::fill(entrances_.values.begin(), entrances_.values.end(), kClosed);
  const int ring = judged_ - open_ring_;
  for (int z = 0; z < around.depth; ++z) {
    const Hollow hollow = hollows_[static_cast<std::size_t>(z + ring)];
    const int last = std::min(hollow.last - ring, around.width);
    for (int x = std::max(hollow.first - ring, 0); x < last; ++x) {
      const std::size_t i = index(x + ring, z + ring);
      if (kinds_[i] == Kind::open) entrances_.at(x, z) = floor_.values[i];
    }
  }
}

void CaveCarver::judge_row(int z, const Field& height) {
  const auto surface = surface_.row(z);
  const auto rock_row = rock_row_.row(z);
  const auto from = height.row(z + shore_).subspan(static_cast<std::size_t>(shore_), surface.size());
  const int level = region_.lod.value();
  const std::int32_t loose_fx = loose_fx_;
  for (std::size_t x = 0; x < surface.size(); ++x) {
    surface[x] = from[x] >> level;
    rock_row[x] = boundary_row(surface[x] - loose_fx);
  }
  std::fill(roof_row_.row(z).begin(), roof_row_.row(z).end(), kFarBelow);
  shore_near_ = shore_ != 0 && !all_dry(z);
  const auto roof = roof_.row(z);
  for (int x = 0; x < surface_.width; ++x) {
    if (roof[static_cast<std::size_t>(x)] == 0) continue;
    judge(x, z, height);
    if (kinds_[index(x, z)] == Kind::solid) continue;
    Hollow& hollow = hollows_[static_cast<std::size_t>(z)];
    if (hollow.last == 0) hollow.first = x;
    hollow.last = x + 1;
  }
}

// Whether even the lowest column of the row and of those beside it is over the sea.
bool CaveCarver::all_dry(int z) const {
  const auto first = lowest_.begin() + z;
  const int level = region_.lod.value();
  return (*std::min_element(first, first + 3) >> level) - (erodes_ ? loose_fx_ : 0) > sea_fx_ >> level;
}

void CaveCarver::judge(int x, int z, const Field& height) {
  const int level = region_.lod.value();
  std::int32_t& floor_fx = floor_.at(x, z);
  std::int32_t& roof_fx = roof_.at(x, z);
  floor_fx = std::max(kSubvoxels, floor_fx >> level);
  roof_fx >>= level;
  const std::int32_t floor_row = boundary_row(floor_fx);
  const std::int32_t roof_row = boundary_row(roof_fx);
  std::int32_t& rock_row = rock_row_.at(x, z);
  if (floor_row >= roof_row || rock_row - floor_row < least_rows_) return;
  bool dry = true;
  if (shore_near_) {
    std::int32_t lowest = surface_.at(x, z);
    for (int south = 0; south <= 2; ++south) {
      for (int east = 0; east <= 2; ++east)
        lowest = std::min(lowest, height.at(x + east, z + south) >> level);
    }
    dry = lowest - (erodes_ ? loose_fx_ : 0) > sea_fx_ >> level;
    if (!dry) rock_row = std::min(rock_row, boundary_row(lowest - loose_fx_));
  }
  Kind& kind = kinds_[index(x, z)];
  if (rock_row - roof_row >= least_rows_) {
    kind = Kind::roofed;
    roof_row_.at(x, z) = roof_row;
  } else if (dry) {
    kind = Kind::open;
    rock_row = kFarBelow;
  }
}

int CaveCarver::carry(std::size_t from, int distance, std::size_t to) const {
  if (kinds_[to] != Kind::roofed) return kinds_[to] == Kind::solid ? 0 : kNowhere;
  const bool touch = std::max(roof_row_.values[from], roof_row_.values[to]) <
                     std::min(rock_row_.values[from], rock_row_.values[to]);
  return touch && distance < span_ ? distance + 1 : kNowhere;
}

// A straight line of roofs that touch, from a column that is solid from below. Its every part is such a line
// too, so that what is kept is carried by what is kept.
void CaveCarver::find_carried() {
  const int reach = std::min(span_, judged_);
  const int first_x = judged_;
  const int last_x = judged_ + region_.width - 1;
  const int first_z = judged_;
  const int last_z = judged_ + region_.depth - 1;
  carried_.assign(kinds_.size(), 0);
  const auto walk_row = [&](int z, int from, int to, int step) {
    int distance = kinds_[index(from, z)] == Kind::solid ? 0 : kNowhere;
    for (int x = from; x != to; x += step) {
      distance = carry(index(x, z), distance, index(x + step, z));
      if (distance <= span_) carried_[index(x + step, z)] = 1;
    }
  };
  for (int z = first_z; z <= last_z; ++z) {
    const Hollow hollow = hollows_[static_cast<std::size_t>(z)];
    if (hollow.last == 0) continue;
    const int west = std::max(hollow.first - 1, first_x - reach);
    const int east = std::min(hollow.last, last_x + reach);
    if (west < std::min(east, last_x)) walk_row(z, west, std::min(east, last_x), 1);
    if (east > std::max(west, first_x)) walk_row(z, east, std::max(west, first_x), -1);
  }
  const auto walk_columns = [&](int from, int to, int step) {
    distances_.assign(static_cast<std::size_t>(region_.width), kNowhere);
    for (int x = first_x; x <= last_x; ++x) {
      if (kinds_[index(x, from)] == Kind::solid) distances_[static_cast<std::size_t>(x - first_x)] = 0;
    }
    for (int z = from; z != to; z += step) {
      const Hollow hollow = hollows_[static_cast<std::size_t>(z + step)];
      const int first = std::clamp(hollow.first, first_x, last_x + 1);
      const int last = std::clamp(hollow.last, first, last_x + 1);
      std::fill(distances_.begin(), distances_.begin() + (first - first_x), 0);
      std::fill(distances_.begin() + (last - first_x), distances_.end(), 0);
      for (int x = first; x < last; ++x) {
        int& distance = distances_[static_cast<std::size_t>(x - first_x)];
        distance = carry(index(x, z), distance, index(x, z + step));
        if (distance <= span_) carried_[index(x, z + step)] = 1;
      }
    }
  };
  walk_columns(first_z - reach, last_z, 1);
  walk_columns(last_z + reach, first_z, -1);
}

void CaveCarver::take(CaveAir& air) const {
  if (!any_) return air.clear();
  air.floor.reshape(region_.width, region_.depth);
  air.roof.reshape(region_.width, region_.depth);
  bool any = false;
  for (int z = 0; z < region_.depth; ++z) {
    const auto floor = air.floor.row(z);
    const auto roof = air.roof.row(z);
    std::fill(floor.begin(), floor.end(), 0);
    std::fill(roof.begin(), roof.end(), 0);
    const Hollow hollow = hollows_[static_cast<std::size_t>(z + judged_)];
    const int last = std::min(hollow.last - judged_, region_.width);
    for (int x = std::max(hollow.first - judged_, 0); x < last; ++x) {
      const std::size_t i = index(x + judged_, z + judged_);
      const bool open = kinds_[i] == Kind::open;
      if (!open && (kinds_[i] != Kind::roofed || carried_[i] == 0)) continue;
      floor[static_cast<std::size_t>(x)] = floor_.values[i];
      roof[static_cast<std::size_t>(x)] = open ? surface_.values[i] : roof_.values[i];
      any = true;
    }
  }
  if (!any) air.clear();
}

}  // namespace talus::terrain
