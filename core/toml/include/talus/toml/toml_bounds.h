// Bounds that a file must keep before a TOML parser may see it. The parser recurses over the parts of a key
// and over brackets, and would overflow its stack; so would the destructor of what it has parsed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace talus {

/// Bytes of a file worth reading: the sample worlds have 4,000.
inline constexpr std::size_t kMaxTomlBytes = std::size_t{1} << 20;
/// Parts of a dotted key.
inline constexpr std::size_t kMaxKeyParts = 64;
/// Arrays, inline tables and headers within each other, so that nothing lies deeper than 16 * 64 tables.
inline constexpr std::size_t kMaxTomlDepth = 16;

struct TomlFault {
  int line = 0;
  std::string what;  // what is wrong and what would be right
};

/// The first bound that the text breaks: length, parts of a key, depth of brackets, no strings of several
/// lines (""" and ''', in which a line's end would hide what follows). Says nothing of whether the text is
/// TOML.
[[nodiscard]] std::optional<TomlFault> find_toml_fault(std::string_view text);

}  // namespace talus
