#include "gallery_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/settle.h>

#include "gallery_caves.h"
#include "gallery_levels.h"
#include "isometric.h"
#include "panels.h"
#include "plane_grid.h"
#include "world_variant.h"

namespace talus::tools {
namespace {

struct PanelSize {
  int width;
  int height;
};
constexpr PanelSize kWhole{1200, 860};
constexpr PanelSize kHalf{760, 600};
constexpr PanelSize kThird{520, 420};

constexpr double kGroundUnits = 0.09;       // ground below the lowest surface, terrain units
constexpr double kClearWaterUnits = 0.025;  // thickness of water that leaves 1/e of the light
constexpr double kLandscape = 2.4;          // side of a landscape, terrain units

// Planes laid out as in terrain::Stacks, from any source.
struct Planes {
  std::vector<MaterialId> materials;
  std::vector<terrain::Field> tops;
  void add(MaterialId material, terrain::Field top) {
    materials.push_back(material);
    tops.push_back(std::move(top));
  }
};

// Rows of a panel's box.
struct Box {
  std::int32_t bottom = 0;
  int rows = 0;
};

Box box_over(const terrain::World& world, const terrain::Field& surface) {
  const auto [lowest, highest] = std::minmax_element(surface.values.begin(), surface.values.end());
  const auto ground = static_cast<std::int32_t>(std::lround(kGroundUnits * world.spec().resolution));
  const std::int32_t bottom = terrain::boundary_row(*lowest) - std::max(2, ground);
  const std::int32_t top = terrain::boundary_row(std::max(*highest, world.sea_fx().value_or(0)));
  // Height is limited to four times the width, for the picture and for memory.
  return {bottom, std::min(top - bottom, 4 * std::max(surface.width, surface.depth))};
}

Image draw(const GalleryContext& context, const terrain::World& world, const VoxelGrid& grid,
           PanelSize size) {
  const IsometricOptions options{
      .width = size.width,
      .height = size.height,
      .threads = context.threads,
      .clear_water = static_cast<float>(kClearWaterUnits * world.spec().resolution)};
  return render_isometric(grid, material_lights(world), options, context.progress);
}

Image draw(const GalleryContext& context, const terrain::World& world, const Planes& planes,
           std::optional<std::int32_t> sea_fx, Box box, PanelSize size) {
  return draw(context, world, grid_of_planes(planes.materials, planes.tops, sea_fx, box.bottom, box.rows),
              size);
}

Image draw_whole(const GalleryContext& context, const terrain::World& world, const terrain::Region& region,
                 PanelSize size) {
  const Box box = box_over(world, generate_stacks(world, region).tops.back());
  return draw(context, world, grid_of_chunks(world, region, box.bottom, box.rows), size);
}

MaterialId palest_rock(const terrain::World& world) {
  const auto brightness = [](const terrain::Material& material) {
    return material.kind == terrain::MaterialKind::stratified
               ? material.colour.red + material.colour.green + material.colour.blue
               : -1;
  };
  const auto& materials = world.materials();
  return std::max_element(materials.begin(), materials.end(),
                          [&](const auto& a, const auto& b) { return brightness(a) < brightness(b); })
      ->id;
}

Expected<terrain::World> at_resolution(const GalleryContext& context, int resolution) {
  return world_variant(context.text, {.resolution = resolution});
}

Expected<Image> draw_landscape(const GalleryContext& context) {
  const auto world = at_resolution(context, 120);
  if (!world) return tl::make_unexpected(world.error());
  return draw_whole(context, *world, columns_of(scenic_place(*world, kLandscape), *world), kWhole);
}

// The surface alone: the plain noise, and the noise raised to its exponent.
Expected<Image> draw_surface(const GalleryContext& context) {
  std::vector<Image> panels;
  const Place place = scenic_place(context.world, 3.2);
  for (const int exponent : {1, 4}) {
    const auto world = world_variant(context.text, {.resolution = 150, .exponent = exponent});
    if (!world) return tl::make_unexpected(world.error());
    terrain::Field surface = generate_terrain(*world, columns_of(place, *world)).surface;
    const Box box = box_over(*world, surface);
    Planes planes;
    planes.add(palest_rock(*world), std::move(surface));
    panels.push_back(draw(context, *world, planes, std::nullopt, box, kHalf));
  }
  return join_panels(panels, 2);
}

Expected<Image> draw_resolutions(const GalleryContext& context) {
  std::vector<Image> panels;
  const Place place = scenic_place(context.world, 1.0);
  for (const int resolution : {400, 100}) {
    const auto world = at_resolution(context, resolution);
    if (!world) return tl::make_unexpected(world.error());
    panels.push_back(draw_whole(context, *world, columns_of(place, *world), kHalf));
  }
  return join_panels(panels, 2);
}

// The first `count` planes of rock, and the `loose_count` heaviest loose materials at the top.
Planes layers(const terrain::World& world, const terrain::Terrain& terrain, std::size_t count,
              std::size_t loose_count) {
  const auto& bottom_up = world.loose_bottom_up();
  std::vector<terrain::Field> loose_tops;
  terrain::Field limit = terrain.surface;
  for (std::size_t i = loose_count; i-- > 0;) {
    loose_tops.push_back(limit);
    const auto& thickness = terrain.loose[bottom_up[i]].values;
    for (std::size_t k = 0; k < limit.values.size(); ++k) limit.values[k] -= thickness[k];
  }
  Planes planes;
  for (std::size_t p = 0; p < count; ++p) {
    terrain::Field top = terrain.strata[p];
    for (std::size_t k = 0; k < top.values.size(); ++k) {
      top.values[k] = std::min(top.values[k], limit.values[k]);
    }
    planes.add(terrain.strata_materials[p], std::move(top));
  }
  for (std::size_t i = 0; i < loose_count; ++i) {
    planes.add(world.loose()[bottom_up[i]].material, std::move(loose_tops[loose_count - 1 - i]));
  }
  return planes;
}

// For each plane that is visible above the one below, the number of planes up to it.
std::vector<std::size_t> planes_that_show(const terrain::Terrain& terrain) {
  std::vector<std::size_t> counts;
  double below = 0;
  for (std::size_t p = 0; p < terrain.strata.size(); ++p) {
    const auto& tops = terrain.strata[p].values;
    const double sum = std::accumulate(tops.begin(), tops.end(), 0.0);
    const double all = std::accumulate(terrain.surface.values.begin(), terrain.surface.values.end(), 0.0);
    if (sum - below < 0.005 * all) continue;
    counts.push_back(p + 1);
    below = sum;
  }
  return counts;
}

Expected<Image> draw_layer_by_layer(const GalleryContext& context) {
  const auto world = at_resolution(context, 90);
  if (!world) return tl::make_unexpected(world.error());
  const terrain::Terrain terrain =
      generate_terrain(*world, columns_of(scenic_place(*world, kLandscape), *world));
  const Box box = box_over(*world, terrain.surface);
  const std::size_t all = terrain.strata.size();
  const std::size_t loose = world->loose().size();
  std::vector<Image> panels;
  const std::vector<std::size_t> shows = planes_that_show(terrain);
  for (const std::size_t third : {0U, 1U, 2U}) {
    const std::size_t count = shows[third * shows.size() / 3];
    panels.push_back(draw(context, *world, layers(*world, terrain, count, 0), std::nullopt, box, kThird));
  }
  panels.push_back(draw(context, *world, layers(*world, terrain, all, 0), std::nullopt, box, kThird));
  panels.push_back(draw(context, *world, layers(*world, terrain, all, std::max<std::size_t>(1, loose / 3)),
                        std::nullopt, box, kThird));
  panels.push_back(draw(context, *world, layers(*world, terrain, all, loose), world->sea_fx(), box, kThird));
  return join_panels(panels, 3);
}

Expected<Image> draw_roughness(const GalleryContext& context) {
  std::vector<Image> panels;
  const Place place = scenic_place(context.world, 1.8);
  for (const double roughness : {0.0, 0.5, 1.0, 1.6}) {
    const auto world = world_variant(context.text, {.resolution = 110, .roughness = roughness});
    if (!world) return tl::make_unexpected(world.error());
    const terrain::Terrain terrain = generate_terrain(*world, columns_of(place, *world));
    const Box box = box_over(*world, terrain.surface);
    panels.push_back(
        draw(context, *world, layers(*world, terrain, terrain.strata.size(), 0), std::nullopt, box, kHalf));
  }
  return join_panels(panels, 2);
}

// The resolution at which the thickest loose material is `voxels` thick, or the nearest one within the bounds
// of a spec.
int magnified_resolution(const terrain::World& world, double voxels) {
  constexpr double kOneQ16 = 65536;
  constexpr double kMaxColumns = 60;    // of halo
  constexpr double kMaxVoxels = 32768;  // from y = 0 to the highest summit
  constexpr double kDegree = 3.14159265358979 / 180;
  double thickest = 1 / kOneQ16;
  double most = kMaxVoxels / std::max(1.0, world.spec().surface.amplitude);
  for (const terrain::ErodedSpec& eroded : world.spec().eroded) {
    const double thickness = std::max(1.0, static_cast<double>(eroded.thickness_q16)) / kOneQ16;
    thickest = std::max(thickest, thickness);
    most = std::min(most, kMaxColumns * std::tan(eroded.angle_of_repose * kDegree) / thickness);
  }
  if (const int halo = world.feature_halo(Lod{}); halo > 0) {
    most = std::min(most, kMaxColumns * world.spec().resolution / halo);
  }
  return std::max(1, static_cast<int>(std::min(voxels / thickest, most)));
}

// Stacks thicknesses on level rock.
Planes piles(const terrain::World& world, std::span<const terrain::Field> thickness, std::int32_t floor_fx) {
  Planes planes;
  terrain::Field top = thickness.front();
  std::fill(top.values.begin(), top.values.end(), floor_fx);
  planes.add(world.materials()[2].id, top);
  for (const std::size_t m : world.loose_bottom_up()) {
    for (std::size_t k = 0; k < top.values.size(); ++k) top.values[k] += thickness[m].values[k];
    planes.add(world.loose()[m].material, top);
  }
  return planes;
}

// Loose material after equation 3, and after settling, moved from the terrain to a level floor.
Expected<Image> draw_settling(const GalleryContext& context) {
  constexpr int kSide = 64;
  constexpr double kSearched = 512;
  constexpr std::int32_t kFloorRows = 6;
  const auto world = at_resolution(context, magnified_resolution(context.world, 16));
  if (!world) return tl::make_unexpected(world.error());
  const terrain::Region around =
      columns_of(scenic_place(*world, kSearched / world->spec().resolution), *world);
  const terrain::Terrain terrain = generate_terrain(*world, settling_place(*world, around, kSide));
  std::vector<terrain::Field> started;
  std::int32_t thickest_fx = 0;
  for (const auto& loose : world->loose()) {
    started.push_back(starting_thickness(terrain.slope, loose.t_fx, loose.S_fx));
    thickest_fx += loose.t_fx;
  }
  const std::vector<terrain::Field>& settled = terrain.loose;
  const Box box{0, kFloorRows + terrain::boundary_row(thickest_fx)};
  std::vector<Image> panels;
  for (const auto& thickness : {std::span<const terrain::Field>{started}, std::span{settled}}) {
    panels.push_back(draw(context, *world, piles(*world, thickness, kFloorRows * terrain::kSubvoxels),
                          std::nullopt, box, kHalf));
  }
  return join_panels(panels, 2);
}

// Rock below the loose material, and the loose materials on it.
Planes planes_of(const terrain::World& world, const terrain::Terrain& terrain) {
  terrain::Field rock = terrain.surface;
  for (const terrain::Field& loose : terrain.loose) {
    for (std::size_t i = 0; i < rock.values.size(); ++i) rock.values[i] -= loose.values[i];
  }
  Planes planes;
  for (std::size_t p = 0; p < terrain.strata.size(); ++p) {
    terrain::Field top = terrain.strata[p];
    for (std::size_t i = 0; i < top.values.size(); ++i)
      top.values[i] = std::min(top.values[i], rock.values[i]);
    planes.add(terrain.strata_materials[p], std::move(top));
  }
  terrain::Field top = std::move(rock);
  for (const std::size_t m : world.loose_bottom_up()) {
    for (std::size_t i = 0; i < top.values.size(); ++i) top.values[i] += terrain.loose[m].values[i];
    planes.add(world.loose()[m].material, top);
  }
  return planes;
}

// One input with both methods: the slope method, and erosion to rest.
Expected<Image> draw_methods(const GalleryContext& context) {
  const auto world = at_resolution(context, 100);
  if (!world) return tl::make_unexpected(world.error());
  const terrain::Region region = columns_of(scenic_place(*world, 2.0), *world);
  terrain::Terrain eroded;
  terrain::Generator{*world}.generate_to_rest(region, terrain::Neighbours::all, eroded);
  const std::vector<Image> panels{draw_whole(context, *world, region, kHalf),
                                  draw(context, *world, planes_of(*world, eroded), world->sea_fx(),
                                       box_over(*world, eroded.surface), kHalf)};
  return join_panels(panels, 2);
}

// Copies a part of a terrain into its region.
void put(const terrain::Field& part, int x, int z, terrain::Field& whole) {
  for (int row = 0; row < part.depth; ++row) {
    std::copy_n(part.row(row).begin(), part.width, whole.row(z + row).begin() + x);
  }
}

// Chunks eroded separately, and the endless land with the same steps.
Expected<Image> draw_edges(const GalleryContext& context) {
  constexpr int kTile = 40;
  constexpr int kTiles = 4;
  const auto uneroded = at_resolution(context, 100);  // searching eroded land is expensive
  if (!uneroded) return tl::make_unexpected(uneroded.error());
  const auto world = world_variant(context.text, {.resolution = 100, .erosion_steps = 64});
  if (!world) return tl::make_unexpected(world.error());
  terrain::Region region = columns_of(scenic_place(*uneroded, 1.6), *uneroded);
  region = {region.x, region.z, kTile * kTiles, kTile * kTiles, Lod{}};
  const terrain::Terrain whole = generate_terrain(*world, region);
  terrain::Terrain torn = whole;
  terrain::Generator generator{*world};
  terrain::Terrain tile;
  for (int z = 0; z < region.depth; z += kTile) {
    for (int x = 0; x < region.width; x += kTile) {
      generator.generate_to_rest({region.x + x, region.z + z, kTile, kTile, Lod{}}, terrain::Neighbours::all,
                                 tile);
      put(tile.surface, x, z, torn.surface);
      for (std::size_t m = 0; m < tile.loose.size(); ++m) put(tile.loose[m], x, z, torn.loose[m]);
      for (std::size_t p = 0; p < tile.strata.size(); ++p) put(tile.strata[p], x, z, torn.strata[p]);
    }
  }
  std::vector<Image> panels;
  for (const terrain::Terrain* terrain : {&std::as_const(torn), &whole}) {
    panels.push_back(draw(context, *world, planes_of(*world, *terrain), world->sea_fx(),
                          box_over(*world, whole.surface), kHalf));
  }
  return join_panels(panels, 2);
}

constexpr std::array kFigures{
    Figure{"gallery-01-landscape.png", kWhole.height, draw_landscape},
    Figure{"gallery-06-surface.png", 2 * kHalf.height, draw_surface},
    Figure{"gallery-07-resolutions.png", 2 * kHalf.height, draw_resolutions},
    Figure{"gallery-08-layers.png", 6 * kThird.height, draw_layer_by_layer},
    Figure{"gallery-09-roughness.png", 4 * kHalf.height, draw_roughness},
    Figure{"gallery-13-settling.png", 2 * kHalf.height, draw_settling},
    Figure{"gallery-16-methods.png", 2 * kHalf.height, draw_methods},
    Figure{"gallery-17-edges.png", 2 * kHalf.height, draw_edges},
    Figure{"gallery-caves.png", 2 * kCavesPanelHeight, draw_caves, true},
    Figure{"gallery-levels.png", 2 * kLevelsPanelHeight, draw_levels},
};

}  // namespace

std::span<const Figure> gallery_figures() {
  return kFigures;
}

}  // namespace talus::tools
