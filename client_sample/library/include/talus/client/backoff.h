// How long to wait before the next attempt to connect. A Client does this by itself; it is here for those who
// make connections of their own.
#pragma once

#include <chrono>
#include <optional>
#include <random>

#include <talus/client/options.h>

namespace talus::client {

/// Exponential back-off with full jitter, as ReconnectPolicy says. Knows no clock: the caller waits.
class Backoff {
 public:
  explicit Backoff(const ReconnectPolicy& policy);

  /// The wait after one more failure; none once the policy's attempts are used up. `retry_after` is what the
  /// server asked for; the random part comes on top, so that those who were sent away together do not return
  /// together.
  [[nodiscard]] std::optional<std::chrono::milliseconds> next(std::chrono::milliseconds retry_after = {});

  /// The connection was of use: count failures from zero again.
  void reset() { failures_ = 0; }

 private:
  ReconnectPolicy policy_;
  std::mt19937_64 random_;
  int failures_ = 0;
};

}  // namespace talus::client
