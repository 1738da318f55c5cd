#include "profile.h"

#include <cstdint>
#include <vector>

#include <talus/terrain/generator.h>
#include <talus/tools/ordered_work.h>
#include <talus/tools/patch_grid.h>

#include "section_colours.h"

namespace talus::tools {
namespace {

class ProfilePainter {
 public:
  ProfilePainter(const terrain::World& world, const ProfileRows& rows, Image& image)
      : world_{world}, rows_{rows}, image_{image}, lights_{material_lights(world)} {}

  // Paints column x of the stacks as column `at` of the picture.
  void paint(const terrain::Stacks& stacks, int x, int at) const {
    const int level = stacks.region.lod.value();
    const std::int32_t ground = stacks.ground_fx(x, 0);
    std::size_t k = 0;
    for (int up = 0; up < rows_.rows; ++up) {
      const std::int64_t base_fx =
          (rows_.low + std::int64_t{up} * rows_.step) * terrain::kSubvoxels + terrain::kSubvoxels / 2;
      const auto fx = static_cast<std::int32_t>(base_fx >> level);
      while (k < stacks.tops.size() && stacks.tops[k].at(x, 0) <= fx) ++k;
      const int y = rows_.rows - 1 - up;
      if (fx < ground && k < stacks.tops.size()) {
        const bool hollow =
            stacks.caves.has(x, 0) && fx >= stacks.caves.floor.at(x, 0) && fx < stacks.caves.roof.at(x, 0);
        image_.set(at, y,
                   hollow ? kUnderRoof : to_colour(lights_[to_integer(stacks.shown(world_, k, x, 0))]));
      } else if (world_.sea_fx() && base_fx < *world_.sea_fx() && !stacks.is_entrance(x, 0)) {
        const auto depth = static_cast<float>(*world_.sea_fx() - base_fx) / terrain::kSubvoxels;
        image_.set(at, y, to_colour(lights_[to_integer(kWater)] * daylight_under(depth)));
      } else {
        image_.set(at, y, sky_colour(static_cast<float>(y) / static_cast<float>(rows_.rows)));
      }
    }
  }

 private:
  const terrain::World& world_;
  const ProfileRows& rows_;
  Image& image_;
  std::vector<glm::vec3> lights_;
};

}  // namespace

Image render_profile(const terrain::World& world, const terrain::Region& line, const ProfileRows& rows,
                     int threads, ProgressBar& progress) {
  Image image{line.width, rows.rows};
  const PatchGrid patches{line, 256};
  const ProfilePainter painter{world, rows, image};
  progress.expect(line.columns());
  const auto paint = [&](std::size_t index) {
    const terrain::Stacks stacks = generate_stacks(world, patches.patch(index));
    for (int x = 0; x < stacks.region.width; ++x) {
      painter.paint(stacks, x, static_cast<int>(stacks.region.x - line.x) + x);
    }
    return stacks.region.columns();
  };
  work_in_order(patches.count(), thread_count(threads), paint, [&](std::size_t, std::size_t columns) {
    progress.advance(columns);
    return true;
  });
  return image;
}

}  // namespace talus::tools
