// What the host reads of the module: 32-bit numbers in linear memory, little-endian. Documented for hosts in
// client_sample/web/talus-js/wasm/world.js, which is the other side.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#define TALUS_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace talus::wasm {

struct Bytes {
  const void* data = nullptr;
  std::uint32_t size = 0;
};
[[nodiscard]] inline Bytes bytes_of(std::string_view text) {
  return {text.data(), static_cast<std::uint32_t>(text.size())};
}
template <class Value>
[[nodiscard]] Bytes bytes_of(std::span<const Value> values) {
  return {values.data(), static_cast<std::uint32_t>(values.size_bytes())};
}

/// Why the last call returned null.
struct Problem {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  Bytes key;
  Bytes text;
};

/// A chunk; the bytes last until the next call.
struct ChunkAnswer {
  std::uint32_t uniform = 0;  // 1: all voxels are `material`
  std::uint32_t material = 0;
  Bytes voxels;                // if asked for and not uniform: 32,768 uint16
  Bytes payload;               // if asked for
  std::uint64_t hash_low = 0;  // if asked for
  std::uint64_t hash_high = 0;
};

/// What a chunk is asked for, as flags.
inline constexpr std::uint32_t kVoxels = 1;
inline constexpr std::uint32_t kPayload = 2;
inline constexpr std::uint32_t kHash = 4;

}  // namespace talus::wasm
