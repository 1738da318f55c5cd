#include "spec/regions_section.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "spec/units.h"
#include "surface/regions/regions.h"

namespace talus::terrain {
namespace {

constexpr int kMaxFields = 32;
constexpr int kMaxFieldOctaves = 8;
constexpr std::size_t kMaxKnots = 12;
constexpr double kMinGain = 1e-3;
constexpr Range kFieldValues{-2, 2};
constexpr Range kShare{0, 1};
constexpr Range kHeights{-kMaxHeight, kMaxHeight};
constexpr Range kWidths{0, 400};           // narrower than valleys
constexpr Range kValleys{0, 700};          // ranges widen them; distances are known up to 1000
constexpr int kMaxRegionsResolution = 64;  // limits warps to the length that kernels allow
constexpr std::int64_t kSeaStep = 64;      // voxels: a voxel of the coarsest level

/// Reads one table after another; omitted keys keep the default world's values.
class RegionTables {
 public:
  /// `fields`: known_fields().
  RegionTables(const std::vector<FieldSpec>& fields, int resolution, PlacesSpec& places)
      : fields_{fields}, resolution_{resolution}, places_{places} {}

  void land(TableReader& table);
  void ranges(TableReader& table);
  void hills(TableReader& table);
  void mesas(TableReader& table);
  void climate(TableReader& table);
  void rivers(TableReader& table);
  void shape(TableReader& table);

  [[nodiscard]] RegionsSpec take() { return std::move(spec_); }

 private:
  /// Chooses the field named by the key, or the default world's if the key is omitted.
  void choose(TableReader& table, const std::string& key, FieldSpec& field);

