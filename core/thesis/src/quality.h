// Measures a world: isotropy of its land, diversity of its places, and steepness, roughness and heights.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <talus/terrain/world.h>

#include <talus/progress/progress_bar.h>
#include "band_power.h"

namespace talus::tools {

/// Number of places measured, up to 2^24 columns from the origin, the same in every world.
struct QualityOptions {
  int threads = 0;    // 0: one per core
  int spectra = 240;  // windows of 256 x 256 samples per band
  int blocks = 200;   // squares of kBlockSide base columns
  int windows = 64;   // windows with every base column
  int window_side = 1024;
  int lattice_places = 40'000;  // points and centres of cells, for each noise

  /// A tenth of the places, for a first impression.
  [[nodiscard]] static QualityOptions quick(int threads);
};

inline constexpr int kBlockSide = 4800;
inline constexpr int kBlockEvery = 50;  // base columns between samples
inline constexpr std::array kSlopeDegrees{35, 45, 60};

struct QualityBand {
  int from = 0;  // base columns
  int to = 0;
  BandRatio power;
};

/// A kind of ground: number of blocks in which it is the largest, and its share of all.
struct QualityKind {
  std::string name;
  bool ground = true;  // not water
  int blocks = 0;
  double share = 0;
};

/// Heights at the lattice points of a noise's first octave, and at the centres of its cells.
struct QualityLattice {
  std::string noise;
  double at_points = 0;  // means, voxels
  double at_middles = 0;
  double apart = 0;  // difference, in standard deviations of heights
  double error = 0;  // standard error of `apart`, assuming independent places
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

/// Shares are 0 to 1. Heights are the surface's before talus and erosion, above the sea, or above y = 0 if
/// there is no sea.
struct Quality {
  QualityOptions options;
  std::vector<QualityBand> bands;

  double water_mean = 0;  // mean share of water in blocks
  double water_deviation = 0;
  std::array<double, 5> water_percentiles{};  // minimum, 10, 50, 90 %, maximum
  std::vector<QualityKind> kinds;             // by blocks, then share
  int kinds_somewhere = 0;                    // kinds of ground that cover most of a block

  double window_water = 0;                           // share of columns in windows
  double lone_water = 0;                             // share of this water in lone pieces
  double inland_water = 0;                           // share in pieces that touch no window's edge
  QualityPlace largest_step;                         // between two adjacent columns
  std::array<double, kSlopeDegrees.size()> steep{};  // shares of land
  // Only for surfaces of kind "regions":
  bool regions = false;
  std::vector<QualityLattice> lattices;
  QualityPlace other_step;   // largest step not made by a terrace
  double beds = 0;           // share of columns in windows in a river's bed, at least half a voxel deep
  double fading_beds = 0;    // share of these beds on rivers that fade out in the hills
  QualityPlace highest_bed;  // complete rivers, above their flood plain
  QualityPlace highest_fading_bed;  // fading rivers

  QualityPlace highest;
  QualityPlace deepest;

  std::vector<QualityWish> wishes;
};

[[nodiscard]] Quality measure_quality(const terrain::World& world, const QualityOptions& options,
                                      ProgressBar& progress);

[[nodiscard]] std::string to_text(const Quality& quality);
[[nodiscard]] std::string to_json(const Quality& quality);

}  // namespace talus::tools
