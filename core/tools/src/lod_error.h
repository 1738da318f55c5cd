// How far each level of detail lies from level 0.
#pragma once

#include <string>
#include <vector>

#include <talus/terrain/world.h>

#include <talus/progress/progress_bar.h>
#include "failure.h"

namespace talus::tools {

/// Lengths in base voxels, over all base columns of a region; a base column lies under the level's column of
/// which it is a part.
struct LodErrorRow {
  int level = 0;
  double mean_surface = 0;  // |H of the level - H of level 0|
  double most_surface = 0;
  double mean_voxels = 0;  // the same of the tops of their highest solid voxels: what is drawn
  double most_voxels = 0;
  double same_material = 0;   // share of the columns that show the same material from above, without objects
  double same_elsewhere = 0;  // the same away from rivers that the level widens
  double same_at_own = 0;     // the same of the base columns alone that the level's columns sample
  double skyline = 0;         // how far 95 % of the skyline's columns are off at most, in the level's voxels
};

/// Skylines are those of squares of kSkylineDepth base columns, from the west and from the south: at each
/// column the highest row of the ground or the sea behind it.
inline constexpr int kSkylineDepth = 512;

struct LodError {
  int side = 0;                   // base columns
  std::vector<LodErrorRow> rows;  // levels 1 to 6
};

/// Over the base columns of `region`, which is square, of level 0, and aligned to the columns of level 6.
[[nodiscard]] LodError measure_lod_error(const terrain::World& world, const terrain::Region& region,
                                         int threads, ProgressBar& progress);

/// A table for people.
[[nodiscard]] std::string to_text(const LodError& error);
/// All figures as JSON, by name.
[[nodiscard]] std::string to_json(const LodError& error);

}  // namespace talus::tools
