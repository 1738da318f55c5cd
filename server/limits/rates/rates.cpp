#include "limits/rates/rates.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace talus::server {
namespace {

using std::chrono::nanoseconds;
using Time = SessionRates::Time;

// Debt in control frames that is always tolerated: a burst may be smaller than Welcome alone.
constexpr std::int64_t kToleratedDebtBytes = 8192;

// Chunks that a rate holds go in batches of what it earns in this time, and of an address's rates at most
// this, so that the turns of many sessions come soon.
constexpr std::chrono::milliseconds kBatchTime{10};
constexpr std::size_t kBatchChunks = 16;
constexpr std::size_t kBatchBytes = std::size_t{32} * 1024;

std::uint64_t tokens_in(std::chrono::milliseconds time, const Rate& rate) {
  return std::max<std::uint64_t>(1, rate.per_second * static_cast<std::uint64_t>(time.count()) / 1000);
}

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

/// Returns a rate whose burst covers what is on its way when a client is first refused: as many requests as
/// it may have in flight, and a second's messages that have no answer. Clients that retry at the time they
/// were given follow each other at the rate by which they were refused.
Rate patience_for(const RateLimits& limits, std::uint32_t requests_in_flight) {
  const std::uint64_t fastest =
      std::max({limits.session.requests.per_second, limits.address.requests.per_second, std::uint64_t{1}});
  return {fastest, requests_in_flight + fastest};
}

Rate voxel_patience_for(const RateLimits& limits) {
  const std::uint64_t fastest =
      std::max({limits.session.voxels.per_second, limits.address.voxels.per_second, std::uint64_t{1}});
  return {fastest, SessionRates::kEditsOnTheirWay + fastest};
}

TokenBucket moved(const std::atomic<TokenBucket>& bucket, const Rate& from, const Rate& to, Time now) {
  return bucket.load(std::memory_order_relaxed).moved(from, to, now);
}

}  // namespace

RateLimits RateLimits::of_gateway() const {
  RateLimits own = *this;
  own.session.requests = gateway_requests;
  own.session.voxels = gateway_voxels;
  own.address.requests = {};
  own.address.voxels = {};
  own.address.editors = {};
  own.address.new_chunks = {};
  own.is_gateway = true;
  return own;
}

AddressBuckets::AddressBuckets(const AddressBuckets& before, const RateSet& to, Time now)
    : rates{to},
      chunks{moved(before.chunks, before.rates.chunks, to.chunks, now)},
      bytes{moved(before.bytes, before.rates.bytes, to.bytes, now)},
      requests{moved(before.requests, before.rates.requests, to.requests, now)},
      voxels{moved(before.voxels, before.rates.voxels, to.voxels, now)},
      editors{moved(before.editors, before.rates.editors, to.editors, now)},
      new_chunks{moved(before.new_chunks, before.rates.new_chunks, to.new_chunks, now)} {}

nanoseconds AddressBuckets::saved_up_in(Time now) const {
  const auto full_in = [&](const std::atomic<TokenBucket>& bucket, const Rate& rate) {
    return rate.limited() ? bucket.load(std::memory_order_relaxed).wait(rate, now, rate.burst)
                          : nanoseconds{};
  };
  return std::max(full_in(editors, rates.editors), full_in(new_chunks, rates.new_chunks));
}

SessionRates::SessionRates(const RateLimits& limits, AddressBucketsPtr address,
                           std::uint32_t requests_in_flight)
    : limits_{limits},
      address_{std::move(address)},
      requests_in_flight_{requests_in_flight},
      patience_rate_{patience_for(limits, requests_in_flight)},
      voxel_patience_rate_{voxel_patience_for(limits)} {}

void SessionRates::change(const RateLimits& limits, AddressBucketsPtr address, Time now) {
  if (limits == limits_ && address == address_) return;
  const RateSet& before = limits_.session;
  chunks_ = chunks_.moved(before.chunks, limits.session.chunks, now);
  bytes_ = bytes_.moved(before.bytes, limits.session.bytes, now);
  requests_ = requests_.moved(before.requests, limits.session.requests, now);
  voxels_ = voxels_.moved(before.voxels, limits.session.voxels, now);
  const Rate patience = patience_for(limits, requests_in_flight_);
  patience_ = patience_.moved(patience_rate_, patience, now);
  patience_rate_ = patience;
  const Rate voxel_patience = voxel_patience_for(limits);
  voxel_patience_ = voxel_patience_.moved(voxel_patience_rate_, voxel_patience, now);
  voxel_patience_rate_ = voxel_patience;
  batch_.reset();
  limits_ = limits;
  address_ = std::move(address);
}

void SessionRates::become_gateway(Time now) {
  change(limits().of_gateway(), address_, now);
  requests_ = voxels_ = {};
}

std::optional<SessionRates::Refusal> SessionRates::refuse_request(Time now) {
  if (const auto kind = take_request(now)) return refuse(*kind, now);
  if (in_line_ > 0) --in_line_;
  return std::nullopt;
}

