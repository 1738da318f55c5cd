// What a balancer says of itself and of this server in every health check. Pure. Source: HAProxy 2.6,
// Configuration Manual, "http-check send-state".
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

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

/// What the check's address asks for in place of the setting: "above_percent=25", at most 1,000. None: it
/// does not.
[[nodiscard]] std::optional<std::uint64_t> read_above_percent(std::string_view query);

/// How many sessions this server has beyond its share and `percent` more of it.
[[nodiscard]] std::uint64_t sessions_above_share(const BalancerState& state, std::uint64_t percent);

}  // namespace talus::server
