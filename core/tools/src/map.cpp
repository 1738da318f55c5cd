#include "map.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "ordered_work.h"
#include "patch_grid.h"
#include "relief.h"

namespace talus::tools {
namespace {

const glm::vec3 kSunlight{0.74F, 0.68F, 0.58F};
const glm::vec3 kSkylight{0.27F, 0.33F, 0.43F};
// Depth of water, in terrain units, that leaves 1/e of the light. Red is lost first.
const glm::vec3 kClearWater{0.012F, 0.024F, 0.032F};
// The light that the water's surface lets through, so that a shore shows even where the water is shallow.
constexpr float kThroughSurface = 0.62F;

glm::vec3 lit(glm::vec3 colour, Light light) {
  return colour * (light.sun * kSunlight + light.sky * kSkylight);
}

// Compresses bright light, so that slopes keep their colour instead of clipping, and softens strong colours.
glm::vec3 developed(glm::vec3 light) {
  const float grey = glm::dot(light, glm::vec3{0.2126F, 0.7152F, 0.0722F});
  const glm::vec3 calm = glm::mix(glm::vec3{grey}, light, 0.92F);
  return calm * 1.18F / (1.0F + 0.25F * calm);
}

class MapPainter {
 public:
  MapPainter(const terrain::World& world, Lod lod)
      : world_{world}, lod_{lod}, lights_{material_lights(world)} {
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
        glm::vec3 pixel = lit(top_colour(stacks, ore, inner_x, inner_z), light_at(ground, inner_x, inner_z));
        const MaterialId object =
            objects.materials[static_cast<std::size_t>(inner_z * stacks.region.width + inner_x)];
        if (object != kAir) pixel = lit(lights_[to_integer(object)], light_at(canopy, inner_x, inner_z));
        const std::int32_t depth_fx = seen.at(inner_x, inner_z) - canopy.at(inner_x, inner_z);
        if (depth_fx > 0) pixel = under_water(pixel, depth_fx, light_at(seen, inner_x, inner_z));
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

  glm::vec3 top_colour(const terrain::Stacks& stacks, const std::vector<MaterialId>& ore, int x,
                       int z) const {
    const MaterialId outcrop = ore[static_cast<std::size_t>(z * stacks.region.width + x)];
    const std::size_t strata = stacks.tops.size() - world_.loose().size();
    const std::int32_t base_voxel_fx = terrain::kSubvoxels >> lod_.value();
    std::int32_t top = stacks.ground_fx(x, z);
    const std::int32_t bottom = top - base_voxel_fx;
    glm::vec3 sum{0};
    for (std::size_t k = stacks.tops.size(); k-- > 0 && top > bottom;) {
      // Under the lowest plane its material goes on without end.
      const std::int32_t under = k == 0 ? bottom : std::max(bottom, stacks.tops[k - 1].at(x, z));
      if (under >= top) continue;
      sum += static_cast<float>(top - under) *
             lights_[to_integer(k < strata && outcrop != kAir ? outcrop : stacks.shown(world_, k, x, z))];
      top = under;
    }
    return sum / static_cast<float>(base_voxel_fx);
  }

  glm::vec3 under_water(glm::vec3 bed, std::int32_t depth_fx, Light light) const {
    const float depth_units = std::ldexp(static_cast<float>(depth_fx), lod_.value()) /
                              static_cast<float>(terrain::kSubvoxels * world_.spec().resolution);
    const glm::vec3 through = kThroughSurface * glm::exp(-depth_units / kClearWater);
    return lit(lights_[to_integer(kWater)], light) * (1.0F - through) + bed * through;
  }

  const terrain::World& world_;
  Lod lod_;
  std::vector<glm::vec3> lights_;
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