std::optional<SessionRates::Refusal> SessionRates::refuse_edit(Time now, const EditCost& cost) {
  const std::uint64_t of_chunks = cost.new_chunks * kNewChunkTokens;
  if (of_chunks > 0) {
    if (auto refused = refuse_saved(RateKind::address_new_chunks, now, of_chunks)) return refused;
  }
  auto refused = refuse_voxels(now, cost.voxels);
  if (refused && of_chunks > 0 && address_ != nullptr && limits_.address.new_chunks.limited()) {
    update(address_->new_chunks, [&](TokenBucket& all) {
      all.give_back(of_chunks);
      return true;
    });
  }
  return refused;
}

std::optional<SessionRates::Refusal> SessionRates::refuse_voxels(Time now, std::uint64_t voxels) {
  const Rate& own = limits_.session.voxels;
  if (own.limited() && voxels_.level(own, now) < static_cast<std::int64_t>(voxels)) {
    return refuse(limits_.is_gateway ? RateKind::gateway_voxels : RateKind::session_voxels, now, voxels);
  }
  const Rate& shared = limits_.address.voxels;
  if (address_ != nullptr && shared.limited() &&
      !update(address_->voxels, [&](TokenBucket& all) { return all.take(shared, now, voxels); })) {
    return refuse(RateKind::address_voxels, now, voxels);
  }
  voxels_.spend(own, now, voxels);
  voxels_in_line_ -= std::min(voxels_in_line_, voxels);
  return std::nullopt;
}

std::optional<SessionRates::Refusal> SessionRates::refuse_editor(Time now) {
  return refuse_saved(RateKind::address_editors, now, kEditorTokens);
}

std::optional<SessionRates::Refusal> SessionRates::refuse_saved(RateKind kind, Time now,
                                                                std::uint64_t tokens) {
  const bool of_editors = kind == RateKind::address_editors;
  const Rate& shared = of_editors ? limits_.address.editors : limits_.address.new_chunks;
  if (address_ == nullptr || !shared.limited()) return std::nullopt;
  std::atomic<TokenBucket>& bucket = of_editors ? address_->editors : address_->new_chunks;
  if (update(bucket, [&](TokenBucket& all) { return all.take(shared, now, tokens); })) return std::nullopt;
  return Refusal{kind, bucket.load(std::memory_order_relaxed).wait(shared, now, tokens), false};
}

void SessionRates::spend_voxels(Time now, std::uint64_t voxels) {
  voxels_.spend(limits_.session.voxels, now, voxels);
  if (address_ == nullptr || !limits_.address.voxels.limited()) return;
  update(address_->voxels, [&](TokenBucket& all) {
    all.spend(limits_.address.voxels, now, voxels);
    return true;
  });
}

void SessionRates::forget_refused(Time now) {
  if (now < room_at_) return;
  in_line_ = 0;
  voxels_in_line_ = 0;
  patience_ = {};
  voxel_patience_ = {};
}

SessionRates::Refusal SessionRates::refuse(RateKind kind, Time now) {
  forget_refused(now);
  room_at_ = std::max(room_at_, now + wait(kind, ++in_line_, now));
  return {kind, room_at_ - now, !patience_.take(patience_rate_, now)};
}

SessionRates::Refusal SessionRates::refuse(RateKind kind, Time now, std::uint64_t voxels) {
  forget_refused(now);
  voxels_in_line_ += voxels;
  const nanoseconds wait = kind == RateKind::address_voxels
                               ? address_->voxels.load(std::memory_order_relaxed)
                                     .wait_in_line(limits_.address.voxels, now, voxels_in_line_)
                               : voxels_.wait_in_line(limits_.session.voxels, now, voxels_in_line_);
  room_at_ = std::max(room_at_, now + wait);
  return {kind, room_at_ - now, !voxel_patience_.take(voxel_patience_rate_, now, voxels)};
}

