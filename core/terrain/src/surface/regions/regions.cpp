#include "surface/regions/regions.h"

#include <algorithm>
#include <cmath>

#include <talus/terrain/world.h>

#include "spec/units.h"

namespace talus::terrain {
namespace {

constexpr double kPi = 3.14159265358979323846;
// The warp: how far and how long its waves are, in terrain units.
constexpr std::array<double, 2> kWarpReach{130, 45};
constexpr std::array<FieldSpec, 2> kWarps{{{520, 3, 0.5}, {150, 1, 0.5}}};
// Weights of the shape's octaves: of hills the first is 1.7, and each next .54 of it; small land adds to the
// fields of mesas, four times as much of each as ridges have.
constexpr double kHillWeight = 1.7;
constexpr double kHillGain = 0.54;
constexpr double kSmallWeight = 6.8;

std::array<float, 2> floats(const std::array<double, 2>& pair) {
  return {static_cast<float>(pair[0]), static_cast<float>(pair[1])};
}

double highest(const std::vector<Knot>& knots) {
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

Regions regions_of(const RegionsSpec& spec, std::uint64_t world_seed, int resolution) {
  const auto noise = [&](std::string_view name, const FieldSpec& field) {
    const std::uint64_t seed = named_seed(world_seed, name);
    return RotatedNoise{seed, rounded(field.wavelength * resolution), field.octaves, field.gain,
                        static_cast<int>(seed % kLatticeAngles)};
  };
  const auto field = [&](std::string_view name, const FieldSpec& from) {
    const RotatedNoise of = noise(name, from);
    return SlowFields::Field{of, Equalizer{of}};
  };
  const auto saddle = [&](const FieldSpec& from) {
    const double wave = 2 * kPi / static_cast<double>(rounded(from.wavelength * resolution));
    return static_cast<float>(0.5 * wave * wave);
  };
  const auto reach = [&](double units) {
    return static_cast<float>(units * resolution * static_cast<double>(kSubvoxels));
  };
  SlowFields slow{field("continents", spec.continents),
                  field("ranges", spec.ranges),
                  field("hilliness", spec.hilliness),
                  field("mesas", spec.mesas),
                  field("temperature", spec.temperature),
                  field("moisture", spec.moisture),
                  {noise("rivers", spec.rivers), noise("tributaries a", spec.tributaries),
                   noise("tributaries b", spec.tributaries)},
                  {saddle(spec.rivers), saddle(spec.tributaries)},
                  {noise("warp east", kWarps[0]), noise("warp east, narrow", kWarps[1])},
                  {noise("warp south", kWarps[0]), noise("warp south, narrow", kWarps[1])},
                  {reach(kWarpReach[0]), reach(kWarpReach[1])},
                  Spline{spec.base},
                  Spline{spec.inland},
                  Spline{spec.belt},
                  Spline{spec.broken},
                  Spline{spec.hills},
                  static_cast<float>(spec.temperature_bias),
                  static_cast<float>(spec.moisture_bias),
                  static_cast<float>(spec.mesa_any),
                  floats(spec.mesa_coast),
                  static_cast<float>(1.0 / resolution)};
  RegionShape shape{{},
                    {},
                    {},
                    0,
                    static_cast<float>(spec.belt_base),
                    static_cast<float>(spec.belt_relief),
                    static_cast<float>(spec.mesa_height),
                    static_cast<float>(spec.mesa_roughness),
                    static_cast<float>(spec.bed_depth),
                    static_cast<float>(spec.sea_level),
                    floats(spec.river_half_width),
                    floats(spec.valley_width),
                    floats(spec.carve),
                    Spline{spec.terrace},
                    static_cast<float>(resolution * kSubvoxels)};
  double ridge = 1;
  double hill = kHillWeight;
  double all_ridges = 0;
  for (std::size_t k = 0; k < kShapeOctaves; ++k) {
    shape.ridge_weights[k] = static_cast<float>(ridge);
    shape.hill_weights[k] = k == 0 ? 0.0F : static_cast<float>(hill);
    shape.small_weights[k] = k < kSlowOctaves ? 0.0F : static_cast<float>(kSmallWeight * ridge);
    if (k > 0) hill *= kHillGain;
    all_ridges += ridge;
    ridge *= spec.shape.gain;
  }
  shape.ridge_scale = static_cast<float>(1.5 / all_ridges);
  return {std::move(slow), noise("shape", spec.shape), std::move(shape)};
}

double highest_land(const RegionsSpec& spec) {
  constexpr double kHighestRidge = 1.12;
  return spec.sea_level + highest(spec.base) + spec.belt_base + highest(spec.hills) +
         kHighestRidge * spec.belt_relief + spec.mesa_height;
}

}  // namespace talus::terrain
