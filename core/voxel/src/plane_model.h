// The context of a row of a plane and the probabilities that follow from it: FORMAT.md, "Layered: the model".
// Column by column, as the document has it; plane_kernels.cpp has the same in vectors.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/voxel/coords.h>

#include "rans.h"

namespace talus::codec {

/// What a column does, of its step or of how that differs from the step to the west.
enum Symbol : std::uint8_t { kSame, kUp, kDown, kOther };

/// In a level row each column's step is read; in the others how it differs from the step to the west.
enum RowKind : std::uint8_t { kLevel, kCarried, kFirst };
inline constexpr std::size_t kRowKinds = kFirst + 1;

/// By how much each column of a row differs from its prediction.
using Steps = std::array<std::int8_t, kChunkSize>;

/// What came before a row, 32 columns each.
struct RowsBefore {
  const std::uint8_t* north = nullptr;        // the plane's row at z - 1; in the first row its floor
  const std::int8_t* steps_north = nullptr;   // of that row; in the first row none
  const std::uint8_t* floor = nullptr;        // the plane below, at z
  const std::uint8_t* floor_north = nullptr;  // the plane below, at z - 1; in the first row at z

  /// Of row z of a plane whose rows before z are known; `below` is the plane below it.
  [[nodiscard]] static RowsBefore of(const std::uint8_t* plane, const std::uint8_t* below, std::size_t z,
                                     const Steps& steps_north) {
    static constexpr Steps kNone{};
    const std::uint8_t* const floor = below + z * kChunkSize;
    if (z == 0) return {floor, kNone.data(), floor, floor};
    return {plane + (z - 1) * kChunkSize, steps_north.data(), floor, floor - kChunkSize};
  }
};

/// What is looked at around a column, each 0 for less, 1 for equal and 2 for more, unless it says otherwise.
/// A column that is not there is taken to be as high as the row's end, and to have no step.
enum Sign : std::uint8_t {
  kWest,           // the row to the north: how it stands to its neighbour one to the west
  kEast,           // how its neighbour one to the east stands to it
  kFarEast,        // and the one two to the east
  kStep,           // the step to the north, against none
  kStepWest,       // that to its west
  kStepEast,       // that to its east
  kStepFarWest,    // that two to its west
  kStepFarEast,    // that two to its east
  kFloor,          // the floor to that to the north
  kThickness,      // of the material to the north: 0, 1, more
  kThicknessWest,  // one to the west of it
  kThicknessEast,  // one to the east of it
  kSymbolWest,     // in odd columns: the symbol of the column to the west
  kSymbolEast,     // and of that to the east
};
inline constexpr std::size_t kSigns = kSymbolEast + 1;
using Signs = std::array<std::uint8_t, kSigns>;

/// Pairs of signs have weights, one for each of their values; the last of them in odd columns alone.
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

/// By place in a pair: for the score of kSame, and for that of kUp.
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

/// `symbols`: of the row, as far as they are known.
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

/// The kind by which a row after the first is likely to take fewer bits: either would do.
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
