#include "net/departures.h"

#include <algorithm>
#include <string>

#include "net/balancer_state.h"

namespace talus::server {
namespace {

constexpr std::chrono::milliseconds kBetweenFarewells{20};
// Other servers are running: clients need not wait before they reconnect.
constexpr std::chrono::milliseconds kNoWait{0};
const std::string kServerEnding = "the server is ending";

}  // namespace

Departures::Departures(asio::io_context& io, Registry& registry, const Clock& clock)
    : registry_{registry}, clock_{clock}, timer_{io} {}

void Departures::send_all(std::chrono::milliseconds time) {
  end_ = clock_.now() + time;
  registry_.tell_others_to_go(kServerEnding);
  send_some();
}

void Departures::send_some() {
  const auto now = clock_.now();
  const std::size_t staying = registry_.sessions().staying;
  if (now >= end_ || staying == 0) return registry_.tell_all_to_go(kServerEnding, kNoWait);
  // One at a time, unless there are too many for that.
  const auto apart = std::max<Clock::duration>((end_ - now) / staying, kBetweenFarewells);
  const auto turns = std::max<std::size_t>(1, static_cast<std::size_t>((end_ - now) / apart));
  (void)registry_.tell_to_go((staying + turns - 1) / turns, {}, Clock::time_point::max(), kServerEnding,
                             kNoWait);
  timer_.expires_after(apart);
  timer_.async_wait([this](std::error_code cancelled) {
    if (!cancelled) send_some();
  });
}

std::size_t Departures::balancer_says(std::string_view state, const BalanceSettings& settings,
                                      std::optional<PortRange> ports) {
  const auto balancer = read_balancer_state(state);
  if (!balancer || settings.per_second == 0) return 0;
  const std::uint64_t too_many = sessions_above_share(*balancer, settings.above_percent);
  // The balancer counts leaving sessions until they have left.
  const std::uint64_t leaving = registry_.sessions(ports).leaving;
  const auto now = clock_.now();
  const Rate rate{settings.per_second, settings.per_second};
  const auto allowed = static_cast<std::uint64_t>(std::max<std::int64_t>(0, sent_.level(rate, now)));
  if (too_many <= leaving || allowed == 0) return 0;
  const std::size_t sent =
      registry_.tell_to_go(std::min(too_many - leaving, allowed), ports, now - settings.session_age,
                           "another server has more room", kNoWait);
  sent_.spend(rate, now, sent);
  return sent;
}

}  // namespace talus::server
