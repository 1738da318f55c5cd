#include "run_result.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace talus::load {

Tally RunResult::players() const {
  Tally sum;
  for (std::size_t role = 0; role < kRoles; ++role) {
    if (is_player(static_cast<Role>(role))) sum.merge(tallies[role]);
  }
  return sum;
}

Tally RunResult::all() const {
  Tally sum;
  for (const Tally& tally : tallies) sum.merge(tally);
  return sum;
}

std::map<std::string, RateModel> RunResult::held_by() const {
  constexpr double kWorthTelling = 0.05;
  std::map<std::string, RateModel> held;
  for (const auto& [name, rate] : rates) {
    if (rate.held() > kWorthTelling) held.emplace(name, rate);
  }
  return held;
}

std::optional<double> RunResult::resident_growth_percent() const {
  if (resident_bytes.size() < 2) return std::nullopt;
  const auto tenth = static_cast<std::ptrdiff_t>(std::max<std::size_t>(resident_bytes.size() / 10, 1));
  const double first = std::accumulate(resident_bytes.begin(), resident_bytes.begin() + tenth, 0.0);
  const double last = std::accumulate(resident_bytes.end() - tenth, resident_bytes.end(), 0.0);
  return (last / first - 1) * 100;
}

}  // namespace talus::load
