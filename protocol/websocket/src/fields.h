// The header fields of an HTTP response, as views into its text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace talus::websocket {

/// Takes the line from the front of `text`; it is without its CR LF.
[[nodiscard]] std::string_view next_line(std::string_view& text);

/// For people: short, and nothing in it that a terminal would obey.
[[nodiscard]] std::string printable(std::string_view text);

class Fields {
 public:
  /// `text`: what follows the status line; outlives this.
  explicit Fields(std::string_view text) : text_{text} {}
  /// Of the first field of this name, in any case.
  [[nodiscard]] std::optional<std::string_view> value(std::string_view name) const;

 private:
  std::string_view text_;
};

}  // namespace talus::websocket
