#include "player_mix.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <sstream>

namespace talus::load {
namespace {

constexpr const char* kMixed = "walk=60,fly=20,stand=15,teleport=5";
constexpr const char* kRight =
    "; write stand, walk, fly, teleport, swarm, mixed, trace:FILE, or shares as in walk=80,fly=20";

std::optional<std::size_t> model_of(const std::string& name) {
  const auto end = kRoleNames.begin() + kModels;
  const auto found = std::find(kRoleNames.begin(), end, name);
  if (found == end) return std::nullopt;
  return static_cast<std::size_t>(found - kRoleNames.begin());
}

}  // namespace

tl::expected<PlayerMix, std::string> parse_player_mix(const std::string& text) {
  if (text == "mixed") return parse_player_mix(kMixed);
  const auto wrong = [&](const std::string& why) {
    return tl::unexpected{"--model " + text + ": " + why + kRight};
  };
  PlayerMix mix;
  std::istringstream entries{text};
  std::string entry;
  while (std::getline(entries, entry, ',')) {
    const auto equals = entry.rfind('=');
    std::string name = entry.substr(0, equals);
    double share = 1;
    if (equals != std::string::npos) {
      std::istringstream number{entry.substr(equals + 1)};
      if (!(number >> share) || !number.eof() || !(share > 0))
        return wrong("'" + entry + "' has no share above 0");
    }
    if (const auto colon = name.find(':'); colon != std::string::npos && name.substr(0, colon) == "trace") {
      mix.trace_file = name.substr(colon + 1);
      name = "trace";
    }
    const auto model = model_of(name);
    if (!model) return wrong("unknown model '" + name + "'");
    if (name == "trace" && mix.trace_file.empty()) return wrong("trace needs its file");
    mix.shares[*model] += share;
  }
  if (std::accumulate(mix.shares.begin(), mix.shares.end(), 0.0) <= 0) return wrong("it names no model");
  return mix;
}

std::vector<Role> deal(const PlayerMix& mix, std::size_t players) {
  const double sum = std::accumulate(mix.shares.begin(), mix.shares.end(), 0.0);
  std::array<double, kModels> owed{};
  std::vector<Role> roles;
  roles.reserve(players);
  for (std::size_t player = 0; player < players; ++player) {
    for (std::size_t model = 0; model < kModels; ++model) owed[model] += mix.shares[model] / sum;
    const auto most = std::max_element(owed.begin(), owed.end());
    *most -= 1;
    roles.push_back(static_cast<Role>(most - owed.begin()));
  }
  return roles;
}

}  // namespace talus::load
