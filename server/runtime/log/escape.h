// Untrusted text, made safe for a terminal and a log file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace talus::server {

/// The first `max_bytes` bytes of `text`, with "..." after them where more follow. Bytes that are not
/// printable ASCII, quotes and backslashes become \xNN.
[[nodiscard]] std::string escaped(std::string_view text, std::size_t max_bytes = 120);

/// Bytes of the printable character at the beginning of the text, in UTF-8; 0 where there is none. What a
/// terminal takes for a command is none: C0, DEL and C1.
[[nodiscard]] std::size_t printable_bytes(std::string_view text);

/// The text with its control characters (C0, DEL and C1), and what is no UTF-8, as \xNN: for lines of our own
/// that name paths.
[[nodiscard]] std::string on_one_line(std::string_view text);

}  // namespace talus::server
