#include "cave_plan.h"

#include <cmath>
#include <locale>
#include <sstream>

#include <talus/terrain/lattice_hash.h>

namespace talus::terrain {
namespace {

constexpr double kMaxPeriod = 16777216;  // voxels
constexpr double kMaxHeight = 32768;     // voxels
constexpr double kMaxOpening = 4096;     // voxels
constexpr double kMaxRoof = 256;         // voxels
constexpr double kMaxSpan = 64;          // columns
constexpr int kOctaves = 2;

std::int64_t rounded(double value) {
  return static_cast<std::int64_t>(std::floor(value + 0.5));
}

}  // namespace

CavePlan caves_of(const WorldSpec& spec) {
  const CaveSpec& caves = *spec.caves;
  const auto noise = [&](std::uint64_t which, double wavelength) {
    // Apart from the surface's octaves.
    return Fbm{derived_seed(spec.seed, 0x4341564500000000U + which), rounded(wavelength * spec.resolution),
               kOctaves};
  };
  const auto fx = [&](double units) {
    return static_cast<std::int32_t>(rounded(units * spec.resolution * kSubvoxels));
  };
  CavePlan plan;
  plan.tunnels = noise(0, caves.wavelength);
  plan.chambers = noise(1, caves.chamber_wavelength);
  plan.climb = noise(2, caves.climb_wavelength);
  plan.low_fx = fx(caves.low);
  plan.climb_fx = fx(caves.high) - plan.low_fx;
  // Along its zero lines noise of a wavelength rises by about one over that length.
  plan.half_width_noise =
      static_cast<std::int32_t>(rounded(kNoiseOne * caves.width / (2 * caves.wavelength)));
  plan.height_fx = fx(caves.height);
  plan.threshold_noise = static_cast<std::int32_t>(rounded(kNoiseOne * caves.chamber_threshold));
  plan.chamber_height_fx = fx(caves.chamber_height);
  plan.roof_fx = fx(caves.roof);
  plan.span = static_cast<int>(rounded(caves.span * spec.resolution));
  return plan;
}

std::optional<SpecFault> fault_of_caves(const WorldSpec& spec, const SpecLines& lines) {
  if (!spec.caves) return std::nullopt;
  const CaveSpec& caves = *spec.caves;
  struct Length {
    const char* key;
    double units;
    double least;
    double most;
  };
  for (const Length& length : {Length{"low", caves.low, 0, kMaxHeight},
                               {"high", caves.high, 0, kMaxHeight},
                               {"climb_wavelength", caves.climb_wavelength, 2, kMaxPeriod},
                               {"wavelength", caves.wavelength, 2, kMaxPeriod},
                               {"height", caves.height, 1, kMaxOpening},
                               {"chamber_wavelength", caves.chamber_wavelength, 2, kMaxPeriod},
                               {"chamber_height", caves.chamber_height, 1, kMaxOpening},
                               {"roof", caves.roof, 2, kMaxRoof},
                               {"span", caves.span, 1, kMaxSpan}}) {
    if (auto fault = out_of_range(lines.caves.find(length.key)->second, "caves", length.key, length.units,
                                  spec.resolution, length.least, length.most)) {
      return fault;
    }
  }
  if (caves.high < caves.low) {
    return SpecFault{lines.caves.find("high")->second, "caves.high",
                     text_of(caves.high, " is less than low; at least ", caves.low)};
  }
  const double least = caves.wavelength / 1024;
  const double most = caves.wavelength / 2;
  if (caves.width < least || caves.width > most) {
    return SpecFault{lines.caves.find("width")->second, "caves.width",
                     text_of(caves.width, " is out of range; ", least, " to ", most,
                             " (a 1024th to a half of the wavelength)")};
  }
  return std::nullopt;
}

std::string canonical_caves(const CavePlan& plan) {
  std::ostringstream form;
  form.imbue(std::locale::classic());
  form << "caves periods " << plan.tunnels.period << ' ' << plan.chambers.period << ' ' << plan.climb.period
       << " low_fx " << plan.low_fx << " climb_fx " << plan.climb_fx << " half_width "
       << plan.half_width_noise << " height_fx " << plan.height_fx << " threshold " << plan.threshold_noise
       << " chamber_height_fx " << plan.chamber_height_fx << " roof_fx " << plan.roof_fx << " span "
       << plan.span << '\n';
  return form.str();
}

int cave_halo(const World& world, Lod lod) {
  if (!world.spec().caves) return 0;
  const int span = caves_of(world.spec()).span_at(lod);
  // What water may reach is decided by the columns beside, too.
  return span == 0 ? 0 : span + (world.sea_fx() ? 1 : 0);
}

}  // namespace talus::terrain
