// Names in HTTP's header fields, and lists. Source: RFC 9110, section 5.
#pragma once

#include <string_view>

namespace talus::protocol {

/// In any case. Bytes that are not ASCII are only like themselves.
[[nodiscard]] bool same_name(std::string_view a, std::string_view b);

/// Without the spaces and tabs around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Takes the first item, trimmed, from the front of a list separated by commas.
[[nodiscard]] std::string_view take_item(std::string_view& list);

/// Whether a list has the word, in any case.
[[nodiscard]] bool has_word(std::string_view list, std::string_view word);

}  // namespace talus::protocol
