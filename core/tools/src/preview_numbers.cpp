#include "preview_numbers.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/slope.h>
#include <talus/tools/ordered_work.h>
#include <talus/tools/patch_grid.h>
#include <talus/voxel/codec.h>

namespace talus::tools {
namespace {

constexpr int kStripRows = 32;
constexpr int kHeightSteps = 96;
constexpr int kSlopeSquares = 8;  // along each side
constexpr int kSlopeSide = 96;
constexpr int kCostSquares = 4;  // along each side
constexpr int kCostSide = 128;

double cpu_ns() {
  timespec used{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return 1e9 * static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec);
}

void sort_shares(std::vector<NamedShare>& shares) {
  std::erase_if(shares, [](const NamedShare& one) { return one.share <= 0; });
  std::stable_sort(shares.begin(), shares.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
}

// The colour that the first rules show for a look.
terrain::Colour colour_of_look(const terrain::World& world, std::size_t look) {
  for (const terrain::Material& material : world.materials()) {
    const terrain::World::ShownBy* const by = world.shown_by(material.id);
    if (by != nullptr && by->looks == 0) return world.materials()[to_integer(by->by_look[look])].colour;
  }
  return {};
}

class LandTally {
 public:
  LandTally(const terrain::World& world, const map::ColumnGrid& grid)
      : world_{world}, grid_{grid}, by_look_(world.look_names().size()) {}

  void add(int first_row, const map::ColumnSamples& strip) {
    for (int k = 0; k < strip.heights_fx.depth; ++k) {
      for (int i = 0; i < strip.heights_fx.width; ++i) {
        const std::int32_t fx = strip.heights_fx.at(i, k);
        heights_.push_back(fx);
        if (heights_.size() == 1 || fx > highest_fx_) {
          highest_fx_ = fx;
          land_.highest = place(fx, i, first_row + k);
        }
        if (heights_.size() == 1 || fx < deepest_fx_) {
          deepest_fx_ = fx;
          land_.deepest = place(fx, i, first_row + k);
        }
        if (world_.sea_fx() && fx < *world_.sea_fx()) {
          ++water_;
        } else {
          ++by_look_[strip.looks.at(i, k)];
        }
      }
    }
  }

  LandNumbers take() {
    const auto columns = static_cast<double>(heights_.size());
    land_.water = static_cast<double>(water_) / columns;
    const double dry = std::max(1.0, columns - static_cast<double>(water_));
    for (std::size_t look = 0; look < by_look_.size() && by_look_.size() > 1; ++look) {
      const std::string& name = world_.look_names()[look];
      land_.looks.push_back({name.empty() ? "no look" : name, colour_of_look(world_, look),
                             static_cast<double>(by_look_[look]) / dry});
    }
    sort_shares(land_.looks);
    land_.highest_possible = over_zero(world_.highest_fx());
    land_.heights.assign(kHeightSteps, 0);
    const double range = std::max(1.0, static_cast<double>(highest_fx_) - deepest_fx_);
    for (const std::int32_t fx : heights_) {
      const double part = (static_cast<double>(fx) - deepest_fx_) / range;
      land_.heights[std::min<std::size_t>(kHeightSteps - 1, static_cast<std::size_t>(part * kHeightSteps))] +=
          1 / columns;
    }
    return std::move(land_);
  }

 private:
  [[nodiscard]] HeightAt place(std::int32_t fx, int i, int k) const {
    return {over_zero(fx), grid_.x_of(i), grid_.z_of(k)};
  }

  [[nodiscard]] double over_zero(std::int32_t fx) const {
    return static_cast<double>(fx - world_.sea_fx().value_or(0)) / terrain::kSubvoxels;
  }

  const terrain::World& world_;
  const map::ColumnGrid& grid_;
  LandNumbers land_;
  std::vector<std::int32_t> heights_;
  std::int32_t highest_fx_ = 0;
  std::int32_t deepest_fx_ = 0;
  std::int64_t water_ = 0;
  std::vector<std::int64_t> by_look_;
};

struct Steep {
  std::int64_t land = 0;
  std::array<std::int64_t, 3> above{};
};

// Square `index` of kSlopeSquares^2, with every base column.
Steep steep_in_square(const terrain::World& world, const map::ColumnGrid& grid, std::size_t index) {
  const auto apart = [&](int columns) { return grid.every * columns / kSlopeSquares; };
  const auto i = static_cast<std::int64_t>(index % kSlopeSquares);
  const auto k = static_cast<std::int64_t>(index / kSlopeSquares);
  const map::ColumnGrid square{grid.x + apart(grid.width) * i + apart(grid.width) / 2,
                               grid.z + apart(grid.depth) * k + apart(grid.depth) / 2, 1, kSlopeSide,
                               kSlopeSide};
  const terrain::Field heights_fx = map::sample_columns(world, square.expanded(1)).heights_fx;
  const terrain::Field slope = slope_inside(heights_fx);
  Steep steep;
  for (int z = 0; z < slope.depth; ++z) {
    for (int x = 0; x < slope.width; ++x) {
      if (world.sea_fx() && heights_fx.at(x + 1, z + 1) < *world.sea_fx()) continue;
      ++steep.land;
      for (std::size_t d = 0; d < 3; ++d) {
        constexpr std::array kDegrees{35.0, 45.0, 60.0};
        const double limit = terrain::kSubvoxels * std::tan(kDegrees[d] * std::numbers::pi / 180);
        if (slope.at(x, z) > limit) ++steep.above[d];
      }
    }
  }
  return steep;
}

// The material of the highest voxel that is not air.
MaterialId seen_from_above(const terrain::World& world, const terrain::Stacks& stacks,
                           const std::vector<MaterialId>& outcrops, int x, int z) {
  const std::int32_t top = stacks.ground_fx(x, z);
  const int level = stacks.region.lod.value();
  if (world.sea_fx() && top < *world.sea_fx() >> level && !stacks.is_entrance(x, z)) {
    const terrain::World::ShownBy* const by = world.shown_by(kWater);
    return by == nullptr ? kWater : by->by_look[stacks.looks[by->looks].at(x, z)];
  }
  std::size_t k = 0;
  while (k + 1 < stacks.tops.size() && stacks.tops[k].at(x, z) < top) ++k;
  const MaterialId outcrop = outcrops[static_cast<std::size_t>(z * stacks.region.width + x)];
  const bool rock = k < stacks.tops.size() - world.loose().size();
  return rock && outcrop != kAir ? outcrop : stacks.shown(world, k, x, z);
}

}  // namespace

LandNumbers measure_land(const terrain::World& world, const map::ColumnGrid& grid, int threads,
                         ProgressBar& progress) {
  progress.expect(grid.columns());
  LandTally tally{world, grid};
  const auto strips = static_cast<std::size_t>((grid.depth + kStripRows - 1) / kStripRows);
  work_in_order(
      strips, thread_count(threads),
      [&](std::size_t index) {
        const int first = static_cast<int>(index) * kStripRows;
        return map::sample_columns(world,
                                   grid.part(0, first, grid.width, std::min(kStripRows, grid.depth - first)));
      },
      [&](std::size_t index, const map::ColumnSamples& strip) {
        tally.add(static_cast<int>(index) * kStripRows, strip);
        progress.advance(strip.heights_fx.values.size());
        return true;
      });
  LandNumbers land = tally.take();
  Steep all;
  work_in_order(
      std::size_t{kSlopeSquares} * kSlopeSquares, thread_count(threads),
      [&](std::size_t index) { return steep_in_square(world, grid, index); },
      [&](std::size_t, const Steep& steep) {
        all.land += steep.land;
        for (std::size_t d = 0; d < 3; ++d) all.above[d] += steep.above[d];
        return true;
      });
  for (std::size_t d = 0; d < 3; ++d) {
    land.steep[d] =
        static_cast<double>(all.above[d]) / static_cast<double>(std::max<std::int64_t>(1, all.land));
  }
  return land;
}

std::vector<NamedShare> materials_on_top(const terrain::World& world, const terrain::Region& region,
                                         int threads, ProgressBar& progress) {
  const PatchGrid patches{region, 256};
  progress.expect(region.columns());
  std::vector<NamedShare> shares;
  for (const terrain::Material& material : world.materials())
    shares.push_back({material.name, material.colour, 0});
  work_in_order(
      patches.count(), thread_count(threads),
      [&](std::size_t index) {
        const terrain::Stacks stacks = generate_stacks(world, patches.patch(index));
        const std::vector<MaterialId> outcrops = exposed_overlays(world, stacks);
        std::vector<std::int64_t> columns(world.materials().size());
        for (int z = 0; z < stacks.region.depth; ++z) {
          for (int x = 0; x < stacks.region.width; ++x) {
            ++columns[to_integer(seen_from_above(world, stacks, outcrops, x, z))];
          }
        }
        return columns;
      },
      [&](std::size_t index, const std::vector<std::int64_t>& columns) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
          shares[i].share += static_cast<double>(columns[i]) / static_cast<double>(region.columns());
        }
        progress.advance(patches.patch(index).columns());
        return true;
      });
  sort_shares(shares);
  return shares;
}

