#include "config/access/revoked_tokens.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "config/access/list_file.h"
#include "runtime/log/escape.h"

namespace talus::server {
namespace {

/// Removes a number of exactly `digits` digits from the text, and returns it.
std::optional<int> take_number(std::string_view& text, std::size_t digits) {
  if (text.size() < digits || text.find_first_not_of("0123456789") < digits) return std::nullopt;
  int number = 0;
  std::from_chars(text.data(), text.data() + digits, number);
  text.remove_prefix(digits);
  return number;
}

/// Parses 2026-11-22T18:30:00Z.
std::optional<std::chrono::sys_seconds> parse_time(std::string_view text) {
  constexpr std::size_t kNumbers = 6;
  constexpr std::size_t kDigits[kNumbers] = {4, 2, 2, 2, 2, 2};
  constexpr std::string_view kAfter = "--T::Z";
  int number[kNumbers] = {};
  for (std::size_t i = 0; i < kNumbers; ++i) {
    const auto taken = take_number(text, kDigits[i]);
    if (!taken || text.empty() || text.front() != kAfter[i]) return std::nullopt;
    number[i] = *taken;
    text.remove_prefix(1);
  }
  using namespace std::chrono;
  const year_month_day day{year{number[0]}, month{static_cast<unsigned>(number[1])},
                           std::chrono::day{static_cast<unsigned>(number[2])}};
  if (!text.empty() || !day.ok() || number[3] > 23 || number[4] > 59 || number[5] > 59) return std::nullopt;
  return sys_days{day} + hours{number[3]} + minutes{number[4]} + seconds{number[5]};
}

}  // namespace

tl::expected<RevokedTokens, std::string> RevokedTokens::parse(std::string_view text) {
  RevokedTokens revoked;
  return parse_list(text, [&](std::string_view line, std::size_t) { return revoked.add(line); }).map([&] {
    return std::move(revoked);
  });
}

std::string RevokedTokens::add(std::string_view line) {
  std::string_view rest = line;
  const std::string_view kind = take_word(rest);
  if (kind == "jti" && !rest.empty()) {
    ids_.emplace(rest);
    return {};
  }
  if (kind == "sub") {
    const auto time = parse_time(take_word(rest));
    if (!time) return "the TIME after sub is not like 2026-11-22T18:30:00Z";
    if (rest.empty()) return "no SUBJECT after the TIME";
    auto& before = subjects_.try_emplace(std::string{rest}, *time).first->second;
    before = std::max(before, *time);
    return {};
  }
  constexpr std::size_t kShown = 80;
  return fmt::format("\"{}\" is neither \"jti ID\" nor \"sub TIME SUBJECT\"", escaped(line, kShown));
}

tl::expected<RevokedTokens, std::string> RevokedTokens::read(const std::filesystem::path& file) {
  RevokedTokens revoked;
  return read_list(file, [&](std::string_view line, std::size_t) { return revoked.add(line); }).map([&] {
    return std::move(revoked);
  });
}

bool RevokedTokens::contains(const std::string& id, const std::string& subject,
                             std::optional<std::chrono::sys_seconds> issued) const {
  if (!id.empty() && ids_.contains(id)) return true;
  const auto found = subjects_.find(subject);
  return !subject.empty() && found != subjects_.end() && (!issued || *issued < found->second);
}

}  // namespace talus::server
