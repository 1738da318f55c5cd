// Base columns at even distances: what is looked at of a world from afar.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <talus/terrain/field.h>
#include <talus/terrain/places.h>
#include <talus/terrain/world.h>

namespace talus::tools {

/// Base columns (x + every * i, z + every * k), i below width and k below depth.
struct ColumnGrid {
  std::int64_t x = 0;
  std::int64_t z = 0;
  std::int64_t every = 1;  // 1 or more
  int width = 0;
  int depth = 0;

  [[nodiscard]] std::int64_t x_of(int i) const { return x + every * i; }
  [[nodiscard]] std::int64_t z_of(int k) const { return z + every * k; }
  [[nodiscard]] std::size_t columns() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(depth);
  }
  /// With `ring` more of them on every side.
  [[nodiscard]] ColumnGrid expanded(int ring) const {
    return {x - every * ring, z - every * ring, every, width + 2 * ring, depth + 2 * ring};
  }
  /// Those of a rectangle whose first is (i, k).
  [[nodiscard]] ColumnGrid part(int i, int k, int part_width, int part_depth) const {
    return {x_of(i), z_of(k), every, part_width, part_depth};
  }
};

/// A grid with that base column in its middle: it is that of i = width / 2, k = depth / 2.
[[nodiscard]] ColumnGrid grid_around(std::int64_t x, std::int64_t z, std::int64_t every, int width,
                                     int depth);

/// What PlaceSampler says of a grid's columns.
struct ColumnSamples {
  terrain::Field heights_fx;               // H, before talus and erosion move it
  terrain::LookField looks;                // numbers of World::look_names(); 0 in a world without looks
  std::vector<std::vector<float>> values;  // of each name asked for; z slowest, then x
};

/// On the calling thread. Columns outside of the world have what the nearest inside has. All names must be
/// among place_names() of the world.
[[nodiscard]] ColumnSamples sample_columns(const terrain::World& world, const ColumnGrid& grid,
                                           std::span<const std::string> names = {});

}  // namespace talus::tools
