// A world in numbers: whether its land looks alike from every side, how different its places are, and how
// steep, broken and high it is.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <talus/terrain/world.h>

#include <talus/progress/progress_bar.h>
#include "band_power.h"

namespace talus::tools {

/// How many places are looked at. They lie up to 2^24 columns from the origin, the same in every world.
struct QualityOptions {
  int threads = 0;    // 0: one a core
  int spectra = 240;  // windows of 256 x 256 samples a band
  int blocks = 200;   // of kBlockSide base columns a side
  int windows = 64;   // of every base column
  int window_side = 1024;
  int lattice_places = 40'000;  // points and middles of cells, of each noise

  /// A tenth of them, for a first look.
  [[nodiscard]] static QualityOptions quick(int threads);
};

inline constexpr int kBlockSide = 4800;
inline constexpr int kBlockEvery = 50;  // base columns between two that are looked at
inline constexpr std::array kSlopeDegrees{35, 45, 60};

struct QualityBand {
  int from = 0;  // base columns
  int to = 0;
  BandRatio power;
};

/// What covers how many blocks more than anything else does, and how much of all.
struct QualityKind {
  std::string name;
  bool ground = true;  // not water
  int blocks = 0;
  double share = 0;
};

/// Heights where a noise has the lattice points of its first octave, and in the middles of its cells.
struct QualityLattice {
  std::string noise;
  double at_points = 0;  // means, voxels
  double at_middles = 0;
  double apart = 0;  // in standard deviations of heights
  double error = 0;  // standard, of that, if the places were independent
};

struct QualityPlace {
  double voxels = 0;
  std::int64_t x = 0;
  std::int64_t z = 0;
};

struct QualityWish {
  std::string what;
  std::string measured;
  bool met = false;
};

/// Shares are of 1. Heights are those of the surface before talus and erosion move it, over the sea, or over
/// y = 0 where there is none.
struct Quality {
  QualityOptions options;
  std::vector<QualityBand> bands;

  double water_mean = 0;  // of the blocks' shares of water
  double water_deviation = 0;
  std::array<double, 5> water_percentiles{};  // least, 10, 50, 90 %, most
  std::vector<QualityKind> kinds;             // by blocks, then share
  int kinds_somewhere = 0;                    // kinds of ground that cover most of a block

  double window_water = 0;                           // share of columns in windows
  double lone_water = 0;                             // share of that water in lone pieces
  double inland_water = 0;                           // in pieces that touch no window's edge
  QualityPlace largest_step;                         // between two columns that share an edge
  std::array<double, kSlopeDegrees.size()> steep{};  // of land
  // Of surfaces of kind "regions" alone:
  bool regions = false;
  std::vector<QualityLattice> lattices;
  QualityPlace other_step;   // the largest that no terrace makes
  double beds = 0;           // share of columns in windows that are a river's bed, half a voxel deep or more
  double fading_beds = 0;    // share of those where the river fades away in the hills
  QualityPlace highest_bed;  // of whole rivers, over their flood plain
  QualityPlace highest_fading_bed;  // of others

  QualityPlace highest;
  QualityPlace deepest;

  std::vector<QualityWish> wishes;
};

[[nodiscard]] Quality measure_quality(const terrain::World& world, const QualityOptions& options,
                                      ProgressBar& progress);

[[nodiscard]] std::string to_text(const Quality& quality);
[[nodiscard]] std::string to_json(const Quality& quality);

}  // namespace talus::tools
