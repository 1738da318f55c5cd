// The identity of a chunk's content, whatever codec carried it.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include <talus/voxel/chunk.h>

namespace talus {

/// XXH3-128 of the canonical voxels: uint16 little endian, y slowest, then z, then x. `low` and `high`
/// are XXH128_hash_t's low64 and high64.
struct ContentHash {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  constexpr auto operator<=>(const ContentHash&) const = default;
};

[[nodiscard]] ContentHash content_hash(const Chunk& chunk);

/// 32 hexadecimal digits, the high half first (as xxhsum prints it).
[[nodiscard]] std::string to_string(ContentHash hash);

}  // namespace talus
