#include "spec_reader.h"

#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include <talus/toml/toml_bounds.h>
#include <toml++/toml.h>

#include "table_reader.h"

namespace talus::terrain {
namespace {

constexpr double kFarthest = 32768;           // terrain units; R >= 1 keeps every height within 32,768 voxels
constexpr double kFarthestMap = 68719476736;  // terrain units; R >= 1 keeps a map within the world
constexpr double kLongest = 16777216;         // terrain units
constexpr double kMostSample = 1e18;          // of a height map
constexpr int kMostErosionSteps = 64;         // a halo of 128 columns

HeightMapSpec read_height_map(TableReader map) {
  HeightMapSpec spec;
  spec.outside = static_cast<Outside>(map.choice("outside", {"mirror", "sea", "blend", "repeat"}));
  if (spec.outside == Outside::blend) {
    map.only({"file", "x", "z", "spacing", "spacing_z", "low", "high", "outside", "margin", "around"});
    spec.margin = map.real("margin", {1e-6, kLongest});
    if (map.has("around")) {
      spec.around = static_cast<SurfaceKind>(map.choice("around", {"perlin", "ridged", "warped"}));
    }
  } else {
    map.only({"file", "x", "z", "spacing", "spacing_z", "low", "high", "outside"});
  }
  spec.file = map.text("file", 1024);
  spec.x = map.real("x", {-kFarthestMap, kFarthestMap});
  spec.z = map.real("z", {-kFarthestMap, kFarthestMap});
  spec.spacing_x = map.real("spacing", {1e-6, kLongest});
  spec.spacing_z = map.has("spacing_z") ? map.real("spacing_z", {1e-6, kLongest}) : spec.spacing_x;
  if (map.has("low")) spec.low = map.real("low", {-kMostSample, kMostSample});
  if (map.has("high")) spec.high = map.real("high", {-kMostSample, kMostSample});
  return spec;
}

FoldSpec read_folds(TableReader folds) {
  folds.only({"amplitude", "wavelength", "octaves", "strike", "stretch"});
  FoldSpec spec;
  spec.amplitude_q16 = folds.units_q16("amplitude", {0, kFarthest});
  spec.wavelength = folds.real("wavelength", {1e-6, kLongest});
  spec.octaves = folds.has("octaves") ? static_cast<int>(folds.integer("octaves", 1, 8)) : 2;
  spec.strike = folds.has("strike") ? folds.real("strike", {-360, 360}) : 0;
  spec.stretch = folds.has("stretch") ? folds.real("stretch", {1, 64}) : 4;
  return spec;
}

FaultSpec read_faults(TableReader faults) {
  faults.only({"strike", "spacing", "throw", "waviness"});
  FaultSpec spec;
  spec.strike = faults.real("strike", {-360, 360});
  spec.spacing_q16 = faults.units_q16("spacing", {1.0 / 65536, kLongest});
  spec.throw_q16 = faults.units_q16("throw", {0, kFarthest});
  spec.waviness_q16 = faults.has("waviness") ? faults.units_q16("waviness", {0, kFarthest}) : 0;
  return spec;
}

OreSpec read_veins(TableReader veins, std::set<std::string>& names) {
  OreSpec spec;
  spec.shape = static_cast<OreShape>(veins.choice("shape", {"pocket", "vein"}));
  std::vector<std::string_view> known{"name", "colour", "shape", "low", "high", "size", "abundance"};
  if (spec.shape == OreShape::vein) known.push_back("thickness");
  veins.only(known);
  spec.name = veins.name(names);
  spec.colour = veins.colour();
  spec.low_q16 = veins.units_q16("low", {0, kFarthest});
  spec.high_q16 = veins.units_q16("high", {0, kFarthest});
  spec.size_q16 = veins.units_q16("size", {1.0 / 65536, kFarthest});
  if (spec.shape == OreShape::vein)
    spec.thickness_q16 = veins.units_q16("thickness", {1.0 / 65536, kFarthest});
  spec.abundance = veins.real("abundance", {0, 1});
  return spec;
}

// A key that its kind of surface has no use for is unknown, like any other.
SurfaceSpec read_surface(TableReader& surface, std::string_view file, std::optional<SpecError>& error) {
  SurfaceSpec spec;
  if (surface.has("kind")) {
    spec.kind =
        static_cast<SurfaceKind>(surface.choice("kind", {"perlin", "ridged", "warped", "height_map"}));
  }
  if (spec.kind == SurfaceKind::height_map) {
    const toml::table* map = surface.table("height_map");
    if (map == nullptr) return spec;
    spec.height_map = read_height_map({file, "surface.height_map", *map, error});
  }
  const auto noise = spec.noise();
  std::vector<std::string_view> known;
  if (noise) known = {"wavelength", "octaves", "gain", "exponent"};
  known.insert(known.end(), {"amplitude", "kind"});
  if (spec.height_map) known.push_back("height_map");
  if (noise == SurfaceKind::ridged) known.push_back("feedback");
  if (noise == SurfaceKind::warped) known.insert(known.end(), {"warp", "warp_wavelength", "warp_octaves"});
  surface.only(known);

  spec.amplitude = surface.real("amplitude", {1.0 / 65536, kFarthest});
  if (!noise) return spec;
  spec.wavelength = surface.real("wavelength", {1e-6, kLongest});
  spec.octaves = static_cast<int>(surface.integer("octaves", 1, 16));
  spec.gain = surface.real("gain", {0, 16});
  spec.exponent = static_cast<int>(surface.integer("exponent", 1, 8));
  if (noise == SurfaceKind::ridged) {
    spec.feedback = surface.has("feedback") ? surface.real("feedback", {0, 16}) : 2;
  }
  if (noise == SurfaceKind::warped) {
    spec.warp = surface.real("warp", {0, 16384});
    spec.warp_wavelength =
        surface.has("warp_wavelength") ? surface.real("warp_wavelength", {1e-6, kLongest}) : spec.wavelength;
    spec.warp_octaves =
        surface.has("warp_octaves") ? static_cast<int>(surface.integer("warp_octaves", 1, 16)) : 3;
  }
  return spec;
}

CaveSpec read_caves(TableReader caves, std::map<std::string, int, std::less<>>& lines) {
  CaveSpec spec;
  struct Key {
    const char* name;
    double& value;
    Range range;
  };
  const Key keys[] = {{"low", spec.low, {0, kFarthest}},
                      {"high", spec.high, {0, kFarthest}},
                      {"climb_wavelength", spec.climb_wavelength, {1e-6, kLongest}},
                      {"wavelength", spec.wavelength, {1e-6, kLongest}},
                      {"width", spec.width, {1e-6, kFarthest}},
                      {"height", spec.height, {1e-6, kFarthest}},
                      {"chamber_wavelength", spec.chamber_wavelength, {1e-6, kLongest}},
                      {"chamber_threshold", spec.chamber_threshold, {0, 1}},
                      {"chamber_height", spec.chamber_height, {1e-6, kFarthest}},
                      {"roof", spec.roof, {0, kFarthest}},
                      {"span", spec.span, {1e-6, kFarthest}}};
  std::vector<std::string_view> known;
  for (const Key& key : keys) {
    known.emplace_back(key.name);
    lines[key.name] = caves.line(key.name);
    if (std::string_view{key.name} == "roof" && !caves.has("roof")) continue;
    key.value = caves.real(key.name, key.range);
  }
  caves.only(known);
  return spec;
}

}  // namespace

SpecError error_of(const std::string& message) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  SpecError error;
  for (const char c : message) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7F) {
      error.message += c;
    } else {
      error.message += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return error;
}

