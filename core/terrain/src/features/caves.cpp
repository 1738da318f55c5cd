// [caves]: tunnels and chambers (docs/DESIGN.md, "Caves"). cave_shape.h computes their shape, cave_carver.h
// removes unsafe parts.
#include "features/caves.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <talus/terrain/lattice_hash.h>

#include "features/cave_carver.h"
#include "spec/units.h"

namespace talus::terrain {
namespace {

constexpr int kOctaves = 2;
constexpr std::uint64_t kCaveSeed = 0x4341564500000000U;

// The range of a length in terrain units and in voxels.
struct Key {
  const char* name;
  Range units;
  Range voxels;
};
constexpr Key kLow{"low", {0, kMaxHeight}, {0, kMaxHeight}};
constexpr Key kHigh{"high", {0, kMaxHeight}, {0, kMaxHeight}};
constexpr Key kClimbWavelength{"climb_wavelength", {kMinLength, kMaxLength}, {2, kMaxLength}};
constexpr Key kWavelength{"wavelength", {kMinLength, kMaxLength}, {2, kMaxLength}};
constexpr Key kHeight{"height", {kMinLength, kMaxHeight}, {1, 4096}};
constexpr Key kChamberWavelength{"chamber_wavelength", {kMinLength, kMaxLength}, {2, kMaxLength}};
constexpr Key kChamberHeight{"chamber_height", {kMinLength, kMaxHeight}, {1, 4096}};
constexpr Key kRoof{"roof", {0, kMaxHeight}, {0, 256}};
constexpr Key kSpan{"span", {kMinLength, kMaxHeight}, {1, 64}};

std::unique_ptr<const Feature> read_caves(FeatureSection& section) {
  auto table = section.table();
  if (!table) return nullptr;
  const WorldSpec& world = section.spec();
  std::vector<std::string_view> known;
  const auto length = [&](const Key& key) {
    known.emplace_back(key.name);
    return table->length(key.name, key.units, {world.resolution, key.voxels});
  };
  const auto real = [&](const char* name, Range range, std::string_view note = {}) {
    known.emplace_back(name);
    return table->real(name, range, note);
  };
  const auto fx = [&](double units) {
    return static_cast<std::int32_t>(rounded(units * world.resolution * kSubvoxels));
  };
  const auto noise = [&](std::uint64_t which, double wavelength) {
    // Separated from the seeds of the surface's octaves.
    return Fbm{derived_seed(world.seed, kCaveSeed + which), rounded(wavelength * world.resolution), kOctaves};
  };
  const double low = length(kLow);
  const double high = length(kHigh);
  const double climb_wavelength = length(kClimbWavelength);
  const double wavelength = length(kWavelength);
  const double width = real("width", {wavelength / 1024, std::min(wavelength / 2, kMaxHeight)},
                            " (a 1024th to a half of the wavelength)");
  const double height = length(kHeight);
  const double chamber_wavelength = length(kChamberWavelength);
  const double chamber_threshold = real("chamber_threshold", {0, 1});
  const double chamber_height = length(kChamberHeight);
  known.emplace_back(kRoof.name);
  const double roof = table->has(kRoof.name) ? length(kRoof) : 0;
  const double span = length(kSpan);
  table->only(known);
  if (high < low) table->fail("high", text_of(high, " is less than low; at least ", low));

  CavePlan plan;
  plan.tunnels = noise(0, wavelength);
  plan.chambers = noise(1, chamber_wavelength);
  plan.climb = noise(2, climb_wavelength);
  plan.low_fx = fx(low);
  plan.climb_fx = fx(high) - plan.low_fx;
  // Along its zero lines noise of a wavelength rises by about one over that length.
  plan.half_width_noise = static_cast<std::int32_t>(rounded(kNoiseOne * width / (2 * wavelength)));
  plan.height_fx = fx(height);
  plan.threshold_noise = static_cast<std::int32_t>(rounded(kNoiseOne * chamber_threshold));
  plan.chamber_height_fx = fx(chamber_height);
  plan.roof_fx = fx(roof);
  plan.span = static_cast<int>(rounded(span * world.resolution));
  return std::make_unique<Caves>(plan, world.sea_level.has_value());
}

}  // namespace

void Caves::write_canonical_form(TextWriter& form) const {
  form << "caves periods " << plan_.tunnels.period << ' ' << plan_.chambers.period << ' '
       << plan_.climb.period << " low_fx " << plan_.low_fx << " climb_fx " << plan_.climb_fx << " half_width "
       << plan_.half_width_noise << " height_fx " << plan_.height_fx << " threshold " << plan_.threshold_noise
       << " chamber_height_fx " << plan_.chamber_height_fx << " roof_fx " << plan_.roof_fx << " span "
       << plan_.span << '\n';
}

int Caves::halo(Lod lod) const {
  const int span = plan_.span_at(lod);
  // Adjacent columns also decide where water may reach.
  return span == 0 ? 0 : span + (has_sea_ ? 1 : 0);
}

std::unique_ptr<Carver> Caves::make_carver(const World& world, InstructionSet set) const {
  return std::make_unique<CaveCarver>(plan_, world, set);
}

void Caves::add_overlays(const ChunkSite& site, const Field* /*survey*/,
                         std::vector<Overlay>& overlays) const {
  const CaveAir& air = site.stacks().caves;
  if (air.none()) return;
  Overlay& overlay = overlays.emplace_back(Overlay{kAir, {}, {}});
  site.cut(air.floor, overlay.from);
  site.cut(air.roof, overlay.to);
}

namespace features {

FeatureKind caves() {
  return {"caves", read_caves};
}

}  // namespace features
}  // namespace talus::terrain
