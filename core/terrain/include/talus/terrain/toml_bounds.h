// What a file must keep before a TOML parser may see it: parsers recurse over the parts of a key.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace talus::terrain {

/// Bytes of a file worth reading: the sample worlds have 4,000.
inline constexpr std::size_t kMaxTomlBytes = std::size_t{1} << 20;
/// Parts of a dotted key.
inline constexpr std::size_t kMaxKeyParts = 64;

struct TomlFault {
  int line = 0;
  std::string what;  // what is wrong and what would be right
};

/// The first bound that the text passes. Says nothing of whether it is TOML.
[[nodiscard]] std::optional<TomlFault> passes_toml_bounds(std::string_view text);

}  // namespace talus::terrain
