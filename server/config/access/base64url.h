// Base64 (RFC 4648): URL alphabet without padding (section 5; RFC 7515 appendix C), and the standard alphabet
// (section 4), common in JSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace talus::server {

[[nodiscard]] std::string base64url_encode(std::string_view bytes);

/// Returns nullopt if the text has a character outside the alphabet or an impossible length. Ignores unused
/// bits of the last character.
[[nodiscard]] std::optional<std::string> base64url_decode(std::string_view text);

/// Like base64url_decode() for the alphabet with + and /, padded with =.
[[nodiscard]] std::optional<std::string> base64_decode(std::string_view text);

}  // namespace talus::server