nanoseconds SessionRates::wait(RateKind kind, std::uint64_t in_line, Time now) const {
  if (kind == RateKind::session_bytes) return bytes_.wait(limits_.session.bytes, now);
  if (kind == RateKind::session_requests || kind == RateKind::gateway_requests) {
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
    return limits_.is_gateway ? RateKind::gateway_requests : RateKind::session_requests;
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
  const auto own_wait = [&](const TokenBucket& bucket, const Rate& rate) {
    return bucket.wait(rate, now, throttled_ ? tokens_in(kBatchTime, rate) : 1);
  };
  const nanoseconds chunks = own_wait(chunks_, limits_.session.chunks);
  const nanoseconds bytes = own_wait(bytes_, limits_.session.bytes);
  Due due{now + std::max(chunks, bytes),
          chunks >= bytes ? RateKind::session_chunks : RateKind::session_bytes};
  if (due.at == now && address_ != nullptr) due = batch_due(now);
  const bool before = std::exchange(throttled_, due.at > now);
  if (!throttled_ || before) due.throttled.reset();
  // The first wait is for a batch, too.
  if (throttled_ && !before) due.at = chunks_due(now).at;
  return due;
}

SessionRates::Due SessionRates::batch_due(Time now) {
  struct SharedBucket {
    std::atomic<TokenBucket>& bucket;
    const Rate& rate;
    std::size_t batch;
    std::size_t RateBatch::*part;
  };
  const SharedBucket chunks{address_->chunks, limits_.address.chunks, kBatchChunks, &RateBatch::chunks};
  const SharedBucket bytes{address_->bytes, limits_.address.bytes, kBatchBytes, &RateBatch::bytes};
  const auto kind_of = [&](nanoseconds of_chunks, nanoseconds of_bytes) {
    return of_chunks >= of_bytes ? RateKind::address_chunks : RateKind::address_bytes;
  };
  if (batch_ && batch_->due > now) return {batch_->due, RateKind::address_chunks};
  if (has_batch()) return {now, {}};
  const auto has = [&](const SharedBucket& shared, std::size_t tokens) {
    return available(shared.bucket.load(std::memory_order_relaxed), shared.rate, now) >= tokens;
  };
  // Batches end if more than two are there at once.
  const std::size_t batches = batch_ ? 2 : 0;
  if (has(chunks, std::max<std::size_t>(1, batches * kBatchChunks)) &&
      has(bytes, std::max<std::size_t>(1, batches * kBatchBytes))) {
    batch_.reset();
    return {now, {}};
  }
  if (!batch_) batch_.emplace();
  const auto reserve = [&](const SharedBucket& shared) {
    if (!shared.rate.limited()) return nanoseconds{};
    const std::size_t all = std::min<std::size_t>(shared.batch, tokens_in(kBatchTime, shared.rate));
    std::size_t& kept = (*batch_).*shared.part;
    const std::size_t more = all - std::min(all, kept);
    kept += more;
    return update(shared.bucket, [&](TokenBucket& bucket) {
      bucket.spend(shared.rate, now, more);
      return bucket.wait(shared.rate, now, 0);
    });
  };
  const nanoseconds of_chunks = reserve(chunks);
  const nanoseconds of_bytes = reserve(bytes);
  batch_->due = now + std::max(of_chunks, of_bytes);
  return {batch_->due, kind_of(of_chunks, of_bytes)};
}

bool SessionRates::has_batch() const {
  return batch_ && (!limits_.address.chunks.limited() || batch_->chunks > 0) &&
         (!limits_.address.bytes.limited() || batch_->bytes > 0);
}

SessionRates::Allowance SessionRates::allowance(Time now) const {
  const Allowance own{available(chunks_, limits_.session.chunks, now),
                      available(bytes_, limits_.session.bytes, now)};
  if (address_ == nullptr) return own;
  Allowance shared;
  if (batch_) {
    const bool due = batch_->due <= now;
    if (limits_.address.chunks.limited()) shared.chunks = due ? batch_->chunks : 0;
    if (limits_.address.bytes.limited()) shared.bytes = due ? batch_->bytes : 0;
  } else {
    shared.chunks = available(address_->chunks.load(std::memory_order_relaxed), limits_.address.chunks, now);
    shared.bytes = available(address_->bytes.load(std::memory_order_relaxed), limits_.address.bytes, now);
  }
  return {std::min(own.chunks, shared.chunks), std::min(own.bytes, shared.bytes)};
}

void SessionRates::sent(Time now, std::size_t chunks, std::size_t bytes) {
  chunks_.spend(limits_.session.chunks, now, chunks);
  bytes_.spend(limits_.session.bytes, now, bytes);
  if (address_ == nullptr) return;
  const auto spend = [&](std::atomic<TokenBucket>& shared, const Rate& rate, std::size_t tokens,
                         std::size_t RateBatch::*part) {
    if (!rate.limited() || tokens == 0) return;
    if (batch_ && chunks > 0) {
      std::size_t& has = (*batch_).*part;
      const std::size_t own = std::min(has, tokens);
      has -= own;
      tokens -= own;
    }
    if (tokens == 0) return;
    update(shared, [&](TokenBucket& all) {
      all.spend(rate, now, tokens);
      return true;
    });
  };
  spend(address_->chunks, limits_.address.chunks, chunks, &RateBatch::chunks);
  spend(address_->bytes, limits_.address.bytes, bytes, &RateBatch::bytes);
}

void SessionRates::give_back() {
  if (!batch_) return;
  const auto give = [](std::atomic<TokenBucket>& shared, std::size_t tokens) {
    if (tokens == 0) return;
    update(shared, [&](TokenBucket& bucket) {
      bucket.give_back(tokens);
      return true;
    });
  };
  give(address_->chunks, batch_->chunks);
  give(address_->bytes, batch_->bytes);
  batch_.reset();
}

}  // namespace talus::server
