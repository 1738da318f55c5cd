// What stands in each column of a region: rock, loose material and the air of caves.
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

/// The stacks of a region (thesis 2.2.3): planes bottom up, over which every column has the same list of
/// materials, with thickness 0 where one is absent. Water and air are not in it.
struct Stacks {
  Region region;
  std::vector<MaterialId> materials;  // materials[k] lies between plane k - 1 and plane k
  std::vector<Field> tops;            // subvoxels; no plane lies below the one before; the last is H
  CaveAir caves;
  /// Planes of loose material, on top of all others.
  std::size_t loose_planes = 0;
  /// What features keep of each column, one of World::features() each; of those that keep nothing it is
  /// empty.
  std::vector<Field> surveys;
  /// Which look each column has, by each of PlacesSpec::looks.
  std::vector<LookField> looks;
  /// Whose voxels may lie over the region.
  std::vector<PlacedObject> objects;

  /// Where rock ends, under loose material.
  [[nodiscard]] const Field& rock_top() const { return tops[tops.size() - 1 - loose_planes]; }
  /// Whether the column is a cave's entrance: no roof, and dry wherever the sea stands.
  [[nodiscard]] bool is_entrance(int x, int z) const {
    return caves.has(x, z) && caves.roof.at(x, z) >= tops.back().at(x, z);
  }
  /// Where the topmost solid material of a column ends, in subvoxels.
  [[nodiscard]] std::int32_t ground_fx(int x, int z) const {
    return is_entrance(x, z) ? caves.floor.at(x, z) : tops.back().at(x, z);
  }
  /// What plane k's material shows at a column.
  [[nodiscard]] MaterialId shown(const World& world, std::size_t plane, int x, int z) const;
  /// Memory, for budgets.
  [[nodiscard]] std::size_t bytes() const;
};

}  // namespace talus::terrain
