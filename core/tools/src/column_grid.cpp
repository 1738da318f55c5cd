#include "column_grid.h"

#include <algorithm>
#include <cassert>

#include <talus/voxel/coords.h>

namespace talus::tools {
namespace {

std::int64_t inside_world(std::int64_t base) {
  const std::int64_t limit = chunk_limit(Lod{}) * kChunkSize;
  return std::clamp(base, -limit, limit - 1);
}

}  // namespace

ColumnGrid grid_around(std::int64_t x, std::int64_t z, std::int64_t every, int width, int depth) {
  return {x - every * (width / 2), z - every * (depth / 2), every, width, depth};
}

ColumnSamples sample_columns(const terrain::World& world, const ColumnGrid& grid,
                             std::span<const std::string> names) {
  auto sampler = terrain::PlaceSampler::make(world, names);
  assert(sampler);
  // The sampler takes ascending columns, each once.
  std::vector<std::int64_t> xs;
  std::vector<std::size_t> place_of(static_cast<std::size_t>(grid.width));
  for (int i = 0; i < grid.width; ++i) {
    const std::int64_t x = inside_world(grid.x_of(i));
    if (xs.empty() || xs.back() != x) xs.push_back(x);
    place_of[static_cast<std::size_t>(i)] = xs.size() - 1;
  }
  sampler->start(xs);
  ColumnSamples samples;
  samples.heights_fx.reshape(grid.width, grid.depth);
  samples.looks.reshape(grid.width, grid.depth);
  // Without looks the sampler's first rules are those of provinces.
  const bool has_looks = world.look_names().size() > 1;
  if (!has_looks) std::fill(samples.looks.values.begin(), samples.looks.values.end(), std::uint8_t{0});
  samples.values.assign(names.size(), std::vector<float>(grid.columns()));
  const auto spread = [&](auto from, auto to) {
    for (std::size_t i = 0; i < place_of.size(); ++i) to[i] = from[place_of[i]];
  };
  for (int k = 0; k < grid.depth; ++k) {
    sampler->row(inside_world(grid.z_of(k)));
    spread(sampler->heights_fx(), samples.heights_fx.row(k));
    if (has_looks) spread(sampler->looks(), samples.looks.row(k));
    for (std::size_t n = 0; n < names.size(); ++n) {
      spread(sampler->values(n), samples.values[n].begin() + std::ptrdiff_t{grid.width} * k);
    }
  }
  return samples;
}

}  // namespace talus::tools
