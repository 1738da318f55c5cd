// Text from a stranger, made safe for a terminal and a log file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace talus::server {

/// At most `most_bytes` of `text`, "..." where more follows; whatever is not printable ASCII, and the
/// characters that quote it, as \xNN.
[[nodiscard]] std::string escaped(std::string_view text, std::size_t most_bytes = 120);

}  // namespace talus::server
