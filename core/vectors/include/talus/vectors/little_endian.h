// The order of bytes that hashes and files have.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace talus {

/// Returns the bytes of the numbers, each in little-endian order: the numbers themselves if this machine has
/// that order, else `scratch`, which is overwritten.
template <class Number>
[[nodiscard]] std::span<const std::byte> little_endian_bytes(std::span<const Number> numbers,
                                                             std::vector<std::byte>& scratch) {
  static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
  const auto bytes = std::as_bytes(numbers);
  if constexpr (std::endian::native == std::endian::little || sizeof(Number) == 1) return bytes;
  scratch.assign(bytes.begin(), bytes.end());
  for (auto at = scratch.begin(); at != scratch.end(); at += sizeof(Number)) {
    std::reverse(at, at + sizeof(Number));
  }
  return scratch;
}

}  // namespace talus
