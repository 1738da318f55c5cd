// What a simulated client does.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace talus::load {

/// The first six are ways of moving; `slow` walks and reads slowly; `build` stands and edits; the others
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
inline constexpr std::size_t kModels = 6;  // roles that --model can name

[[nodiscard]] constexpr std::string_view name_of(Role role) {
  return kRoleNames[static_cast<std::size_t>(role)];
}
/// Whether its figures are those of the players; what greedy and slow clients meet is told apart.
[[nodiscard]] constexpr bool is_player(Role role) {
  return role != Role::slow && role != Role::greedy;
}

}  // namespace talus::load
