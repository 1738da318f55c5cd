#include "spec/canonical_form.h"

#include <bit>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#define XXH_STATIC_LINKING_ONLY
#include <xxhash.h>

#include <talus/terrain/strata.h>
#include <talus/terrain/surface.h>
#include <talus/terrain/world.h>
#include <talus/vectors/little_endian.h>

#include "feature.h"
#include "loose/aprons.h"
#include "place/places.h"
#include "spec/text_writer.h"
#include "surface/regions/regions.h"

namespace talus::terrain {
namespace {

void add_noise(const Surface& surface, SurfaceKind kind, TextWriter& form) {
  form << "surface period " << surface.noise.period << '\n'
       << "surface octaves " << surface.noise.octaves << '\n'
       << "surface gain " << bits_of(surface.gain) << '\n'
       << "surface exponent " << surface.exponent << '\n';
  if (kind == SurfaceKind::ridged) form << "surface ridged feedback " << bits_of(surface.feedback) << '\n';
  if (kind == SurfaceKind::warped) {
    form << "surface warped reach_fx " << bits_of(surface.warp.reach_fx) << " period "
         << surface.warp.east.period << " octaves " << surface.warp.east.octaves << '\n';
  }
}

void add_spline(const char* name, const Spline& spline, TextWriter& form) {
  form << "regions " << name << ' ' << bits_of(spline.first_y());
  for (const Spline::Segment& s : spline.segments()) {
    for (const float number : {s.x, s.reciprocal, s.a, s.b, s.c}) form << ' ' << bits_of(number);
  }
  form << '\n';
}

void add_rotated(const char* name, const RotatedNoise& noise, TextWriter& form) {
  form << "regions " << name << " seed " << noise.seed << " period " << noise.period << " octaves "
       << noise.octaves << " gain " << std::bit_cast<std::uint64_t>(noise.gain) << '\n';
}

void add_numbers(const char* name, std::initializer_list<float> numbers, TextWriter& form) {
  form << "regions " << name;
  for (const float number : numbers) form << ' ' << bits_of(number);
  form << '\n';
}

void add_regions(const Regions& regions, TextWriter& form) {
  const SlowFields& slow = regions.slow;
  const RegionShape& shape = regions.at_columns;
  const auto add_field = [&](const char* name, const SlowFields::Field& field) {
    add_rotated(name, field.noise, form);
    form << "regions " << name << " warped " << (field.warped ? 1 : 0) << '\n';
  };
  add_field("continents", slow.continents);
  add_field("ranges", slow.ranges);
  add_field("hilliness", slow.hilliness);
  add_field("mesas", slow.mesas);
  add_field("temperature", slow.temperature);
  add_field("moisture", slow.moisture);
  add_rotated("rivers", slow.rivers[0], form);
  add_rotated("tributaries", slow.rivers[1], form);
  add_rotated("shape", regions.shape, form);
  for (const SlowFields::Field& other : slow.others) add_field("field", other);
  add_spline("base", slow.base, form);
  add_spline("inland", slow.inland, form);
  add_spline("belt", slow.belt, form);
  add_spline("passes", slow.passes, form);
  add_spline("hills", slow.hills, form);
  add_spline("terraces", shape.terraces, form);
  add_numbers("climate", {slow.warmer, slow.wetter}, form);
  add_numbers(
      "mesas",
      {slow.mesas_anywhere, slow.mesa_coast[0], slow.mesa_coast[1], shape.mesa_height, shape.mesa_roughness},
      form);
  add_numbers("ranges", {shape.range_base, shape.range_relief}, form);
  add_numbers("rivers",
              {shape.half_width[0], shape.half_width[1], shape.valley[0], shape.valley[1], shape.carve[0],
               shape.carve[1], shape.bed},
              form);
  add_numbers("units", {shape.sea_level, shape.subvoxels_a_unit, slow.units_a_column}, form);
}

void add_map(const PlacedMap& map, TextWriter& form) {
  const Field& heights = *map.heights_fx;
  std::vector<std::byte> scratch;
  const auto bytes = little_endian_bytes(std::span{heights.values}, scratch);
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  form << "surface map " << heights.width << ' ' << heights.depth << " heights "
       << to_string(ContentHash{hash.low64, hash.high64}) << " x_q16 " << map.x_q16 << " z_q16 " << map.z_q16
       << " spacing_q16 " << map.spacing_x_q16 << ' ' << map.spacing_z_q16 << " outside "
       << static_cast<int>(map.outside) << " margin_q16 " << map.margin_q16 << '\n';
}

void add_features(const World& world, Feature::Stage stage, TextWriter& form) {
  for (const auto& feature : world.features()) {
    if (feature->stage() == stage) feature->write_canonical_form(form);
  }
}

void add_places(const World& world, const Places& places, TextWriter& form) {
  form << "places lapse " << bits_of(places.reciprocal_lapse) << '\n';
  for (const auto& rules : places.looks) {
    form << "looks " << rules.size() << '\n';
    for (const Places::Case& one : rules) {
      form << "look " << int{one.look};
      for (const Places::Condition& condition : one.conditions) {
        form << ' ' << condition.quantity << (condition.above ? " above " : " below ")
             << bits_of(condition.limit);
      }
      form << '\n';
    }
  }
  for (const Places::Share& share : places.shares) {
    form << "share looks " << share.looks;
    for (const auto* const ramps : {&share.early, &share.late}) {
      for (const Places::Ramp& ramp : *ramps) {
        form << " ramp " << ramp.quantity << ' ' << bits_of(ramp.none) << ' ' << bits_of(ramp.reciprocal);
      }
    }
    form << '\n';
  }
  for (const Material& material : world.materials()) {
    const World::ShownBy* const shown = world.shown_by(material.id);
    if (shown == nullptr) continue;
    form << "material " << to_integer(material.id) << " by looks " << shown->looks << " shows";
    for (const MaterialId each : shown->by_look) form << ' ' << to_integer(each);
    form << '\n';
  }
}

}  // namespace

std::string bits_of(float value) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto bits = std::bit_cast<std::uint32_t>(value);
  std::string text;
  for (int shift = 28; shift >= 0; shift -= 4) text += kDigits[bits >> shift & 15];
  return text;
}

