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

}  // namespace

SessionRates::SessionRates(const RateLimits& limits, AddressBucketsPtr address)
    : limits_{limits}, address_{std::move(address)} {}

std::optional<SessionRates::Refusal> SessionRates::refuse_request(Time now) {
  const auto& [session, address] = limits_;
  const auto refuse = [&](RateKind kind, nanoseconds wait) {
    const Rate& rate = session.requests.limited() ? session.requests : address.requests;
    return Refusal{kind, wait, !refusals_.take(rate, now)};
  };
  // No rate delays control frames: the requests of a client whose control frames exceed its bytes by far are
  // refused.
  if (session.bytes.limited()) {
    const std::int64_t debt = -bytes_.level(session.bytes, now);
    if (debt > std::max(static_cast<std::int64_t>(session.bytes.burst), kToleratedDebtBytes)) {
      return refuse(RateKind::session_bytes, bytes_.wait(session.bytes, now));
    }
  }
  if (!requests_.take(session.requests, now)) {
    return refuse(RateKind::session_requests, requests_.wait(session.requests, now));
  }
  if (address_ == nullptr || !address.requests.limited()) return std::nullopt;
  if (update(address_->requests, [&](TokenBucket& all) { return all.take(address.requests, now); })) {
    return std::nullopt;
  }
  return refuse(RateKind::address_requests,
                address_->requests.load(std::memory_order_relaxed).wait(address.requests, now));
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
