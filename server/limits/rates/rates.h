// The rates that throttle a session: its own, and its address's, which all sessions of the address share. No
// I/O. The caller passes the time.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "limits/rates/rate_kind.h"
#include "limits/rates/token_bucket.h"

namespace talus::server {

/// Tokens of an editor that is created: a rate of this many a second is one an hour.
inline constexpr std::uint64_t kEditorTokens = 3'600;

/// Tokens of a chunk that was never edited before: the same.
inline constexpr std::uint64_t kNewChunkTokens = 3'600;

/// The cost of an edit for the rates.
struct EditCost {
  std::uint64_t voxels = 0;      // voxels that it names
  std::uint64_t new_chunks = 0;  // chunks never edited before that it may write, reveal ore in, or guards
};

/// Requests, and voxels that edits name, count when they arrive; chunks and bytes (of all frames) count when
/// they are written.
struct RateSet {
  Rate chunks, bytes, requests;
  Rate voxels{};
  Rate editors{};     // an address's: kEditorTokens for each that is created
  Rate new_chunks{};  // an address's: kNewChunkTokens for each
  bool operator==(const RateSet&) const = default;
};
struct RateLimits {
  RateSet session, address;
  std::chrono::milliseconds burst{};  // time in which bursts are earned
  /// Replaces the rates of the session and of its address for a session that asks for many players.
  Rate gateway_requests{}, gateway_voxels{};
  bool is_gateway = false;  // true if `gateway` has replaced them
  bool operator==(const RateLimits&) const = default;

  [[nodiscard]] RateLimits of_gateway() const;
};

/// The rates with which sessions begin, and to which open sessions change. Callable from any thread.
class CurrentRates {
 public:
  CurrentRates() = default;
  explicit CurrentRates(const RateLimits& limits) : limits_{limits} {}

  [[nodiscard]] RateLimits get() const {
    const std::lock_guard lock{mutex_};
    return limits_;
  }
  void set(const RateLimits& limits) {
    const std::lock_guard lock{mutex_};
    limits_ = limits;
  }

 private:
  mutable std::mutex mutex_;
  RateLimits limits_;
};

/// Shared by the sessions of one address, on any thread, without a lock.
struct AddressBuckets {
  AddressBuckets() = default;
  explicit AddressBuckets(const RateSet& of) : rates{of} {}
  /// For new rates: with what is left in `before`. Sessions that still use `before` take nothing from these.
  AddressBuckets(const AddressBuckets& before, const RateSet& to, TokenBucket::Time now);

  /// Returns how long until what the address saves up over hours is all there: its editors and its new
  /// chunks.
  [[nodiscard]] std::chrono::nanoseconds saved_up_in(TokenBucket::Time now) const;

  const RateSet rates{};  // rates of the buckets
  std::atomic<TokenBucket> chunks{}, bytes{}, requests{}, voxels{}, editors{}, new_chunks{};
};
using AddressBucketsPtr = std::shared_ptr<AddressBuckets>;

/// A session's reservation of its address's rates; the rest of a batch is kept for the next.
struct RateBatch {
  std::size_t chunks = 0;
  std::size_t bytes = 0;
  TokenBucket::Time due{};
};

/// The rates of one session. For its thread.
class SessionRates {
 public:
  using Time = TokenBucket::Time;
  /// Voxels of the edits that a client may send before it learns that the first is refused.
  static constexpr std::uint64_t kEditsOnTheirWay = std::uint64_t{64} * 65'536;

  /// `address` null: the rates of an address do not apply. A client may have `requests_in_flight` on their
  /// way here.
  SessionRates(const RateLimits& limits, AddressBucketsPtr address, std::uint32_t requests_in_flight);

  /// Returns the rates that apply; without the rates of an address these have no limit.
  [[nodiscard]] RateLimits limits() const {
    return {limits_.session,        address_ == nullptr ? RateSet{} : limits_.address,
            limits_.burst,          limits_.gateway_requests,
            limits_.gateway_voxels, limits_.is_gateway};
  }

