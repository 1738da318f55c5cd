#include "export_plan.h"

#include <utility>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/places.h>

namespace talus::tools {
namespace {

using files::NpyType;

constexpr const char* kHeightUnit = "1/256 voxel of the level";

// Every column has the same planes, so that one tells what all have.
std::vector<MaterialId> strata_materials(const terrain::World& world, const terrain::Region& region) {
  return generate_terrain(world, {region.x, region.z, 1, 1, region.lod}).strata_materials;
}

std::vector<MaterialId> shown_planes(const terrain::World& world, std::vector<MaterialId> planes) {
  for (const std::size_t m : world.loose_bottom_up()) planes.push_back(world.loose()[m].material);
  if (world.sea_fx()) planes.push_back(kWater);
  return planes;
}

std::string land_of_slope(const terrain::World& world, Lod lod) {
  std::string land = world.spec().talus ? "ground with aprons" : "ground";
  if (world.spec().method == terrain::Method::erosion) land += ", before erosion";
  if (world.spec().talus && lod.value() > 0) land += "; where an apron lies, its angle of repose";
  return land;
}

void plan_loose(const ExportPlan& plan, std::vector<PlannedArray>& arrays) {
  const std::size_t materials = plan.world->loose().size();
  if (plan.world->spec().method == terrain::Method::slope) {
    arrays.push_back({ExportArray::apron, "apron.npy", NpyType::int32, std::nullopt, "", kHeightUnit,
                      "by how much talus aprons raised the ground: surface.npy is with them"});
  }
  arrays.push_back({ExportArray::place, "place.npy", NpyType::int32, materials, "m", kHeightUnit,
                    "t(x, z) of each material of `eroded`: the thickness that the place allows, before the "
                    "slope takes its share"});
  arrays.push_back({ExportArray::eroded, "eroded.npy", NpyType::int32, materials, "m", kHeightUnit,
                    "settled thickness of each material of `eroded`, with aprons; the lightest ends at the "
                    "surface, each heavier one under it, none below y = 0"});
}

}  // namespace

std::size_t ExportPlan::column_bytes() const {
  std::size_t bytes = 0;
  for (const PlannedArray& array : arrays) bytes += array.slices.value_or(1) * files::item_bytes(array.type);
  return bytes;
}

ExportPlan plan_export(const terrain::World& world, const terrain::Region& region) {
  ExportPlan plan;
  plan.world = &world;
  plan.region = region;
  plan.y0 = region.lod.value() == 0 ? 0 : -1;
  plan.layers = strata_materials(world, region);
  plan.planes = shown_planes(world, plan.layers);
  plan.fields = terrain::place_names(world);
  plan.slope_of = land_of_slope(world, region.lod);

  std::vector<PlannedArray>& arrays = plan.arrays;
  arrays.push_back({ExportArray::surface, "surface.npy", NpyType::int32, std::nullopt, "", kHeightUnit,
                    "H, the top of the stack, also where a cave opens to the sky"});
  arrays.push_back({ExportArray::slope, "slope.npy", NpyType::int32, std::nullopt, "",
                    "1/256 of rise over run",
                    "eq. 1, between base columns, of the land that `slope_of` names"});
  plan_loose(plan, arrays);
  arrays.push_back({ExportArray::strata, "strata.npy", NpyType::int32, plan.layers.size(), "layer",
                    kHeightUnit,
                    "tops of the materials of `layers` before loose material takes the place of rock, cut at "
                    "the surface; the last is the surface"});
  arrays.push_back({ExportArray::shown, "shown.npy", NpyType::uint16, plan.planes.size(), "plane",
                    "material id",
                    "what each material of `planes` shows at the column; water, the last of a "
                    "world with a sea, in its topmost voxel alone"});
  arrays.push_back(
      {ExportArray::fields, "fields.npy", NpyType::int32, plan.fields.size(), "f",
       "1/65536 of the quantity's own unit",
       "the quantities `fields.names` of the base column, times `fields.scale`, rounded to even"});
  if (world.look_names().size() > 1) {
    arrays.push_back({ExportArray::look, "look.npy", NpyType::uint8, std::nullopt, "", "index into `looks`",
                      "the column's look; 0: none"});
  }
  const auto rows = static_cast<std::size_t>(terrain::highest_row(world, region.lod) - plan.y0);
  arrays.push_back({ExportArray::voxels, "voxels.npy",
                    world.materials().size() > 256 ? NpyType::uint16 : NpyType::uint8, rows, "y",
                    "material id", "voxels from row `y0` up to the highest that is not air"});
  for (const auto& [array, file] :
       {std::pair{ExportArray::apron, "apron.npy"}, {ExportArray::look, "look.npy"}}) {
    bool planned = false;
    for (const PlannedArray& one : arrays) planned |= one.array == array;
    if (!planned) plan.left_out.emplace_back(file);
  }
  return plan;
}

}  // namespace talus::tools
