// What throttles a session: its own rates, and those of its address, which all sessions of the address share.
// No I/O. The caller passes the time.
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

/// What an editor that is made costs: so many a second are one an hour.
inline constexpr std::uint64_t kEditorTokens = 3'600;

/// What a chunk costs that nobody edited before, likewise.
inline constexpr std::uint64_t kNewChunkTokens = 3'600;

/// What an edit takes of the rates.
struct EditCost {
  std::uint64_t voxels = 0;      // that it names
  std::uint64_t new_chunks = 0;  // that it may write or guards, and nobody edited before
};

/// Requests, and voxels that edits name, count when they arrive, chunks and bytes (of all frames) when they
/// are written.
struct RateSet {
  Rate chunks, bytes, requests;
  Rate voxels{};
  Rate editors{};     // of an address: kEditorTokens for each that is made
  Rate new_chunks{};  // of an address: kNewChunkTokens for each
  bool operator==(const RateSet&) const = default;
};
struct RateLimits {
  RateSet session, address;
  std::chrono::milliseconds burst{};  // what their bursts are earned in
  /// Of a session that asks for many players, in place of those of the session and of its address.
  Rate gateway_requests{}, gateway_voxels{};
  bool is_gateway = false;  // whether they took that place
  bool operator==(const RateLimits&) const = default;

  [[nodiscard]] RateLimits of_gateway() const;
};

/// Of which sessions begin, and to which those that are there change. Callable from any thread.
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
  /// For new rates: with what is left in `before`. Who still uses that takes nothing from these.
  AddressBuckets(const AddressBuckets& before, const RateSet& to, TokenBucket::Time now);

  /// How long until what it saves up over hours is all there: its editors and its new chunks.
  [[nodiscard]] std::chrono::nanoseconds saved_up_in(TokenBucket::Time now) const;

  const RateSet rates{};  // by which the buckets are used
  std::atomic<TokenBucket> chunks{}, bytes{}, requests{}, voxels{}, editors{}, new_chunks{};
};
using AddressBucketsPtr = std::shared_ptr<AddressBuckets>;

/// What a session has reserved of its address's rates; what a batch leaves is kept for the next.
struct RateBatch {
  std::size_t chunks = 0;
  std::size_t bytes = 0;
  TokenBucket::Time due{};
};

/// Of one session, and of its thread.
class SessionRates {
 public:
  using Time = TokenBucket::Time;
  /// Voxels of the edits that a client may send before it hears that the first is refused.
  static constexpr std::uint64_t kEditsOnTheirWay = std::uint64_t{64} * 65'536;

  /// `address` null: no rate of an address applies. A client may have `requests_in_flight` on their way here.
  SessionRates(const RateLimits& limits, AddressBucketsPtr address, std::uint32_t requests_in_flight);

  /// The rates that apply; those of the address without limit where none does.
  [[nodiscard]] RateLimits limits() const {
    return {limits_.session,        address_ == nullptr ? RateSet{} : limits_.address,
            limits_.burst,          limits_.gateway_requests,
            limits_.gateway_voxels, limits_.is_gateway};
  }

  /// Other rates apply from now on. What is left of the session's tokens, or owed, stays; a batch that it has
  /// reserved of its address is lost.
  void change(const RateLimits& limits, AddressBucketsPtr address, Time now);
  /// Those of a gateway apply from now on, and their buckets are full.
  void become_gateway(Time now);

  /// A refused request is told when it has room, behind all that were refused before it. A client that
  /// waits so long, for each request or for the last, is never abusive, whatever was on its way when it was
  /// first told; nor where others of its address took the room meanwhile.
  struct Refusal {
    RateKind kind{};
    std::chrono::nanoseconds wait{};
    bool abusive = false;  // it goes on asking, and does not wait
  };
  /// Counts one request. None: it is granted.
  [[nodiscard]] std::optional<Refusal> refuse_request(Time now);

  /// Counts an edit, of no more voxels than a burst. None: it is granted. A client that goes on asking is
  /// abusive as with requests, but by voxels: what it may have on its way is kEditsOnTheirWay.
  [[nodiscard]] std::optional<Refusal> refuse_edit(Time now, const EditCost& cost);

  /// Counts an editor that is made for the session. None: it is granted.
  [[nodiscard]] std::optional<Refusal> refuse_editor(Time now);

  /// Counts voxels that an edit changed beyond those that it named. The next ones pay.
  void spend_voxels(Time now, std::uint64_t voxels);

  struct Due {
    Time at;                              // when the next chunk may go; `now`: at once
    std::optional<RateKind> throttled{};  // where this call is the first to say "later"
  };
  /// For who has a chunk to send. Chunks that a rate holds go in batches: of the session's own rates of what
  /// they earn in 10 ms. Of those of its address the session reserves a batch, behind the batches that others
  /// have reserved, so that each session is woken for its own alone.
  [[nodiscard]] Due chunks_due(Time now);

  /// How much of chunks may go now. The last chunk may pass `bytes`.
  struct Allowance {
    std::size_t chunks = SIZE_MAX;
    std::size_t bytes = SIZE_MAX;
  };
  [[nodiscard]] Allowance allowance(Time now) const;
  /// `bytes` are those of all frames, chunks or not.
  void sent(Time now, std::size_t chunks, std::size_t bytes);
  /// The session ends and sends no more chunks: others of its address have what it has reserved.
  void give_back();

 private:
  /// Takes a token for a request, or says which rate has none.
  [[nodiscard]] std::optional<RateKind> take_request(Time now);
  [[nodiscard]] Refusal refuse(RateKind kind, Time now);
  [[nodiscard]] Refusal refuse(RateKind kind, Time now, std::uint64_t voxels);
  [[nodiscard]] std::optional<Refusal> refuse_voxels(Time now, std::uint64_t voxels);
  /// Tokens of something that the address saves up over hours.
  [[nodiscard]] std::optional<Refusal> refuse_saved(RateKind kind, Time now, std::uint64_t tokens);
  /// All that was refused had room, so what comes now begins anew.
  void forget_refused(Time now);
  /// Until `in_line` requests have room by this rate.
  [[nodiscard]] std::chrono::nanoseconds wait(RateKind kind, std::uint64_t in_line, Time now) const;

  /// Whether chunks may go from the address's buckets, or when the session's batch is due.
  [[nodiscard]] bool has_batch() const;
  [[nodiscard]] Due batch_due(Time now);

  RateLimits limits_;
  AddressBucketsPtr address_;
  TokenBucket chunks_, bytes_, requests_, voxels_;
  std::optional<RateBatch> batch_;

  // Since the client was first refused. It ends when it is refused again although it waited.
  Time room_at_{};                    // of all that was refused, as the client was told
  std::uint64_t in_line_ = 0;         // refused, and not granted since
  std::uint64_t voxels_in_line_ = 0;  // likewise
  TokenBucket patience_;              // one token goes with each refusal; empty: the client is abusive
  TokenBucket voxel_patience_;        // the same for voxels, one with each
  const std::uint32_t requests_in_flight_;
  Rate patience_rate_;
  Rate voxel_patience_rate_;

  bool throttled_ = false;
};

}  // namespace talus::server
