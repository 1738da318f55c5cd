#include "net/balancer_state.h"

#include <algorithm>
#include <charconv>

#include "net/http/query.h"

namespace talus::server {
namespace {

// No balancer has more; products of two of them fit.
constexpr std::uint64_t kMaxOfBalancer = 1U << 24;

struct BalancerShare {
  std::uint64_t own = 0;
  std::uint64_t all = 0;
};

std::optional<std::uint64_t> read_balancer_count(std::string_view text) {
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc{} || end != text.data() + text.size() || count > kMaxOfBalancer) return std::nullopt;
  return count;
}

bool take_balancer_name(std::string_view& text, std::string_view name) {
  if (!text.starts_with(name)) return false;
  text.remove_prefix(name.size());
  return true;
}

/// Finds "NAME=OWN/ALL" among the parts separated by "; ".
std::optional<BalancerShare> read_balancer_share(std::string_view text, std::string_view name) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    part.remove_prefix(std::min(part.find_first_not_of(' '), part.size()));
    if (!take_balancer_name(part, name)) continue;
    const std::size_t slash = std::min(part.find('/'), part.size());
    const auto own = read_balancer_count(part.substr(0, slash));
    const auto all = read_balancer_count(part.substr(std::min(slash + 1, part.size())));
    if (!own || !all || *own > *all) return std::nullopt;
    return BalancerShare{*own, *all};
  }
  return std::nullopt;
}

std::optional<std::uint64_t> read_balancer_percent(std::string_view text) {
  constexpr std::uint64_t kMaxPercent = 1000;
  const auto percent = read_balancer_count(text);
  return percent && *percent <= kMaxPercent ? percent : std::nullopt;
}

/// "4780" or "4800-4863".
std::optional<PortRange> read_balancer_ports(std::string_view text) {
  const std::size_t dash = std::min(text.find('-'), text.size());
  const auto first = read_balancer_count(text.substr(0, dash));
  const auto last = dash == text.size() ? first : read_balancer_count(text.substr(dash + 1));
  if (!first || !last || *first > *last || *last > UINT16_MAX) return std::nullopt;
  return PortRange{static_cast<std::uint16_t>(*first), static_cast<std::uint16_t>(*last)};
}

}  // namespace

std::optional<BalancerState> read_balancer_state(std::string_view text) {
  // "UP", or "UP 1/2" if a check has failed recently.
  if (!text.starts_with("UP")) return std::nullopt;
  const auto weight = read_balancer_share(text, "weight=");
  const auto sessions = read_balancer_share(text, "scur=");
  if (!weight || !sessions || weight->own == 0) return std::nullopt;
  return BalancerState{weight->own, weight->all, sessions->own, sessions->all};
}

tl::expected<BalancerQuery, std::string> read_balancer_query(std::string_view query) {
  BalancerQuery read;
  while (!query.empty()) {
    const std::size_t end = std::min(query.find('&'), query.size());
    const std::string_view part = query.substr(0, end);
    query.remove_prefix(std::min(end + 1, query.size()));
    const std::string decoded = http::form_decoded(part).value_or("");
    std::string_view value = decoded;
    bool understood = false;
    if (!read.above_percent && take_balancer_name(value, "above_percent=")) {
      read.above_percent = read_balancer_percent(value);
      understood = read.above_percent.has_value();
    } else if (!read.ports && take_balancer_name(value, "ports=")) {
      read.ports = read_balancer_ports(value);
      understood = read.ports.has_value();
    }
    if (!understood) {
      constexpr std::size_t kShown = 80;
      return tl::make_unexpected("'" + std::string{part.substr(0, kShown)} +
                                 "' is not one of above_percent=PERCENT (at most 1000), ports=PORT and "
                                 "ports=FIRST-LAST (at most 65535), each once");
    }
  }
  return read;
}

std::uint64_t sessions_above_share(const BalancerState& state, std::uint64_t percent) {
  const std::uint64_t share = (state.all_sessions * state.weight + state.all_weight - 1) / state.all_weight;
  const std::uint64_t most = share + (share * percent + 99) / 100;
  return state.sessions > most ? state.sessions - most : 0;
}

}  // namespace talus::server
