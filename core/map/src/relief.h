// Shading of a surface of heights.
#pragma once

#include <talus/map/painting.h>
#include <talus/terrain/field.h>

namespace talus::map {

/// Both are 1 on a plain under the open sky.
struct Light {
  float sun = 1;  // from the north-west, at an elevation of about 42 degrees; 0 if turned away or in shadow
  float sky = 1;  // visible part of the sky: less in clefts and at the foot of cliffs
};

/// The light on column (x, z) of `surface`, which must have kReliefRing columns on each side of it. Heights
/// are in subvoxels, horizontal distances in columns. Depends only on these neighbours, so overlapping
/// pictures agree.
[[nodiscard]] Light light_at(const terrain::Field& surface, int x, int z);

}  // namespace talus::map
