// Objects on the ground: trees, boulders, and an author's models.
#pragma once

#include <cstdint>
#include <string>

namespace talus::terrain {

/// A kind of object, as named in its section of world.toml.
struct ObjectKindName {
  std::string name;
  std::string model;  // "conifer"
};

/// Position of one object of a region. Its voxels come from its model.
struct PlacedObject {
  std::uint16_t kind = 0;    // index in World::object_kinds()
  std::uint8_t variant = 0;  // variant of the kind
  std::uint8_t turn = 0;     // quarter turns
  std::int64_t x = 0;        // base voxel of its foot, the first above the ground
  std::int64_t y = 0;
  std::int64_t z = 0;
  std::uint64_t hash = 0;  // random bits drawn from its place in the endless plane
  /// At levels 3 and up, the base column that shows the object; each column finds the objects around it.
  std::int64_t seen_x = 0;
  std::int64_t seen_z = 0;
  bool operator==(const PlacedObject&) const = default;
};

}  // namespace talus::terrain