CostNumbers measure_cost(const terrain::World& world, const map::ColumnGrid& grid, ProgressBar& progress) {
  constexpr int kSquares = kCostSquares * kCostSquares;
  progress.expect(kSquares);
  terrain::Generator generator{world};
  terrain::Stacks stacks;
  CostNumbers cost;
  double generating = 0;
  double encoding = 0;
  std::int64_t chunks = 0;
  std::int64_t bytes = 0;
  std::vector<std::byte> payload;
  for (int square = 0; square < kSquares; ++square) {
    const auto chunk_at = [&](std::int64_t first, int columns, int index) {
      const std::int64_t apart = grid.every * columns / kCostSquares;
      return floor_div(first + apart * index + apart / 2, kChunkSize);
    };
    const std::int64_t chunk_x = chunk_at(grid.x, grid.width, square % kCostSquares);
    const std::int64_t chunk_z = chunk_at(grid.z, grid.depth, square / kCostSquares);
    const terrain::Region region{chunk_x * kChunkSize, chunk_z * kChunkSize, kCostSide, kCostSide, Lod{}};
    if (square == 0) generator.generate(region, stacks);  // with warm memory, as on a server
    const double before = cpu_ns();
    generator.generate(region, stacks);
    generating += cpu_ns() - before;
    for (int i = 0; i < kCostSide / kChunkSize; ++i) {
      for (int k = 0; k < kCostSide / kChunkSize; ++k) {
        const auto x = static_cast<std::int32_t>(chunk_x + i);
        const auto z = static_cast<std::int32_t>(chunk_z + k);
        const terrain::MixedRange rows = mixed_range(world, stacks, x, z);
        for (std::int32_t y = rows.first; y <= rows.last; ++y) {
          payload.clear();
          const double begun = cpu_ns();
          const Chunk chunk = extract_chunk(world, stacks, {x, y, z});
          if (chunk.is_uniform()) continue;  // the range only bounds the mixed chunks
          encode(chunk, payload);
          encoding += cpu_ns() - begun;
          ++chunks;
          bytes += static_cast<std::int64_t>(payload.size());
          cost.max_bytes = std::max(cost.max_bytes, static_cast<std::int64_t>(payload.size()));
        }
      }
    }
    progress.advance(1);
  }
  const double columns = double{kSquares} * kCostSide * kCostSide;
  cost.ns_a_column = generating / columns;
  const auto all_chunks = static_cast<double>(std::max<std::int64_t>(1, chunks));
  cost.ns_a_chunk = encoding / all_chunks;
  cost.bytes_a_chunk = static_cast<double>(bytes) / all_chunks;
  cost.chunks_a_column = static_cast<double>(chunks) / (columns / kChunkArea);
  return cost;
}

}  // namespace talus::tools
