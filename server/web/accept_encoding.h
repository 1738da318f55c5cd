// What a client can decompress. Pure. Source: RFC 9110, 12.5.3.
#pragma once

#include <string_view>

namespace talus::server::web {

/// Whether an Accept-Encoding list names the encoding, and not with a weight of 0. "*" names none.
[[nodiscard]] bool accepts_encoding(std::string_view list, std::string_view encoding);

}  // namespace talus::server::web
