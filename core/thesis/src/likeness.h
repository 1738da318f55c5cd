// Compares the loose layers of both methods on the same input.
#pragma once

#include <string>
#include <vector>

#include <talus/progress/progress_bar.h>
#include <talus/tools/failure.h>
#include <talus/tools/world_file.h>
#include "spread.h"

namespace talus::tools {

/// Agreement of two layers of loose material over the same columns.
struct Alike {
  double cover_a = 0;  // share of the columns with any material
  double cover_b = 0;
  double overlap = 0;      // columns with both, divided by columns with either; 1 if there are none
  double unrelated = 0;    // expected `overlap` of independent covers
  double correlation = 0;  // Pearson's, of the thickness over all columns; 0 if either is constant
};
[[nodiscard]] Alike alike(const terrain::Field& a, const terrain::Field& b);

/// Figures of one material, or of all materials together.
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
  int resolution = 0;             // voxels per terrain unit
  std::vector<LikenessRow> rows;  // all loose material first, then each one, heaviest first
};

/// Compares the slope method (a) with erosion to rest (b) on the world's surface with seeds 1, 2, ..., over a
/// square of two terrain units from the origin on. Erosion treats the square as a finite map.
[[nodiscard]] Expected<Likeness> measure_likeness(const WorldText& text, int seeds, ProgressBar& progress);

/// A table for humans.
[[nodiscard]] std::string to_text(const Likeness& likeness);
/// All figures as JSON, by name.
[[nodiscard]] std::string to_json(const Likeness& likeness);

}  // namespace talus::tools
