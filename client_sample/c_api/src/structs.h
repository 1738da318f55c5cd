// Structs that begin with their size, for programs and libraries of different minor versions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>

#include <talus.h>

namespace talus::c_api {

/// A larger size must be an uninitialised variable.
inline constexpr std::uint32_t kMaxStructBytes = 4096;

/// End of the fields that a struct had in version 1.0.
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

/// True if a caller's struct is not null and has a valid size.
template <typename T>
[[nodiscard]] bool has_size(const T* given) {
  static_assert(kFirstBytes<T> > 0 && sizeof(T) <= kMaxStructBytes);
  return given != nullptr && given->size >= kFirstBytes<T> && given->size <= kMaxStructBytes;
}

/// Copies a caller's struct; fields that an older program lacks are 0. nullopt if a newer program sets later
/// fields that this library does not support. REQUIRES: has_size().
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

/// Fills a caller's struct but keeps its size; fields known only to a newer program become 0. REQUIRES:
/// has_size().
template <typename T>
void write_struct(T* out, T values) {
  values.size = out->size;
  const std::size_t known = std::min<std::size_t>(out->size, sizeof(T));
  std::memset(out, 0, out->size);
  std::memcpy(out, &values, known);
}

}  // namespace talus::c_api
