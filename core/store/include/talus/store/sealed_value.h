// What every value of the store begins and ends with: the number of its format, and a checksum.
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

/// The number that every value begins with. What is read has this one; meta alone may have another, which is
/// then told.
inline constexpr std::uint8_t kStoreFormat = 1;
inline constexpr std::size_t kChecksumBytes = 8;

[[nodiscard]] std::uint64_t hash_of(std::string_view text);

/// A value in place of what `out` held.
[[nodiscard]] ByteWriter begin_value(Bytes& out);
/// Ends it by its XXH3-64, which is returned. It is seeded by that of its key, so that no value passes for
/// another's, or, in a chain, by the one before.
std::uint64_t seal(std::uint64_t seed, Bytes& out);

/// What seal() sealed, of whatever format, or nothing.
[[nodiscard]] std::optional<std::span<const std::byte>> sealed_bytes(std::uint64_t seed,
                                                                     std::span<const std::byte> value);
/// The same behind its number of the format, where that is this one.
[[nodiscard]] std::optional<std::span<const std::byte>> sealed(std::uint64_t seed,
                                                               std::span<const std::byte> value);

}  // namespace talus::store
