// world.toml -> World, section by section.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <talus/terrain/erosion.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/strata.h>
#include <talus/terrain/surface.h>
#include <talus/terrain/world.h>

#include "feature.h"
#include "loose/aprons.h"
#include "spec/canonical_form.h"
#include "spec/looks_section.h"
#include "spec/material_sections.h"
#include "spec/places_section.h"
#include "spec/regions_section.h"
#include "spec/surface_section.h"
#include "spec/table_reader.h"
#include "spec/units.h"

namespace talus::terrain {
namespace {

constexpr std::int64_t kMaxResolution = 32768;  // voxels a terrain unit
constexpr int kMaxErosionSteps = 64;            // a halo of 128 columns

}  // namespace

/// Reads the sections in order; each may use the results of earlier ones.
struct World::Builder {
  Builder(TableReader root_table, SpecErrors& spec_errors, World& built)
      : root{root_table}, errors{spec_errors}, world{built} {}

  void build(const WorldFiles& files, std::span<const FeatureKind> kinds);

  void check_keys(std::span<const FeatureKind> kinds);
  void read_general();
  void read_strata_wavelength();
  void read_sea();
  void read_method();
  void read_materials(PlacesReader& places);
  void read_features(std::span<const FeatureKind> kinds, PlacesReader& places, const WorldFiles& files,
                     bool after_looks);
  void read_world_looks(PlacesReader& places);
  [[nodiscard]] std::string height_term() const;
  void check_lifts();
  void derive_strata();
  void derive_loose();
  void check_rows();
  void derive_halo();

  MaterialId add_material(const std::string& name, Colour colour, MaterialKind kind);

