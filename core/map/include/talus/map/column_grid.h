// Samples of base columns at equal distances, for views of a world from afar.
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

/// Base columns (x + every * i, z + every * k) for 0 <= i < width and 0 <= k < depth.
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
  /// The grid with `ring` more columns on every side.
  [[nodiscard]] ColumnGrid expanded(int ring) const {
    return {x - every * ring, z - every * ring, every, width + 2 * ring, depth + 2 * ring};
  }
  /// The columns of a rectangle that starts at column (i, k).
  [[nodiscard]] ColumnGrid part(int i, int k, int part_width, int part_depth) const {
    return {x_of(i), z_of(k), every, part_width, part_depth};
  }
};

/// A grid with column (x, z) in its middle, at i = width / 2, k = depth / 2.
[[nodiscard]] ColumnGrid grid_around(std::int64_t x, std::int64_t z, std::int64_t every, int width,
                                     int depth);

/// PlaceSampler's results for a grid's columns.
struct ColumnSamples {
  terrain::Field heights_fx;               // H, before talus and erosion move it
  terrain::LookField looks;                // numbers of World::look_names(); 0 in a world without looks
  std::vector<std::vector<float>> values;  // one vector per requested name; z slowest, then x
};

/// Samples a grid in pieces. Columns outside the world get the values of the nearest column inside. All names
/// must be among place_names() of the world, which must outlive this.
class ColumnSampler {
 public:
  ColumnSampler(const terrain::World& world, const ColumnGrid& grid, std::span<const std::string> names = {});
  /// Samples some rows; false when no rows are left.
  bool step();
  [[nodiscard]] ColumnSamples take() { return std::move(samples_); }

 private:
  const ColumnGrid grid_;
  terrain::PlaceSampler sampler_;
  const bool has_looks_;
  std::vector<std::size_t> place_of_;  // for each column of the grid, its index in the sampler's row
  ColumnSamples samples_;
  int next_row_ = 0;
};

/// Computes, in pieces, the slope at a grid's columns: eq. 1 with the neighbours to the east, the south and
/// the south-east. REQUIRES grid.every > 1.
class SlopeSampler {
 public:
  SlopeSampler(const terrain::World& world, const ColumnGrid& grid);
  /// Computes some rows; false when no rows are left.
  bool step();
  /// Subvoxels per base column.
  [[nodiscard]] terrain::Field take() { return std::move(slopes_fx_); }

 private:
  const ColumnGrid grid_;
  terrain::PlaceSampler sampler_;
  terrain::Field slopes_fx_;
  int next_row_ = 0;
};

/// Runs a ColumnSampler to its end.
[[nodiscard]] ColumnSamples sample_columns(const terrain::World& world, const ColumnGrid& grid,
                                           std::span<const std::string> names = {});

}  // namespace talus::map
