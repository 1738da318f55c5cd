// Names and lists in HTTP header fields. Source: RFC 9110, section 5.
#pragma once

#include <string_view>

namespace talus::protocol {

/// Compares names, ignoring the case of ASCII letters.
[[nodiscard]] bool same_name(std::string_view a, std::string_view b);

/// Removes leading and trailing spaces and tabs.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Removes the first item from a comma-separated list and returns it trimmed.
[[nodiscard]] std::string_view take_item(std::string_view& list);

/// True if the list contains the word, ignoring case.
[[nodiscard]] bool has_word(std::string_view list, std::string_view word);

}  // namespace talus::protocol
