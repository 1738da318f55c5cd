// A subscription that NATS rejects or has revoked: NATS reports that once, and does not report when it is
// allowed again. Pure.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "cluster/log_stream.h"

namespace talus::server::jetstream {

/// Used by one thread at a time.
class RefusedSubscription {
 public:
  using TimePoint = LogStream::TimePoint;

  static constexpr std::chrono::seconds kBetweenTries{3};
  enum class Due : std::uint8_t { nothing, try_again, restored };

  /// NATS rejected the subscription with the reason `why`. True if that is news.
  bool refused(std::string why, TimePoint now) {
    refused_at_ = now;
    if (!why_.empty()) return false;
    why_ = std::move(why);
    tried_at_.reset();
    next_ = now + kBetweenTries;
    return true;
  }
  /// On try_again the caller must subscribe again. A try that is not rejected before the next one is due has
  /// restored the subscription.
  [[nodiscard]] Due due(TimePoint now) {
    if (why_.empty() || now < next_) return Due::nothing;
    next_ = now + kBetweenTries;
    if (tried_at_ && refused_at_ < *tried_at_) {
      why_.clear();
      return Due::restored;
    }
    tried_at_ = now;
    return Due::try_again;
  }
  /// A try may not have been sent.
  void disconnected() { tried_at_.reset(); }

  /// Empty if the subscription is allowed, as far as is known.
  [[nodiscard]] const std::string& why() const { return why_; }

 private:
  std::string why_;
  TimePoint refused_at_{};
  std::optional<TimePoint> tried_at_;
  TimePoint next_{};
};

}  // namespace talus::server::jetstream
