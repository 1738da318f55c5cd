// Folds and faults: how far the strata are lifted at a column, or sunk. Private to the room.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/fbm.h>
#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

#include "fbm_rows.h"
#include "point_fbm.h"

namespace talus::terrain {

/// A strike as a direction: lines that run along it have `x cos + z sin` in common. In 2^-16, fixed when a
/// world is read, so that no machine's cosine decides a voxel.
struct Strike {
  std::int64_t cos_q16 = 0;
  std::int64_t sin_q16 = 0;

  /// Distances of a base column across the strike and along it, in 2^-16 column.
  [[nodiscard]] std::int64_t across_q16(std::int64_t x, std::int64_t z) const {
    return x * cos_q16 + z * sin_q16;
  }
  [[nodiscard]] std::int64_t along_q16(std::int64_t x, std::int64_t z) const {
    return z * cos_q16 - x * sin_q16;
  }
};

/// The folds of a spec in the numbers they are computed with.
struct FoldField {
  Fbm noise;
  Strike strike;
  std::int64_t shrink_q16 = 0;  // of distances along the strike
  float amplitude_fx = 0;
};
[[nodiscard]] FoldField fold_field(const WorldSpec& spec);

/// One set of faults.
struct FaultField {
  std::uint64_t seed = 0;
  Strike strike;
  std::int64_t spacing_q16 = 0;  // of a column
  std::int64_t throw_fx = 0;
  Fbm wander;
  float waviness_fx = 0;

  /// How far block `index` is lifted: -throw / 2 to throw / 2.
  [[nodiscard]] std::int32_t lift_fx(std::int64_t index) const;
};
[[nodiscard]] FaultField fault_field(const WorldSpec& spec, std::size_t set);

/// No column's strata are lifted or sunk farther. In 2^-16 terrain unit.
[[nodiscard]] std::int64_t greatest_bend_q16(const WorldSpec& spec);

/// Keeps its memory from region to region. For one thread at a time.
class Bends {
 public:
  Bends(const WorldSpec& spec, InstructionSet set);

  /// Whether all strata lie level.
  [[nodiscard]] bool none() const { return !folded_ && faults_.empty(); }

  /// The lift in subvoxels of level 0 at all (x, z) of two ascending lists of base columns: a pure function
  /// of the column.
  void cover(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, Field& lift_fx);

 private:
  /// Columns along one axis among the lattice of folds: a column lies `past` eighths of the way from one
  /// point to another.
  struct Lattice {
    struct Place {
      std::size_t before = 0;
      std::size_t after = 0;
      std::int32_t past = 0;
    };
    std::vector<std::int64_t> points;  // base columns, ascending
    std::vector<Place> places;         // one a column
    void cover(std::span<const std::int64_t> columns);
  };

  void fold(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, Field& lift_fx);
  void fault(const FaultField& faults, std::span<const std::int64_t> xs, std::span<const std::int64_t> zs,
             Field& lift_fx);
  [[nodiscard]] std::int32_t fold_at(std::int64_t x, std::int64_t z);

  bool folded_;
  FoldField folds_;
  PointFbm fold_noise_;
  std::vector<FaultField> faults_;
  FbmRows wander_;
  Lattice east_;
  Lattice south_;
  Field coarse_;
  std::vector<std::int32_t> between_;  // a row of the lattice's points, in eighths of a subvoxel
};

}  // namespace talus::terrain
