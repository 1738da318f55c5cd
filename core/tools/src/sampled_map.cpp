#include "sampled_map.h"

#include <talus/map/grid_painter.h>
#include <talus/tools/ordered_work.h>
#include <talus/tools/patch_grid.h>

namespace talus::tools {

Image render_sampled_map(const terrain::World& world, const map::ColumnGrid& grid,
                         const SampledMapOptions& options, ProgressBar& progress) {
  Image image{grid.width, grid.depth};
  const PatchGrid patches{{0, 0, grid.width, grid.depth, Lod{}}, options.patch_edge};
  const map::GridPainter painter{world, grid.every};
  progress.expect(grid.columns());
  const auto paint = [&](std::size_t index) {
    const terrain::Region patch = patches.patch(index);
    const int x = static_cast<int>(patch.x);
    const int z = static_cast<int>(patch.z);
    const auto painting = painter.start(grid.part(x, z, patch.width, patch.depth), image, x, z);
    while (painting->step()) {
    }
    return patch.columns();
  };
  work_in_order(patches.count(), thread_count(options.threads), paint, [&](std::size_t, std::size_t columns) {
    progress.advance(columns);
    return true;
  });
  return image;
}

}  // namespace talus::tools
