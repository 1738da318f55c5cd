#include "map.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>

#include "map_light.h"
#include "ordered_work.h"
#include "patch_grid.h"
#include "relief.h"
#include "top_colour.h"

namespace talus::tools {
namespace {

class MapPainter {
 public:
  MapPainter(const terrain::World& world, Lod lod)
      : world_{world}, lod_{lod}, lights_{material_lights(world)}, water_{world} {
    if (const auto sea_fx = world.sea_fx()) sea_fx_ = *sea_fx >> lod.value();
  }

  void paint(const terrain::Region& patch, Image& image, int image_x, int image_y) const {
    const terrain::Stacks stacks = generate_stacks(world_, patch.expanded(kReliefRing));
    const terrain::Field ground = ground_of(stacks);
    const std::vector<MaterialId> ore = exposed_overlays(world_, stacks);
    const terrain::ObjectTops objects = object_tops(world_, stacks);
    terrain::Field canopy = ground;
    for (std::size_t i = 0; i < objects.rows.size(); ++i) {
      if (objects.materials[i] != kAir) canopy.values[i] = objects.rows[i] * terrain::kSubvoxels;
    }
    terrain::Field seen = ground;  // the sea's surface where it covers the ground
    if (sea_fx_) {
      for (int z = 0; z < seen.depth; ++z) {
        for (int x = 0; x < seen.width; ++x) {
          if (!stacks.is_entrance(x, z)) seen.at(x, z) = std::max(seen.at(x, z), *sea_fx_);
        }
      }
    }
    for (int z = 0; z < patch.depth; ++z) {
      for (int x = 0; x < patch.width; ++x) {
        const int inner_x = x + kReliefRing;
        const int inner_z = z + kReliefRing;
        glm::vec3 pixel = lit(top_colour(world_, stacks, ore, lights_, inner_x, inner_z),
                              light_at(ground, inner_x, inner_z));
        const MaterialId object =
            objects.materials[static_cast<std::size_t>(inner_z * stacks.region.width + inner_x)];
        if (object != kAir) pixel = lit(lights_[to_integer(object)], light_at(canopy, inner_x, inner_z));
        const std::int32_t depth_fx = seen.at(inner_x, inner_z) - canopy.at(inner_x, inner_z);
        if (depth_fx > 0) {
          const std::int64_t depth_base_fx = std::int64_t{depth_fx} << lod_.value();
          pixel = water_.over(pixel, lights_[to_integer(water_at(stacks, inner_x, inner_z))], depth_base_fx,
                              light_at(seen, inner_x, inner_z));
        }
        image.set(image_x + x, image_y + z, to_colour(developed(pixel)));
      }
    }
  }

 private:
  static terrain::Field ground_of(const terrain::Stacks& stacks) {
    terrain::Field ground = stacks.tops.back();
    if (stacks.caves.none()) return ground;
    for (int z = 0; z < ground.depth; ++z) {
      for (int x = 0; x < ground.width; ++x) ground.at(x, z) = stacks.ground_fx(x, z);
    }
    return ground;
  }

  // Ice where there is some.
  MaterialId water_at(const terrain::Stacks& stacks, int x, int z) const {
    const terrain::World::ShownBy* const by = world_.shown_by(kWater);
    return by == nullptr ? kWater : by->by_look[stacks.looks[by->looks].at(x, z)];
  }

  const terrain::World& world_;
  Lod lod_;
  std::vector<glm::vec3> lights_;
  WaterLight water_;
  std::optional<std::int32_t> sea_fx_;
};

}  // namespace

Image render_map(const terrain::World& world, const terrain::Region& region, const MapOptions& options,
                 ProgressBar& progress) {
  Image image{region.width, region.depth};
  const PatchGrid grid{region, options.patch_edge};
  const MapPainter painter{world, region.lod};
  progress.expect(region.columns());
  const auto paint = [&](std::size_t index) {
    const terrain::Region patch = grid.patch(index);
    painter.paint(patch, image, static_cast<int>(patch.x - region.x), static_cast<int>(patch.z - region.z));
    return patch.columns();
  };
  work_in_order(grid.count(), thread_count(options.threads), paint, [&](std::size_t, std::size_t columns) {
    progress.advance(columns);
    return true;
  });
  return image;
}

}  // namespace talus::tools
