#include <talus/map/region_painter.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <talus/map/light.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/stacks.h>

#include "map_light.h"
#include "relief.h"
#include "top_colour.h"

namespace talus::map {
namespace {

terrain::Field ground_of(const terrain::Stacks& stacks) {
  terrain::Field ground = stacks.tops.back();
  if (stacks.caves.none()) return ground;
  for (int z = 0; z < ground.depth; ++z) {
    for (int x = 0; x < ground.width; ++x) ground.at(x, z) = stacks.ground_fx(x, z);
  }
  return ground;
}

void lift(terrain::Field& field, float factor) {
  for (std::int32_t& height : field.values) {
    height = static_cast<std::int32_t>(std::lround(static_cast<float>(height) * factor));
  }
}

}  // namespace

/// The visible surfaces of a patch and its ring.
struct RegionPainter::Scene {
  terrain::Stacks stacks;
  std::vector<MaterialId> ore;
  std::vector<MaterialId> objects;  // by column: objects on the ground, or the top of edited ground
  std::vector<MaterialId> water;    // by column: water placed by edits; empty if no edit placed any
  terrain::Field depth_fx;          // depth of the water; 0 or less if dry
  // Heights used for shading.
  terrain::Field ground;
  terrain::Field canopy;
  terrain::Field seen;  // the sea's surface if it covers the ground
};

class RegionPainter::Work final : public Painting {
 public:
  Work(const RegionPainter& painter, terrain::Generator& generator, const terrain::Region& patch,
       Image& image, int x, int y)
      : painter_{painter}, generator_{generator}, patch_{patch}, image_{image}, x_{x}, y_{y} {
    generator_.start(patch.expanded(kReliefRing));
  }

  bool step() override {
    if (!scene_) {
      if (generator_.step()) return true;
      scene_.emplace(painter_.scene_of(generator_.take()));
      return true;
    }
    const int end = std::min(patch_.depth, next_row_ + kRowsAStep);
    for (; next_row_ < end; ++next_row_) {
      for (int x = 0; x < patch_.width; ++x) {
        const glm::vec3 pixel = painter_.pixel(*scene_, x + kReliefRing, next_row_ + kReliefRing);
        image_.set(x_ + x, y_ + next_row_, to_colour(developed(pixel)));
      }
    }
    return next_row_ < patch_.depth;
  }

 private:
  const RegionPainter& painter_;
  terrain::Generator& generator_;
  const terrain::Region patch_;
  Image& image_;
  const int x_;
  const int y_;
  std::optional<Scene> scene_;
  int next_row_ = 0;
};

RegionPainter::RegionPainter(const terrain::World& world, Lod lod, float relief, const EditedTops* edits)
    : world_{world},
      lod_{lod},
      relief_{relief},
      edits_{edits},
      lights_{material_lights(
          world, edits == nullptr ? std::span<const terrain::Material>{} : std::span{edits->materials()})},
      water_{std::make_unique<const WaterLight>(world)} {
  if (const auto sea_fx = world.sea_fx()) sea_fx_ = *sea_fx >> lod.value();
}

RegionPainter::~RegionPainter() = default;

std::unique_ptr<Painting> RegionPainter::start(terrain::Generator& generator, const terrain::Region& patch,
                                               Image& image, int x, int y) const {
  return std::make_unique<Work>(*this, generator, patch, image, x, y);
}

RegionPainter::Scene RegionPainter::scene_of(terrain::Stacks stacks) const {
  Scene scene;
  scene.ore = exposed_overlays(world_, stacks);
  terrain::ObjectTops objects = object_tops(world_, stacks);
  scene.ground = ground_of(stacks);
  scene.canopy = scene.ground;
  for (std::size_t i = 0; i < objects.rows.size(); ++i) {
    if (objects.materials[i] != kAir) scene.canopy.values[i] = objects.rows[i] * terrain::kSubvoxels;
  }
  scene.objects = std::move(objects.materials);
  scene.seen = scene.ground;
  if (sea_fx_) {
    for (int z = 0; z < scene.seen.depth; ++z) {
      for (int x = 0; x < scene.seen.width; ++x) {
        if (!stacks.is_entrance(x, z)) scene.seen.at(x, z) = std::max(scene.seen.at(x, z), *sea_fx_);
      }
    }
  }
  scene.stacks = std::move(stacks);
  if (edits_ != nullptr) apply_edits(scene);
  scene.depth_fx = scene.seen;
  for (std::size_t i = 0; i < scene.depth_fx.values.size(); ++i)
    scene.depth_fx.values[i] -= scene.canopy.values[i];
  if (relief_ != 1) {
    for (terrain::Field* const field : {&scene.ground, &scene.canopy, &scene.seen}) lift(*field, relief_);
  }
  return scene;
}

void RegionPainter::apply_edits(Scene& scene) const {
  const terrain::Region& region = scene.stacks.region;
  for (const EditedTop& top : edits_->find(region)) {
    const auto x = static_cast<int>(top.x - region.x);
    const auto z = static_cast<int>(top.z - region.z);
    const auto i = static_cast<std::size_t>(z * region.width + x);
    scene.objects[i] = top.material;
    scene.canopy.values[i] = scene.seen.values[i] = top.row * terrain::kSubvoxels;
    if (top.water == kAir) continue;
    scene.seen.values[i] = top.water_row * terrain::kSubvoxels;
    scene.water.resize(region.columns(), kAir);
    scene.water[i] = top.water;
  }
}

glm::vec3 RegionPainter::pixel(const Scene& scene, int x, int z) const {
  const terrain::Stacks& stacks = scene.stacks;
  glm::vec3 pixel = lit(top_colour(world_, stacks, scene.ore, lights_, x, z), light_at(scene.ground, x, z));
  const MaterialId object = scene.objects[static_cast<std::size_t>(z * stacks.region.width + x)];
  if (object != kAir) pixel = lit(lights_[to_integer(object)], light_at(scene.canopy, x, z));
  const std::int32_t depth_fx = scene.depth_fx.at(x, z);
  if (depth_fx <= 0) return pixel;
  const std::int64_t depth_base_fx = std::int64_t{depth_fx} << lod_.value();
  const auto i = static_cast<std::size_t>(z * stacks.region.width + x);
  const MaterialId water =
      scene.water.empty() || scene.water[i] == kAir ? water_at(stacks, x, z) : scene.water[i];
  return water_->over(pixel, lights_[to_integer(water)], depth_base_fx, light_at(scene.seen, x, z));
}

// Returns ice if the column's look shows ice.
MaterialId RegionPainter::water_at(const terrain::Stacks& stacks, int x, int z) const {
  const terrain::World::ShownBy* const by = world_.shown_by(kWater);
  return by == nullptr ? kWater : by->by_look[stacks.looks[by->looks].at(x, z)];
}

}  // namespace talus::map
