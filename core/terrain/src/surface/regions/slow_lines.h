// What the slow fields of regions say at samples, every eighth column, line after line.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/vectors/aligned.h>

#include "kernels/regions.h"
#include "noise/rotated_fbm.h"
#include "surface/regions/regions.h"

namespace talus::terrain {

/// A line of samples: a row of each of Slow, padded.
using SlowLine = std::array<AlignedVector<float>, kSlowCount>;

/// Keeps the last two lines, and what they need of those beside them. For one thread at a time.
class SlowLines {
 public:
  SlowLines(const SlowFields& fields, const RotatedNoise& shape, InstructionSet set);

  /// From here on lines are of these samples: ascending base columns, multiples of kSampleStep.
  void start(std::span<const std::int64_t> samples);

  /// The line at z, a multiple of kSampleStep, valid until a third line is asked for.
  [[nodiscard]] const SlowLine& at(std::int64_t z);

 private:
  /// The rivers' noise on a line, at the samples and one step to either side of each.
  struct RiverLine {
    std::int64_t z = 0;
    bool drawn = false;
    std::array<std::vector<float>, 3> noise;
  };
  /// Where the noise is read on a line: as many as there are columns. Padded.
  struct WarpLine {
    std::vector<std::int32_t> east;
    std::vector<std::int32_t> south;
  };
  struct WarpNoise {
    explicit WarpNoise(InstructionSet set) : east{set}, east_narrow{set}, south{set}, south_narrow{set} {}
    void start(const SlowFields& fields, std::span<const std::int64_t> columns);
    RotatedFbm east, east_narrow, south, south_narrow;
  };
  struct Beside {
    std::size_t west = 0;  // in columns_
    std::size_t here = 0;
    std::size_t east = 0;
  };
  struct Line {
    std::int64_t z = 0;
    bool drawn = false;
    SlowLine values;
  };

  void draw(std::int64_t z, SlowLine& line);
  void draw_rivers(std::int64_t z, SlowLine& line);
  void draw_shape(std::int64_t z, SlowLine& line);
  void warp(WarpNoise& noise, std::int64_t z, std::size_t width, WarpLine& line) const;
  [[nodiscard]] const RiverLine& rivers_at(std::int64_t z);

  const SlowFields& fields_;
  const RegionKernels* kernels_;
  const RotatedNoise& shape_noise_;
  std::vector<std::int64_t> samples_;
  std::vector<std::int64_t> columns_;  // samples and those one step west and east of them
  std::vector<Beside> beside_;         // a sample
  WarpNoise warp_at_samples_;
  WarpNoise warp_at_columns_;
  RotatedFbm continents_, ranges_, hilliness_, mesas_, temperature_, moisture_, shape_;
  std::array<RotatedFbm, 3> rivers_;
  WarpLine warp_;
  WarpLine half_warp_;
  WarpLine river_warp_;
  std::array<Line, 2> lines_;
  std::array<RiverLine, 4> river_lines_;
};

}  // namespace talus::terrain
