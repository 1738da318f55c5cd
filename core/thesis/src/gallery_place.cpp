#include "gallery_place.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <talus/terrain/generator.h>
#include <talus/terrain/heights.h>
#include <talus/terrain/settle.h>

namespace talus::tools {
namespace {

constexpr int kSquares = 12;  // squares along each side by which a place is judged
constexpr int kReach = 48;    // maximum distance of places from the origin, in squares: 8 places a side

// The height up to which strata differ. Rock above it is of one material.
std::int32_t banded_height_fx(const terrain::World& world) {
  std::int64_t sum_q16 = 0;
  std::int64_t banded_q16 = 0;
  for (std::size_t j = 0; j < world.strata().size(); ++j) {
    sum_q16 += world.strata()[j].thickness_q16;
    if (world.strata()[j].material != world.strata().back().material) banded_q16 = sum_q16;
  }
  return static_cast<std::int32_t>(
      std::min<std::int64_t>(banded_q16 * world.spec().resolution / terrain::kSubvoxels, world.highest_fx()));
}

// Rates squares of a height field, in subvoxels, by their view.
class View {
 public:
  explicit View(const terrain::World& world)
      : sea_{world.sea_fx().value_or(0)},
        highest_{world.highest_fx()},
        enough_{banded_height_fx(world) + banded_height_fx(world) / 4} {}

  [[nodiscard]] double score(const terrain::Field& heights, int x, int z) const {
    double back = 0;
    double front = 0;
    int wet = 0;
    int cut_off = 0;  // columns cut off at the world's maximum, which appear as a plateau
    std::int32_t lowest = heights.at(x, z);
    std::int32_t highest = lowest;
    for (int j = 0; j < kSquares; ++j) {
      for (int i = 0; i < kSquares; ++i) {
        const std::int32_t height = heights.at(x + i, z + j);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
        wet += height < sea_ ? 1 : 0;
        cut_off += height >= highest_ ? 1 : 0;
        (i + j < kSquares - 1 ? back : front) += std::min(height, enough_);
      }
    }
    constexpr double kHalf = kSquares * kSquares / 2.0;
    const double relief = highest - lowest;
    const double shows = std::min<double>(relief, enough_) - 0.7 * std::max(0.0, relief - enough_);
    const double water = std::min(1.0, wet / (kHalf / 4)) - 2 * std::max(0.0, wet - kHalf / 2) / kHalf;
    return (back - front) / kHalf + shows * (1 + 0.5 * water) - 0.1 * cut_off * enough_;
  }

 private:
  std::int32_t sea_;
  std::int32_t highest_;
  std::int32_t enough_;
};

}  // namespace

terrain::Region columns_of(const Place& place, const terrain::World& world) {
  const double resolution = world.spec().resolution;
  const int side = static_cast<int>(std::lround(place.side * resolution));
  return {std::llround(place.x * resolution), std::llround(place.z * resolution), side, side, Lod{}};
}

Place scenic_place(const terrain::World& world, double side) {
  const double square = side / kSquares;
  constexpr int kAcross = 2 * kReach + kSquares;
  std::vector<terrain::BaseColumn> columns;
  const auto column = [&](int i) { return std::llround((i - kReach) * square * world.spec().resolution); };
  for (int j = 0; j < kAcross; ++j) {
    for (int i = 0; i < kAcross; ++i) columns.push_back({column(i), column(j)});
  }
  terrain::Field heights{kAcross, kAcross};
  const auto all = surface_heights(world, columns);
  heights.values.assign(all.begin(), all.end());
  const View view{world};
  int best_x = 0;
  int best_z = 0;
  double best = -1e300;
  for (int z = 0; z + kSquares <= kAcross; ++z) {
    for (int x = 0; x + kSquares <= kAcross; ++x) {
      const double here = view.score(heights, x, z);
      if (here <= best) continue;
      best = here;
      best_x = x;
      best_z = z;
    }
  }
  return {(best_x - kReach) * square, (best_z - kReach) * square, side};
}

terrain::Region settling_place(const terrain::World& world, const terrain::Region& region, int side) {
  const terrain::Terrain terrain = generate_terrain(world, region);
  std::vector<std::int64_t> removed(region.columns());
  for (std::size_t m = 0; m < world.loose().size(); ++m) {
    const terrain::LooseSpec& loose = world.loose()[m];
    const terrain::Field start = starting_thickness(terrain.slope, loose.t_fx, loose.S_fx);
    for (std::size_t i = 0; i < removed.size(); ++i) {
      removed[i] += start.values[i] - terrain.loose[m].values[i];
    }
  }
  const int step = std::max(1, side / 4);
  terrain::Region best{region.x, region.z, side, side, region.lod};
  std::int64_t most = -1;
  for (int z = 0; z + side <= region.depth; z += step) {
    for (int x = 0; x + side <= region.width; x += step) {
      std::int64_t sum = 0;
      for (int j = z; j < z + side; ++j) {
        for (int i = x; i < x + side; ++i) {
          sum += removed[static_cast<std::size_t>(j) * static_cast<std::size_t>(region.width) +
                         static_cast<std::size_t>(i)];
        }
      }
      if (sum <= most) continue;
      most = sum;
      best.x = region.x + x;
      best.z = region.z + z;
    }
  }
  return best;
}

}  // namespace talus::tools
