// The interface of all kinds of surface: H over columns, row after row. Private to core/terrain.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <talus/terrain/surface.h>
#include <talus/vectors/instruction_set.h>

namespace talus::terrain {

/// A surface over many columns, row after row. H is a pure function of the column, so that no implementation
/// needs a halo. Keeps its memory from one start() to the next. For one thread at a time.
class SurfaceRows {
 public:
  virtual ~SurfaceRows() = default;

  /// From here on rows are over these ascending base columns.
  virtual void start(std::span<const std::int64_t> xs) = 0;

  /// Writes H at (xs[i], z) for all i: 0 to highest_fx, rounded. Rows close to the one before cost least.
  virtual void row(std::int64_t z, std::int32_t* heights_fx) = 0;

  /// Whether starts_level() begins something.
  [[nodiscard]] virtual bool knows_slopes() const { return false; }
  /// Begins rows of a coarse level over its columns, as start() does, where the surface knows their slopes by
  /// itself: false where it does not, and nothing is begun.
  [[nodiscard]] virtual bool starts_level(std::span<const std::int64_t> /*xs*/, Lod /*lod*/) { return false; }
  /// Writes H and eq. 1's slope, in level 0's subvoxels. REQUIRES starts_level().
  virtual void sloped_row(std::int64_t /*z*/, std::int32_t* /*heights_fx*/, std::int32_t* /*slopes_fx*/) {}

  /// Of each Quantity and then of each field that places ask for, a value a column of the last row(), which
  /// was at z; called once at most after each. What a surface does not know, or not by itself, stays null.
  /// REQUIRES that the surface has places.
  virtual void quantities(std::int64_t /*z*/, std::span<const float*> /*rows*/) {}
};

[[nodiscard]] std::unique_ptr<SurfaceRows> make_surface_rows(const Surface& surface, InstructionSet set);

}  // namespace talus::terrain