std::string World::canonical_form() const {
  const Surface surface = surface_of(spec_);
  TextWriter form;
  form << "talus world\n"
       << "generator " << to_integer(generator_version()) << '\n'
       << "seed " << spec_.seed << '\n';
  if (const auto noise = spec_.surface.noise()) add_noise(surface, *noise, form);
  if (spec_.surface.height_map) add_map(surface.map, form);
  if (spec_.surface.regions) add_regions(*surface.regions, form);
  if (surface.places) add_places(*this, *surface.places, form);
  form << "surface highest_fx " << bits_of(surface.highest_fx) << '\n'
       << (spec_.method == Method::erosion ? "erosion " + std::to_string(spec_.erosion_steps) + '\n' : "")
       << "sea_fx " << (sea_fx_ ? std::to_string(*sea_fx_) : "none") << '\n';
  if (spec_.strata_octaves != kMaxLayerOctaves) form << "layer octaves " << spec_.strata_octaves << '\n';
  for (std::size_t j = 0; j < strata_.size(); ++j) {
    form << "layer " << to_integer(strata_[j].material) << " thickness_q16 " << strata_[j].thickness_q16
         << " resolution " << spec_.resolution << " period "
         << layer_noise(spec_, strata_[j].roughness, j).period << " swing "
         << bits_of(static_cast<float>(2.0 * strata_[j].roughness)) << '\n';
  }
  add_features(*this, Feature::Stage::strata, form);
  for (const std::size_t i : loose_bottom_up_) {
    form << "loose " << to_integer(loose_[i].material) << " t_fx " << loose_[i].t_fx << " S_fx "
         << loose_[i].S_fx << " c_fx " << loose_[i].c_fx;
    if (loose_[i].share) form << " share " << *loose_[i].share;
    form << '\n';
  }
  if (spec_.talus) {
    const ApronNumbers aprons = apron_numbers(*this);
    // These words are hashed: another word is another fingerprint, and no store of the world opens.
    form << "talus of " << spec_.talus->of << " most_fx " << aprons.max_fx << " share_q8 " << aprons.share_q8
         << " steps " << aprons.steps << " cliff_reach " << aprons.cliff_reach << '\n';
  }
  add_features(*this, Feature::Stage::voxels, form);
  return std::move(form).take();
}

ContentHash hash_canonical_form(const std::string& form) {
  const XXH128_hash_t hash = XXH3_128bits(form.data(), form.size());
  return {hash.low64, hash.high64};
}

}  // namespace talus::terrain
