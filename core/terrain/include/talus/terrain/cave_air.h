// The air of caves over a region of columns.
#pragma once

#include <talus/terrain/field.h>

namespace talus::terrain {

/// Each column is air from `floor` to `roof`, in subvoxels of the region's level, regardless of planes, loose
/// material and water; floor >= roof if the column has no cave. An entrance, open to the sky, has the surface
/// before erosion as its roof. Both fields are empty if the region has no caves.
struct CaveAir {
  Field floor;
  Field roof;

  [[nodiscard]] bool none() const { return floor.values.empty(); }
  [[nodiscard]] bool has(int x, int z) const { return !none() && floor.at(x, z) < roof.at(x, z); }
  /// Keeps the allocations.
  void clear() {
    floor.reshape(0, 0);
    roof.reshape(0, 0);
  }
};

}  // namespace talus::terrain
