// Deviation of each level of detail from level 0.
#pragma once

#include <string>
#include <vector>

#include <talus/terrain/world.h>
#include <talus/tools/failure.h>

#include <talus/progress/progress_bar.h>

namespace talus::tools {

/// Lengths in base voxels, over all base columns of a region, each compared with the level's column that
/// contains it.
struct LodErrorRow {
  int level = 0;
  double mean_surface = 0;  // |H of the level - H of level 0|
  double max_surface = 0;
  double mean_voxels = 0;  // mean difference of the tops of the highest solid voxels, as drawn
  double max_voxels = 0;
  double same_material = 0;   // share of columns that show the same material from above, without objects
  double same_elsewhere = 0;  // `same_material` away from rivers that the level widens
  double same_at_own = 0;     // `same_elsewhere` for the base columns that the level samples
  double skyline = 0;         // error that 95 % of the skyline's columns do not exceed, in the level's voxels
};

/// Side of the squares, in base columns, whose skylines are compared, from the west and from the south: for
/// each column the highest row of the ground or the sea behind it.
inline constexpr int kSkylineDepth = 512;

struct LodError {
  int side = 0;                   // base columns
  std::vector<LodErrorRow> rows;  // levels 1 to 6
};

/// Measures the base columns of `region`, a square of level 0 aligned to the columns of level 6.
[[nodiscard]] LodError measure_lod_error(const terrain::World& world, const terrain::Region& region,
                                         int threads, ProgressBar& progress);

/// A table for humans.
[[nodiscard]] std::string to_text(const LodError& error);
/// All figures as JSON, by name.
[[nodiscard]] std::string to_json(const LodError& error);

}  // namespace talus::tools
