// Which players move in which way.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "role.h"

namespace talus::load {

/// Shares of the models, by Role; any positive sum.
struct PlayerMix {
  std::array<double, kModels> shares{};
  std::string trace_file;  // where trace has a share
};

/// "walk", "mixed", "trace:FILE" or "walk=80,fly=15,teleport=5"; else one line that says what is wrong.
[[nodiscard]] tl::expected<PlayerMix, std::string> parse_player_mix(const std::string& text);

/// One model a player. Any run of players has the shares as nearly as can be.
[[nodiscard]] std::vector<Role> deal(const PlayerMix& mix, std::size_t players);

}  // namespace talus::load
