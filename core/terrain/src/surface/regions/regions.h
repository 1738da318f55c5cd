// Surface "regions": continents with plains, hills, mountain ranges, mesas in terraces, and rivers that meet
// in a Y and run to the sea.
//
// Slow fields, drawn at every eighth column and interpolated, say how the land is at a place: how high, how
// hilly, how dry. The shape, noise at every column, says what hill or ridge is there. All of it is a pure
// function of the column.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "noise/rotated_fbm.h"
#include "surface/equalizer.h"
#include "surface/spline.h"

namespace talus::terrain {

struct FieldSpec {
  double wavelength = 0;  // terrain units
  int octaves = 0;
  double gain = 0;
};

/// What an author chooses; lengths and heights in terrain units, heights over the sea. Fields take every
/// value from -1 to 1 as often.
struct RegionsSpec {
  double sea_level = 128;

  FieldSpec continents{9000, 7, 0.5};
  std::vector<Knot> base{{-1, -60}, {-0.62, -42}, {-0.38, -16}, {-0.26, -4}, {-0.2, 1.5},
                         {-0.1, 6}, {0.1, 13},    {0.45, 26},   {1, 52}};       // height by continents
  std::vector<Knot> inland{{-0.5, 0.1}, {-0.25, 0.12}, {-0.1, 0.5}, {0.1, 1}};  // 0 to 1 by continents

  FieldSpec ranges{7000, 3, 0.3};
  std::vector<Knot> belt{{0, 1}, {0.1, 0.93}, {0.28, 0.5}, {0.45, 0.14}, {0.58, 0}};  // by |ranges|
  std::vector<Knot> broken{{-0.7, 0.12}, {-0.1, 0.6}, {0.4, 1}};                      // by hilliness: passes
  double belt_base = 70;                                                              // what a range lifts
  double belt_relief = 270;                                                           // its ridges over that

  FieldSpec hilliness{2600, 3, 0.5};
  std::vector<Knot> hills{{-1, 9}, {-0.2, 16}, {0.3, 34}, {0.7, 80}, {1, 110}};  // their height

  FieldSpec mesas{1250, 5, 0.45};
  std::vector<Knot> terrace{{-0.16, 0},   {-0.1, 0.3},  {0.02, 0.34}, {0.07, 0.62},
                            {0.24, 0.66}, {0.29, 0.97}, {0.8, 1}};  // share of the height by mesas
  double mesa_height = 95;
  double mesa_any = 0;  // how much of them there is where it is neither warm nor dry
  std::array<double, 2> mesa_coast{-0.16, 0.02};  // of continents: from none to all
  double mesa_roughness = 0.36;

  FieldSpec temperature{15000, 5, 0.5};
  FieldSpec moisture{8000, 5, 0.5};
  double temperature_bias = 0;
  double moisture_bias = 0;

  FieldSpec rivers{4600, 2, 0.3};
  FieldSpec tributaries{1900, 2, 0.3};
  std::array<double, 2> river_half_width{13, 9};  // of rivers and of tributaries
  std::array<double, 2> valley_width{240, 130};   // from the middle to where the valley ends
  std::array<double, 2> carve{45, 26};            // land over that is cut less and less
  double bed_depth = 5.5;

  FieldSpec shape{1400, 8, 0.47};
};

/// What the slow fields say of a place; a row of each is interpolated between samples.
enum class Slow : std::uint8_t {
  base,         // height of the plain
  belt,         // 0 to 1: how much of a mountain range
  hills,        // their height
  mesa,         // 0 to 1: how much mesa country
  terrace,      // the field whose steps mesas are
  temperature,  // -1 to 1.2
  moisture,     // -1 to 1
  river,        // signed distance from a river's middle, terrain units
  tributary_a,  // from a tributary's, where `river` is positive
  tributary_b,  // where it is not
  shape_0,      // the shape's first octaves
  shape_1,
  shape_2,
};
inline constexpr std::size_t kSlowCount = 13;
/// The octaves of the shape that are slow.
inline constexpr int kSlowOctaves = 3;
inline constexpr int kShapeOctaves = 8;
/// Base columns from one sample to the next.
inline constexpr std::int64_t kSampleStep = 8;

/// The seed of what bears this name: so whatever a world has beside it changes nothing.
[[nodiscard]] std::uint64_t named_seed(std::uint64_t world_seed, std::string_view name);

/// The slow fields in the numbers they are computed with.
struct SlowFields {
  struct Field {
    RotatedNoise noise;
    Equalizer equalized;
  };
  Field continents, ranges, hilliness, mesas, temperature, moisture;
  std::array<RotatedNoise, 3> rivers;     // rivers, tributaries on either side of them
  std::array<float, 2> saddle;            // kappa of rivers and of tributaries, 1 / columns^2
  std::array<RotatedNoise, 2> warp_east;  // wide and narrow
  std::array<RotatedNoise, 2> warp_south;
  std::array<float, 2> warp_reach;  // in 2^-8 columns
  Spline base, inland, belt, broken, hills;
  float temperature_bias, moisture_bias, mesa_any;
  std::array<float, 2> mesa_coast;
  float units_a_column;
};

/// What the shape is computed with, in terrain units.
struct RegionShape {
  std::array<float, kShapeOctaves> ridge_weights;
  std::array<float, kShapeOctaves> hill_weights;
  std::array<float, kShapeOctaves> small_weights;
  float ridge_scale;  // 1.5 / sum of the ridge weights
  float belt_base, belt_relief, mesa_height, mesa_roughness, bed_depth, sea_level;
  std::array<float, 2> half_width, valley_width, carve;
  Spline terrace;
  float subvoxels_a_unit;
};

struct Regions {
  SlowFields slow;
  RotatedNoise shape;
  RegionShape at_columns;
};

[[nodiscard]] Regions regions_of(const RegionsSpec& spec, std::uint64_t world_seed, int resolution);

/// No land is higher: terrain units.
[[nodiscard]] double highest_land(const RegionsSpec& spec);

}  // namespace talus::terrain
