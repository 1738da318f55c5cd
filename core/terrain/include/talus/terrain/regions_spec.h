// An author's rules for a surface of kind "regions": [[field]] and the tables of [surface] in a world.toml.
// Lengths and heights are in terrain units, heights above the sea. docs/WORLDS.md explains each key.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace talus::terrain {

/// A point of a curve. Curves are monotone between their knots and level beyond the outer ones.
struct Knot {
  double x = 0;
  double y = 0;
};
using Curve = std::vector<Knot>;  // at least one knot, x ascending

/// A noise with uniformly distributed values from -1 to 1, so that an author can read shares of land off its
/// values. Its name, not its index, decides its values.
struct FieldSpec {
  std::string name;
  double wavelength = 0;  // of the first octave
  int octaves = 0;
  double gain = 0;      // amplitude of an octave relative to the one before
  bool warped = false;  // displaced as the coasts are
};

struct RegionsSpec {
  double sea_level = 0;  // the world's

  FieldSpec continents{"continents", 9000, 7, 0.5, true};
  Curve base{{-1, -60}, {-0.62, -42}, {-0.38, -16}, {-0.26, -4}, {-0.2, 1.5},
             {-0.1, 6}, {0.1, 13},    {0.45, 26},   {1, 52}};       // height of the plain, by continents
  Curve inland{{-0.5, 0.1}, {-0.25, 0.12}, {-0.1, 0.5}, {0.1, 1}};  // 0 to 1, by continents

  FieldSpec ranges{"ranges", 7000, 3, 0.3, true};
  Curve belt{{0, 1}, {0.1, 0.93}, {0.28, 0.5}, {0.45, 0.14}, {0.58, 0}};  // 0 to 1, by |ranges|
  Curve passes{{-0.7, 0.12}, {-0.1, 0.6}, {0.4, 1}};                      // factor of the belt, by hilliness
  double range_base = 70;                                                 // height added by a range
  double range_relief = 270;                                              // height of its ridges above that

  FieldSpec hilliness{"hilliness", 2600, 3, 0.5, false};
  Curve hills{{-1, 9}, {-0.2, 16}, {0.3, 34}, {0.7, 80}, {1, 110}};  // height of the hills

  FieldSpec mesas{"mesas", 1250, 5, 0.45, true};
  Curve terraces{{-0.16, 0},   {-0.1, 0.3},  {0.02, 0.34}, {0.07, 0.62},
                 {0.24, 0.66}, {0.29, 0.97}, {0.8, 1}};  // share of the height, by mesas
  double mesa_height = 95;
  double mesas_anywhere = 0;                      // 0 to 1: share of mesas where it is neither warm nor dry
  std::array<double, 2> mesa_coast{-0.16, 0.02};  // by continents: no mesas, all mesas
  double mesa_roughness = 0.36;

  FieldSpec temperature{"temperature", 15000, 5, 0.5, false};
  FieldSpec moisture{"moisture", 8000, 5, 0.5, false};
  double warmer = 0;  // added to either
  double wetter = 0;

  double river_wavelength = 4600;
  double tributary_wavelength = 1900;
  std::array<double, 2> half_width{13, 9};  // rivers, tributaries; on the plain, wider in lowlands
  std::array<double, 2> valley{240, 130};   // from the river's middle to the valley's end
  std::array<double, 2> carve{45, 26};      // land higher than this is cut less
  double bed = 5.5;                         // depth

  double shape_wavelength = 1400;  // wavelength of the largest hills
  double shape_gain = 0.47;
};

/// Octaves of a field shorter than this, in columns, would be lost between its samples.
inline constexpr double kShortestFieldOctave = 64;
inline constexpr int kShapeOctaves = 8;
/// Maximum width of rivers in lowlands, as a multiple of half_width.
inline constexpr double kWidestRiver = 1.6;

/// Maximum height of land, in terrain units above y = 0.
[[nodiscard]] double highest_land(const RegionsSpec& spec);

}  // namespace talus::terrain
