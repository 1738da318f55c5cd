#include "servers.h"

#include <algorithm>
#include <utility>

#include <talus/client/backoff.h>

namespace talus::client {

Servers::Servers(ServerAddress first, const std::vector<ServerAddress>& more,
                 std::optional<std::uint64_t> seed)
    : random_{seed ? *seed : std::random_device{}()} {
  servers_.push_back({std::move(first), {}});
  for (const ServerAddress& address : more) servers_.push_back({address, {}});
}

std::chrono::milliseconds Servers::leave(Clock::Time now, std::chrono::milliseconds retry_after) {
  servers_[current_].not_before = now + std::min(retry_after, kLongestRetryAfter);
  current_ = (current_ + 1) % servers_.size();
  const auto wait = servers_[current_].not_before - now;
  return std::max(std::chrono::ceil<std::chrono::milliseconds>(wait), std::chrono::milliseconds{0});
}

std::vector<asio::ip::tcp::endpoint> Servers::in_order(const asio::ip::tcp::resolver::results_type& found) {
  std::vector<asio::ip::tcp::endpoint> order;
  for (const auto& entry : found) order.push_back(entry.endpoint());
  const auto of_one_family = [](const auto& a, const auto& b) { return a.protocol() == b.protocol(); };
  for (auto from = order.begin(); from != order.end();) {
    const auto to = std::find_if_not(from, order.end(),
                                     [&](const auto& address) { return of_one_family(*from, address); });
    std::shuffle(from, to, random_);
    std::stable_partition(from, to, [this](const auto& address) { return address != reached_; });
    from = to;
  }
  return order;
}

}  // namespace talus::client
