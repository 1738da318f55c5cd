// A column of a stack as voxel rows, by the rule of voxel centres.
#pragma once

#include <algorithm>
#include <cstdint>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/stacks.h>

namespace talus::tools {

/// Calls visit(material, from, to) for the runs of column (x, z) between rows `bottom` and `top`, upward:
/// solid material, then water where the sea stands over it. Rows that nobody visits are air: caves, and what
/// lies above all. For level 0.
template <typename Visit>
void visit_column_rows(const terrain::World& world, const terrain::Stacks& stacks, int x, int z,
                       std::int32_t bottom, std::int32_t top, const Visit& visit) {
  std::int32_t from = bottom;
  const bool cave = stacks.caves.has(x, z);
  const std::int32_t floor = cave ? terrain::boundary_row(stacks.caves.floor.at(x, z)) : top;
  const std::int32_t roof = cave ? terrain::boundary_row(stacks.caves.roof.at(x, z)) : top;
  const auto fill_to = [&](MaterialId material, std::int32_t boundary_fx) {
    const std::int32_t to = std::clamp(terrain::boundary_row(boundary_fx), from, top);
    const std::int32_t under = std::min(to, floor);
    const std::int32_t over = std::max(from, roof);
    if (under > from) visit(material, from, under);
    if (to > over) visit(material, over, to);
    from = to;
  };
  for (std::size_t k = 0; k < stacks.tops.size(); ++k) fill_to(stacks.materials[k], stacks.tops[k].at(x, z));
  if (const auto sea_fx = world.sea_fx()) fill_to(kWater, *sea_fx);
}

}  // namespace talus::tools
