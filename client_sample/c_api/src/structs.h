// Structs that begin with their size: programs and libraries of different minor versions meet here.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>

#include <talus.h>

namespace talus::c_api {

/// A size beyond this is no struct but a variable that nobody has set.
inline constexpr std::uint32_t kMaxStructBytes = 4096;

/// The bytes that a struct has had since version 1.0: its end there.
template <typename T>
inline constexpr std::size_t kFirstBytes = 0;
template <>
inline constexpr std::size_t kFirstBytes<talus_connect_options> = offsetof(talus_connect_options,
                                                                           reconnect_max_delay_ms) +
                                                                  sizeof(std::uint32_t);
template <>
inline constexpr std::size_t kFirstBytes<talus_view> = offsetof(talus_view, reserved) + sizeof(std::uint32_t);
template <>
inline constexpr std::size_t kFirstBytes<talus_world> = offsetof(talus_world, reserved) +
                                                        sizeof(std::uint32_t);
template <>
inline constexpr std::size_t kFirstBytes<talus_material> = offsetof(talus_material, name) +
                                                           sizeof(const char*);
template <>
inline constexpr std::size_t kFirstBytes<talus_stats> = offsetof(talus_stats, connections) +
                                                        sizeof(std::uint64_t);
template <>
inline constexpr std::size_t kFirstBytes<talus_event> = offsetof(talus_event, reserved) +
                                                        sizeof(std::uint32_t);
template <>
inline constexpr std::size_t kFirstBytes<talus_edit> = offsetof(talus_edit, reserved) + sizeof(std::uint32_t);

/// Whether a caller's struct is there and says a size that it can have.
template <typename T>
[[nodiscard]] bool has_size(const T* given) {
  static_assert(kFirstBytes<T> > 0 && sizeof(T) <= kMaxStructBytes);
  return given != nullptr && given->size >= kFirstBytes<T> && given->size <= kMaxStructBytes;
}

/// A caller's struct as this library knows it; what an older program lacks is 0. None where a newer program
/// asks by its later fields for what this library cannot do. REQUIRES: has_size().
template <typename T>
[[nodiscard]] std::optional<T> read_struct(const T* given) {
  const std::size_t known = std::min<std::size_t>(given->size, sizeof(T));
  const std::span bytes{reinterpret_cast<const std::byte*>(given), given->size};
  const auto unknown = bytes.subspan(known);
  if (std::any_of(unknown.begin(), unknown.end(), [](std::byte b) { return b != std::byte{}; })) return {};
  T own{};
  std::memcpy(&own, given, known);
  return own;
}

/// Fills a caller's struct, and leaves its size; fields that only a newer program knows become 0. REQUIRES:
/// has_size().
template <typename T>
void write_struct(T* out, T values) {
  values.size = out->size;
  const std::size_t known = std::min<std::size_t>(out->size, sizeof(T));
  std::memset(out, 0, out->size);
  std::memcpy(out, &values, known);
}

}  // namespace talus::c_api
