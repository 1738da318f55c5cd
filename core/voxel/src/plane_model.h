// Context of a plane's row and the resulting probabilities: FORMAT.md, "Layered: the model". Scalar, as in
// the document; plane_kernels.cpp implements the same with vectors.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/voxel/coords.h>

#include "rans.h"

namespace talus::codec {

/// Class of a column's step, or of its difference from the step to the west.
enum Symbol : std::uint8_t { kSame, kUp, kDown, kOther };

/// A level row codes each column's step; other rows code its difference from the step to the west.
enum RowKind : std::uint8_t { kLevel, kCarried, kFirst };
inline constexpr std::size_t kRowKinds = kFirst + 1;

/// Difference of each column of a row from its prediction.
using Steps = std::array<std::int8_t, kChunkSize>;

/// Known rows near a row, 32 columns each.
struct RowsBefore {
  const std::uint8_t* north = nullptr;        // the plane's row z - 1; the floor in the first row
  const std::int8_t* steps_north = nullptr;   // steps of that row; zeros in the first row
  const std::uint8_t* floor = nullptr;        // row z of the plane below
  const std::uint8_t* floor_north = nullptr;  // row z - 1 of the plane below; row z in the first row

  /// Rows for row z of a plane whose rows before z are known; `below` is the plane below it.
  [[nodiscard]] static RowsBefore of(const std::uint8_t* plane, const std::uint8_t* below, std::size_t z,
                                     const Steps& steps_north) {
    static constexpr Steps kNone{};
    const std::uint8_t* const floor = below + z * kChunkSize;
    if (z == 0) return {floor, kNone.data(), floor, floor};
    return {plane + (z - 1) * kChunkSize, steps_north.data(), floor, floor - kChunkSize};
  }
};

/// Comparisons around a column: 0 for less, 1 for equal, 2 for greater, unless noted. Columns outside the row
/// count as equal to its outermost column, with a step of 0.
enum Sign : std::uint8_t {
  kWest,           // the row to the north, against its neighbour one to the west
  kEast,           // the row to the north: its neighbour one to the east, against it
  kFarEast,        // the neighbour two to the east, against it
  kStep,           // the step to the north, against 0
  kStepWest,       // the step one to the west of it
  kStepEast,       // the step one to the east of it
  kStepFarWest,    // the step two to the west of it
  kStepFarEast,    // the step two to the east of it
  kFloor,          // the floor, against the floor to the north
  kThickness,      // of the material to the north: 0, 1 or more
  kThicknessWest,  // one to the west of it
  kThicknessEast,  // one to the east of it
  kSymbolWest,     // odd columns only: symbol of the column to the west
  kSymbolEast,     // odd columns only: symbol of the column to the east
};
inline constexpr std::size_t kSigns = kSymbolEast + 1;
using Signs = std::array<std::uint8_t, kSigns>;

/// Weights are indexed by pairs of signs; the last pairs apply to odd columns only.
inline constexpr std::array<std::array<Sign, 2>, 13> kPairs{{
    {kStepWest, kStepEast},
    {kFloor, kThicknessEast},
    {kWest, kEast},
    {kStep, kStepFarWest},
    {kFarEast, kStepFarEast},
    {kThicknessWest, kThicknessEast},
    {kWest, kThickness},
    {kEast, kThickness},
    {kFloor, kThickness},
    {kWest, kSymbolWest},
    {kEast, kSymbolEast},
    {kThickness, kSymbolWest},
    {kThickness, kSymbolEast},
}};
inline constexpr std::size_t kPairsOfEven = 9;

constexpr std::size_t pairs_of(std::size_t x) {
  return x % 2 == 0 ? kPairsOfEven : kPairs.size();
}

constexpr std::size_t place_of_pair(std::uint8_t first, std::uint8_t second) {
  return first + 4U * second;
}

/// Weights of a pair, by place: for the score of kSame, and for the score of kUp.
struct PairWeights {
  std::array<std::int8_t, 16> same;
  std::array<std::int8_t, 16> up;
};
using Weights = std::array<PairWeights, kPairs.size()>;

inline constexpr std::size_t kClasses = 16;

[[nodiscard]] constexpr int add_weight(int score, int weight) {
  return std::clamp(score + weight, -128, 127);
}

[[nodiscard]] constexpr std::size_t class_of(int score) {
  return static_cast<std::size_t>(std::max(score, 0)) / (128 / kClasses);
}

[[nodiscard]] constexpr std::uint8_t sign_of(int value) {
  return static_cast<std::uint8_t>(value < 0 ? 0 : value == 0 ? 1 : 2);
}

[[nodiscard]] constexpr Symbol symbol_of(int change) {
  if (change == 0) return kSame;
  if (change == 1) return kUp;
  return change == -1 ? kDown : kOther;
}

/// `symbols`: symbols of the row, as far as they are known.
[[nodiscard]] inline Signs signs_of(const RowsBefore& before, const std::array<Symbol, kChunkSize>& symbols,
                                    int x) {
  constexpr int kLast = kChunkSize - 1;
  const auto north = [&](int dx) { return int{before.north[std::clamp(x + dx, 0, kLast)]}; };
  const auto there = [&](int dx) { return x + dx >= 0 && x + dx <= kLast; };
  const auto step = [&](int dx) { return sign_of(there(dx) ? before.steps_north[x + dx] : 0); };
  const auto thickness = [&](int dx) {
    const int column = std::clamp(x + dx, 0, kLast);
    return static_cast<std::uint8_t>(std::min(before.north[column] - before.floor_north[column], 2));
  };
  const auto symbol = [&](int dx) {
    return x % 2 == 1 && there(dx) ? symbols[static_cast<std::size_t>(x + dx)] : kSame;
  };
  Signs signs;
  signs[kWest] = sign_of(north(0) - north(-1));
  signs[kEast] = sign_of(north(1) - north(0));
  signs[kFarEast] = sign_of(north(2) - north(0));
  signs[kStep] = step(0);
  signs[kStepWest] = step(-1);
  signs[kStepEast] = step(1);
  signs[kStepFarWest] = step(-2);
  signs[kStepFarEast] = step(2);
  signs[kFloor] = sign_of(before.floor[x] - before.floor_north[x]);
  signs[kThickness] = thickness(0);
  signs[kThicknessWest] = thickness(-1);
  signs[kThicknessEast] = thickness(1);
  signs[kSymbolWest] = symbol(-1);
  signs[kSymbolEast] = symbol(1);
  return signs;
}

[[nodiscard]] constexpr std::uint8_t predicted_row(const RowsBefore& before, std::size_t x) {
  if (before.north[x] == before.floor_north[x]) return before.floor[x];
  return std::max(before.north[x], before.floor[x]);
}

/// Estimates the kind that takes fewer bits for a row after the first; either kind is valid.
[[nodiscard]] inline RowKind better_kind(const Steps& steps) {
  constexpr int kOtherBits = 10;
  constexpr int kLevelBits = 3;
  constexpr int kCarriedBits = 4;
  int level = 0;
  int carried = 0;
  bool others = false;
  int west = 0;
  for (const int step : steps) {
    const Symbol as_step = symbol_of(step);
    const Symbol as_change = symbol_of(step - west);
    west = step;
    others |= as_step == kOther;
    level += as_step == kOther ? kOtherBits : as_step == kSame ? 0 : kLevelBits;
    carried += as_change == kOther ? kOtherBits : as_change == kSame ? 0 : kCarriedBits;
  }
  return others && carried < level ? kCarried : kLevel;
}

}  // namespace talus::codec
