// Randomness from positions: integer hashes of seeds, octaves and lattice cells. No state, no tables.
#pragma once

#include <cstdint>

namespace talus::terrain {

/// A bijection of 64 bits in which every input bit reaches every output bit (xorshift-multiply rounds).
[[nodiscard]] constexpr std::uint64_t mix64(std::uint64_t v) {
  v = (v ^ (v >> 30)) * 0xBF58476D1CE4E5B9U;
  v = (v ^ (v >> 27)) * 0x94D049BB133111EBU;
  return v ^ (v >> 31);
}

/// The 32-bit counterpart of mix64.
[[nodiscard]] constexpr std::uint32_t mix32(std::uint32_t v) {
  v = (v ^ (v >> 16)) * 0x7FEB352DU;
  v = (v ^ (v >> 15)) * 0x846CA68BU;
  return v ^ (v >> 16);
}

/// The seed of the `index`-th child of `seed`.
[[nodiscard]] constexpr std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t index) {
  return mix64(mix64(seed + 0x9E3779B97F4A7C15U) ^ (index * 0xD1B54A32D192ED03U));
}

enum class Axis : std::uint8_t { x = 0, z = 1 };

/// The difference between the keys of adjacent lattice cells.
inline constexpr std::uint64_t kCellStep = 0x9E3779B97F4A7C15U;

/// The unmixed key of a lattice cell's coordinate along one axis.
[[nodiscard]] constexpr std::uint64_t axis_key(std::uint64_t seed, Axis axis, std::int64_t cell) {
  const std::uint64_t salted = seed ^ (axis == Axis::x ? 0x632BE59BD9B4E019U : 0xA24BAED4963EE407U);
  return salted + static_cast<std::uint64_t>(cell) * kCellStep;
}

/// The contribution of a lattice cell's coordinate along one axis to the hash of its corner.
[[nodiscard]] constexpr std::uint32_t axis_hash(std::uint64_t seed, Axis axis, std::int64_t cell) {
  return static_cast<std::uint32_t>(mix64(axis_key(seed, axis, cell)));
}

/// Combines the two axes' contributions into the hash of a lattice corner.
[[nodiscard]] constexpr std::uint32_t corner_hash(std::uint32_t x_hash, std::uint32_t z_hash) {
  return mix32(x_hash ^ ((z_hash << 16) | (z_hash >> 16)));
}

}  // namespace talus::terrain
