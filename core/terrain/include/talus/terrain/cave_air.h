// The air of caves over a region of columns.
#pragma once

#include <talus/terrain/field.h>

namespace talus::terrain {

/// In each column all is air from `floor` to `roof`, in subvoxels of the region's level, whatever planes,
/// loose material or water would have it otherwise; floor >= roof where there is none. An entrance, open to
/// the sky, has the surface before erosion as its roof. Both fields are empty where the region has no caves.
struct CaveAir {
  Field floor;
  Field roof;

  [[nodiscard]] bool none() const { return floor.values.empty(); }
  [[nodiscard]] bool has(int x, int z) const { return !none() && floor.at(x, z) < roof.at(x, z); }
  /// Keeps the memory.
  void clear() {
    floor.reshape(0, 0);
    roof.reshape(0, 0);
  }
};

}  // namespace talus::terrain
