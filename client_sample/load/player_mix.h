// Distribution of players over the models of movement.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "role.h"

namespace talus::load {

/// Shares of the models, by Role; their sum may be any positive number.
struct PlayerMix {
  std::array<double, kModels> shares{};
  std::string trace_file;  // set if trace has a share
};

/// Parses "walk", "mixed", "trace:FILE" or "walk=80,fly=15,teleport=5"; an error is one line.
[[nodiscard]] tl::expected<PlayerMix, std::string> parse_player_mix(const std::string& text);

/// Assigns a model to each player. Any sequence of players matches the shares as closely as possible.
[[nodiscard]] std::vector<Role> deal(const PlayerMix& mix, std::size_t players);

}  // namespace talus::load
