// Loose material over a field in the layout of the settling kernels: rows padded on all sides, int16 if that
// holds every thickness. Private to core/terrain.
#pragma once

#include <cstddef>
#include <cstdint>

#include <talus/terrain/field.h>
#include <talus/vectors/aligned.h>

#include "kernels/settle.h"

namespace talus::terrain {

/// Reuses its memory from one start to the next; not thread-safe.
class SettleGrid {
 public:
  explicit SettleGrid(InstructionSet set) : kernels_{&settle_kernels(set)} {}

  /// Sets the thickness before settling (eq. 3) over `slope`.
  void start(const Field& slope, std::int32_t thickness_fx, std::int32_t max_slope_fx);
  /// start() row by row: call begin(), with the maximum thickness, then start_row() for each row.
  void begin(int width, int depth, std::int32_t max_fx) { reshape(width, depth, max_fx); }
  void start_row(int z, const std::int32_t* slope, std::int32_t thickness_fx, std::int32_t max_slope_fx);
  /// Uses floor(thickness * share / whole), 0 <= share <= whole; `whole` is a power of two.
  void start_row(int z, const std::int32_t* slope, const std::int32_t* share, std::int32_t thickness_fx,
                 std::int32_t whole, std::int32_t max_slope_fx);
  /// Sets any thickness of 0 to 2^20.
  void start(const Field& thickness);
  /// Sets walls, the columns of `slope` without its outermost `ring` that are steeper than `wall_fx`, to 0,
  /// and others to `elsewhere`. Returns true if there are walls.
  bool start_at_walls(const Field& slope, int ring, std::int32_t wall_fx, std::int32_t elsewhere);
  /// May change the type of the cells, because a steep repose needs wide ones.
  void settle(std::int32_t repose_fx) { settle(Rise{repose_fx, repose_fx}); }
  void settle(Rise rise);

  /// Calls visit(cells) with a pointer to the cells of row z, of their current type.
  template <class Visit>
  void with_row(int z, const Visit& visit) const {
    if (narrow_) {
      visit(static_cast<const std::int16_t*>(narrow_rows_.row(static_cast<std::size_t>(z))));
    } else {
      visit(static_cast<const std::int32_t*>(wide_rows_.row(static_cast<std::size_t>(z))));
    }
  }

 private:
  void reshape(int width, int depth, std::int32_t max_fx);
  void widen();

  const SettleKernels* kernels_;
  bool narrow_ = true;
  AlignedVector<std::int16_t> narrow_cells_;
  AlignedVector<std::int32_t> wide_cells_;
  PaddedRows<std::int16_t> narrow_rows_;
  PaddedRows<std::int32_t> wide_rows_;
};

}  // namespace talus::terrain
