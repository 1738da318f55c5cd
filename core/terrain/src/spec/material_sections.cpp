#include "spec/material_sections.h"

#include <algorithm>
#include <array>

#include "loose/aprons.h"
#include "spec/angles.h"
#include "spec/units.h"

namespace talus::terrain {
namespace {

constexpr double kMaxLooseThickness = 4096;  // voxels
constexpr int kMaxHalo = 64;                 // columns
constexpr double kMaxApron = 48;             // voxels
constexpr double kMaxWallReach = 32;         // voxels
constexpr int kMaxApronHalo = 128;           // columns
constexpr double kMaxRoughness = 16;
constexpr double kMaxWeight = 1e9;
constexpr Range kAngles{1, 89};               // degrees
constexpr std::size_t kMaxPlaceables = 1024;  // materials, each state counted
constexpr std::size_t kMaxStates = 16;
constexpr std::array kPhases{MaterialKind::stratified, MaterialKind::water, MaterialKind::air};

std::int32_t tangent_fx(double degrees) {
  return static_cast<std::int32_t>(rounded(kSubvoxels * tangent_of_degrees(degrees)));
}

void check_halo(TableReader& table, const ErodedSpec& eroded, const WorldSpec& spec) {
  const int halo = loose_of(eroded, spec.resolution).halo_at(Lod{});
  if (halo > kMaxHalo && spec.method == Method::slope) {
    table.fail("thickness", text_of("at this angle of repose it needs a halo of ", halo, " columns; at most ",
                                    kMaxHalo, ", so make the thickness smaller or the angle steeper"));
  }
}

}  // namespace

std::vector<StratifiedSpec> read_stratified(std::vector<TableReader>& tables, bool repeat,
                                            std::set<std::string>& names) {
  std::vector<StratifiedSpec> materials;
  for (TableReader& table : tables) {
    table.only(repeat ? std::vector<std::string_view>{"name", "colour", "band", "thickness", "roughness"}
                      : std::vector<std::string_view>{"name", "colour", "depth", "thickness", "roughness"});
    StratifiedSpec& stratified = materials.emplace_back();
    stratified.name = table.material_name(names);
    stratified.colour = table.colour();
    if (repeat) {
      stratified.band = table.has("band") && table.boolean("band");
    } else {
      stratified.depth_q16 = table.units_q16("depth", {-kMaxHeight, kMaxHeight});
    }
    stratified.thickness_q16 = table.units_q16("thickness", {kMinUnits_q16, kMaxHeight});
    stratified.roughness = table.real("roughness", {0, kMaxRoughness});
  }
  const bool bands = std::any_of(materials.begin(), materials.end(),
                                 [](const StratifiedSpec& material) { return material.band; });
  if (repeat && !bands && !tables.empty()) {
    tables.front().fail("band", "no layer has band = true; the first that repeats needs it");
  }
  return materials;
}

std::vector<ErodedSpec> read_eroded(std::vector<TableReader>& tables, const WorldSpec& spec,
                                    PlacesReader& places, std::set<std::string>& names) {
  std::vector<ErodedSpec> materials;
  for (TableReader& table : tables) {
    table.only({"name", "colour", "weight", "thickness", "angle_of_repose", "max_slope", "where"});
    ErodedSpec& eroded = materials.emplace_back();
    eroded.name = table.material_name(names);
    eroded.colour = table.colour();
    eroded.weight = table.real("weight", {-kMaxWeight, kMaxWeight});
    eroded.thickness_q16 = table.length_q16("thickness", {kMinUnits_q16, kMaxHeight},
                                            {spec.resolution, {0, kMaxLooseThickness}});
    eroded.angle_of_repose = table.real("angle_of_repose", kAngles);
    eroded.max_slope = table.real("max_slope", kAngles);
    eroded.share = places.share(table);
    check_halo(table, eroded, spec);
  }
  return materials;
}

TalusSpec read_talus(TableReader& table, const WorldSpec& spec) {
  table.only({"of", "thickness", "share", "reach", "cliff"});
  TalusSpec talus;
  const std::string of = table.text("of", kMaxNameBytes);
  const auto found = std::find_if(spec.eroded.begin(), spec.eroded.end(),
                                  [&](const ErodedSpec& eroded) { return eroded.name == of; });
  if (found == spec.eroded.end()) {
    table.fail("of", "no [[eroded]] material is named '" + of + "'; aprons are made of one of them");
    return talus;
  }
  talus.of = static_cast<std::size_t>(found - spec.eroded.begin());
  const auto length = [&](const char* key, double max_voxels, double otherwise) {
    if (table.has(key)) return table.length(key, {0, kMaxHeight}, {spec.resolution, {0, max_voxels}});
    if (otherwise * spec.resolution <= max_voxels) return otherwise;
    table.fail(key, text_of("missing; ", otherwise, " units, the default, are ", otherwise * spec.resolution,
                            " voxels at this resolution, more than ", max_voxels, ", so give a length"));
    return 0.0;
  };
  talus.thickness = length("thickness", kMaxApron, talus.thickness);
  talus.reach = length("reach", kMaxWallReach, talus.reach);
  talus.cliff = length("cliff", kMaxHalo, talus.cliff);
  if (table.has("share")) talus.share = table.real("share", {0, 4});
  const int halo = apron_halo(apron_numbers(talus, loose_of(*found, spec.resolution), spec.resolution));
  if (halo > kMaxApronHalo) {
    table.fail("thickness", text_of("at the angle of repose of '", of, "' it needs a halo of ", halo,
                                    " columns; at most ", kMaxApronHalo, ", so make it smaller"));
  }
  return talus;
}

std::vector<Placeable> read_placeables(std::vector<TableReader>& tables, std::set<std::string>& names) {
  std::vector<Placeable> placeables;
  for (TableReader& table : tables) {
    table.only({"name", "colour", "phase", "states"});
    const Colour colour = table.colour();
    const MaterialKind kind =
        table.has("phase") ? kPhases[table.choice("phase", {"solid", "liquid", "gas"})] : kPhases[0];
    const std::string name = table.text("name", kMaxNameBytes);
    if (!table.has("states")) {
      table.take_name("name", name, names);
      placeables.push_back({name, colour, kind});
    } else {
      for (const std::string& state : table.texts("states", kMaxNameBytes, kMaxStates)) {
        const std::string whole = name + ": " + state;
        table.take_name("states", whole, names);
        placeables.push_back({whole, colour, kind});
      }
    }
    if (placeables.size() > kMaxPlaceables) {
      table.fail("name", text_of("is one placeable material too many; at most ", kMaxPlaceables,
                                 ", each state counted"));
      break;
    }
  }
  return placeables;
}

LooseSpec loose_of(const ErodedSpec& eroded, int resolution) {
  return {MaterialId{},
          eroded.weight,
          static_cast<std::int32_t>(subvoxels_of(eroded.thickness_q16, resolution)),
          tangent_fx(eroded.max_slope),
          tangent_fx(eroded.angle_of_repose),
          eroded.share};
}

}  // namespace talus::terrain
