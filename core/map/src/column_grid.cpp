#include <talus/map/column_grid.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <utility>

#include <talus/voxel/coords.h>

namespace talus::map {
namespace {

constexpr int kSampledRows = 16;  // per step

std::int64_t inside_world(std::int64_t base) {
  const std::int64_t limit = chunk_limit(Lod{}) * kChunkSize;
  return std::clamp(base, -limit, limit - 1);
}

terrain::PlaceSampler sampler_of(const terrain::World& world, std::span<const std::string> names) {
  auto sampler = terrain::PlaceSampler::make(world, names);
  assert(sampler);
  return *std::move(sampler);
}

}  // namespace

ColumnGrid grid_around(std::int64_t x, std::int64_t z, std::int64_t every, int width, int depth) {
  return {x - every * (width / 2), z - every * (depth / 2), every, width, depth};
}

ColumnSampler::ColumnSampler(const terrain::World& world, const ColumnGrid& grid,
                             std::span<const std::string> names)
    : grid_{grid},
      sampler_{sampler_of(world, names)},
      has_looks_{world.look_names().size() > 1},
      place_of_(static_cast<std::size_t>(grid.width)) {
  // The sampler takes strictly ascending columns.
  std::vector<std::int64_t> xs;
  for (int i = 0; i < grid.width; ++i) {
    const std::int64_t x = inside_world(grid.x_of(i));
    if (xs.empty() || xs.back() != x) xs.push_back(x);
    place_of_[static_cast<std::size_t>(i)] = xs.size() - 1;
  }
  sampler_.start(xs);
  samples_.heights_fx.reshape(grid.width, grid.depth);
  samples_.looks.reshape(grid.width, grid.depth);
  // Without looks the sampler's first rules are the provinces'.
  if (!has_looks_) std::fill(samples_.looks.values.begin(), samples_.looks.values.end(), std::uint8_t{0});
  samples_.values.assign(names.size(), std::vector<float>(grid.columns()));
}

bool ColumnSampler::step() {
  const auto spread = [&](auto from, auto to) {
    for (const std::size_t place : place_of_) *to++ = from[place];
  };
  const int end = std::min(grid_.depth, next_row_ + kSampledRows);
  for (; next_row_ < end; ++next_row_) {
    sampler_.row(inside_world(grid_.z_of(next_row_)));
    spread(sampler_.heights_fx(), samples_.heights_fx.row(next_row_).begin());
    if (has_looks_) spread(sampler_.looks(), samples_.looks.row(next_row_).begin());
    for (std::size_t n = 0; n < samples_.values.size(); ++n) {
      spread(sampler_.values(n), samples_.values[n].begin() + std::ptrdiff_t{grid_.width} * next_row_);
    }
  }
  return next_row_ < grid_.depth;
}

SlopeSampler::SlopeSampler(const terrain::World& world, const ColumnGrid& grid)
    : grid_{grid}, sampler_{sampler_of(world, {})}, slopes_fx_{grid.width, grid.depth} {
  assert(grid.every > 1);  // a column and its eastern neighbour, still ascending
  std::vector<std::int64_t> xs;
  for (int i = 0; i < grid.width; ++i) {
    for (const int east : {0, 1}) xs.push_back(grid.x_of(i) + east);
  }
  sampler_.start(xs);
}

bool SlopeSampler::step() {
  std::vector<std::int32_t> here;
  const int end = std::min(grid_.depth, next_row_ + kSampledRows);
  for (; next_row_ < end; ++next_row_) {
    const std::int64_t z = grid_.z_of(next_row_);
    sampler_.row(z);
    here.assign(sampler_.heights_fx().begin(), sampler_.heights_fx().end());
    sampler_.row(z + 1);
    const std::span<const std::int32_t> south = sampler_.heights_fx();
    for (int i = 0; i < grid_.width; ++i) {
      const auto at = 2 * static_cast<std::size_t>(i);
      const std::int32_t height = here[at];
      slopes_fx_.at(i, next_row_) = std::max(
          {std::abs(here[at + 1] - height), std::abs(south[at] - height), std::abs(south[at + 1] - height)});
    }
  }
  return next_row_ < grid_.depth;
}

ColumnSamples sample_columns(const terrain::World& world, const ColumnGrid& grid,
                             std::span<const std::string> names) {
  ColumnSampler sampler{world, grid, names};
  while (sampler.step()) {
  }
  return sampler.take();
}

}  // namespace talus::map
