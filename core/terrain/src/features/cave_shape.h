// The shape of caves before their roofs are checked: one interval of air in each column. Private to
// core/terrain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "features/cave_plan.h"
#include "noise/fbm_rows.h"

namespace talus::terrain {

/// A pure function of position, row after row. Keeps its memory from one start() to the next. For one thread
/// at a time.
class CaveShape {
 public:
  CaveShape(const CavePlan& plan, InstructionSet set)
      : plan_{plan}, tunnels_{set}, chambers_{set}, climb_{set} {}

  /// From here on rows are over these ascending base columns.
  void start(std::span<const std::int64_t> xs);

  /// The air at (xs[i], z), from floor_fx[i] to roof_fx[i] in subvoxels of level 0; both 0 where there is
  /// none, and outside `first` <= i < `last`. Whether there is any.
  bool row(std::int64_t z, std::size_t first, std::size_t last, std::int32_t* floor_fx,
           std::int32_t* roof_fx);

  /// No floor lies lower.
  [[nodiscard]] std::int32_t lowest_floor_fx() const;

 private:
  void open(std::int32_t tunnel_noise, std::int32_t chamber_noise, float climb_noise, std::int32_t& floor_fx,
            std::int32_t& roof_fx) const;

  CavePlan plan_;
  FbmRows tunnels_;
  FbmRows chambers_;
  FbmRows climb_;
  std::size_t width_ = 0;
  std::vector<std::int32_t> tunnel_noise_;
  std::vector<std::int32_t> chamber_noise_;
};

}  // namespace talus::terrain
