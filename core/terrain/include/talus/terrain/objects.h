// Objects that stand on the ground: trees, boulders, models of an author.
#pragma once

#include <cstdint>
#include <string>

namespace talus::terrain {

/// A kind of objects, as its section of world.toml has it.
struct ObjectKindName {
  std::string name;
  std::string model;  // "conifer"
};

/// One object of a region. Where it stands, not its voxels: those are its model's.
struct PlacedObject {
  std::uint16_t kind = 0;    // of World::object_kinds()
  std::uint8_t variant = 0;  // of its kind
  std::uint8_t turn = 0;     // quarter turns
  std::int64_t x = 0;        // base voxel of its foot, the first above the ground
  std::int64_t y = 0;
  std::int64_t z = 0;
  std::uint64_t hash = 0;  // what its place in the endless plane drew
  /// Levels 3 and up: the base column that shows it; every column sees the objects around it for itself.
  std::int64_t seen_x = 0;
  std::int64_t seen_z = 0;
  bool operator==(const PlacedObject&) const = default;
};

}  // namespace talus::terrain
