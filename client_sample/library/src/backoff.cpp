#include <talus/client/backoff.h>

#include <algorithm>

namespace talus::client {

Backoff::Backoff(const ReconnectPolicy& policy)
    : policy_{policy}, random_{policy.seed ? *policy.seed : std::random_device{}()} {}

std::optional<std::chrono::milliseconds> Backoff::next(std::chrono::milliseconds retry_after) {
  if (failures_ >= policy_.max_attempts) return std::nullopt;
  auto most = std::min(policy_.first_delay, policy_.max_delay);
  for (int i = 0; i < failures_ && most < policy_.max_delay; ++i)
    most = std::min(most * 2, policy_.max_delay);
  ++failures_;
  const auto random_part = random_() % (static_cast<std::uint64_t>(most.count()) + 1);
  return std::min(retry_after, kLongestRetryAfter) +
         std::chrono::milliseconds{static_cast<std::int64_t>(random_part)};
}

}  // namespace talus::client
