// Numbers in a preview of a world.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

#include <talus/map/column_grid.h>
#include <talus/progress/progress_bar.h>

namespace talus::tools {

struct NamedShare {
  std::string name;
  terrain::Colour colour;
  double share = 0;  // 0 to 1
};

struct HeightAt {
  double voxels = 0;  // above the sea, or above y = 0 if there is no sea
  std::int64_t x = 0;
  std::int64_t z = 0;
};

/// Numbers of a grid's columns: heights of the surface before talus and erosion, and looks.
struct LandNumbers {
  double water = 0;               // share of columns
  std::vector<NamedShare> looks;  // shares of land, largest first; empty in a world without looks
  HeightAt highest;
  HeightAt deepest;
  double highest_possible = 0;  // maximum of any column of the world, in voxels above the same zero
  std::vector<double> heights;  // shares of columns by height, from deepest to highest in equal steps
  std::array<double, 3>
      steep{};  // share of land above 35, 45 and 60 degrees, in squares spread over the grid
};
[[nodiscard]] LandNumbers measure_land(const terrain::World& world, const map::ColumnGrid& grid, int threads,
                                       ProgressBar& progress);

/// Shares of the materials seen from above in a region, largest first.
[[nodiscard]] std::vector<NamedShare> materials_on_top(const terrain::World& world,
                                                       const terrain::Region& region, int threads,
                                                       ProgressBar& progress);

/// Measured on 16 squares of 128 x 128 base columns spread over a grid. Times are CPU time of one thread on
/// this machine, and vary between runs.
struct CostNumbers {
  double ns_a_column = 0;      // from the world to stacks
  double ns_a_chunk = 0;       // from stacks to the bytes of a chunk that is not uniform
  double chunks_a_column = 0;  // mixed chunks per 32 x 32 columns
  double bytes_a_chunk = 0;    // of such a chunk, encoded
  std::int64_t max_bytes = 0;
};
[[nodiscard]] CostNumbers measure_cost(const terrain::World& world, const map::ColumnGrid& grid,
                                       ProgressBar& progress);

}  // namespace talus::tools
