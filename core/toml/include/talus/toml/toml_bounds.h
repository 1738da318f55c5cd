// Bounds that a TOML text must keep before a parser reads it: parsers recurse over the parts of a dotted key.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace talus {

/// Largest file that is read. The sample worlds have 4,000 bytes.
inline constexpr std::size_t kMaxTomlBytes = std::size_t{1} << 20;
/// Most parts of a dotted key.
inline constexpr std::size_t kMaxKeyParts = 64;

struct TomlFault {
  int line = 0;
  std::string what;  // what is wrong, for an error message
};

/// The first bound that the text exceeds, or none. Does not check whether the text is TOML. Pure.
[[nodiscard]] std::optional<TomlFault> passes_toml_bounds(std::string_view text);

}  // namespace talus
