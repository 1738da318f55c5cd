// Identity of a chunk's content, independent of the codec.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include <talus/voxel/chunk.h>

namespace talus {

/// XXH3-128 of the canonical voxels: little-endian uint16, y slowest, then z, then x. `low` and `high` are
/// low64 and high64 of XXH128_hash_t.
struct ContentHash {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  constexpr auto operator<=>(const ContentHash&) const = default;
};

[[nodiscard]] ContentHash content_hash(const Chunk& chunk);

/// 32 hexadecimal digits, high half first (as printed by xxhsum).
[[nodiscard]] std::string to_string(ContentHash hash);

}  // namespace talus
