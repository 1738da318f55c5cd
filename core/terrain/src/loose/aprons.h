// Talus aprons: scree that cliffs shed and that leans on their feet (docs/DESIGN.md "Talus aprons"), and how
// near a cliff each column is. Private to core/terrain.
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

/// How much nearer a wall a column counts for each that is one of the four beside it, in eighths; and how
/// much more where that is twice as steep as walls are.
struct WallsBeside {
  int any = 0;
  int sheer = 0;
};

/// Columns are those of a level, heights (`_fx`) always level 0's subvoxels.
struct ApronNumbers {
  std::int32_t wall_fx = 0;   // a column is wall where its slope is above that
  std::int32_t c_fx = 1;      // rise per column at repose, 1 to 2^20
  std::int32_t most_fx = 0;   // no apron is thicker, 0 to 2^20; 0: no aprons
  std::int32_t share_q8 = 0;  // of the rock around that stands above a foot, 0 to 1024 (= 4)
  int steps = 0;              // columns in which a wall's foot is looked for, and rock: 1, 2, 4, .. 32, or 0
  std::int32_t bare_fx = -(1 << 29);  // no apron is thicker than H - bare_fx, so that beds are free; to 2^23
  int cliff_reach = 0;                // columns from a wall that count as near, up to 4096; 0: none
  bool cliff_by_slope = false;        // instead, as columns are too far apart
  WallsBeside walls_beside;           // then
};

/// What [talus] says of aprons of that loose material, at level 0, but for the sea.
[[nodiscard]] ApronNumbers apron_numbers(const TalusSpec& talus, const LooseSpec& loose, int resolution);
/// What a world's [talus] says, at level 0. REQUIRES that it has one.
[[nodiscard]] ApronNumbers apron_numbers(const World& world);

/// The same ground at a level's columns, 2^level base columns apart, given the numbers of level 0.
[[nodiscard]] ApronNumbers at_level(ApronNumbers numbers, Lod lod);

/// How many columns beyond a region height and slope must be known so that all over the region the results
/// are those of the endless plane.
[[nodiscard]] int apron_halo(const ApronNumbers& numbers);

/// How near cliffs are that stand in a column: `Aprons::compute`'s `cliff` there.
inline constexpr std::int32_t kCliff = 4096;

/// Keeps its memory from call to call. For one thread at a time.
class Aprons {
 public:
  explicit Aprons(InstructionSet set)
      : kernels_{&apron_kernels(set)}, columns_{&column_kernels(set)}, distances_{set} {}

  /// `height`, 0 to 2^23, and `slope` (eq. 1) cover a region.expanded(margin), margin >= apron_halo(numbers).
  /// What comes out covers the region: `raised`, H with its aprons, and `cliff`, the region without its
  /// outermost `cliff_ring` columns: from kCliff at walls to 0 at cliff_reach columns from them, by octagonal
  /// distance; or, by slope, clamp(2 slope / wall + walls beside - 1, 0, 1) of that. Neither is an input.
  void compute(const Field& height, const Field& slope, int margin, const ApronNumbers& numbers,
               Field& raised, Field& cliff, int cliff_ring = 0);

 private:
  // `ring`: how many columns from the edges of the fields what is known begins.
  bool start_feet(const Field& height, const Field& slope, const ApronNumbers& numbers, int ring);
  void find_feet(const Field& slope, const ApronNumbers& numbers, int ring);
  void find_means(const Field& height, int steps, int ring);
  bool begin(const Field& height, const Field& slope, const ApronNumbers& numbers, int ring);
  void spread(const ApronNumbers& numbers, int ring);
  void near_walls(const Field& slope, int margin, const ApronNumbers& numbers, Field& cliff);
  /// How near a wall columns so far from one are.
  void lower(const std::int16_t* far, std::span<std::int32_t> cliff) const;
  void lower(const std::int32_t* far, std::span<std::int32_t> cliff) const;
  static void near_walls_by_slope(const Field& slope, int margin, const ApronNumbers& numbers, Field& cliff);

  const ApronKernels* kernels_;
  const ColumnKernels* columns_;
  SettleGrid distances_;
  std::vector<std::int32_t> at_walls_;  // kCliff in each column of a row
  Field feet_;                          // these two by turns: feet, then the tops of aprons
  Field next_;
  Field means_;
  Field floor_;
  Field surface_;
  std::vector<ColumnRange> active_;  // of each row: where walls are, then where aprons may have come
  std::vector<ColumnRange> spread_;
  int first_ = 0;  // rows among which all walls are, to before the last
  int last_ = 0;
};

}  // namespace talus::terrain
