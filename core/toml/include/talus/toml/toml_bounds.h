// Bounds to check before a TOML parser reads a file. The parser recurses over the parts of a key and over
// brackets, and could overflow its stack, as could the destructor of the result.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace talus {

/// Maximum bytes of a file: the sample worlds have 4,000.
inline constexpr std::size_t kMaxTomlBytes = std::size_t{1} << 20;
/// Maximum parts of a dotted key.
inline constexpr std::size_t kMaxKeyParts = 64;
/// Maximum nesting of arrays, inline tables and headers, which limits tables to a depth of 16 * 64.
inline constexpr std::size_t kMaxTomlDepth = 16;

struct TomlFault {
  int line = 0;
  std::string what;  // the fault and what is expected
};

/// Returns the first bound that the text exceeds: length, parts of a key, depth of brackets, a multi-line
/// string (""" or '''), which could hide the rest of a line, or UTF-16. Does not check that the text is TOML.
[[nodiscard]] std::optional<TomlFault> find_toml_fault(std::string_view text);

}  // namespace talus