tl::expected<ReadSpec, SpecError> read_spec(std::string_view toml, std::string_view file) {
  if (const auto fault = passes_toml_bounds(toml)) {
    std::ostringstream message;
    message << file << ':' << fault->line << ": " << fault->what;
    return tl::unexpected(error_of(message.str()));
  }
  toml::table document;
  try {
    document = toml::parse(toml, file);
  } catch (const toml::parse_error& bad) {
    std::ostringstream message;
    message << file << ':' << bad.source().begin.line << ": not TOML: " << bad.description();
    return tl::unexpected(error_of(message.str()));
  }

  std::optional<SpecError> error;
  ReadSpec read;
  WorldSpec& spec = read.spec;
  TableReader root{file, "", document, error};
  root.only({"seed", "resolution", "strata_wavelength", "sea_level", "method", "erosion_steps", "surface",
             "stratified", "eroded", "caves", "folds", "faults", "veins"});
  spec.seed = static_cast<std::uint64_t>(root.integer("seed", std::numeric_limits<std::int64_t>::min(),
                                                      std::numeric_limits<std::int64_t>::max()));
  spec.resolution = static_cast<int>(root.integer("resolution", 1, 32768));

  if (const toml::table* table = root.table("surface")) {
    TableReader surface{file, "surface", *table, error};
    spec.surface = read_surface(surface, file, error);
    read.lines.wavelength = surface.line("wavelength");
    read.lines.amplitude = surface.line("amplitude");
    read.lines.warp = surface.line("warp");
    read.lines.height_map = surface.line("height_map");
  }
  // A surface without noise has no wavelength to borrow.
  const bool own_strata_wavelength = root.has("strata_wavelength") || !spec.surface.noise();
  spec.strata_wavelength =
      own_strata_wavelength ? root.real("strata_wavelength", {1e-6, 16777216}) : spec.surface.wavelength;
  if (root.has("sea_level")) spec.sea_level = root.real("sea_level", {0, kFarthest});
  if (root.has("method")) {
    spec.method = root.choice("method", {"slope", "erosion"}) == 1 ? Method::erosion : Method::slope;
  }
  if (spec.method == Method::erosion) {
    spec.erosion_steps = static_cast<int>(root.integer("erosion_steps", 1, kMostErosionSteps));
  } else if (root.has("erosion_steps")) {
    root.fail(root.line("erosion_steps"), "erosion_steps",
              "is for method = \"erosion\"; leave it out or choose that method");
  }

  read.lines.strata_wavelength =
      root.has("strata_wavelength") ? root.line("strata_wavelength") : read.lines.wavelength;
  read.lines.sea_level = root.line("sea_level");

  std::set<std::string> names;
  for (const toml::table* table : root.tables("stratified")) {
    TableReader material{file, "stratified[" + std::to_string(spec.stratified.size()) + "]", *table, error};
    material.only({"name", "colour", "depth", "thickness", "roughness"});
    if (spec.stratified.empty()) read.lines.stratified = material.line();
    StratifiedSpec& stratified = spec.stratified.emplace_back();
    stratified.name = material.name(names);
    stratified.colour = material.colour();
    stratified.depth_q16 = material.units_q16("depth", {-kFarthest, kFarthest});
    stratified.thickness_q16 = material.units_q16("thickness", {1.0 / 65536, kFarthest});
    stratified.roughness = material.real("roughness", {0, 16});
  }
  for (const toml::table* table : root.tables("eroded")) {
    TableReader material{file, "eroded[" + std::to_string(spec.eroded.size()) + "]", *table, error};
    material.only({"name", "colour", "weight", "thickness", "angle_of_repose", "max_slope"});
    read.lines.eroded_thickness.push_back(material.line("thickness"));
    ErodedSpec& eroded = spec.eroded.emplace_back();
    eroded.name = material.name(names);
    eroded.colour = material.colour();
    eroded.weight = material.real("weight", {-1e9, 1e9});
    eroded.thickness_q16 = material.units_q16("thickness", {1.0 / 65536, kFarthest});
    eroded.angle_of_repose = material.real("angle_of_repose", {1, 89});
    eroded.max_slope = material.real("max_slope", {1, 89});
  }
  const auto note_lines = [&](const TableReader& table, const std::string& name,
                              std::initializer_list<const char*> keys) {
    for (const char* key : keys) read.lines.underground[name + '.' + key] = table.line(key);
  };
  if (root.has("folds")) {
    if (const toml::table* table = root.table("folds")) {
      const TableReader folds{file, "folds", *table, error};
      note_lines(folds, "folds", {"amplitude", "wavelength"});
      spec.folds = read_folds(folds);
    }
  }
  if (root.has("faults")) {
    for (const toml::table* table : root.tables("faults")) {
      const std::string name = "faults[" + std::to_string(spec.faults.size()) + "]";
      const TableReader faults{file, name, *table, error};
      note_lines(faults, name, {"spacing", "throw", "waviness"});
      spec.faults.push_back(read_faults(faults));
    }
  }
  if (root.has("veins")) {
    for (const toml::table* table : root.tables("veins")) {
      const std::string name = "veins[" + std::to_string(spec.veins.size()) + "]";
      const TableReader veins{file, name, *table, error};
      note_lines(veins, name, {"name", "size", "high", "thickness"});
      spec.veins.push_back(read_veins(veins, names));
    }
  }
  if (root.has("caves")) {
    if (const toml::table* table = root.table("caves")) {
      spec.caves = read_caves({file, "caves", *table, error}, read.lines.caves);
    }
  }
  if (error) return tl::unexpected(*error);
  return read;
}

}  // namespace talus::terrain
