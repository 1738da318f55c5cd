// Light on a surface, which makes mountains of a map of heights.
#pragma once

#include <talus/map/painting.h>
#include <talus/terrain/field.h>

namespace talus::map {

/// Both are 1 on a plain under open sky.
struct Light {
  float sun = 1;  // from the north-west, halfway up; 0 where turned away or in shadow
  float sky = 1;  // how much of the sky is seen: less in clefts and at the foot of cliffs
};

/// The light on column (x, z) of `surface`, which must have kReliefRing columns on each side of it.
/// Heights in subvoxels, run in columns. A pure function of those neighbours, so that pictures of
/// overlapping regions agree.
[[nodiscard]] Light light_at(const terrain::Field& surface, int x, int z);

}  // namespace talus::map
