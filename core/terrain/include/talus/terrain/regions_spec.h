// What an author says of a surface of kind "regions": [[field]] and the tables of [surface] in a world.toml.
// Lengths and heights are in terrain units, heights over the sea. docs/WORLDS.md explains each key.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace talus::terrain {

/// A point of a curve. Between its knots a curve is monotone, beyond the outer ones level.
struct Knot {
  double x = 0;
  double y = 0;
};
using Curve = std::vector<Knot>;  // one knot at least, x ascending

/// A noise that takes every value from -1 to 1 as often: an author reads shares of land off its values. Its
/// name, not its place among others, decides where it is high.
struct FieldSpec {
  std::string name;
  double wavelength = 0;  // of the first octave
  int octaves = 0;
  double gain = 0;      // how much an octave is of the one before
  bool warped = false;  // bent as the coasts are
};

struct RegionsSpec {
  double sea_level = 0;  // the world's

  FieldSpec continents{"continents", 9000, 7, 0.5, true};
  Curve base{{-1, -60}, {-0.62, -42}, {-0.38, -16}, {-0.26, -4}, {-0.2, 1.5},
             {-0.1, 6}, {0.1, 13},    {0.45, 26},   {1, 52}};       // height of the plain, by continents
  Curve inland{{-0.5, 0.1}, {-0.25, 0.12}, {-0.1, 0.5}, {0.1, 1}};  // 0 to 1, by continents

  FieldSpec ranges{"ranges", 7000, 3, 0.3, true};
  Curve belt{{0, 1}, {0.1, 0.93}, {0.28, 0.5}, {0.45, 0.14}, {0.58, 0}};  // 0 to 1, by |ranges|
  Curve passes{{-0.7, 0.12}, {-0.1, 0.6}, {0.4, 1}};                      // what is left of it, by hilliness
  double range_base = 70;                                                 // what a range lifts
  double range_relief = 270;                                              // its ridges over that

  FieldSpec hilliness{"hilliness", 2600, 3, 0.5, false};
  Curve hills{{-1, 9}, {-0.2, 16}, {0.3, 34}, {0.7, 80}, {1, 110}};  // their height

  FieldSpec mesas{"mesas", 1250, 5, 0.45, true};
  Curve terraces{{-0.16, 0},   {-0.1, 0.3},  {0.02, 0.34}, {0.07, 0.62},
                 {0.24, 0.66}, {0.29, 0.97}, {0.8, 1}};  // share of the height, by mesas
  double mesa_height = 95;
  double mesas_anywhere = 0;                      // 0 to 1: of them where it is neither warm nor dry
  std::array<double, 2> mesa_coast{-0.16, 0.02};  // of continents: from none to all
  double mesa_roughness = 0.36;

  FieldSpec temperature{"temperature", 15000, 5, 0.5, false};
  FieldSpec moisture{"moisture", 8000, 5, 0.5, false};
  double warmer = 0;  // added to either
  double wetter = 0;

  double river_wavelength = 4600;
  double tributary_wavelength = 1900;
  std::array<double, 2> half_width{13, 9};  // of rivers and of tributaries, on the plain; in lowlands more
  std::array<double, 2> valley{240, 130};   // from the middle to where the valley ends
  std::array<double, 2> carve{45, 26};      // land higher than that is cut less
  double bed = 5.5;                         // depth

  double shape_wavelength = 1400;  // of the largest hills
  double shape_gain = 0.47;
};

/// Octaves of a field that are shorter than this, in columns, would be lost between its samples.
inline constexpr double kShortestFieldOctave = 64;
inline constexpr int kShapeOctaves = 8;
/// Rivers are up to so many times as wide in lowlands as half_width says.
inline constexpr double kWidestRiver = 1.6;

/// No land is higher, in terrain units above y = 0.
[[nodiscard]] double highest_land(const RegionsSpec& spec);

}  // namespace talus::terrain
