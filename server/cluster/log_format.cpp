#include "cluster/log_format.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>

#include <fmt/format.h>

namespace talus::server::cluster {
namespace {

constexpr std::string_view kBegin = "log format";

char in_lower_case(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

/// Ignores case: a typing error must not enable less than was meant.
bool speaks_of_formats(std::string_view description) {
  return description.size() >= kBegin.size() &&
         std::equal(kBegin.begin(), kBegin.end(), description.begin(),
                    [](char ours, char theirs) { return ours == in_lower_case(theirs); });
}

/// Removes `word` from the beginning of the text, if present.
bool take_word(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

/// Removes a number without leading zeros, not 0, from the beginning of the text.
template <typename Number>
bool take_number(std::string_view& text, Number& number) {
  if (text.starts_with('0')) return false;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return true;
}

std::optional<std::vector<EnabledFormat>> read_formats(std::string_view text) {
  std::vector<EnabledFormat> list;
  EnabledFormat last{};
  if (!take_word(text, kBegin) || !take_word(text, " ")) return std::nullopt;
  do {
    EnabledFormat next;
    if (!take_number(text, next.number) || !take_word(text, " from message ") ||
        !take_number(text, next.from) || next.number <= last.number || next.from <= last.from) {
      return std::nullopt;
    }
    list.push_back(next);
    last = next;
  } while (take_word(text, ", "));
  if (!text.empty()) return std::nullopt;
  return list;
}

}  // namespace

std::uint64_t EnabledFormats::newer_from() const {
  if (!understood) return 0;
  const auto newer = std::find_if(list.begin(), list.end(),
                                  [](const EnabledFormat& each) { return each.number > kLogFormat; });
  return newer == list.end() ? kNever : newer->from;
}

EnabledFormats enabled_formats(std::string_view description) {
  if (!speaks_of_formats(description)) return {};
  auto list = read_formats(description);
  if (!list) return {{}, false};
  return {*std::move(list), true};
}

std::string to_string(const EnabledFormats& enabled) {
  std::string text{kBegin};
  if (enabled.list.empty()) return text + " 1";
  const char* between = " ";
  for (const EnabledFormat& each : enabled.list) {
    text += fmt::format("{}{} from message {}", between, each.number, each.from);
    between = ", ";
  }
  return text;
}

}  // namespace talus::server::cluster
