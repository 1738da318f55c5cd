// A hash of all edits of a world, for comparing two nodes at one revision.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string>

#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

namespace talus::edits {

/// S: the sum, modulo 2^128, of the hashes of all level-0 overrides. Addition is commutative and invertible,
/// so the cost of an update depends only on the change. S detects faults; it does not resist an attacker who
/// searches for edits with equal sums.
///
/// The hash of an override is the XXH3-128, unseeded, of 16 little-endian bytes: chunk x, y, z (int32 each),
/// index in the chunk (uint16), material (uint16). S = high * 2^64 + low, as in XXH128_hash_t.
struct StateHash {
  std::uint64_t low = 0;
  std::uint64_t high = 0;

  void add(ChunkCoord chunk, Override voxel);
  /// REQUIRES (unchecked): the override was added and not removed since.
  void remove(ChunkCoord chunk, Override voxel);
  void add(ChunkCoord chunk, std::span<const Override> voxels);

  constexpr auto operator<=>(const StateHash&) const = default;
};

/// 32 hexadecimal digits, high half first.
[[nodiscard]] std::string to_string(StateHash hash);

}  // namespace talus::edits
