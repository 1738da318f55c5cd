// Subjects of tokens as `talusd store` prints and takes them: whoever makes tokens chooses their bytes, and
// what is printed can be given back.
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server {

/// On one line, each subject in its own way: visible characters of UTF-8 and single spaces between them as
/// they are, backslashes and all other bytes as \xNN; no subject as "(no token)".
[[nodiscard]] std::string subject_text(std::string_view subject);

/// The subject whose text that is, or, also with other bytes as \xNN, could be. An error is one line.
[[nodiscard]] tl::expected<std::string, std::string> parse_subject(std::string_view text);

}  // namespace talus::server
