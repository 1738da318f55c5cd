#include "rates/rates.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace talus::server {
namespace {

using std::chrono::nanoseconds;
using Time = SessionRates::Time;

// Of the control lane. A burst may be smaller than the Welcome alone.
constexpr std::int64_t kFewFrames = 8192;

template <typename Change>
auto change(std::atomic<TokenBucket>& shared, Change&& how) {
  TokenBucket before = shared.load(std::memory_order_relaxed);
  for (;;) {
    TokenBucket after = before;
    const auto result = how(after);
    if (shared.compare_exchange_weak(before, after, std::memory_order_relaxed)) return result;
  }
}

Rate rate_of(std::uint64_t per_second, std::chrono::milliseconds burst) {
  return {per_second,
          std::max<std::uint64_t>(1, per_second * static_cast<std::uint64_t>(burst.count()) / 1000)};
}

std::size_t room(const TokenBucket& bucket, const Rate& rate, Time now) {
  if (!rate.limited()) return std::numeric_limits<std::size_t>::max();
  return static_cast<std::size_t>(std::max<std::int64_t>(0, bucket.level(rate, now)));
}

}  // namespace

RateLimits rate_limits(const Rates& config) {
  const auto rate = [&](std::uint64_t per_second) { return rate_of(per_second, config.burst); };
  return {{rate(config.session_chunks), rate(config.session_bytes), rate(config.session_requests)},
          {rate(config.address_chunks), rate(config.address_bytes), rate(config.address_requests)}};
}

SessionRates::SessionRates(const RateLimits& limits, AddressBucketsPtr address, Metrics& metrics)
    : limits_{limits}, address_{std::move(address)}, metrics_{metrics} {}

std::optional<SessionRates::Refusal> SessionRates::refuse_request(Time now) {
  const auto refuse = [&](RateKind kind, nanoseconds wait) {
    metrics_.throttled(kind).add();
    const Rate& rate =
        limits_.session.requests.limited() ? limits_.session.requests : limits_.address.requests;
    return Refusal{kind, wait, !refusals_.take(rate, now)};
  };
  const auto& [session, address] = limits_;
  // Who took answers far beyond its bytes, all in the control lane, which no rate holds, asks no more.
  if (session.bytes.limited()) {
    const std::int64_t debt = -bytes_.level(session.bytes, now);
    if (debt > std::max(static_cast<std::int64_t>(session.bytes.burst), kFewFrames)) {
      return refuse(RateKind::session_bytes, bytes_.wait(session.bytes, now));
    }
  }
  if (!requests_.take(session.requests, now)) {
    return refuse(RateKind::session_requests, requests_.wait(session.requests, now));
  }
  if (address_ == nullptr || !address.requests.limited()) return std::nullopt;
  if (change(address_->requests, [&](TokenBucket& all) { return all.take(address.requests, now); })) {
    return std::nullopt;
  }
  return refuse(RateKind::address_requests,
                address_->requests.load(std::memory_order_relaxed).wait(address.requests, now));
}

Time SessionRates::chunks_due(Time now) {
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
  const bool held = longest > nanoseconds{};
  if (held && !held_) metrics_.throttled(kind).add();
  held_ = held;
  return now + longest;
}

ChunkAllowance SessionRates::allowance(Time now) const {
  const ChunkAllowance own{room(chunks_, limits_.session.chunks, now),
                           room(bytes_, limits_.session.bytes, now)};
  if (address_ == nullptr) return own;
  const auto shared = [&](const std::atomic<TokenBucket>& bucket, const Rate& rate) {
    return room(bucket.load(std::memory_order_relaxed), rate, now);
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
    change(shared, [&](TokenBucket& all) {
      all.spend(rate, now, tokens);
      return true;
    });
  };
  spend(address_->chunks, limits_.address.chunks, chunks);
  spend(address_->bytes, limits_.address.bytes, bytes);
}

}  // namespace talus::server
