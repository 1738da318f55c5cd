#include "plane_grid.h"

#include <algorithm>
#include <cstddef>

#include <talus/terrain/boundary_row.h>

namespace talus::tools {

VoxelGrid grid_of_planes(std::span<const MaterialId> materials, std::span<const terrain::Field> tops,
                         std::optional<std::int32_t> sea_fx, std::int32_t bottom, int rows) {
  VoxelGrid grid{tops.front().width, rows, tops.front().depth};
  for (int z = 0; z < grid.depth(); ++z) {
    for (int x = 0; x < grid.width(); ++x) {
      std::int64_t from = 0;
      const auto fill_to = [&](MaterialId material, std::int32_t boundary_fx) {
        const std::int64_t to = std::int64_t{terrain::boundary_row(boundary_fx)} - bottom;
        grid.fill(x, z, from, to, material);
        from = std::max(from, to);
      };
      for (std::size_t k = 0; k < tops.size(); ++k) fill_to(materials[k], tops[k].at(x, z));
      if (sea_fx) fill_to(kWater, *sea_fx);
    }
  }
  return grid;
}

}  // namespace talus::tools
