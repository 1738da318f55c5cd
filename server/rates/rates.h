// What holds a session back: its own rates, and those of its address, which it shares with the address's
// other sessions. No I/O; time is passed in.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "config/config.h"
#include "metrics/metrics.h"
#include "rates/rate_kind.h"
#include "rates/token_bucket.h"
#include "stream/outbox.h"

namespace talus::server {

/// What is counted: requests when they come, chunks and all bytes when they go.
struct RateSet {
  Rate chunks, bytes, requests;
};
struct RateLimits {
  RateSet session, address;
};
inline constexpr RateLimits kUnlimited{};

[[nodiscard]] RateLimits rate_limits(const Rates& config);

/// Shared by the sessions of one address, on any thread, without a lock.
struct AddressBuckets {
  std::atomic<TokenBucket> chunks{}, bytes{}, requests{};
};
using AddressBucketsPtr = std::shared_ptr<AddressBuckets>;

class SessionRates {
 public:
  using Time = TokenBucket::Time;

  /// Without `address` no address is limited. `limits` and `metrics` outlive it.
  SessionRates(const RateLimits& limits, AddressBucketsPtr address, Metrics& metrics);

  struct Refusal {
    RateKind kind{};
    std::chrono::nanoseconds wait{};  // until there is room for one
    bool flooding = false;  // refused as often as a rested session may ask at once, and still asking
  };
  /// One request more; none where it may be worked on.
  [[nodiscard]] std::optional<Refusal> refuse_request(Time now);

  /// When the next chunk may go; `now` at once.
  [[nodiscard]] Time chunks_due(Time now);

  /// What may go now.
  [[nodiscard]] ChunkAllowance allowance(Time now) const;
  void sent(Time now, std::size_t chunks, std::size_t bytes);

 private:
  const RateLimits& limits_;
  AddressBucketsPtr address_;
  Metrics& metrics_;
  TokenBucket chunks_, bytes_, requests_, refusals_;
  bool held_ = false;  // noted in metrics_ once, when it begins
};

}  // namespace talus::server