  RegionsSpec spec_;
  const std::vector<FieldSpec>& fields_;
  int resolution_;
  PlacesSpec& places_;
};

double number_or(TableReader& table, const std::string& key, Range range, double otherwise) {
  return table.has(key) ? table.real(key, range) : otherwise;
}

/// Reads a wavelength of a noise of which `octaves` octaves are sampled like fields.
double wavelength_or(TableReader& table, const std::string& key, int octaves, int resolution,
                     double otherwise) {
  if (!table.has(key)) return otherwise;
  const double shortest = kShortestFieldOctave * static_cast<double>(1 << (octaves - 1));
  return table.length(key, {kMinLength, kMaxLength}, {resolution, {shortest, kMaxLength}, true});
}

/// Returns true if conditions use the name for a quantity that is not a field of the default world.
bool is_quantity_alone(const std::string& name) {
  const bool quantity = std::find(kQuantityNames.begin(), kQuantityNames.end(), name) != kQuantityNames.end();
  return quantity && name != "temperature" && name != "moisture" && name != "mesas" && name != "ranges";
}

FieldSpec read_field(TableReader& table, int resolution) {
  table.only({"name", "wavelength", "octaves", "gain", "warp"});
  FieldSpec field;
  field.name = table.text("name", kMaxNameBytes);
  if (!field.name.empty() && field.name.front() == '.') {
    table.fail("name", "'" + field.name + "' begins with a dot, as the generator's own noises do");
  }
  if (is_quantity_alone(field.name)) {
    table.fail("name",
               "'" + field.name + "' is a quantity, which would hide this field; another name is needed");
  }
  field.octaves = static_cast<int>(table.integer("octaves", 1, kMaxFieldOctaves));
  field.wavelength = wavelength_or(table, "wavelength", field.octaves, resolution, 0);
  if (!table.has("wavelength")) table.fail("wavelength", "missing; a number is needed");
  field.gain = table.real("gain", {kMinGain, 1});
  field.warped = table.has("warp") && table.integer("warp", 0, 1) == 1;
  return field;
}

void RegionTables::choose(TableReader& table, const std::string& key, FieldSpec& field) {
  if (table.has(key)) field.name = table.text(key, kMaxNameBytes);
  const auto said = std::find_if(fields_.begin(), fields_.end(),
                                 [&](const FieldSpec& other) { return other.name == field.name; });
  if (said != fields_.end()) {
    field = *said;
    return;
  }
  table.fail(key, "no field is named '" + field.name + "'; a [[field]] of that name is needed");
}

void RegionTables::land(TableReader& table) {
  table.only({"field", "height", "inland"});
  choose(table, "field", spec_.continents);
  spec_.base = table.curve("height", kFieldValues, kHeights, kMaxKnots, spec_.base);
  spec_.inland = table.curve("inland", kFieldValues, kShare, kMaxKnots, spec_.inland);
}

void RegionTables::ranges(TableReader& table) {
  table.only({"field", "belt", "passes", "base", "relief"});
  choose(table, "field", spec_.ranges);
  spec_.belt = table.curve("belt", kFieldValues, kShare, kMaxKnots, spec_.belt);
  spec_.passes = table.curve("passes", kFieldValues, kShare, kMaxKnots, spec_.passes);
  spec_.range_base = number_or(table, "base", {0, kMaxHeight}, spec_.range_base);
  spec_.range_relief = number_or(table, "relief", {0, kMaxHeight}, spec_.range_relief);
}

void RegionTables::hills(TableReader& table) {
  table.only({"field", "height"});
  choose(table, "field", spec_.hilliness);
  spec_.hills = table.curve("height", kFieldValues, {0, kMaxHeight}, kMaxKnots, spec_.hills);
}

void RegionTables::mesas(TableReader& table) {
  table.only({"field", "terraces", "height", "anywhere", "coast", "roughness"});
  choose(table, "field", spec_.mesas);
  spec_.terraces = table.curve("terraces", kFieldValues, kShare, kMaxKnots, spec_.terraces);
  spec_.mesa_height = number_or(table, "height", {0, kMaxHeight}, spec_.mesa_height);
  spec_.mesas_anywhere = number_or(table, "anywhere", kShare, spec_.mesas_anywhere);
  spec_.mesa_coast = table.pair("coast", kFieldValues, spec_.mesa_coast);
  if (std::abs(spec_.mesa_coast[0] - spec_.mesa_coast[1]) < 0.001) {
    table.fail(
        "coast",
        text_of(
            spec_.mesa_coast[0],
            " twice, or nearly; the field's value without mesas and its value with all mesas are needed"));
  }
  spec_.mesa_roughness = number_or(table, "roughness", {0, 4}, spec_.mesa_roughness);
}

void RegionTables::climate(TableReader& table) {
  table.only({"temperature", "moisture", "warmer", "wetter", "lapse"});
  choose(table, "temperature", spec_.temperature);
  choose(table, "moisture", spec_.moisture);
  spec_.warmer = number_or(table, "warmer", kFieldValues, spec_.warmer);
  spec_.wetter = number_or(table, "wetter", kFieldValues, spec_.wetter);
  places_.lapse = number_or(table, "lapse", {1, kMaxLength}, places_.lapse);
}

void RegionTables::rivers(TableReader& table) {
  table.only({"wavelength", "tributaries", "half_width", "valley", "carve", "bed"});
  spec_.river_wavelength =
      wavelength_or(table, "wavelength", kRiverOctaves, resolution_, spec_.river_wavelength);
  spec_.tributary_wavelength =
      wavelength_or(table, "tributaries", kRiverOctaves, resolution_, spec_.tributary_wavelength);
  spec_.half_width = table.pair("half_width", {0.5, kWidths.max}, spec_.half_width);
  spec_.valley = table.pair("valley", kValleys, spec_.valley);
  for (std::size_t i = 0; i < spec_.valley.size(); ++i) {
    const double least = kWidestRiver * spec_.half_width[i] + 1;
    if (spec_.valley[i] >= least) continue;
    table.fail("valley",
               text_of(spec_.valley[i], " is narrower than its river: half_width ", spec_.half_width[i],
                       " times ", kWidestRiver, " in lowlands; at least ", least));
  }
  spec_.carve = table.pair("carve", {0, kMaxHeight}, spec_.carve);
  spec_.bed = number_or(table, "bed", {0, 256}, spec_.bed);
}

void RegionTables::shape(TableReader& table) {
  table.only({"wavelength", "gain"});
  spec_.shape_wavelength =
      wavelength_or(table, "wavelength", kSlowOctaves, resolution_, spec_.shape_wavelength);
  spec_.shape_gain = number_or(table, "gain", {kMinGain, 1}, spec_.shape_gain);
}

using ReadTable = void (RegionTables::*)(TableReader&);
struct Section {
  std::string_view name;
  ReadTable read;
};
constexpr std::array<Section, 7> kSections{{{"land", &RegionTables::land},
                                            {"ranges", &RegionTables::ranges},
                                            {"hills", &RegionTables::hills},
                                            {"mesas", &RegionTables::mesas},
                                            {"climate", &RegionTables::climate},
                                            {"rivers", &RegionTables::rivers},
                                            {"shape", &RegionTables::shape}}};

}  // namespace

std::vector<FieldSpec> read_fields(TableReader& root, int resolution) {
  std::vector<FieldSpec> fields;
  if (!root.has("field")) return fields;
  for (TableReader& table : root.tables("field")) {
    if (fields.size() == kMaxFields) {
      table.fail("name", text_of("more than ", kMaxFields, " fields; leave some out"));
      break;
    }
    FieldSpec field = read_field(table, resolution);
    const bool known = std::any_of(fields.begin(), fields.end(),
                                   [&](const FieldSpec& other) { return other.name == field.name; });
    if (known) table.fail("name", "'" + field.name + "' names another field already; names are unique");
    fields.push_back(std::move(field));
  }
  return fields;
}

std::vector<FieldSpec> known_fields(std::vector<FieldSpec> fields) {
  const RegionsSpec shipped;
  for (const FieldSpec* const known : {&shipped.continents, &shipped.ranges, &shipped.hilliness,
                                       &shipped.mesas, &shipped.temperature, &shipped.moisture}) {
    const bool given = std::any_of(fields.begin(), fields.end(),
                                   [&](const FieldSpec& field) { return field.name == known->name; });
    if (!given) fields.push_back(*known);
  }
  return fields;
}

const std::vector<std::string_view>& region_tables() {
  static const std::vector<std::string_view> kNames = [] {
    std::vector<std::string_view> names;
    for (const Section& section : kSections) names.push_back(section.name);
    return names;
  }();
  return kNames;
}

RegionsSpec read_regions(const std::vector<FieldSpec>& fields, TableReader& surface, int resolution,
                         PlacesSpec& places) {
  RegionTables regions{fields, resolution, places};
  for (const Section& section : kSections) {
    auto table = surface.table_or_empty(std::string{section.name});
    if (table) (regions.*section.read)(*table);
  }
  return regions.take();
}

void check_regions(TableReader& root, TableReader& surface, WorldSpec& world) {
  RegionsSpec& regions = *world.surface.regions;
  if (world.resolution > kMaxRegionsResolution) {
    return root.fail("resolution", text_of(world.resolution, " is out of range; 1 to ", kMaxRegionsResolution,
                                           " for regions"));
  }
  if (!world.sea_level) return root.fail("sea_level", "missing; land of regions is measured from the sea");
  const double voxels = *world.sea_level * world.resolution;
  if (voxels < kSeaStep || std::fmod(voxels, static_cast<double>(kSeaStep)) != 0) {
    return root.fail("sea_level",
                     text_of(*world.sea_level, " is ", voxels, " voxels; a multiple of ", kSeaStep,
                             " is needed for regions, so that the sea is level from afar"));
  }
  regions.sea_level = *world.sea_level;
  world.surface.amplitude = highest_land(regions);
  const double highest = world.surface.amplitude * world.resolution;
  if (highest <= kMaxHeight) return;
  surface.fail("kind", text_of("sea_level, land, ranges, hills and mesas come to ", std::ceil(highest),
                               " voxels in all; at most ", kMaxHeight));
}

}  // namespace talus::terrain
