#include "cluster/log_format.h"

#include <charconv>
#include <system_error>

namespace talus::server::cluster {
namespace {

/// Takes `word` off the text's begin, if it stands there.
bool take_word(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

template <typename Number>
bool take_number(std::string_view& text, Number& number) {
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return true;
}

}  // namespace

EnabledFormat enabled_format(std::string_view description) {
  EnabledFormat enabled;
  const bool is_one = take_word(description, "log format ") && take_number(description, enabled.number) &&
                      take_word(description, " from message ") && take_number(description, enabled.from) &&
                      description.empty();
  return is_one ? enabled : EnabledFormat{};
}

}  // namespace talus::server::cluster
