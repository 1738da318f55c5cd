// Hydraulic erosion of a finite height map by droplets (after Olsen, Realtime Procedural Terrain Generation,
// 2004, and Beyer, Implementation of a Method for Hydraulic Erosion, 2015): an offline step before
// generation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <talus/progress/progress_bar.h>

namespace talus::tools {

/// Heights on a grid, z slowest, then x.
struct HeightGrid {
  int width = 0;  // at least 2
  int depth = 0;  // at least 2
  std::vector<double> heights;
};

struct DropletOptions {
  std::uint64_t droplets = 0;
  std::uint64_t seed = 0;
};

/// Simulates droplets one after another, each starting at a position derived from the seed and its number. A
/// droplet runs downhill, takes up ground while it is fast, deposits some where it slows, and the rest where
/// it ends. Only ground carried over the edge is lost. Slopes use the map's total relief as the length of a
/// cell, so the unit of the heights does not matter. Uses doubles, a fixed order and no function except sqrt,
/// so heights are the same on every machine.
void erode(HeightGrid& grid, const DropletOptions& options, ProgressBar& progress);

}  // namespace talus::tools
