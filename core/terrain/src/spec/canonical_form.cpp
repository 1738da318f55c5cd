#include "spec/canonical_form.h"

#include <bit>
#include <iomanip>
#include <locale>
#include <sstream>

#define XXH_STATIC_LINKING_ONLY
#include <xxhash.h>

#include <talus/terrain/strata.h>
#include <talus/terrain/surface.h>
#include <talus/terrain/world.h>

#include "feature.h"

namespace talus::terrain {
namespace {

void add_noise(const Surface& surface, SurfaceKind kind, std::ostream& form) {
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

void add_map(const PlacedMap& map, std::ostream& form) {
  const Field& heights = *map.heights_fx;
  const XXH128_hash_t hash =
      XXH3_128bits(heights.values.data(), heights.values.size() * sizeof heights.values[0]);
  form << "surface map " << heights.width << ' ' << heights.depth << " heights "
       << to_string(ContentHash{hash.low64, hash.high64}) << " x_q16 " << map.x_q16 << " z_q16 " << map.z_q16
       << " spacing_q16 " << map.spacing_x_q16 << ' ' << map.spacing_z_q16 << " outside "
       << static_cast<int>(map.outside) << " margin_q16 " << map.margin_q16 << '\n';
}

void add_features(const World& world, Feature::Stage stage, std::ostream& form) {
  for (const auto& feature : world.features()) {
    if (feature->stage() == stage) feature->write_canonical_form(form);
  }
}

}  // namespace

std::string bits_of(float value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::hex << std::setw(8) << std::setfill('0') << std::bit_cast<std::uint32_t>(value);
  return text.str();
}

std::string World::canonical_form() const {
  const Surface surface = surface_of(spec_);
  std::ostringstream form;
  form.imbue(std::locale::classic());  // a host program's locale must not group the digits
  form << "talus world\n"
       << "generator " << to_integer(generator_version()) << '\n'
       << "seed " << spec_.seed << '\n';
  if (const auto noise = spec_.surface.noise()) add_noise(surface, *noise, form);
  if (spec_.surface.height_map) add_map(surface.map, form);
  form << "surface highest_fx " << bits_of(surface.highest_fx) << '\n'
       << (spec_.method == Method::erosion ? "erosion " + std::to_string(spec_.erosion_steps) + '\n' : "")
       << "sea_fx " << (sea_fx_ ? std::to_string(*sea_fx_) : "none") << '\n';
  for (std::size_t j = 0; j < strata_.size(); ++j) {
    form << "layer " << to_integer(strata_[j].material) << " thickness_q16 " << strata_[j].thickness_q16
         << " resolution " << spec_.resolution << " period "
         << layer_noise(spec_, strata_[j].roughness, j).period << " swing "
         << bits_of(static_cast<float>(2.0 * strata_[j].roughness)) << '\n';
  }
  add_features(*this, Feature::Stage::strata, form);
  for (const std::size_t i : loose_bottom_up_) {
    form << "loose " << to_integer(loose_[i].material) << " t_fx " << loose_[i].t_fx << " S_fx "
         << loose_[i].S_fx << " c_fx " << loose_[i].c_fx << '\n';
  }
  add_features(*this, Feature::Stage::voxels, form);
  return form.str();
}

ContentHash hash_canonical_form(const std::string& form) {
  const XXH128_hash_t hash = XXH3_128bits(form.data(), form.size());
  return {hash.low64, hash.high64};
}

}  // namespace talus::terrain
