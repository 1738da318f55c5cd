// A height map as a surface: cubic between its samples, in integers, with a rule for the land outside.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "surface/surface_rows.h"

namespace talus::terrain {

/// Outside of its samples the map is mirrored at its edges without end, or repeats one spacing past its last
/// sample (`repeat`), or all samples are 0 (`sea`). With `blend` another surface lies there, to which the map
/// gives way over a margin within its edge.
class HeightMapRows final : public SurfaceRows {
 public:
  /// `around` must be given if and only if surface.map.outside is `blend`.
  HeightMapRows(const Surface& surface, std::unique_ptr<SurfaceRows> around);

  void start(std::span<const std::int64_t> xs) override;
  void row(std::int64_t z, std::int32_t* heights_fx) override;

 private:
  static constexpr std::int32_t kNoSample = -1;
  static constexpr std::int64_t kAllMap = std::int64_t{1} << 24;

  /// The four samples around a position along one axis, and their weights.
  struct Taps {
    std::int64_t first = 0;
    std::array<std::int32_t, 4> sample;  // index in the map, or kNoSample
    std::array<std::int64_t, 4> weight;
  };
  /// The map along one of its rows of samples, at the columns: exact, in 2^-19 subvoxel.
  struct Line {
    bool drawn = false;
    std::int64_t sample_z = 0;
    std::vector<std::int64_t> values;
  };

  [[nodiscard]] Taps taps_at(std::int64_t column, std::int64_t origin_q16, std::int64_t spacing_q16,
                             int samples) const;
  [[nodiscard]] std::int32_t sample_of(std::int64_t index, int samples) const;
  [[nodiscard]] std::int64_t share_of_map(std::int64_t column, std::int64_t origin_q16,
                                          std::int64_t spacing_q16, int samples) const;
  void draw(std::int64_t sample_z, std::int32_t map_row, Line& line) const;
  void map_row(std::int64_t z, std::int32_t* heights_fx);
  void blend_row(std::int64_t z, std::int32_t* heights_fx);

  PlacedMap map_;
  std::int32_t highest_fx_;
  std::unique_ptr<SurfaceRows> around_;
  std::vector<Taps> columns_;
  std::vector<std::int64_t> shares_;  // share of the map along x, 0 to kAllMap; only with `around`
  std::int64_t min_share_ = 0;
  std::int64_t max_share_ = 0;
  std::array<Line, 4> lines_;  // four consecutive rows of samples, each at its index modulo 4
  std::vector<std::int32_t> of_map_;
};

}  // namespace talus::terrain
