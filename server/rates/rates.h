// What throttles a session: its own rates, and those of its address, which all sessions of the address share.
// No I/O. The caller passes the time.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "rates/rate_kind.h"
#include "rates/token_bucket.h"

namespace talus::server {

/// Requests count when they arrive, chunks and bytes (of all frames) when they are written.
struct RateSet {
  Rate chunks, bytes, requests;
};
struct RateLimits {
  RateSet session, address;
};

/// Shared by the sessions of one address, on any thread, without a lock.
struct AddressBuckets {
  std::atomic<TokenBucket> chunks{}, bytes{}, requests{};
};
using AddressBucketsPtr = std::shared_ptr<AddressBuckets>;

/// Of one session, and of its thread.
class SessionRates {
 public:
  using Time = TokenBucket::Time;

  /// `limits` outlives it. `address` null: no rate of an address applies.
  SessionRates(const RateLimits& limits, AddressBucketsPtr address);

  struct Refusal {
    RateKind kind{};
    std::chrono::nanoseconds wait{};  // until one request is granted
    bool abusive = false;             // refused a whole burst of requests, and still asking
  };
  /// Counts one request. None: it is granted.
  [[nodiscard]] std::optional<Refusal> refuse_request(Time now);

  struct Due {
    Time at;                              // when the next chunk may go; `now`: at once
    std::optional<RateKind> throttled{};  // where this call is the first to say "later"
  };
  [[nodiscard]] Due chunks_due(Time now);

  /// How much of chunks may go now. The last chunk may pass `bytes`.
  struct Allowance {
    std::size_t chunks = SIZE_MAX;
    std::size_t bytes = SIZE_MAX;
  };
  [[nodiscard]] Allowance allowance(Time now) const;
  /// `bytes` are those of all frames, chunks or not.
  void sent(Time now, std::size_t chunks, std::size_t bytes);

 private:
  const RateLimits& limits_;
  AddressBucketsPtr address_;
  TokenBucket chunks_, bytes_, requests_;
  TokenBucket refusals_;  // at the rate of requests; empty: the client is abusive
  bool throttled_ = false;
};

}  // namespace talus::server
