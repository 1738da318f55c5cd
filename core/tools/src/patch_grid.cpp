#include <talus/tools/patch_grid.h>

#include <algorithm>

namespace talus::tools {

PatchGrid::PatchGrid(const terrain::Region& region, int edge)
    : region_{region},
      edge_{edge},
      across_{static_cast<std::size_t>((region.width + edge - 1) / edge)},
      down_{static_cast<std::size_t>((region.depth + edge - 1) / edge)} {}

terrain::Region PatchGrid::patch(std::size_t index) const {
  const int from_x = static_cast<int>(index % across_) * edge_;
  const int from_z = static_cast<int>(index / across_) * edge_;
  return {region_.x + from_x, region_.z + from_z, std::min(edge_, region_.width - from_x),
          std::min(edge_, region_.depth - from_z), region_.lod};
}

}  // namespace talus::tools
