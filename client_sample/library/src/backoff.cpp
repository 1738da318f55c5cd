#include "backoff.h"

#include <algorithm>

namespace talus::client {

std::optional<std::chrono::milliseconds> Backoff::next(std::chrono::milliseconds retry_after) {
  if (failures_ >= policy_.max_attempts) return std::nullopt;
  auto delay = std::min(policy_.first_delay, policy_.max_delay);
  for (int i = 0; i < failures_ && delay < policy_.max_delay; ++i) {
    delay = std::min(delay * 2, policy_.max_delay);
  }
  ++failures_;
  const auto random_part = static_cast<std::uint64_t>(delay.count() / 2 + 1);
  delay -= std::chrono::milliseconds{static_cast<std::int64_t>(random_() % random_part)};
  return std::max(delay, std::min(retry_after, kLongestRetryAfter));
}

}  // namespace talus::client
