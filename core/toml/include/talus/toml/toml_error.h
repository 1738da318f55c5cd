// What a TOML parser's error tells a person: which key it is about, and what is wrong, without the parser's
// own words for its own parts.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace talus {

/// At most `max_bytes` of the text, "..." among them where it is longer; no UTF-8 character is cut in two.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t max_bytes);

/// The key that a line of the text assigns to, with its tables: "surface.gain", "stratified[1].colour". Empty
/// where the line assigns to none. For texts without a fault of toml_bounds.h; the first line is 1.
[[nodiscard]] std::string toml_key_at_line(std::string_view toml, int line);

/// The parser's description of an error at `key`, or at none: shortened, without names of macros.
[[nodiscard]] std::string toml_error_text(std::string_view description, std::string_view key);

}  // namespace talus
