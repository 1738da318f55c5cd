// Converts a TOML parser's errors for users: the key and the fault, without the parser's internal names.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace talus {

/// At most `max_bytes` of the text, including "..." if it is longer; no UTF-8 character is cut.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t max_bytes);

/// The key assigned in a line (from 1), with its tables: "surface.gain", "stratified[1].colour". Empty if it
/// assigns nothing. REQUIRES: find_toml_fault() finds no fault in the text.
[[nodiscard]] std::string toml_key_at_line(std::string_view toml, int line);

/// The parser's description of an error at `key`, which may be empty: shortened, without macro names.
[[nodiscard]] std::string toml_error_text(std::string_view description, std::string_view key);

}  // namespace talus
