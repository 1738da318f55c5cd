#include "export_plan.h"

#include <algorithm>
#include <utility>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/places.h>

namespace talus::tools {
namespace {

using files::NpyType;

constexpr const char* kHeightUnit = "1/256 voxel of the level";

// Every column has the same planes, so one column is enough.
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

/// Rows of voxels that edits may have changed in the region; may be empty.
ChunkRange edited_rows(const LandEdits& edits, const terrain::Region& region) {
  ChunkRange rows;
  const auto chunk = [](std::int64_t voxel) { return floor_div(voxel, kChunkSize); };
  for (std::int64_t z = chunk(region.z); z <= chunk(region.z + region.depth - 1); ++z) {
    for (std::int64_t x = chunk(region.x); x <= chunk(region.x + region.width - 1); ++x) {
      const auto key = checked_chunk(x, 0, z, region.lod);
      const ChunkRange column = key ? edits.edited_rows(*key) : ChunkRange{};
      if (column.size() == 0) continue;
      const ChunkRange voxels{column.first * kChunkSize, column.last * kChunkSize + kChunkSize - 1};
      rows = rows.size() == 0
                 ? voxels
                 : ChunkRange{std::min(rows.first, voxels.first), std::max(rows.last, voxels.last)};
    }
  }
  return rows;
}

}  // namespace

std::size_t ExportPlan::column_bytes() const {
  std::size_t bytes = 0;
  for (const PlannedArray& array : arrays) bytes += array.slices.value_or(1) * files::item_bytes(array.type);
  return bytes;
}

ExportPlan plan_export(const terrain::World& world, const terrain::Region& region, const LandEdits* edits) {
  ExportPlan plan;
  plan.world = &world;
  plan.region = region;
  plan.edits = edits;
  plan.y0 = region.lod.value() == 0 ? 0 : -1;
  std::int64_t end = terrain::highest_row(world, region.lod);
  if (const ChunkRange edited = edits == nullptr ? ChunkRange{} : edited_rows(*edits, region);
      edited.size() > 0) {
    plan.y0 = static_cast<std::int32_t>(std::min<std::int64_t>(plan.y0, edited.first));
    end = std::max(end, edited.last + 1);
  }
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
  const auto rows = static_cast<std::size_t>(end - plan.y0);
  const bool wide = world.materials().size() > 256 || (edits != nullptr && !edits->materials().empty());
  arrays.push_back(
      {ExportArray::voxels, "voxels.npy", wide ? NpyType::uint16 : NpyType::uint8, rows, "y", "material id",
       edits == nullptr
           ? "voxels from row `y0` up to the highest that is not air"
           : "voxels from row `y0` up to the highest that is not air, with the edits of `store`; all "
             "other arrays are as generated"});
  for (const auto& [array, file] :
       {std::pair{ExportArray::apron, "apron.npy"}, {ExportArray::look, "look.npy"}}) {
    bool planned = false;
    for (const PlannedArray& one : arrays) planned |= one.array == array;
    if (!planned) plan.left_out.emplace_back(file);
  }
  return plan;
}

}  // namespace talus::tools
