// What a balancer says of itself and of this server in every health check. Pure. Source: HAProxy 2.6,
// Configuration Manual, "http-check send-state".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "net/port_range.h"

namespace talus::server {

struct BalancerState {
  // Of this server, and of all that the balancer sends somebody to now; `all` is at least 1.
  std::uint64_t weight = 0, all_weight = 1;
  std::uint64_t sessions = 0, all_sessions = 0;

  bool operator==(const BalancerState&) const = default;
};

inline constexpr std::string_view kBalancerStateField = "X-Haproxy-Server-State";

/// None: it is no such text, or this server is not up there.
[[nodiscard]] std::optional<BalancerState> read_balancer_state(std::string_view text);

/// What the check's address says beside: "above_percent=25&ports=4800-4863", each once or not at all.
struct BalancerQuery {
  std::optional<std::uint64_t> above_percent;  // in place of the setting; at most 1,000
  // Of the balancer, by which the sessions come that it counts; 0: it does not say by which. None: all
  // sessions.
  std::optional<PortRange> ports;
  bool operator==(const BalancerQuery&) const = default;
};
/// The error names the part that is not understood, and says what would be.
[[nodiscard]] tl::expected<BalancerQuery, std::string> read_balancer_query(std::string_view query);

/// How many sessions this server has beyond its share and `percent` more of it.
[[nodiscard]] std::uint64_t sessions_above_share(const BalancerState& state, std::uint64_t percent);

}  // namespace talus::server
