// What a preview says of a world in numbers.
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
  double share = 0;  // of 1
};

struct HeightAt {
  double voxels = 0;  // over the sea, or over y = 0 where there is none
  std::int64_t x = 0;
  std::int64_t z = 0;
};

/// Of a grid's columns: heights of the surface before talus and erosion move it, and looks.
struct LandNumbers {
  double water = 0;               // share of columns
  std::vector<NamedShare> looks;  // of land, the largest first; none in a world without looks
  HeightAt highest;
  HeightAt deepest;
  double highest_possible = 0;  // of any column of the world, in voxels over the same zero
  std::vector<double> heights;  // shares of columns by height, from deepest to highest in even steps
  std::array<double, 3>
      steep{};  // share of land above 35, 45 and 60 degrees, in squares spread over the grid
};
[[nodiscard]] LandNumbers measure_land(const terrain::World& world, const map::ColumnGrid& grid, int threads,
                                       ProgressBar& progress);

/// What is seen of a region from above, the largest share first.
[[nodiscard]] std::vector<NamedShare> materials_on_top(const terrain::World& world,
                                                       const terrain::Region& region, int threads,
                                                       ProgressBar& progress);

/// Of 16 squares of 128 x 128 base columns spread over a grid. Seconds are CPU time of one thread, so they
/// are this machine's and never twice the same.
struct CostNumbers {
  double ns_a_column = 0;      // from the world to stacks
  double ns_a_chunk = 0;       // from stacks to the bytes of a chunk that is not uniform
  double chunks_a_column = 0;  // chunks that are not uniform, of 32 x 32 columns
  double bytes_a_chunk = 0;    // of such chunks, encoded
  std::int64_t most_bytes = 0;
};
[[nodiscard]] CostNumbers measure_cost(const terrain::World& world, const map::ColumnGrid& grid,
                                       ProgressBar& progress);

}  // namespace talus::tools
