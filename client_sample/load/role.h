// Behaviours of simulated clients.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace talus::load {

/// The first six are models of movement; `slow` walks and reads slowly; `build` stands and edits; the others
/// send no View.
enum class Role : std::uint8_t {
  stand,
  walk,
  fly,
  teleport,
  swarm,
  trace,
  slow,
  greedy,
  requests,
  idle,
  build
};

inline constexpr std::array<std::string_view, 11> kRoleNames{
    "stand", "walk", "fly", "teleport", "swarm", "trace", "slow", "greedy", "requests", "idle", "build"};
inline constexpr std::size_t kRoles = kRoleNames.size();
inline constexpr std::size_t kModels = 6;  // roles that --model accepts

[[nodiscard]] constexpr std::string_view name_of(Role role) {
  return kRoleNames[static_cast<std::size_t>(role)];
}
/// True if its figures count as the players'; greedy and slow clients are reported separately.
[[nodiscard]] constexpr bool is_player(Role role) {
  return role != Role::slow && role != Role::greedy;
}

}  // namespace talus::load
