#include "loose/aprons.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

#include "spec/units.h"

namespace talus::terrain {
namespace {

constexpr std::int32_t kSteepestRepose_fx = 1 << 20;
constexpr int kMinCliffReach = 2;  // columns of a coarse level

// Multiplies by sqrt(2).
std::int32_t along_diagonal(std::int32_t straight) {
  return (straight * 362) >> 8;
}

// Returns true in every second step, from the first: diagonals are used only there, so that reach is an
// octagon, not a square.
bool along_diagonals(int step) {
  return step % 2 == 1;
}

// Number of steps by which an apron spreads from its wall: until it has no thickness left.
int spreads(const ApronNumbers& numbers) {
  if (numbers.steps == 0 || numbers.share_q8 == 0 || numbers.max_fx == 0) return 0;
  return (numbers.max_fx - 1) / numbers.c_fx;
}

// Halo of the aprons: feet and means around their walls, and one column for smoothing.
int raised_halo(const ApronNumbers& numbers) {
  const int steps = spreads(numbers);
  return steps == 0 ? 0 : numbers.steps + steps + 1;
}

int cliff_halo(const ApronNumbers& numbers) {
  if (numbers.cliff_by_slope) return numbers.walls_beside.any != 0 ? 1 : 0;
  return std::max(0, numbers.cliff_reach - 1);
}

std::size_t inner_columns(int side, int ring) {
  return static_cast<std::size_t>(side - 2 * ring);
}

// Converts `range`, relative to `ring`, to columns of the field.
ColumnRange counted_from_field(ColumnRange range, int ring) {
  const auto columns = static_cast<std::size_t>(ring);
  return range.last == 0 ? range : ColumnRange{range.first + columns, range.last + columns};
}

// The part of `range` that is at least `ring` columns away from the ends of a row.
ColumnRange known_columns(ColumnRange range, int width, int ring) {
  const auto first = static_cast<std::size_t>(ring);
  const ColumnRange inside{std::max(range.first, first),
                           std::min(range.last, static_cast<std::size_t>(width) - first)};
  return inside.first < inside.last ? inside : ColumnRange{};
}

ColumnRange hull(ColumnRange a, ColumnRange b) {
  if (a.last == 0) return b;
  if (b.last == 0) return a;
  return {std::min(a.first, b.first), std::max(a.last, b.last)};
}

}  // namespace

ApronNumbers apron_numbers(const TalusSpec& talus, const LooseSpec& loose, int resolution) {
  const double voxels = resolution;
  ApronNumbers numbers;
  numbers.wall_fx = loose.S_fx;
  numbers.c_fx = loose.c_fx;
  numbers.max_fx = static_cast<std::int32_t>(rounded(talus.thickness * voxels * kSubvoxels));
  numbers.share_q8 = static_cast<std::int32_t>(rounded(talus.share * 256));
  numbers.steps = static_cast<int>(std::bit_ceil(static_cast<unsigned>(rounded(talus.reach * voxels))));
  numbers.cliff_reach = static_cast<int>(rounded(talus.cliff * voxels));
  return numbers;
}

ApronNumbers apron_numbers(const World& world) {
  const TalusSpec& talus = *world.spec().talus;
  ApronNumbers numbers = apron_numbers(talus, world.loose()[talus.of], world.spec().resolution);
  if (world.sea_fx()) numbers.bare_fx = *world.sea_fx();
  return numbers;
}

ApronNumbers at_level(ApronNumbers numbers, Lod lod) {
  const int level = lod.value();
  numbers.c_fx = static_cast<std::int32_t>(
      std::min<std::int64_t>(std::int64_t{numbers.c_fx} << level, kSteepestRepose_fx));
  numbers.steps >>= level;
  const int reach = numbers.cliff_reach >> level;
  numbers.cliff_by_slope = level > 0 && numbers.cliff_reach > 0 && reach < kMinCliffReach;
  if (numbers.cliff_by_slope && reach == 1) numbers.walls_beside = {8, 5};
  if (numbers.cliff_by_slope && reach == 0 && numbers.cliff_reach >> (level - 1) == 1) {
    numbers.walls_beside = {5, 2};
  }
  numbers.cliff_reach = numbers.cliff_by_slope ? 0 : reach;
  return numbers;
}

int apron_halo(const ApronNumbers& numbers) {
  return std::max(raised_halo(numbers), cliff_halo(numbers));
}

void Aprons::compute(const Field& height, const Field& slope, int margin, const ApronNumbers& numbers,
                     Field& raised, Field& cliff, int cliff_ring) {
  assert(margin >= apron_halo(numbers) && height.width == slope.width && height.depth == slope.depth);
  assert(numbers.steps == 0 || std::has_single_bit(static_cast<unsigned>(numbers.steps)));
  near_walls(slope, margin + cliff_ring, numbers, cliff);
  // Every pass reads neighbours, so its results end one ring farther in, and finally at the region.
  int ring = margin - raised_halo(numbers);
  if (spreads(numbers) == 0 || !start_feet(height, slope, numbers, ring)) {
    height.crop_into(margin, raised);
    return;
  }
  find_feet(slope, numbers, ring);
  find_means(height, numbers.steps, ring);
  ring += numbers.steps;
  if (!begin(height, slope, numbers, ring)) {
    height.crop_into(margin, raised);
    return;
  }
  spread(numbers, ring);
  ring += spreads(numbers);
  for (int z = ring; z < height.depth - ring; ++z) {
    kernels_->cover(&next_.at(ring, z), inner_columns(height.width, ring), &surface_.at(ring, z));
  }
  raised.reshape(height.width - 2 * margin, height.depth - 2 * margin);
  const auto stride = static_cast<std::size_t>(height.width);
  for (int z = margin; z < height.depth - margin; ++z) {
    kernels_->finish(&surface_.at(margin - 1, z - 1), stride, height.row(z).data() + margin,
                     &next_.at(margin, z), inner_columns(height.width, margin), numbers.c_fx, numbers.bare_fx,
                     raised.row(z - margin).data());
  }
}

bool Aprons::start_feet(const Field& height, const Field& slope, const ApronNumbers& numbers, int ring) {
  feet_.reshape(height.width, height.depth);
  next_.reshape(height.width, height.depth);
  active_.assign(static_cast<std::size_t>(height.depth), {});
  first_ = height.depth;
  last_ = 0;
  const std::size_t width = inner_columns(height.width, ring);
  for (int z = ring; z < height.depth - ring; ++z) {
    const ColumnRange walls =
        kernels_->start_feet(height.row(z).data() + ring, slope.row(z).data() + ring, width, numbers.wall_fx,
                             &feet_.at(ring, z), &next_.at(ring, z));
    if (walls.last == 0) continue;
    active_[static_cast<std::size_t>(z)] = counted_from_field(walls, ring);
    first_ = std::min(first_, z);
    last_ = z + 1;
  }
  return first_ < last_;
}

// In rows without walls both fields have the ground from the start.
void Aprons::find_feet(const Field& slope, const ApronNumbers& numbers, int ring) {
  const auto stride = static_cast<std::size_t>(slope.width);
  for (int step = 1; step <= numbers.steps; ++step) {
    ++ring;
    for (int z = std::max(ring, first_); z < std::min(slope.depth - ring, last_); ++z) {
      const ColumnRange columns = known_columns(active_[static_cast<std::size_t>(z)], slope.width, ring);
      if (columns.last == 0) continue;
      const auto x = static_cast<int>(columns.first);
      kernels_->descend(&feet_.at(x - 1, z - 1), stride, slope.row(z).data() + x,
                        columns.last - columns.first, numbers.wall_fx, along_diagonals(step),
                        &next_.at(x, z));
    }
    std::swap(feet_, next_);
  }
}

// A tent of 2 steps - 1 columns, as two boxes along each axis, where a box of 2^k columns is k additions of
// the elements 1, 2, 4, .. farther on. The mean of column (steps - 1 + ring + x, ..) is stored at (x, ..).
// Computes only rows that walls need.
void Aprons::find_means(const Field& height, int steps, int ring) {
  const int halvings = std::countr_zero(static_cast<unsigned>(steps));
  std::size_t width = inner_columns(height.width, ring);
  const int past_first = ring + steps - 1;
  const int first = std::max(0, first_ - past_first);
  int last = std::min(height.depth - ring, last_ + steps - 1) - ring;
  means_.reshape(height.width, height.depth);
  for (int z = first; z < last; ++z) {
    std::int32_t* const row = means_.row(z).data();
    std::copy_n(height.row(z + ring).data() + ring, width, row);
    std::size_t left = width;
    for (int box = 0; box < 2; ++box) {
      for (std::size_t past = 1; past < static_cast<std::size_t>(steps); past *= 2) {
        left -= past;
        kernels_->add(row + past, left, row);
      }
      kernels_->halve(left, halvings, row);
    }
  }
  width -= 2 * static_cast<std::size_t>(steps - 1);
  for (int box = 0; box < 2; ++box) {
    for (int past = 1; past < steps; past *= 2) {
      last -= past;
      for (int z = first; z < last; ++z) {
        kernels_->add(means_.row(z + past).data(), width, means_.row(z).data());
      }
    }
    for (int z = first; z < last; ++z) kernels_->halve(width, halvings, means_.row(z).data());
  }
}

bool Aprons::begin(const Field& height, const Field& slope, const ApronNumbers& numbers, int ring) {
  floor_.reshape(height.width, height.depth);
  surface_.reshape(height.width, height.depth);
  const std::int32_t enough_fx = (numbers.max_fx * 256 + numbers.share_q8 - 1) / numbers.share_q8;
  const ApronSupply supply{numbers.wall_fx, numbers.max_fx, numbers.share_q8, enough_fx};
  active_.assign(active_.size(), {});
  bool any = false;
  for (int z = ring; z < height.depth - ring; ++z) {
    const ColumnRange begins =
        kernels_->begin(height.row(z).data() + ring, slope.row(z).data() + ring, &feet_.at(ring, z),
                        &means_.at(1, z - ring + 1), inner_columns(height.width, ring), supply,
                        {&floor_.at(ring, z), &next_.at(ring, z), &surface_.at(ring, z)});
    active_[static_cast<std::size_t>(z)] = counted_from_field(begins, ring);
    any |= begins.last != 0;
  }
  return any;
}

// An apron grows by one column and one row per step. Columns beyond are skipped: there both fields have no
// tops from the start.
void Aprons::spread(const ApronNumbers& numbers, int ring) {
  const auto stride = static_cast<std::size_t>(floor_.width);
  const std::int32_t diagonal_fx = along_diagonal(numbers.c_fx);
  const int steps = spreads(numbers);
  std::fill(feet_.values.begin(), feet_.values.end(), -kNoGround_fx);
  spread_.assign(active_.size(), {});
  for (int step = 1; step <= steps; ++step) {
    ++ring;
    std::swap(feet_, next_);
    for (int z = ring; z < floor_.depth - ring; ++z) {
      const auto row = static_cast<std::size_t>(z);
      const ColumnRange near = hull(active_[row - 1], hull(active_[row], active_[row + 1]));
      if (near.last == 0) continue;
      const ColumnRange columns = known_columns({near.first - 1, near.last + 1}, floor_.width, ring);
      spread_[row] = columns;
      if (columns.last == 0) continue;
      const auto x = static_cast<int>(columns.first);
      kernels_->spread(&feet_.at(x - 1, z - 1), stride, &floor_.at(x, z), columns.last - columns.first,
                       numbers.c_fx, along_diagonals(step) ? diagonal_fx : 0,
                       numbers.max_fx - numbers.c_fx * step, &next_.at(x, z));
    }
    std::swap(active_, spread_);
  }
}

void Aprons::near_walls(const Field& slope, int margin, const ApronNumbers& numbers, Field& cliff) {
  cliff.reshape(slope.width - 2 * margin, slope.depth - 2 * margin);
  if (numbers.cliff_by_slope) return near_walls_by_slope(slope, margin, numbers, cliff);
  if (numbers.cliff_reach == 0) {
    std::fill(cliff.values.begin(), cliff.values.end(), 0);
    return;
  }
  const int halo = cliff_halo(numbers);
  const int ring = margin - halo;
  if (!distances_.start_at_walls(slope, ring, numbers.wall_fx, kCliff)) {
    std::fill(cliff.values.begin(), cliff.values.end(), 0);
    return;
  }
  const std::int32_t straight = (kCliff + numbers.cliff_reach - 1) / numbers.cliff_reach;
  distances_.settle(Rise{straight, along_diagonal(straight)});
  at_walls_.assign(static_cast<std::size_t>(cliff.width), kCliff);
  for (int z = 0; z < cliff.depth; ++z) {
    distances_.with_row(z + halo, [&](const auto* row) { lower(row + halo, cliff.row(z)); });
  }
}

void Aprons::lower(const std::int16_t* far, std::span<std::int32_t> cliff) const {
  columns_->lower_int16(at_walls_.data(), far, cliff.size(), cliff.data());
}

void Aprons::lower(const std::int32_t* far, std::span<std::int32_t> cliff) const {
  columns_->lower_int32(at_walls_.data(), far, cliff.size(), cliff.data());
}

// A column on ground nearly as steep as a wall is near one; less slope suffices next to walls.
void Aprons::near_walls_by_slope(const Field& slope, int margin, const ApronNumbers& numbers, Field& cliff) {
  const std::int32_t wall_fx = numbers.wall_fx;
  const WallsBeside& beside = numbers.walls_beside;
  const auto eighths = [&](std::int32_t rise) {
    return (rise > wall_fx ? beside.any : 0) + (rise > 2 * wall_fx ? beside.sheer : 0);
  };
  for (int z = 0; z < cliff.depth; ++z) {
    for (int x = 0; x < cliff.width; ++x) {
      const std::int32_t* const own = slope.row(z + margin).data() + margin + x;
      int walls = 0;
      if (beside.any != 0) {
        walls = eighths(own[-1]) + eighths(own[1]) + eighths(own[-slope.width]) + eighths(own[slope.width]);
      }
      const std::int32_t near = 16 * std::min(*own, wall_fx) + (walls - 8) * wall_fx;
      cliff.at(x, z) = kCliff * std::clamp(near, 0, 8 * wall_fx) / (8 * wall_fx);
    }
  }
}

}  // namespace talus::terrain
