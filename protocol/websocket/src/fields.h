// Header fields of an HTTP response, as views into its text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace talus::websocket {

/// Removes the first line from `text` and returns it without its CR LF.
[[nodiscard]] std::string_view next_line(std::string_view& text);

/// Shortens a text for messages and removes control characters.
[[nodiscard]] std::string printable(std::string_view text);

class Fields {
 public:
  /// `text`: everything after the status line; must outlive this object.
  explicit Fields(std::string_view text) : text_{text} {}
  /// Values of all fields with this name, ignoring case, as one list. Source: RFC 9110, 5.2.
  [[nodiscard]] std::optional<std::string> list(std::string_view name) const;

 private:
  std::string_view text_;
};

}  // namespace talus::websocket
