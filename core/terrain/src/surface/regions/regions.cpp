#include "surface/regions/regions.h"

#include <algorithm>
#include <cmath>

#include <talus/terrain/world.h>

#include "spec/units.h"

namespace talus::terrain {
namespace {

constexpr double kPi = 3.14159265358979323846;
// The warp's reach and wavelength in terrain units.
constexpr std::array<double, 2> kWarpReach{130, 45};
struct Waves {
  double wavelength = 0;
  int octaves = 0;
  double gain = 0;
};
constexpr std::array<Waves, 2> kWarps{{{520, 3, 0.5}, {150, 1, 0.5}}};
constexpr double kRiverGain = 0.3;
constexpr double kBorderWavelength = 24;
constexpr int kBorderOctaves = 2;
// Weights of the shape's octaves. Hills: 1.7 for the first, and .54 of the one before for each next. Small
// hills, which are added to the fields of mesas: four times the weights of ridges.
constexpr double kHillWeight = 1.7;
constexpr double kHillGain = 0.54;
constexpr double kSmallWeight = 6.8;

std::array<float, 2> floats(const std::array<double, 2>& pair) {
  return {static_cast<float>(pair[0]), static_cast<float>(pair[1])};
}

double highest(const Curve& knots) {
  double most = knots.front().y;
  for (const Knot& knot : knots) most = std::max(most, knot.y);
  return most;
}

}  // namespace

std::uint64_t named_seed(std::uint64_t world_seed, std::string_view name) {
  std::uint64_t hash = 0xCBF29CE484222325U;  // FNV-1a
  for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001B3U;
  return derived_seed(world_seed, hash);
}

Regions regions_of(const RegionsSpec& spec, std::span<const FieldSpec> others, std::uint64_t world_seed,
                   int resolution) {
  const auto noise = [&](std::string_view name, const Waves& waves) {
    const std::uint64_t seed = named_seed(world_seed, name);
    return RotatedNoise{seed, rounded(waves.wavelength * resolution), waves.octaves, waves.gain,
                        static_cast<int>(seed % kLatticeAngles)};
  };
  const auto field = [&](const FieldSpec& from) {
    const RotatedNoise of = noise(from.name, {from.wavelength, from.octaves, from.gain});
    return SlowFields::Field{of, Equalizer{of}, from.warped};
  };
  const auto river = [&](std::string_view name, double wavelength) {
    return noise(name, {wavelength, kRiverOctaves, kRiverGain});
  };
  const auto saddle = [](const RotatedNoise& of) {
    const double wave = 2 * kPi / static_cast<double>(of.period);
    return static_cast<float>(0.5 * wave * wave);
  };
  const auto reach = [&](double units) {
    return static_cast<float>(units * resolution * static_cast<double>(kSubvoxels));
  };
  const std::array<RotatedNoise, 3> rivers{river(".rivers", spec.river_wavelength),
                                           river(".tributaries a", spec.tributary_wavelength),
                                           river(".tributaries b", spec.tributary_wavelength)};
  SlowFields slow{field(spec.continents),
                  field(spec.ranges),
                  field(spec.hilliness),
                  field(spec.mesas),
                  field(spec.temperature),
                  field(spec.moisture),
                  rivers,
                  {saddle(rivers[0]), saddle(rivers[1])},
                  {noise(".warp east", kWarps[0]), noise(".warp east, narrow", kWarps[1])},
                  {noise(".warp south", kWarps[0]), noise(".warp south, narrow", kWarps[1])},
                  {reach(kWarpReach[0]), reach(kWarpReach[1])},
                  Spline{spec.base},
                  Spline{spec.inland},
                  Spline{spec.belt},
                  Spline{spec.passes},
                  Spline{spec.hills},
                  static_cast<float>(spec.warmer),
                  static_cast<float>(spec.wetter),
                  static_cast<float>(spec.mesas_anywhere),
                  floats(spec.mesa_coast),
                  static_cast<float>(1.0 / resolution),
                  {}};
  RegionShape shape{{},
                    {},
                    {},
                    0,
                    static_cast<float>(spec.range_base),
                    static_cast<float>(spec.range_relief),
                    static_cast<float>(spec.mesa_height),
                    static_cast<float>(spec.mesa_roughness),
                    static_cast<float>(spec.bed),
                    static_cast<float>(spec.sea_level),
                    floats(spec.half_width),
                    floats(spec.valley),
                    floats(spec.carve),
                    Spline{spec.terraces},
                    static_cast<float>(resolution * kSubvoxels)};
  double ridge = 1;
  double hill = kHillWeight;
  double all_ridges = 0;
  for (std::size_t k = 0; k < kShapeOctaves; ++k) {
    shape.ridge_weights[k] = static_cast<float>(ridge);
    shape.hill_weights[k] = k == 0 ? 0.0F : static_cast<float>(hill);
    shape.small_weights[k] = k < kSmallFrom ? 0.0F : static_cast<float>(kSmallWeight * ridge);
    if (k > 0) hill *= kHillGain;
    all_ridges += ridge;
    ridge *= spec.shape_gain;
  }
  shape.ridge_scale = static_cast<float>(1.5 / all_ridges);
  for (const FieldSpec& other : others) slow.others.push_back(field(other));
  return {std::move(slow), noise(".shape", {spec.shape_wavelength, kShapeOctaves, spec.shape_gain}),
          std::move(shape),
          Fbm{named_seed(world_seed, ".border"), rounded(kBorderWavelength * resolution), kBorderOctaves}};
}

double highest_land(const RegionsSpec& spec) {
  constexpr double kHighestRidge = 1.12;
  return spec.sea_level + highest(spec.base) + spec.range_base + highest(spec.hills) +
         kHighestRidge * spec.range_relief + spec.mesa_height;
}

}  // namespace talus::terrain