  TableReader root;
  SpecErrors& errors;
  World& world;
  WorldSpec& spec = world.spec_;
  std::set<std::string> names;  // of materials
  int stratified_line = 0;
};

tl::expected<World, SpecError> World::parse(std::string_view toml, std::string_view file,
                                            const WorldFiles& files) {
  return parse(toml, file, files, shipped_features());
}

tl::expected<World, SpecError> World::parse(std::string_view toml, std::string_view file,
                                            const WorldFiles& files, std::span<const FeatureKind> kinds) {
  SpecErrors errors{file};
  World world;
  if (const auto document = TomlDocument::parse(toml, errors)) {
    Builder{TableReader{document->root(), "", errors}, errors, world}.build(files, kinds);
  }
  if (errors.any()) return tl::unexpected(errors.first());
  return world;
}

void World::Builder::build(const WorldFiles& files, std::span<const FeatureKind> kinds) {
  check_keys(kinds);
  read_general();
  auto surface = root.table("surface");
  const std::vector<FieldSpec> fields = known_fields(read_fields(root, spec.resolution));
  if (surface) read_surface(root, *surface, fields, spec);
  if (spec.surface.regions) spec.fields = fields;
  read_strata_wavelength();
  read_sea();
  if (spec.surface.regions) check_regions(root, *surface, spec);
  read_method();
  PlacesReader places{spec, fields, spec.places};
  read_materials(places);
  read_features(kinds, places, files, false);
  read_world_looks(places);
  read_features(kinds, places, files, true);
  if (root.has("placeable")) {
    auto placeables = root.tables("placeable");
    world.placeables_ = read_placeables(placeables, names);
  }
  if (errors.any()) return;
  load_height_map(*surface, spec, files.height_map);
  check_lifts();
  if (errors.any()) return;
  world.highest_fx_ = highest_height_fx(surface_of(spec));
  derive_strata();
  derive_loose();
  check_rows();
  derive_halo();
  world.fingerprint_ = hash_canonical_form(world.canonical_form());
}

void World::Builder::check_keys(std::span<const FeatureKind> kinds) {
  std::vector<std::string_view> known{
      "seed",   "resolution", "strata_wavelength", "sea_level", "method", "erosion_steps",
      "field",  "surface",    "stratified",        "eroded",    "look",   "province",
      "strata", "talus",      "placeable"};
  for (const FeatureKind& kind : kinds) known.push_back(kind.section);
  root.only(known);
}

void World::Builder::read_general() {
  spec.seed = static_cast<std::uint64_t>(root.integer("seed", std::numeric_limits<std::int64_t>::min(),
                                                      std::numeric_limits<std::int64_t>::max()));
  spec.resolution = static_cast<int>(root.integer("resolution", 1, kMaxResolution));
}

void World::Builder::read_strata_wavelength() {
  // A surface without noise has no wavelength to use instead.
  const bool borrowed = !root.has("strata_wavelength") && spec.surface.noise();
  spec.strata_wavelength = borrowed ? spec.surface.wavelength
                                    : root.length("strata_wavelength", {kMinLength, kMaxLength},
                                                  {spec.resolution, {0, kMaxLength}, true});
}

void World::Builder::read_sea() {
  if (!root.has("sea_level")) return;
  spec.sea_level = root.length("sea_level", {0, kMaxHeight}, {spec.resolution, {0, kMaxHeight}});
  world.sea_fx_ = static_cast<std::int32_t>(rounded(*spec.sea_level * spec.resolution * kSubvoxels));
}

void World::Builder::read_method() {
  if (root.has("method")) spec.method = static_cast<Method>(root.choice("method", {"slope", "erosion"}));
  if (spec.method == Method::erosion) {
    spec.erosion_steps = static_cast<int>(root.integer("erosion_steps", 1, kMaxErosionSteps));
  } else if (root.has("erosion_steps")) {
    root.fail("erosion_steps", "is for method = \"erosion\"; leave it out or choose that method");
  }
}

MaterialId World::Builder::add_material(const std::string& name, Colour colour, MaterialKind kind) {
  const MaterialId id{static_cast<std::uint16_t>(world.materials_.size())};
  world.materials_.push_back({id, name, colour, kind});
  return id;
}

MaterialId FeatureSection::add_material(TableReader& table, MaterialKind kind) {
  const MaterialId id{static_cast<std::uint16_t>(materials_.size())};
  const std::string name = table.material_name(names_);
  materials_.push_back({id, name, table.colour(), kind});
  return id;
}

std::optional<MaterialId> FeatureSection::material_named(std::string_view name) const {
  const auto found = std::find_if(materials_.begin() + 2, materials_.end(),
                                  [&](const Material& material) { return material.name == name; });
  return found == materials_.end() ? std::nullopt : std::optional{found->id};
}

void World::Builder::read_materials(PlacesReader& places) {
  auto stratified = root.tables("stratified");
  if (!stratified.empty()) stratified_line = stratified.front().line();
  if (root.has("strata")) {
    if (auto strata = root.table("strata")) {
      strata->only({"repeat", "octaves"});
      if (strata->has("octaves")) {
        spec.strata_octaves = static_cast<int>(strata->integer("octaves", 1, kMaxLayerOctaves));
      }
      spec.strata_repeat = strata->has("repeat") && strata->boolean("repeat");
    }
  }
  spec.stratified = read_stratified(stratified, spec.strata_repeat, names);
  auto eroded = root.tables("eroded");
  spec.eroded = read_eroded(eroded, spec, places, names);
  if (root.has("talus")) {
    if (auto talus = root.table("talus")) spec.talus = read_talus(*talus, spec);
  }
  add_material("air", {186, 215, 236}, MaterialKind::air);
  add_material("water", {58, 108, 150}, MaterialKind::water);
  for (const StratifiedSpec& s : spec.stratified) add_material(s.name, s.colour, MaterialKind::stratified);
  for (const ErodedSpec& e : spec.eroded) add_material(e.name, e.colour, MaterialKind::eroded);
}

void World::Builder::read_features(std::span<const FeatureKind> kinds, PlacesReader& places,
                                   const WorldFiles& files, bool after_looks) {
  std::string_view carver;
  for (const FeatureKind& kind : kinds) {
    if (kind.after_looks != after_looks || !root.has(kind.section)) continue;
    FeatureSection section{root,  kind.section,     spec, names, world.materials_, places,
                           files, world.look_names_};
    std::shared_ptr<const Feature> feature = kind.read(section);
    if (!feature) continue;
    if (feature->carves() && !carver.empty()) {
      root.fail(kind.section, text_of("a world has one kind of caves; leave this or [", carver, "] out"));
    }
    if (feature->carves()) carver = kind.section;
    world.features_.push_back(std::move(feature));
  }
}

void World::Builder::read_world_looks(PlacesReader& places) {
  const auto deepest =
      std::max_element(spec.stratified.begin(), spec.stratified.end(),
                       [](const auto& a, const auto& b) { return a.depth_q16 < b.depth_q16; });
  const auto lowest = spec.strata_repeat || spec.stratified.empty() ? 0 : deepest - spec.stratified.begin();
  const auto id_of = [](std::size_t layer) { return MaterialId{static_cast<std::uint16_t>(2 + layer)}; };
  LookTables looks = read_looks(root, places, spec.places.looks,
                                {id_of(static_cast<std::size_t>(lowest)), id_of(spec.stratified.size())},
                                names, world.materials_);
  world.shown_by_ = std::move(looks.shown_by);
  world.look_names_ = std::move(looks.names);
}

/// The name of the surface's height in errors; regions derive it.
std::string World::Builder::height_term() const {
  if (!spec.surface.regions) return "surface.amplitude";
  return text_of("the highest ground (", spec.surface.amplitude, " units)");
}

void World::Builder::check_lifts() {
  std::string terms = height_term();
  Feature::MaxLift largest;
  for (const auto& feature : world.features_) {
    const Feature::MaxLift lift = feature->max_lift();
    if (lift.terms.empty()) continue;
    world.max_lift_q16_ += lift.q16;
    terms += ", " + lift.terms;
    if (largest.terms.empty() || lift.q16 > largest.q16) largest = lift;
  }
  const double voxels = (units_of(world.max_lift_q16_) + spec.surface.amplitude) * spec.resolution;
  if (voxels <= kMaxHeight) return;
  errors.add(
      largest.line, 0, largest.key,
      text_of(terms, ", * resolution, are ", std::ceil(voxels), " voxels in all; at most ", kMaxHeight));
}

void World::Builder::derive_strata() {
  const auto amplitude_q16 = rounded(spec.surface.amplitude * 65536.0);
  const auto sequence = spec.strata_repeat ? repeated_sequence : layer_sequence;
  for (const std::size_t i : sequence(spec.stratified, amplitude_q16, world.max_lift_q16_)) {
    const StratifiedSpec& material = spec.stratified[i];
    world.strata_.push_back({world.materials_[2 + i].id, material.thickness_q16, material.roughness});
  }
  if (!world.strata_.empty()) return;
  errors.add(stratified_line, 0, "stratified.thickness",
             text_of("filling 1.25 * ", height_term(),
                     world.max_lift_q16_ > 0 ? " and how far strata are sunk" : "", " takes more than ",
                     kMaxLayers, " layers; at most ", kMaxLayers, ", so make the thicknesses larger"));
}

void World::Builder::derive_loose() {
  for (const ErodedSpec& eroded : spec.eroded) {
    LooseSpec loose = loose_of(eroded, spec.resolution);
    loose.material = world.materials_[2 + spec.stratified.size() + world.loose_.size()].id;
    world.loose_.push_back(loose);
  }
  world.loose_bottom_up_.resize(world.loose_.size());
  std::iota(world.loose_bottom_up_.begin(), world.loose_bottom_up_.end(), std::size_t{0});
  // Heaviest lowest; of equal weights the first in the spec is on top, so the last is lowest.
  std::sort(world.loose_bottom_up_.begin(), world.loose_bottom_up_.end(), [&](std::size_t a, std::size_t b) {
    const double weight_a = world.loose_[a].weight;
    const double weight_b = world.loose_[b].weight;
    return weight_a != weight_b ? weight_a > weight_b : a > b;
  });
  if (spec.method == Method::slope) return;
  // A single material never exceeds its highest column, except by the rounding of a step of 1 (c below 8). A
  // material under others lifts them by its inflow: a step from each of eight neighbours.
  world.rise_fx_ = 8;
  for (std::size_t i = 0; i + 1 < world.loose_.size(); ++i) {
    const LooseSpec& loose = world.loose_[world.loose_bottom_up_[i]];
    world.rise_fx_ += spec.erosion_steps * 8 * erosion_step_fx(loose.c_fx);
  }
}

void World::Builder::check_rows() {
  const HeightRange rows = height_range(world);
  if (is_height_range(rows)) return;
  root.fail("erosion_steps", text_of("with these angles of repose the ground may rise to row ", rows.high,
                                     "; at most ", kMaxWorldRows, " rows are allowed"));
}

const World::ShownBy* World::shown_by(MaterialId material) const {
  const std::size_t place = to_integer(material);
  return place < shown_by_.size() && shown_by_[place] ? &*shown_by_[place] : nullptr;
}

int World::erosion_steps_at(Lod lod) const {
  return spec_.method == Method::erosion ? std::max(1, spec_.erosion_steps >> lod.value()) : 0;
}

// A single step is a single step at every level, by the rules of both versions.
GeneratorVersion World::generator_version() const {
  return erosion_steps_at(Lod{}) > 1 || spec_.surface.regions || spec_.places.any() || spec_.talus ||
                 has_objects()
             ? GeneratorVersion::v3
             : GeneratorVersion::v2;
}

void World::Builder::derive_halo() {
  world.halo_ = world.feature_halo(Lod{});
  if (spec.method == Method::erosion) {
    world.halo_ = std::max(world.halo_, 2 * world.erosion_steps_at(Lod{}));
    return;
  }
  for (const LooseSpec& loose : world.loose_) world.halo_ = std::max(world.halo_, loose.halo_at(Lod{}));
  if (!spec.talus) return;
  const ApronNumbers aprons = apron_numbers(world);
  world.halo_ += apron_halo(aprons) + 1;
  if (aprons.max_fx > 0)
    world.loose_[spec.talus->of].without_aprons_from =
        static_cast<int>(std::bit_width(static_cast<unsigned>(aprons.steps)));
}

const World& default_world() {
  // Built in and tested, so it parses.
  static const World world = *World::parse(default_world_toml(), "default.toml");
  return world;
}

}  // namespace talus::terrain
