// Surface "regions": continents with plains, hills, mountain ranges, mesas in terraces, and rivers that meet
// in a Y and run to the sea.
//
// Slow fields, computed at every sixteenth column and interpolated, describe the character of the land: its
// height, hilliness and climate. The shape, noise at every column, adds the hills and ridges. Everything is a
// pure function of the column.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <talus/terrain/fbm.h>
#include <talus/terrain/regions_spec.h>

#include "noise/rotated_fbm.h"
#include "surface/equalizer.h"
#include "surface/spline.h"

namespace talus::terrain {

/// The slow fields; a row of each is interpolated between samples.
enum class Slow : std::uint8_t {
  base,         // height of the plain
  belt,         // 0 to 1: strength of a mountain range
  hills,        // their height
  mesa,         // 0 to 1: strength of mesa country
  terrace,      // the field from which mesas take their steps
  temperature,  // -1 to 1.2
  moisture,     // -1 to 1
  river,        // signed distance from a river's middle, terrain units
  tributary_a,  // distance from a tributary's middle, on the river's positive side
  tributary_b,  // distance from a tributary's middle, on its other side
  shape_0,      // the shape's first octaves
  shape_1,
  shape_2,
  shape_3,
  shape_4,
};
inline constexpr std::size_t kSlowCount = 15;  // in addition: SlowFields::others
/// Number of the shape's octaves that are slow.
inline constexpr int kSlowOctaves = 5;
/// First octave of the small hills.
inline constexpr int kSmallFrom = 3;
inline constexpr int kRiverOctaves = 2;
/// Base columns from one sample to the next.
inline constexpr std::int64_t kSampleStep = 16;

/// A seed from a name, so that other contents of a world do not affect it.
[[nodiscard]] std::uint64_t named_seed(std::uint64_t world_seed, std::string_view name);

/// The slow fields in the numbers used to compute them.
struct SlowFields {
  struct Field {
    RotatedNoise noise;
    Equalizer equalized;
    bool warped = false;
  };
  Field continents, ranges, hilliness, mesas, temperature, moisture;
  std::array<RotatedNoise, 3> rivers;     // rivers, and tributaries on each side of them
  std::array<float, 2> saddle;            // kappa of rivers and of tributaries, 1 / columns^2
  std::array<RotatedNoise, 2> warp_east;  // wide and narrow
  std::array<RotatedNoise, 2> warp_south;
  std::array<float, 2> warp_reach;  // in 2^-8 columns
  Spline base, inland, belt, passes, hills;
  float warmer, wetter, mesas_anywhere;
  std::array<float, 2> mesa_coast;
  float units_a_column;
  std::vector<Field> others;  // fields used only by places
};

/// The parameters of the shape, in terrain units.
struct RegionShape {
  std::array<float, kShapeOctaves> ridge_weights;
  std::array<float, kShapeOctaves> hill_weights;
  std::array<float, kShapeOctaves> small_weights;
  float ridge_scale;  // 1.5 / sum of the ridge weights
  float range_base, range_relief, mesa_height, mesa_roughness, bed, sea_level;
  std::array<float, 2> half_width, valley, carve;
  Spline terraces;
  float subvoxels_a_unit;
};

struct Regions {
  SlowFields slow;
  RotatedNoise shape;
  RegionShape at_columns;
  Fbm border;  // makes the borders of places ragged
};

/// `others`: fields that places use.
[[nodiscard]] Regions regions_of(const RegionsSpec& spec, std::span<const FieldSpec> others,
                                 std::uint64_t world_seed, int resolution);

}  // namespace talus::terrain
