// Finds places of an endless world for pictures.
#pragma once

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

namespace talus::tools {

/// A square in terrain units: the same place at every resolution.
struct Place {
  double x = 0;
  double z = 0;
  double side = 0;
};

/// The columns of a place at the world's resolution.
[[nodiscard]] terrain::Region columns_of(const Place& place, const terrain::World& world);

/// The square of `side` terrain units near the origin with the best picture from the south-east: high ground
/// at the back, low ground in front, and some water if the world has any. Depends only on the world.
[[nodiscard]] Place scenic_place(const terrain::World& world, double side);

/// The `side` x `side` columns of `region`, at level 0, from which settling removes the most material.
[[nodiscard]] terrain::Region settling_place(const terrain::World& world, const terrain::Region& region,
                                             int side);

}  // namespace talus::tools
