// The slow fields of regions at samples, every sixteenth column, line by line.
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

/// A line of samples: a row of each of Slow, then of each of SlowFields::others; padded.
using SlowLine = std::vector<AlignedVector<float>>;

/// A line with its rise per column eastward and southward, if requested, for the rows of Slow that shape the
/// land. Not for temperature, moisture and other fields.
struct SlopedLine {
  SlowLine values;
  SlowLine east;
  SlowLine south;
};

/// Keeps the last lines; not thread-safe.
class SlowLines {
 public:
  SlowLines(const SlowFields& fields, const RotatedNoise& shape, const RegionShape& land, InstructionSet set);

  /// The following lines are of these samples: ascending base columns, multiples of kSampleStep.
  void start(std::span<const std::int64_t> samples, bool sloped);

  /// Returns the line at z, a multiple of kSampleStep. Valid as long as all requested lines are at most 3
  /// kSampleStep away.
  [[nodiscard]] const SlopedLine& at(std::int64_t z);

 private:
  /// Displacement along one axis of the positions where noises are read on a line. Padded.
  struct Warp {
    std::vector<std::int32_t> displacement;
    std::vector<std::int32_t> half;
    AlignedVector<float> by_x;
    AlignedVector<float> by_z;
    [[nodiscard]] Stretch stretch() { return {by_x.data(), by_z.data()}; }
  };
  struct Line {
    std::int64_t z = 0;
    bool drawn = false;
    SlopedLine line;
  };

  void warp(RotatedFbm& wide, RotatedFbm& narrow, std::int64_t z, Warp& warp) const;
  void draw(std::int64_t z, SlopedLine& line);
  void lay(std::int64_t z, SlopedLine& line);
  void lay_sloped(std::int64_t z, SlopedLine& line);
  void draw_rivers(std::int64_t z, SlopedLine& line);
  void draw_rivers_in_parts(std::int64_t z, SlopedLine& line);
  void draw_terraces_in_parts(std::int64_t z, SlopedLine& line);
  void draw_shape(std::int64_t z, SlopedLine& line);

  const SlowFields& fields_;
  const RotatedNoise& shape_noise_;
  const RegionShape& land_;
  const RegionKernels* kernels_;
  std::size_t width_ = 0;
  bool sloped_ = false;
  RotatedFbm warp_east_, warp_east_narrow_, warp_south_, warp_south_narrow_;
  RotatedFbm continents_, ranges_, hilliness_, mesas_, temperature_, moisture_, shape_;
  std::array<RotatedFbm, 3> rivers_;
  std::vector<RotatedFbm> others_;
  Warp east_;
  Warp south_;
  std::array<std::array<AlignedVector<float>, 2>, 5> bent_;  // derivatives of a field
  AlignedVector<float> level_;  // derivatives of fields that are treated as level
  std::array<Line, 4> lines_;
};

}  // namespace talus::terrain
