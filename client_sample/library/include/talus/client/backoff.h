// Delays between attempts to connect. A Client uses this by itself; it is public for programs that open their
// own connections.
#pragma once

#include <chrono>
#include <optional>
#include <random>

#include <talus/client/options.h>

namespace talus::client {

/// Exponential back-off with full jitter, as ReconnectPolicy describes. Has no clock: the caller waits.
class Backoff {
 public:
  explicit Backoff(const ReconnectPolicy& policy);

  /// Delay after one more failure; nullopt when the policy's attempts are used up. The random part is added
  /// to `retry_after`, the delay that the server asked for, so that clients sent away together do not return
  /// together.
  [[nodiscard]] std::optional<std::chrono::milliseconds> next(std::chrono::milliseconds retry_after = {});

  /// Call after the connection was useful: failures count from zero again.
  void reset() { failures_ = 0; }

 private:
  ReconnectPolicy policy_;
  std::mt19937_64 random_;
  int failures_ = 0;
};

}  // namespace talus::client
