#include <talus/terrain/world.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <sstream>

#include "bends.h"
#include "canonical_hash.h"
#include "cave_plan.h"
#include "spec_reader.h"
#include "surface_plan.h"
#include "underground_plan.h"

#include <talus/terrain/erosion.h>
#include <talus/terrain/strata.h>
#include <talus/terrain/surface.h>

namespace talus::terrain {
namespace {

constexpr std::int64_t kMaxPeriod = std::int64_t{1} << 24;
constexpr std::int32_t kMaxLooseThickness_fx = std::int32_t{1} << 20;
constexpr int kMaxHalo = 64;
constexpr std::size_t kMaxMaterials = 255;
constexpr double kMaxHeight = 32768;  // voxels

std::int32_t tangent_fx(double degrees) {
  return static_cast<std::int32_t>(std::floor(kSubvoxels * std::tan(degrees * std::numbers::pi / 180) + 0.5));
}

// 256 R thickness, rounded, in integers all the way.
std::int64_t subvoxels_of(std::int64_t units_q16, int resolution) {
  return (units_q16 * resolution * kSubvoxels + 32768) >> 16;
}

}  // namespace

tl::expected<World, SpecError> World::parse(std::string_view toml, std::string_view file,
                                            const LoadHeightMap& load) {
  auto read = read_spec(toml, file);
  if (!read) return tl::unexpected(read.error());
  const SpecLines& lines = read->lines;
  const auto refuse = [&](int line, const std::string& key, const auto&... what) {
    std::ostringstream message;
    message << file << ':' << line << ": " << key << ": ";
    (message << ... << what);
    return tl::unexpected(error_of(message.str()));
  };

  World world;
  world.spec_ = std::move(read->spec);
  const WorldSpec& spec = world.spec_;
  const double resolution = spec.resolution;

  if (spec.surface.amplitude * resolution > kMaxHeight) {
    return refuse(lines.amplitude, "surface.amplitude", "amplitude * resolution is ",
                  spec.surface.amplitude * resolution, " voxels; at most 32768");
  }
  if (const auto fault = complete_surface(world.spec_, lines, load)) {
    return refuse(fault->line, fault->key, fault->what);
  }
  const Surface surface = surface_of(spec);
  const bool wrong_period = surface.noise.period < 2 || surface.noise.period > kMaxPeriod;
  if (spec.surface.noise() && wrong_period) {
    return refuse(lines.wavelength, "surface.wavelength", "wavelength * resolution is ", surface.noise.period,
                  " voxels; 2 to ", kMaxPeriod);
  }
  if (layer_noise(spec, 0, 0).period > kMaxPeriod) {
    return refuse(lines.strata_wavelength, "strata_wavelength", "strata_wavelength * resolution is ",
                  layer_noise(spec, 0, 0).period, " voxels; at most ", kMaxPeriod);
  }
  if (const auto fault = check_underground(spec, lines)) return refuse(fault->line, fault->key, fault->what);
  world.highest_fx_ = static_cast<std::int32_t>(std::floor(surface.highest_fx + 0.5F));
  if (spec.sea_level) {
    if (*spec.sea_level * resolution > kMaxHeight) {
      return refuse(lines.sea_level, "sea_level", "sea_level * resolution is ", *spec.sea_level * resolution,
                    " voxels; at most 32768");
    }
    world.sea_fx_ = static_cast<std::int32_t>(std::floor(*spec.sea_level * resolution * kSubvoxels + 0.5));
  }

  const std::size_t materials = spec.stratified.size() + spec.eroded.size() + spec.veins.size();
  if (materials > kMaxMaterials) {
    return refuse(lines.stratified, "stratified", materials, " stratified and eroded materials",
                  spec.veins.empty() ? "" : " and ores", "; at most ", kMaxMaterials);
  }
  const auto add_material = [&](const std::string& name, Colour colour, MaterialKind kind) {
    const MaterialId id{static_cast<std::uint16_t>(world.materials_.size())};
    world.materials_.push_back({id, name, colour, kind});
    return id;
  };
  add_material("air", {186, 215, 236}, MaterialKind::air);
  add_material("water", {58, 108, 150}, MaterialKind::water);
  std::vector<MaterialId> stratified_ids;
  for (const StratifiedSpec& s : spec.stratified) {
    stratified_ids.push_back(add_material(s.name, s.colour, MaterialKind::stratified));
  }

  const auto amplitude_q16 = static_cast<std::int64_t>(std::floor(spec.surface.amplitude * 65536.0 + 0.5));
  const std::int64_t bend_q16 = greatest_bend_q16(spec);
  for (const std::size_t i : layer_sequence(spec.stratified, amplitude_q16, bend_q16)) {
    world.strata_.push_back(
        {stratified_ids[i], spec.stratified[i].thickness_q16, spec.stratified[i].roughness});
  }
  if (world.strata_.empty()) {
    return refuse(lines.stratified, "stratified.thickness", "filling 1.25 * amplitude",
                  bend_q16 > 0 ? " and the depth of folds and faults" : "", " takes more than ", kMaxLayers,
                  " layers; at most ", kMaxLayers, ", so make the thicknesses larger");
  }

  for (std::size_t i = 0; i < spec.eroded.size(); ++i) {
    const ErodedSpec& e = spec.eroded[i];
    const int line = lines.eroded_thickness[i];
    const std::string key = "eroded[" + std::to_string(i) + "].thickness";
    const std::int64_t t_fx = subvoxels_of(e.thickness_q16, spec.resolution);
    if (t_fx > kMaxLooseThickness_fx) {
      return refuse(line, key, "thickness * resolution is ", t_fx / kSubvoxels, " voxels; at most 4096");
    }
    LooseSpec loose{add_material(e.name, e.colour, MaterialKind::eroded), e.weight,
                    static_cast<std::int32_t>(t_fx), tangent_fx(e.max_slope), tangent_fx(e.angle_of_repose)};
    const int halo = loose.halo_at(Lod{});
    if (halo > kMaxHalo && spec.method == Method::slope) {
      return refuse(line, key, "at this angle of repose it needs a halo of ", halo, " columns; at most ",
                    kMaxHalo, ", so make the thickness smaller or the angle steeper");
    }
    world.halo_ = std::max(world.halo_, halo);
    world.loose_.push_back(loose);
  }
  for (const OreSpec& ore : spec.veins) add_material(ore.name, ore.colour, MaterialKind::stratified);
  world.loose_bottom_up_.resize(world.loose_.size());
  std::iota(world.loose_bottom_up_.begin(), world.loose_bottom_up_.end(), std::size_t{0});
  // Heaviest lowest; of equal weight the first of the spec on top, so the last of the spec lowest.
  std::sort(world.loose_bottom_up_.begin(), world.loose_bottom_up_.end(), [&](std::size_t a, std::size_t b) {
    const double weight_a = world.loose_[a].weight;
    const double weight_b = world.loose_[b].weight;
    return weight_a != weight_b ? weight_a > weight_b : a > b;
  });
  if (spec.method == Method::erosion) {
    world.halo_ = 2 * spec.erosion_steps;
    // A material alone never passes its highest column, but for what a step of 1 rounds up to (c below 8).
    // What lies under others lifts them by what flows in: a step from each of eight neighbours.
    world.rise_fx_ = 8;
    for (std::size_t i = 0; i + 1 < world.loose_.size(); ++i) {
      const LooseSpec& loose = world.loose_[world.loose_bottom_up_[i]];
      world.rise_fx_ += spec.erosion_steps * 8 * erosion_step_fx(loose.c_fx);
    }
  }
  if (const auto fault = fault_of_caves(spec, lines)) return refuse(fault->line, fault->key, fault->what);
  world.halo_ = std::max(world.halo_, cave_halo(world, Lod{}));
  world.fingerprint_ = hash_canonical_form(world.canonical_form());
  return world;
}

const World& default_world() {
  // Built in and tested: it parses.
  static const World world = *World::parse(default_world_toml(), "default.toml");
  return world;
}

}  // namespace talus::terrain
