// Base64 with the URL alphabet and without padding (RFC 4648 section 5; RFC 7515 appendix C).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace talus::server {

[[nodiscard]] std::string base64url_encode(std::string_view bytes);

/// None where the text holds a character outside the alphabet or has a length that no bytes encode to. Unused
/// bits of the last character are ignored.
[[nodiscard]] std::optional<std::string> base64url_decode(std::string_view text);

}  // namespace talus::server
