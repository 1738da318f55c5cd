// Base columns at even distances: what is looked at of a world from afar.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <talus/terrain/field.h>
#include <talus/terrain/places.h>
#include <talus/terrain/world.h>

namespace talus::map {

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

/// Samples a grid in pieces. Columns outside of the world have what the nearest inside has. All names must be
/// among place_names() of the world, which outlives this.
class ColumnSampling {
 public:
  ColumnSampling(const terrain::World& world, const ColumnGrid& grid,
                 std::span<const std::string> names = {});
  /// Some rows; false when none is left.
  bool step();
  [[nodiscard]] ColumnSamples take() { return std::move(samples_); }

 private:
  const ColumnGrid grid_;
  terrain::PlaceSampler sampler_;
  const bool has_looks_;
  std::vector<std::size_t> place_of_;  // in the sampler's row, of each column of the grid
  ColumnSamples samples_;
  int next_row_ = 0;
};

/// How steep the ground is at a grid's columns, by eq. 1 with the neighbours to the east and the south, in
/// pieces.
class SlopeSampling {
 public:
  SlopeSampling(const terrain::World& world, const ColumnGrid& grid);
  /// Some rows; false when none is left.
  bool step();
  /// Subvoxels a base column.
  [[nodiscard]] terrain::Field take() { return std::move(slopes_fx_); }

 private:
  const ColumnGrid grid_;
  terrain::PlaceSampler sampler_;
  terrain::Field slopes_fx_;
  int next_row_ = 0;
};

/// All of a ColumnSampling.
[[nodiscard]] ColumnSamples sample_columns(const terrain::World& world, const ColumnGrid& grid,
                                           std::span<const std::string> names = {});

}  // namespace talus::map
