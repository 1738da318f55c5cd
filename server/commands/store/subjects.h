// Printed form of token subjects in `talusd store`. Token issuers choose arbitrary bytes; printed text can be
// used as input.
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server {

/// Encodes a subject unambiguously on one line: visible UTF-8 characters and single spaces stay, backslashes
/// and all other bytes become \xNN; an empty subject becomes "(no token)".
[[nodiscard]] std::string subject_text(std::string_view subject);

/// Inverse of subject_text(); accepts \xNN for any byte. An error is one line.
[[nodiscard]] tl::expected<std::string, std::string> parse_subject(std::string_view text);

}  // namespace talus::server
