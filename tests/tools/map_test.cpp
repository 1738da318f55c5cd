#include "map.h"

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/progress/progress_bar.h>

using namespace talus;
using namespace talus::tools;

namespace {

Image map_of(const terrain::Region& region, const MapOptions& options = {}) {
  ProgressBar progress{"map", "columns"};
  return render_map(terrain::default_world(), region, options, progress);
}

}  // namespace

TEST_CASE("A map equals the same place in a larger map, so pictures join without a seam") {
  for (const int level : {0, 3}) {
    const terrain::Region whole{-70, 1234, 160, 150, Lod::of(level)};
    const Image large = map_of(whole);
    CHECK(rc::check([&] {
      const int x = *rc::gen::inRange(0, whole.width - 40);
      const int z = *rc::gen::inRange(0, whole.depth - 30);
      const Image crop = map_of({whole.x + x, whole.z + z, 40, 30, whole.lod});
      for (int row = 0; row < crop.height; ++row) {
        for (int column = 0; column < crop.width; ++column) {
          RC_ASSERT(crop.at(column, row) == large.at(x + column, z + row));
        }
      }
    }));
  }
}

TEST_CASE("A map does not depend on threads or patches") {
  const terrain::Region region{(std::int64_t{1} << 36) - 100, -(std::int64_t{1} << 36), 100, 90, Lod{}};
  const Image one = map_of(region, {.threads = 1, .patch_edge = 100});
  CHECK(map_of(region, {.threads = 3, .patch_edge = 17}).rgb == one.rgb);
}
