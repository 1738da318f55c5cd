// What the rows before it tell about a row of a plane: FORMAT.md, "Layered". Encoder and decoder share it, so
// they cannot differ.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/voxel/coords.h>

namespace talus::codec {

/// By how much each column of a row differs from its prediction, x from -1 to 32; beyond the chunk 0.
struct Steps {
  std::array<std::int8_t, kChunkSize + 2> padded{};

  [[nodiscard]] constexpr std::int8_t* data() { return padded.data() + 1; }
  [[nodiscard]] constexpr const std::int8_t* data() const { return padded.data() + 1; }
};

inline constexpr Steps kFirstSteps = [] {
  Steps steps;
  std::fill_n(steps.data(), kChunkSize, std::int8_t{1});
  return steps;
}();

/// What came before a row, 32 columns each.
struct RowsBefore {
  const std::uint8_t* north = nullptr;        // the plane's row at z - 1; in the first row its floor
  const Steps* steps_north = nullptr;         // of that row; in the first row kFirstSteps
  const std::uint8_t* floor = nullptr;        // the plane below, at z
  const std::uint8_t* floor_north = nullptr;  // the plane below, at z - 1; in the first row at z

  /// Of row z of a plane whose rows before z are known; `below` is the plane below it, null for the ground.
  [[nodiscard]] static RowsBefore of(const std::uint8_t* plane, const std::uint8_t* below, std::size_t z,
                                     const Steps& steps_north) {
    static constexpr std::array<std::uint8_t, kChunkArea> kGround{};
    const std::uint8_t* const floor = (below == nullptr ? kGround.data() : below) + z * kChunkSize;
    if (z == 0) return {floor, &kFirstSteps, floor, floor};
    return {plane + (z - 1) * kChunkSize, &steps_north, floor, floor - kChunkSize};
  }
};

struct RowGuess {
  std::array<std::uint8_t, kChunkSize> predicted;
  std::array<std::uint16_t, kChunkSize> context;  // below kRowContexts
};

inline constexpr std::size_t kRowContexts = 486;

/// What is known of the column to the west. Its number times kRowContexts is added to a row's context.
enum class West : std::uint8_t { level, up, down, steep };

inline constexpr std::size_t kContexts = 4 * kRowContexts;

constexpr std::size_t context_of(West west) {
  return static_cast<std::size_t>(west) * kRowContexts;
}

constexpr West west_of(int step) {
  if (step == 0) return West::level;
  if (step == 1) return West::up;
  return step == -1 ? West::down : West::steep;
}

inline constexpr int kMostStep = kChunkSize;  // up or down

/// A change further than one, as its place in the list 2, -2, 3, -3, ... A step of 32 after one of -32 is a
/// change of 64.
constexpr std::uint32_t place_of(int change) {
  const auto size = static_cast<std::uint32_t>(change < 0 ? -change : change);
  return 2 * (size - 2) + (change < 0 ? 1 : 0);
}

/// What a column's step is less what a steep column to the west carries on.
constexpr int change_of(int step, int west) {
  return step - (west_of(west) == West::steep ? west : 0);
}

/// What a column does, of its step less what a steep column to the west carries on.
enum Symbol : std::uint8_t { kAsPredicted, kOneUp, kOneDown, kFurtherOff };

/// A row as its writer needs it.
struct RowSymbols {
  std::array<std::uint16_t, kChunkSize> context;  // with the west: below kContexts
  std::array<std::uint8_t, kChunkSize> symbol;
};

}  // namespace talus::codec