  /// Other rates apply from now on. The session's remaining tokens, or debt, stay; a batch that it has
  /// reserved of its address is lost.
  void change(const RateLimits& limits, AddressBucketsPtr address, Time now);
  /// A gateway's rates apply from now on, and their buckets are full.
  void become_gateway(Time now);

  /// Returns when a refused request has room, behind all that were refused before it. A client that waits
  /// until then, for each request or for the last, is never abusive, whatever was on its way when it was
  /// first refused; nor if others of its address took the room meanwhile.
  struct Refusal {
    RateKind kind{};
    std::chrono::nanoseconds wait{};
    bool abusive = false;  // it goes on asking and does not wait
  };
  /// Counts one request. nullopt: it is granted.
  [[nodiscard]] std::optional<Refusal> refuse_request(Time now);

  /// Counts an edit, of no more voxels than a burst. nullopt: it is granted. A client that goes on asking is
  /// abusive as with requests, but by voxels: it may have kEditsOnTheirWay on their way.
  [[nodiscard]] std::optional<Refusal> refuse_edit(Time now, const EditCost& cost);

  /// Counts an editor that is created for the session. nullopt: it is granted.
  [[nodiscard]] std::optional<Refusal> refuse_editor(Time now);

  /// Counts voxels that an edit changed in addition to the ones that it named. The next edits pay.
  void spend_voxels(Time now, std::uint64_t voxels);

  struct Due {
    Time at;                              // when the next chunk may go; `now`: at once
    std::optional<RateKind> throttled{};  // set if this call is the first that delays
  };
  /// For a session that has a chunk to send. Chunks that a rate holds go in batches: of the session's own
  /// rates, of what they earn in 10 ms. Of its address's rates the session reserves a batch, behind the
  /// batches that others have reserved, so that each session is woken for its own alone.
  [[nodiscard]] Due chunks_due(Time now);

  /// Returns how much of chunks may go now. The last chunk may pass `bytes`.
  struct Allowance {
    std::size_t chunks = SIZE_MAX;
    std::size_t bytes = SIZE_MAX;
  };
  [[nodiscard]] Allowance allowance(Time now) const;
  /// `bytes`: of all frames, chunks or not.
  void sent(Time now, std::size_t chunks, std::size_t bytes);
  /// The session ends and sends no more chunks: others of its address get what it has reserved.
  void give_back();

 private:
  /// Takes a token for a request, or returns the rate that is empty.
  [[nodiscard]] std::optional<RateKind> take_request(Time now);
  [[nodiscard]] Refusal refuse(RateKind kind, Time now);
  [[nodiscard]] Refusal refuse(RateKind kind, Time now, std::uint64_t voxels);
  [[nodiscard]] std::optional<Refusal> refuse_voxels(Time now, std::uint64_t voxels);
  /// Tokens of something that the address saves up over hours.
  [[nodiscard]] std::optional<Refusal> refuse_saved(RateKind kind, Time now, std::uint64_t tokens);
  /// All refused requests had room, so what comes now begins anew.
  void forget_refused(Time now);
  /// Returns how long until `in_line` requests have room by this rate.
  [[nodiscard]] std::chrono::nanoseconds wait(RateKind kind, std::uint64_t in_line, Time now) const;

  /// has_batch() is true if chunks may go from the address's buckets; batch_due() returns when the session's
  /// batch is due.
  [[nodiscard]] bool has_batch() const;
  [[nodiscard]] Due batch_due(Time now);

  RateLimits limits_;
  AddressBucketsPtr address_;
  TokenBucket chunks_, bytes_, requests_, voxels_;
  std::optional<RateBatch> batch_;

  // Since the client was first refused. It ends when it is refused again although it waited.
  Time room_at_{};                    // when all refused requests have room, as sent to the client
  std::uint64_t in_line_ = 0;         // refused, and not granted since
  std::uint64_t voxels_in_line_ = 0;  // refused, and not granted since
  TokenBucket patience_;              // one token goes with each refusal; empty: the client is abusive
  TokenBucket voxel_patience_;        // one goes with each refused voxel
  const std::uint32_t requests_in_flight_;
  Rate patience_rate_;
  Rate voxel_patience_rate_;

  bool throttled_ = false;
};

}  // namespace talus::server
