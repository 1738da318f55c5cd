// Repeats table 1 of the thesis: run times of both methods by the size of the terrain.
#pragma once

#include <string>
#include <vector>

#include <talus/terrain/world.h>
#include <talus/tools/failure.h>
#include <talus/tools/world_file.h>

#include <talus/progress/progress_bar.h>
#include "spread.h"

namespace talus::tools {

/// Seconds, as mean and deviation over the seeds.
struct Table1Row {
  int side = 0;  // columns, and voxels per terrain unit: always one terrain unit
  Spread erosion;
  Spread slope;
  double erosion_steps = 0;  // mean
  Spread thesis_erosion;
  Spread thesis_slope;
};

struct Table1 {
  std::vector<Table1Row> rows;
  int seeds = 0;
  /// Exponents p of seconds ~ side^p, by least squares over the logarithms.
  double erosion_growth = 0;
  double slope_growth = 0;
  double thesis_erosion_growth = 0;
  double thesis_slope_growth = 0;
};

/// Generates `seeds` complete terrains of each size by both methods on one thread: surface, strata and loose
/// material, with the erosion method run to rest. Seeds are 1, 2, ...
[[nodiscard]] Expected<Table1> run_table1(const WorldText& text, int seeds, ProgressBar& progress);

/// A table for humans.
[[nodiscard]] std::string to_text(const Table1& table);
/// All figures as JSON, by name.
[[nodiscard]] std::string to_json(const Table1& table);
/// An SVG picture: seconds by side, both axes logarithmic, together with the thesis' figures.
[[nodiscard]] std::string to_svg(const Table1& table);

}  // namespace talus::tools
