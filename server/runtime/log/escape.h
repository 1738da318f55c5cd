// Makes untrusted text safe for a terminal and a log file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace talus::server {

/// Returns the first `max_bytes` bytes of `text`, followed by "..." if `text` is longer. Bytes that are not
/// printable ASCII, quotes and backslashes become \xNN.
[[nodiscard]] std::string escaped(std::string_view text, std::size_t max_bytes = 120);

/// Length in bytes of the printable UTF-8 character at the beginning of the text; 0 if there is not one.
/// Control characters that a terminal interprets (C0, DEL, C1) are not printable.
[[nodiscard]] std::size_t printable_bytes(std::string_view text);

/// Replaces control characters (C0, DEL, C1) and invalid UTF-8 by \xNN. For the server's own lines that name
/// paths.
[[nodiscard]] std::string on_one_line(std::string_view text);

}  // namespace talus::server
