// What a server sent as text, and is any bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace talus::client {

/// As one line of UTF-8 of at most `max_bytes`: control characters (C0, DEL) are spaces, each byte that
/// begins no character is U+FFFD, and no character is cut in two.
[[nodiscard]] std::string printable_line(std::string_view text, std::size_t max_bytes);

}  // namespace talus::client
