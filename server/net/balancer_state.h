// The state of a balancer and of this server that the balancer sends with every health check. Pure functions.
// Source: HAProxy 2.6, Configuration Manual, "http-check send-state".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "net/port_range.h"

namespace talus::server {

struct BalancerState {
  // For this server, and the total of all servers that accept new connections; `all` is at least 1.
  std::uint64_t weight = 0, all_weight = 1;
  std::uint64_t sessions = 0, all_sessions = 0;

  bool operator==(const BalancerState&) const = default;
};

inline constexpr std::string_view kBalancerStateField = "X-Haproxy-Server-State";

/// Returns nullopt if the text is malformed or the balancer does not consider this server up.
[[nodiscard]] std::optional<BalancerState> read_balancer_state(std::string_view text);

/// Query parameters of the health-check URL: "above_percent=25&ports=4800-4863", each at most once.
struct BalancerQuery {
  std::optional<std::uint64_t> above_percent;  // replaces the setting; at most 1,000
  // The balancer's ports of the sessions that it counts; port 0: sessions without a known port. Empty: all
  // sessions.
  std::optional<PortRange> ports;
  bool operator==(const BalancerQuery&) const = default;
};
/// The error names the parameter that is not understood, and the valid ones.
[[nodiscard]] tl::expected<BalancerQuery, std::string> read_balancer_query(std::string_view query);

/// Number of sessions by which this server exceeds its share plus `percent` of it.
[[nodiscard]] std::uint64_t sessions_above_share(const BalancerState& state, std::uint64_t percent);

}  // namespace talus::server
