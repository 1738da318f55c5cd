// The interface of all kinds of surface: H over columns, row by row. Private to core/terrain.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <talus/terrain/surface.h>
#include <talus/vectors/instruction_set.h>

namespace talus::terrain {

/// A surface over many columns, row by row. H is a pure function of the column, so implementations need no
/// halo. Reuses its memory from one start() to the next; not thread-safe.
class SurfaceRows {
 public:
  virtual ~SurfaceRows() = default;

  /// The following rows are over these ascending base columns.
  virtual void start(std::span<const std::int64_t> xs) = 0;

  /// Writes H at (xs[i], z) for all i: 0 to highest_fx, rounded. Cheapest for rows close to the previous one.
  virtual void row(std::int64_t z, std::int32_t* heights_fx) = 0;

  /// Returns true if the surface supports starts_level().
  [[nodiscard]] virtual bool knows_slopes() const { return false; }
  /// If the surface computes slopes itself, starts rows over the columns of a coarse level, like start(), and
  /// returns true. Otherwise does nothing and returns false.
  [[nodiscard]] virtual bool starts_level(std::span<const std::int64_t> /*xs*/, Lod /*lod*/) { return false; }
  /// Writes H and eq. 1's slope, in level 0's subvoxels. REQUIRES starts_level().
  virtual void sloped_row(std::int64_t /*z*/, std::int32_t* /*heights_fx*/, std::int32_t* /*slopes_fx*/) {}

  /// Sets rows[q] to the values of each Quantity, and then of each field that places use, at the columns of
  /// the last row(), which was at z; call at most once after each. Rows stay null for quantities that the
  /// surface does not compute itself. REQUIRES that the surface has places.
  virtual void quantities(std::int64_t /*z*/, std::span<const float*> /*rows*/) {}
};

[[nodiscard]] std::unique_ptr<SurfaceRows> make_surface_rows(const Surface& surface, InstructionSet set);

}  // namespace talus::terrain
