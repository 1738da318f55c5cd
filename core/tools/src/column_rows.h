// A column of a stack as voxel rows, by the rule of voxel centres.
#pragma once

#include <algorithm>
#include <cstdint>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/stacks.h>

namespace talus::tools {

/// Calls visit(material, from, to) for the runs of column (x, z) between rows `bottom` and `top`, upward:
/// solid material, then water where the sea stands over it. Rows that nobody visits are air. For level 0.
template <typename Visit>
void visit_column_rows(const terrain::World& world, const terrain::Stacks& stacks, int x, int z,
                       std::int32_t bottom, std::int32_t top, const Visit& visit) {
  std::int32_t from = bottom;
  const auto fill_to = [&](MaterialId material, std::int32_t boundary_fx) {
    const std::int32_t to = std::clamp(terrain::boundary_row(boundary_fx), from, top);
    if (to > from) visit(material, from, to);
    from = to;
  };
  for (std::size_t k = 0; k < stacks.tops.size(); ++k) fill_to(stacks.materials[k], stacks.tops[k].at(x, z));
  if (const auto sea_fx = world.sea_fx()) fill_to(kWater, *sea_fx);
}

}  // namespace talus::tools
