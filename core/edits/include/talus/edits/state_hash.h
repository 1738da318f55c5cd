// A hash of all edits of a world, by which two nodes at one revision can be compared.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string>

#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

namespace talus::edits {

/// S: the sum, modulo 2^128, of the hashes of all overrides of level 0. A sum knows no order, and what was
/// added can be taken away, so S is kept at the cost of what changes. It finds faults; it is no proof against
/// somebody who searches for edits whose sums are alike.
///
/// The hash of an override is XXH3-128, without a seed, of 16 bytes, little endian: chunk x, y, z (int32
/// each), index in the chunk (uint16), material (uint16). S = high * 2^64 + low, as of XXH128_hash_t.
struct StateHash {
  std::uint64_t low = 0;
  std::uint64_t high = 0;

  void add(ChunkCoord chunk, Override voxel);
  /// REQUIRES, unchecked: it was added and not removed since.
  void remove(ChunkCoord chunk, Override voxel);
  void add(ChunkCoord chunk, std::span<const Override> voxels);

  constexpr auto operator<=>(const StateHash&) const = default;
};

/// 32 hexadecimal digits, the high half first.
[[nodiscard]] std::string to_string(StateHash hash);

}  // namespace talus::edits
