// Frame of every value of the store: a format number in front and a checksum at the end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <talus/store/bytes.h>

namespace talus::store {

using Bytes = std::vector<std::byte>;

/// Format number at the beginning of every value. Other numbers are rejected; only for meta is the foreign
/// number reported.
inline constexpr std::uint8_t kStoreFormat = 1;
inline constexpr std::size_t kChecksumBytes = 8;

[[nodiscard]] std::uint64_t hash_of(std::string_view text);

/// Starts a value, replacing the contents of `out`.
[[nodiscard]] ByteWriter begin_value(Bytes& out);
/// Appends the value's XXH3-64, and returns it. The seed is the hash of its key or, in a chain, of the
/// previous value, so that a value cannot pass for another's.
std::uint64_t seal(std::uint64_t seed, Bytes& out);

/// Returns what seal() sealed, of any format; nullopt if the checksum is wrong.
[[nodiscard]] std::optional<std::span<const std::byte>> sealed_bytes(std::uint64_t seed,
                                                                     std::span<const std::byte> value);
/// Like sealed_bytes(), but requires kStoreFormat and strips it.
[[nodiscard]] std::optional<std::span<const std::byte>> sealed(std::uint64_t seed,
                                                               std::span<const std::byte> value);

}  // namespace talus::store
