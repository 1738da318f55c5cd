// How alike the loose layers of both methods are on one and the same input.
#pragma once

#include <string>
#include <vector>

#include <talus/progress/progress_bar.h>
#include "failure.h"
#include "spread.h"
#include "world_file.h"

namespace talus::tools {

/// How far two layers of loose material over the same columns agree.
struct Alike {
  double cover_a = 0;  // share of the columns in which there is any
  double cover_b = 0;
  double overlap = 0;      // columns with both over columns with either; 1 where there are none
  double unrelated = 0;    // what `overlap` would be if the covers had nothing to do with each other
  double correlation = 0;  // Pearson's, of the thickness over all columns; 0 where one of them is even
};
[[nodiscard]] Alike alike(const terrain::Field& a, const terrain::Field& b);

/// The figures of one material, or of all materials together.
struct LikenessRow {
  std::string name;
  Spread cover_slope;
  Spread cover_erosion;
  Spread overlap;
  Spread unrelated;
  Spread correlation;
};

struct Likeness {
  int seeds = 0;
  int side = 0;                   // columns
  int resolution = 0;             // voxels a terrain unit
  std::vector<LikenessRow> rows;  // all loose material first, then each, the heaviest first
};

/// The slope method (a) beside erosion to rest (b) on the world's surface with the seeds 1, 2, ..., over a
/// square of two terrain units from the origin on. Erosion takes the square for a map that ends.
[[nodiscard]] Expected<Likeness> measure_likeness(const WorldText& text, int seeds, ProgressBar& progress);

/// A table for people.
[[nodiscard]] std::string to_text(const Likeness& likeness);
/// All figures as JSON, by name.
[[nodiscard]] std::string to_json(const Likeness& likeness);

}  // namespace talus::tools
