#include "map.h"

#include <talus/map/region_painter.h>
#include <talus/terrain/generator.h>
#include <talus/tools/ordered_work.h>
#include <talus/tools/patch_grid.h>

namespace talus::tools {

Image render_map(const terrain::World& world, const terrain::Region& region, const MapOptions& options,
                 ProgressBar& progress) {
  Image image{region.width, region.depth};
  const PatchGrid grid{region, options.patch_edge};
  const map::RegionPainter painter{world, region.lod, 1, options.edits};
  progress.expect(region.columns());
  const auto paint = [&](std::size_t index) {
    const terrain::Region patch = grid.patch(index);
    terrain::Generator generator{world};
    const auto painting = painter.start(generator, patch, image, static_cast<int>(patch.x - region.x),
                                        static_cast<int>(patch.z - region.z));
    while (painting->step()) {
    }
    return patch.columns();
  };
  work_in_order(grid.count(), thread_count(options.threads), paint, [&](std::size_t, std::size_t columns) {
    progress.advance(columns);
    return true;
  });
  return image;
}

}  // namespace talus::tools
