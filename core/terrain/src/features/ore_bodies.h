// Pockets and veins of ore: the position of each body and its span in a column. Private to core/terrain.
//
// Space is divided into cubes as large as a body. A hash of the cube decides whether it contains a body's
// middle, and where, so that a body is a pure function of position and reaches no farther than half its size.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <talus/terrain/world.h>
#include <talus/voxel/material.h>

#include "features/sip_hash.h"

namespace talus::terrain {

/// Pockets are lumps; veins are thin, long, tilted sheets with branches.
enum class OreShape : std::uint8_t { pocket, vein };

/// A kind of ore in the numbers used to compute it. `_fx`: subvoxels of level 0.
struct OreKind {
  MaterialId material{};
  std::uint64_t seed = 0;
  OreShape shape = OreShape::pocket;
  std::int32_t low_fx = 0;
  std::int32_t high_fx = 0;
  std::int32_t size_fx = 0;  // edge of a body's box and of the cubes
  std::int32_t thickness_fx = 0;
  std::uint64_t chance_q32 = 0;   // probability that a cube holds a body
  std::optional<SipHash> secret;  // draws the bodies instead of `seed`

  /// Returns true if bodies are at least four voxels of the level large, and a vein at least one voxel thick.
  /// Secret ore shows at level 0 only.
  [[nodiscard]] bool shows_at(Lod lod) const {
    if (secret && lod.value() > 0) return false;
    return size_fx >> lod.value() >= 4 * kSubvoxels &&
           (shape == OreShape::pocket || thickness_fx >> lod.value() >= kSubvoxels);
  }
};

/// The ore in a column, in subvoxels of level 0.
struct OreSpan {
  std::int32_t from_fx = 0;
  std::int32_t to_fx = 0;
};

/// A part of a body with one span per column: an ellipse as seen from above, thickest in its middle, tilted,
/// with a ragged edge.
struct OreLobe {
  std::int64_t x_fx = 0;
  std::int64_t z_fx = 0;
  std::int32_t y_fx = 0;
  std::int32_t reach_fx = 0;  // maximum distance along x and z
  std::int32_t rise_fx = 0;   // maximum distance along y
  std::int32_t half_fx = 0;   // half the thickness in the middle
  std::int64_t cos_q14 = 0;   // direction of the long axis
  std::int64_t sin_q14 = 0;
  std::int64_t per_along_q40 = 0;   // 1 / half the long axis
  std::int64_t per_across_q40 = 0;  // 1 / half the short axis
  std::int64_t tilt_along_q12 = 0;  // rise over run
  std::int64_t tilt_across_q12 = 0;
  std::uint64_t seed = 0;  // for the body's ragged edge
  int grain_bits = 0;      // it varies over 2^grain_bits subvoxels
  std::int64_t ragged_q15 = 0;
  std::int32_t sway_fx = 0;
};

/// A lobe along a row of columns. Columns of one grain share hashes, so query them in order.
class OreRow {
 public:
  /// `lobe` must outlive this. Spans outside of the heights [low_fx, high_fx) may be omitted.
  OreRow(const OreLobe& lobe, std::int64_t column_z,
         std::int64_t low_fx = std::numeric_limits<std::int64_t>::min(),
         std::int64_t high_fx = std::numeric_limits<std::int64_t>::max());

  /// Base columns [from, to) outside of which at() returns nullopt; may be empty.
  struct Reach {
    std::int64_t from = 0;
    std::int64_t to = 0;
  };
  [[nodiscard]] Reach reach() const;

  /// The lobe's span in a column.
  [[nodiscard]] std::optional<OreSpan> at(std::int64_t column_x);

 private:
  /// Two numbers that vary smoothly from grain to grain, on a line between grains.
  struct GrainLine {
    std::int64_t edge_q30 = 0;
    std::int64_t sway_q30 = 0;
  };

  [[nodiscard]] GrainLine grain_line(std::int64_t line) const;

  const OreLobe& lobe_;
  std::int64_t low_fx_;
  std::int64_t high_fx_;
  std::int64_t z_fx_;
  std::int64_t along_q14_;  // component of the row's distance from the middle
  std::int64_t across_q14_;
  bool misses_;
  std::int64_t grain_ = std::numeric_limits<std::int64_t>::min();  // the grain of west_ and east_
  GrainLine west_;
  GrainLine east_;
};

/// Base columns [x0, x1) and [z0, z1), heights [low_fx, high_fx).
struct OreBox {
  std::int64_t x0 = 0;
  std::int64_t x1 = 0;
  std::int64_t z0 = 0;
  std::int64_t z1 = 0;
  std::int64_t low_fx = 0;
  std::int64_t high_fx = 0;
};

/// Adds the lobes that may reach into the box, from bodies whose middles lie within half a size of it: at
/// most four for each of (box / size + 2)^3 cubes.
void add_lobes(const OreKind& kind, const OreBox& box, std::vector<OreLobe>& lobes);

}  // namespace talus::terrain
