// The shape of caves before roofs are checked: one interval of air per column. Private to core/terrain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <talus/voxel/coords.h>

#include "features/cave_plan.h"
#include "kernels/caves.h"
#include "noise/fbm_rows.h"

namespace talus::terrain {

/// A pure function of position, row by row. Reuses its memory from one start() to the next; not thread-safe.
class CaveShape {
 public:
  CaveShape(const CavePlan& plan, InstructionSet set)
      : plan_{plan}, kernels_{cave_kernels(set)}, tunnels_{set}, chambers_{set}, climb_{set} {}

  /// The following rows are over these ascending base columns, in subvoxels of the level.
  void start(std::span<const std::int64_t> xs, Lod lod);

  /// Computes the air at (xs[i], z), from floor_fx[i] to roof_fx[i]; both 0 without air, and outside of
  /// `within`. Returns true if there is air.
  bool row(std::int64_t z, ColumnRange within, std::int32_t* floor_fx, std::int32_t* roof_fx);

  /// The lowest possible floor, in subvoxels of level 0.
  [[nodiscard]] std::int32_t lowest_floor_fx() const;

 private:
  CavePlan plan_;
  const CaveKernels& kernels_;
  FbmRows tunnels_;
  FbmRows chambers_;
  FbmRows climb_;
  std::size_t width_ = 0;
  int level_ = 0;
};

}  // namespace talus::terrain
