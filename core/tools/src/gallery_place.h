// Where in an endless world a picture is worth taking.
#pragma once

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

namespace talus::tools {

/// A square in terrain units, so that it is the same place at every resolution.
struct Place {
  double x = 0;
  double z = 0;
  double side = 0;
};

/// The columns of a place at the resolution of a world.
[[nodiscard]] terrain::Region columns_of(const Place& place, const terrain::World& world);

/// The square of `side` terrain units near the origin that makes the best picture seen from the south-east:
/// high ground at the back, low ground in front, some water where the world has any. Depends on the world
/// alone.
[[nodiscard]] Place scenic_place(const terrain::World& world, double side);

/// The `side` x `side` columns inside `region`, at level 0, from which settling removes the most material.
[[nodiscard]] terrain::Region settling_place(const terrain::World& world, const terrain::Region& region,
                                             int side);

}  // namespace talus::tools
