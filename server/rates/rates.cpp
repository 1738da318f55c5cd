#include "rates/rates.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace talus::server {
namespace {

using std::chrono::nanoseconds;
using Time = SessionRates::Time;

// Debt in control frames that is always tolerated: a burst may be smaller than Welcome alone.
constexpr std::int64_t kToleratedDebtBytes = 8192;

/// Changes a shared bucket by change(bucket) and returns its result.
template <typename Change>
auto update(std::atomic<TokenBucket>& shared, Change&& change) {
  TokenBucket before = shared.load(std::memory_order_relaxed);
  for (;;) {
    TokenBucket after = before;
    const auto result = change(after);
    if (shared.compare_exchange_weak(before, after, std::memory_order_relaxed)) return result;
  }
}

std::size_t available(const TokenBucket& bucket, const Rate& rate, Time now) {
  if (!rate.limited()) return std::numeric_limits<std::size_t>::max();
  return static_cast<std::size_t>(std::max<std::int64_t>(0, bucket.level(rate, now)));
}

/// What is on its way when a client is first refused: as many requests as it may have in flight, and of
/// messages that have no answer as many as go in a second. And those who come when they were told to come
/// follow each other at the rate by which they were refused.
Rate patience_for(const RateLimits& limits, std::uint32_t requests_in_flight) {
  const std::uint64_t fastest =
      std::max({limits.session.requests.per_second, limits.address.requests.per_second, std::uint64_t{1}});
  return {fastest, requests_in_flight + fastest};
}

}  // namespace

SessionRates::SessionRates(const RateLimits& limits, AddressBucketsPtr address,
                           std::uint32_t requests_in_flight)
    : limits_{limits},
      address_{std::move(address)},
      patience_rate_{patience_for(limits, requests_in_flight)} {}

std::optional<SessionRates::Refusal> SessionRates::refuse_request(Time now) {
  if (const auto kind = take_request(now)) return refuse(*kind, now);
  if (in_line_ > 0) --in_line_;
  return std::nullopt;
}

SessionRates::Refusal SessionRates::refuse(RateKind kind, Time now) {
  if (now >= room_at_) {
    in_line_ = 0;
    patience_ = {};
  }
  ++in_line_;
  room_at_ = std::max(room_at_, now + wait(kind, in_line_, now));
  return {kind, room_at_ - now, !patience_.take(patience_rate_, now)};
}

nanoseconds SessionRates::wait(RateKind kind, std::uint64_t in_line, Time now) const {
  if (kind == RateKind::session_bytes) return bytes_.wait(limits_.session.bytes, now);
  if (kind == RateKind::session_requests) {
    return requests_.wait_in_line(limits_.session.requests, now, in_line);
  }
  return address_->requests.load(std::memory_order_relaxed)
      .wait_in_line(limits_.address.requests, now, in_line);
}

std::optional<RateKind> SessionRates::take_request(Time now) {
  const RateSet& session = limits_.session;
  // No rate delays control frames: the requests of a client whose control frames exceed its bytes by far are
  // refused.
  if (session.bytes.limited()) {
    const std::int64_t debt = -bytes_.level(session.bytes, now);
    if (debt > std::max(static_cast<std::int64_t>(session.bytes.burst), kToleratedDebtBytes)) {
      return RateKind::session_bytes;
    }
  }
  if (session.requests.limited() && requests_.level(session.requests, now) < 1) {
    return RateKind::session_requests;
  }
  const Rate& shared = limits_.address.requests;
  if (address_ != nullptr && shared.limited() &&
      !update(address_->requests, [&](TokenBucket& all) { return all.take(shared, now); })) {
    return RateKind::address_requests;
  }
  requests_.spend(session.requests, now, 1);
  return std::nullopt;
}

SessionRates::Due SessionRates::chunks_due(Time now) {
  nanoseconds longest{};
  RateKind kind{};
  const auto consider = [&](RateKind each, const TokenBucket& bucket, const Rate& rate) {
    const nanoseconds wait = bucket.wait(rate, now);
    if (wait <= longest) return;
    longest = wait;
    kind = each;
  };
  consider(RateKind::session_chunks, chunks_, limits_.session.chunks);
  consider(RateKind::session_bytes, bytes_, limits_.session.bytes);
  if (address_ != nullptr) {
    consider(RateKind::address_chunks, address_->chunks.load(std::memory_order_relaxed),
             limits_.address.chunks);
    consider(RateKind::address_bytes, address_->bytes.load(std::memory_order_relaxed), limits_.address.bytes);
  }
  Due due{now + longest};
  const bool before = std::exchange(throttled_, longest > nanoseconds{});
  if (throttled_ && !before) due.throttled = kind;
  return due;
}

SessionRates::Allowance SessionRates::allowance(Time now) const {
  const Allowance own{available(chunks_, limits_.session.chunks, now),
                      available(bytes_, limits_.session.bytes, now)};
  if (address_ == nullptr) return own;
  const auto shared = [&](const std::atomic<TokenBucket>& bucket, const Rate& rate) {
    return available(bucket.load(std::memory_order_relaxed), rate, now);
  };
  return {std::min(own.chunks, shared(address_->chunks, limits_.address.chunks)),
          std::min(own.bytes, shared(address_->bytes, limits_.address.bytes))};
}

void SessionRates::sent(Time now, std::size_t chunks, std::size_t bytes) {
  chunks_.spend(limits_.session.chunks, now, chunks);
  bytes_.spend(limits_.session.bytes, now, bytes);
  if (address_ == nullptr) return;
  const auto spend = [&](std::atomic<TokenBucket>& shared, const Rate& rate, std::size_t tokens) {
    if (!rate.limited() || tokens == 0) return;
    update(shared, [&](TokenBucket& all) {
      all.spend(rate, now, tokens);
      return true;
    });
  };
  spend(address_->chunks, limits_.address.chunks, chunks);
  spend(address_->bytes, limits_.address.bytes, bytes);
}

}  // namespace talus::server
