#include "commands/store/moments.h"

#include <time.h>

#include <charconv>
#include <chrono>
#include <optional>

#include <fmt/format.h>

#include "runtime/log/escape.h"
#include "runtime/log/utc_time.h"

namespace talus::server {
namespace {

/// Parses a duration such as "2h" into milliseconds.
std::optional<std::int64_t> parse_duration(std::string_view text) {
  constexpr std::int64_t kSecond = 1'000;
  constexpr std::int64_t kOneDay = 86'400 * kSecond;
  const char unit = text.empty() ? ' ' : text.back();
  const std::int64_t each = unit == 's'   ? kSecond
                            : unit == 'm' ? 60 * kSecond
                            : unit == 'h' ? 3'600 * kSecond
                            : unit == 'd' ? kOneDay
                                          : 0;
  if (each == 0) return std::nullopt;
  std::int64_t count = 0;
  const char* const end = text.data() + text.size() - 1;
  const auto [stop, error] = std::from_chars(text.data(), end, count);
  if (error != std::errc{} || stop != end || count < 0 || count > 36'500 * kOneDay / each)
    return std::nullopt;
  return count * each;
}

std::optional<std::int64_t> parse_utc(const std::string& text) {
  for (const char* const format : {"%Y-%m-%dT%H:%M:%SZ", "%Y-%m-%d"}) {
    std::tm broken_down{};
    const char* const stop = ::strptime(text.c_str(), format, &broken_down);
    if (stop == nullptr || *stop != '\0') continue;
    const int day = broken_down.tm_mday;
    const std::int64_t since_1970 = ::timegm(&broken_down);
    if (broken_down.tm_mday != day) return std::nullopt;  // e.g. the 31st of a 30-day month
    return since_1970 * 1'000;
  }
  return std::nullopt;
}

}  // namespace

tl::expected<std::int64_t, std::string> parse_moment(std::string_view text, std::int64_t now_ms) {
  if (const auto ago = parse_duration(text)) return now_ms - *ago;
  if (const auto time = parse_utc(std::string{text})) return *time;
  return tl::unexpected{
      fmt::format("\"{}\" is wrong; give 90s, 30m, 2h or 7d ago, or a time in UTC as 2026-11-25T08:30:00Z",
                  escaped(text))};
}

std::string moment(std::int64_t time_ms) {
  return utc_time(std::chrono::sys_seconds{std::chrono::seconds{time_ms / 1'000}}, "%Y-%m-%dT%H:%M:%SZ");
}

}  // namespace talus::server
