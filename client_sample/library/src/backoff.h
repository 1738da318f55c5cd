// How long to wait before the next attempt to connect.
#pragma once

#include <chrono>
#include <optional>
#include <random>

#include <talus/client/options.h>

namespace talus::client {

class Backoff {
 public:
  explicit Backoff(const ReconnectPolicy& policy) : policy_{policy}, random_{policy.seed} {}

  /// The wait after one more failure, no shorter than the server asks for within kLongestRetryAfter; none
  /// once the policy's attempts are used up.
  [[nodiscard]] std::optional<std::chrono::milliseconds> next(std::chrono::milliseconds retry_after = {});

  /// The connection was of use: count failures from zero again.
  void reset() { failures_ = 0; }

 private:
  ReconnectPolicy policy_;
  std::mt19937_64 random_;
  int failures_ = 0;
};

}  // namespace talus::client
