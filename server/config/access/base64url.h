// Base64 (RFC 4648): with the URL alphabet and without padding (section 5; RFC 7515 appendix C), and as JSON
// of others mostly has it (section 4).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace talus::server {

[[nodiscard]] std::string base64url_encode(std::string_view bytes);

/// None where the text holds a character outside the alphabet or has a length that no bytes encode to. Unused
/// bits of the last character are ignored.
[[nodiscard]] std::optional<std::string> base64url_decode(std::string_view text);

/// The same of the alphabet with + and /, padded by =.
[[nodiscard]] std::optional<std::string> base64_decode(std::string_view text);

}  // namespace talus::server
