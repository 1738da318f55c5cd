#include "cluster/checkpoint/aside_store.h"

#include <algorithm>
#include <charconv>
#include <tuple>

#include <fmt/format.h>

namespace talus::server {
namespace {

/// Removes a number and the space after it from the beginning of `text`.
template <typename Number>
bool take_number(std::string_view& text, Number& number, int base) {
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (error != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  if (text.starts_with(' ')) text.remove_prefix(1);
  return true;
}

}  // namespace

std::string to_string(const AsideStore& store) {
  return fmt::format("{} {} {:08x}", store.sequence, store.created_ns, store.server);
}

std::optional<AsideStore> parse_aside(std::string_view text) {
  AsideStore store;
  if (!take_number(text, store.sequence, 10) || !take_number(text, store.created_ns, 10) ||
      !take_number(text, store.server, 16) || !text.empty()) {
    return std::nullopt;
  }
  return store;
}

bool goes_on(const AsideStore& own, const Round& round, bool patient) {
  if (round.aside.empty() || round.aside.size() + round.silent < round.peers) return false;
  if (round.silent > 0 && (patient || 2 * round.aside.size() <= round.peers)) return false;
  return std::ranges::all_of(round.aside, [&](const AsideStore& other) {
    return other.created_ns == own.created_ns &&
           std::tie(other.sequence, other.server) <= std::tie(own.sequence, own.server);
  });
}

}  // namespace talus::server
