// Parses the encodings that a client can decompress. Pure functions. Source: RFC 9110, 12.5.3.
#pragma once

#include <string_view>

namespace talus::server::web {

/// Returns true if an Accept-Encoding list contains the encoding with a weight other than 0. "*" is ignored.
[[nodiscard]] bool accepts_encoding(std::string_view list, std::string_view encoding);

}  // namespace talus::server::web
