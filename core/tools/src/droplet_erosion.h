// Hydraulic erosion of a finite height map by droplets (after Olsen, Realtime Procedural Terrain Generation,
// 2004, and Beyer, Implementation of a Method for Hydraulic Erosion, 2015): an offline step before
// generation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <talus/progress/progress_bar.h>

namespace talus::tools {

/// Heights over a grid, z slowest, then x.
struct HeightGrid {
  int width = 0;  // at least 2
  int depth = 0;  // at least 2
  std::vector<double> heights;
};

struct DropletOptions {
  std::uint64_t droplets = 0;
  std::uint64_t seed = 0;
};

/// Lets droplets fall one after another, each where the seed and its number say; it runs downhill, takes up
/// ground while it is fast, lays it down where it slows, and lays down the rest where it ends. What runs over
/// the edge is lost, nothing else is. Steepness is reckoned with the map's whole relief as one cell's length,
/// so that the unit of the heights does not matter. In doubles, in one order, with no function but sqrt: the
/// same heights on every machine.
void erode(HeightGrid& grid, const DropletOptions& options, ProgressBar& progress);

}  // namespace talus::tools
