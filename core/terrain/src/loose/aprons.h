// Talus aprons, the scree that cliffs shed and that leans on their feet (docs/DESIGN.md "Talus aprons"), and
// the nearness of each column to a cliff. Private to core/terrain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/vectors/aligned.h>
#include <talus/vectors/instruction_set.h>

#include "kernels/aprons.h"
#include "kernels/columns.h"
#include "loose/settle_grid.h"

namespace talus::terrain {

/// By how much each wall among the four adjacent columns makes a column count as nearer to a wall, in
/// eighths: `any`, plus `sheer` if it is more than twice as steep as walls are.
struct WallsBeside {
  int any = 0;
  int sheer = 0;
};

/// Columns are a level's; heights (`_fx`) are always in level 0's subvoxels.
struct ApronNumbers {
  std::int32_t wall_fx = 0;   // a column is a wall if its slope is above this
  std::int32_t c_fx = 1;      // rise per column at repose, 1 to 2^20
  std::int32_t max_fx = 0;    // maximum thickness of an apron, 0 to 2^20; 0: no aprons
  std::int32_t share_q8 = 0;  // part of the height of surrounding rock above a foot, 0 to 1024 (= 4)
  int steps = 0;              // search distance for a wall's foot and rock, in columns: 1, 2, 4, .. 32, or 0
  std::int32_t bare_fx = -(1 << 29);  // aprons are at most H - bare_fx thick, so that beds stay free; to 2^23
  int cliff_reach = 0;  // distance from a wall that counts as near, in columns, up to 4096; 0: no distance
  bool cliff_by_slope = false;  // uses the slope instead if columns are too far apart
  WallsBeside walls_beside;     // used if cliff_by_slope
};

/// The numbers of a [talus] of that loose material at level 0, without the sea.
[[nodiscard]] ApronNumbers apron_numbers(const TalusSpec& talus, const LooseSpec& loose, int resolution);
/// The numbers of a world's [talus] at level 0. REQUIRES that it has one.
[[nodiscard]] ApronNumbers apron_numbers(const World& world);

/// Converts the numbers of level 0 to a level's columns, 2^level base columns apart.
[[nodiscard]] ApronNumbers at_level(ApronNumbers numbers, Lod lod);

/// Number of columns around a region whose height and slope must be known so that the results in the whole
/// region are those of the endless plane.
[[nodiscard]] int apron_halo(const ApronNumbers& numbers);

/// Nearness to a cliff in the cliff's own columns: the maximum of `cliff` in Aprons::compute.
inline constexpr std::int32_t kCliff = 4096;

/// Reuses its memory from call to call; not thread-safe.
class Aprons {
 public:
  explicit Aprons(InstructionSet set)
      : kernels_{&apron_kernels(set)}, columns_{&column_kernels(set)}, distances_{set} {}

  /// `height`, 0 to 2^23, and `slope` (eq. 1) cover a region.expanded(margin), margin >= apron_halo(numbers).
  /// Outputs: `raised`, H with its aprons, covers the region. `cliff` covers the region without its outermost
  /// `cliff_ring` columns: from kCliff at walls to 0 at cliff_reach columns from them, by octagonal distance;
  /// or, with cliff_by_slope, kCliff times clamp(2 slope / wall + walls beside - 1, 0, 1). Outputs must not
  /// alias inputs.
  void compute(const Field& height, const Field& slope, int margin, const ApronNumbers& numbers,
               Field& raised, Field& cliff, int cliff_ring = 0);

 private:
  // `ring`: distance from the edges of the fields to the known columns.
  bool start_feet(const Field& height, const Field& slope, const ApronNumbers& numbers, int ring);
  void find_feet(const Field& slope, const ApronNumbers& numbers, int ring);
  void find_means(const Field& height, int steps, int ring);
  bool begin(const Field& height, const Field& slope, const ApronNumbers& numbers, int ring);
  void spread(const ApronNumbers& numbers, int ring);
  void near_walls(const Field& slope, int margin, const ApronNumbers& numbers, Field& cliff);
  /// Converts distances from walls to nearness.
  void lower(const std::int16_t* far, std::span<std::int32_t> cliff) const;
  void lower(const std::int32_t* far, std::span<std::int32_t> cliff) const;
  static void near_walls_by_slope(const Field& slope, int margin, const ApronNumbers& numbers, Field& cliff);

  const ApronKernels* kernels_;
  const ColumnKernels* columns_;
  SettleGrid distances_;
  std::vector<std::int32_t> at_walls_;  // kCliff in each column of a row
  Field feet_;                          // feet, later tops of aprons; swapped with next_ in each step
  Field next_;
  Field means_;
  Field floor_;
  Field surface_;
  std::vector<ColumnRange> active_;  // by row: columns with walls, later columns that aprons may have reached
  std::vector<ColumnRange> spread_;
  int first_ = 0;  // all walls are in rows [first_, last_)
  int last_ = 0;
};

}  // namespace talus::terrain
