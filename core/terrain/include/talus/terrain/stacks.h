// The contents of each column of a region: rock, loose material and the air of caves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <talus/terrain/cave_air.h>
#include <talus/terrain/field.h>
#include <talus/terrain/objects.h>
#include <talus/terrain/world.h>
#include <talus/voxel/material.h>

namespace talus::terrain {

/// The stacks of a region (thesis 2.2.3): planes bottom up. Every column has the same list of materials, with
/// thickness 0 for absent ones. Excludes water and air.
struct Stacks {
  Region region;
  std::vector<MaterialId> materials;  // materials[k] lies between plane k - 1 and plane k
  std::vector<Field> tops;            // subvoxels; each plane is at or above the one before; the last is H
  CaveAir caves;
  /// Number of planes of loose material, on top of all others.
  std::size_t loose_planes = 0;
  /// Per-column data of features: one field for each of World::features(), empty if it keeps no data.
  std::vector<Field> surveys;
  /// The look of each column, one field for each of PlacesSpec::looks.
  std::vector<LookField> looks;
  /// Objects whose voxels may lie over the region.
  std::vector<PlacedObject> objects;

  /// The top of rock, under loose material.
  [[nodiscard]] const Field& rock_top() const { return tops[tops.size() - 1 - loose_planes]; }
  /// Returns true if the column is a cave's entrance: it has no roof, and is dry at any sea level.
  [[nodiscard]] bool is_entrance(int x, int z) const {
    return caves.has(x, z) && caves.roof.at(x, z) >= tops.back().at(x, z);
  }
  /// The top of a column's topmost solid material, in subvoxels.
  [[nodiscard]] std::int32_t ground_fx(int x, int z) const {
    return is_entrance(x, z) ? caves.floor.at(x, z) : tops.back().at(x, z);
  }
  /// The material that plane k shows at a column.
  [[nodiscard]] MaterialId shown(const World& world, std::size_t plane, int x, int z) const;
  /// Memory in bytes, for budgets.
  [[nodiscard]] std::size_t bytes() const;
};

}  // namespace talus::terrain
