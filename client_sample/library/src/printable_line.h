// Sanitizes text from a server, which may be arbitrary bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace talus::client {

/// Converts to one line of UTF-8 of at most `max_bytes`: control characters (C0, DEL) become spaces, each
/// byte that does not begin a character becomes U+FFFD, and no character is cut in two.
[[nodiscard]] std::string printable_line(std::string_view text, std::size_t max_bytes);

}  // namespace talus::client
