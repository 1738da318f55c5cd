// Tracks received and missing messages of a stream. Pure: takes bytes and times, returns requests.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "cluster/log_stream.h"

namespace talus::server::jetstream {

/// Messages are pushed (the tail), in order but with gaps, and returned by the leader on request. Answers are
/// authoritative. The tail relies on NATS' permissions to keep others from publishing to it, so a pushed
/// message that contradicts another is compared with an answer. Only the leader knows the stream's end: a
/// number pushed ahead of the next message is a claim, for which the next message is requested, ever more
/// rarely while it is missing, and twice as many at once while they exist, because a newly elected leader may
/// return messages before it reports their number.
///
/// If no leader answers, any replica is asked. A sound replica has only messages of the stream, though it may
/// lack some; with nats-server 2.9.10 some were seen to hold others. So they are believed until a leader
/// answers: then take() returns nothing until the leader has confirmed each of those messages.
class MessageReassembler {
 public:
  using TimePoint = LogStream::TimePoint;

  static constexpr std::size_t kMaxRequests = 64;
  static constexpr std::uint64_t kWindow = 1024;                  // messages kept ahead
  static constexpr std::size_t kWindowBytes = 16U << 20;          // total size of kept messages
  static constexpr std::chrono::milliseconds kSilence{1000};      // then the next message is requested
  static constexpr std::chrono::milliseconds kSilenceUnled{250};  // the same without a leader
  static constexpr std::size_t kMaxUnconfirmedMessages = 65'536;  // 4 MiB
  static constexpr std::chrono::milliseconds kAnswerIn{500};      // then a request is repeated
  static constexpr std::chrono::milliseconds kOnItsWay{10};       // the tail may still bring it
  static constexpr std::chrono::milliseconds kFirstRetry{5};      // a deposed leader may have answered
  static constexpr std::chrono::milliseconds kLastRetry{250};
  static constexpr std::chrono::milliseconds kSureOfNone{
      40};  // a retry pause this long implies several misses
  /// Pause after a request that found nothing, if the tail has a different message for the disputed number:
  /// the stream may have it by now.
  static constexpr std::chrono::milliseconds kDisputed{20};

  /// `seed` must be secret, so that others cannot construct two messages with equal digests.
  MessageReassembler(TimePoint now, std::uint64_t seed) : news_{now}, seed_{seed} {}

  /// Makes the message after `after` the next one.
  void move_to(std::uint64_t after, TimePoint now);
  [[nodiscard]] std::uint64_t after() const { return after_; }

  /// Adds a pushed message. Drops what exceeds the window; it is requested later.
  void heard(std::uint64_t sequence, std::span<const std::byte> bytes, TimePoint now);
  /// Adds the leader's answer; `time_ms` is the message's time.
  void answered(std::uint64_t sequence, std::span<const std::byte> bytes, TimePoint now,
                std::optional<std::int64_t> time_ms = {});
  /// Adds a replica's answer, while no leader answers.
  void answered_by_replica(std::uint64_t sequence, std::span<const std::byte> bytes, TimePoint now,
                           std::optional<std::int64_t> time_ms = {});
  /// The leader lacks the message, perhaps temporarily: a deposed leader reports that too.
  void not_found(std::uint64_t sequence, TimePoint now);
  /// The leader reports that the stream reaches `sequence`. True if that is news.
  bool learned(std::uint64_t sequence, TimePoint now);
  /// The leader reports that `last` is the end; requested messages above it remain unverifiable.
  void ends_at(std::uint64_t last);
  /// The leader reports that it keeps no message before `first`: disputes about older ones can no longer be
  /// resolved.
  void starts_at(std::uint64_t first);

  /// The next message, if the leader's stream reaches it and it has not arrived.
  [[nodiscard]] std::optional<std::uint64_t> missing() const {
    return known_ > after_ && !held_.contains(after_ + 1) ? std::optional{after_ + 1} : std::nullopt;
  }
  /// Returns the next message if it has arrived.
  [[nodiscard]] std::optional<StreamMessage> take();

  /// The last message from take() cannot be decoded: ignores the tail for its number, and take() returns it
  /// again once the leader has answered. Has no effect if the leader returned it.
  void ask_again(TimePoint now);

  /// Sequences to request now; they count as requested.
  [[nodiscard]] std::vector<std::uint64_t> wanted(TimePoint now);
  /// True if an answer is expected.
  [[nodiscard]] bool asks() const {
    return asked_.upper_bound(after_) != asked_.end() || (led_ && !unconfirmed_.empty() && !asked_.empty());
  }
  /// True if the tail claims more than the leader has reported: the leader must be asked for the end.
  [[nodiscard]] bool claims_more() const { return claimed_ > std::max(known_, after_); }
  /// Next time at which wanted() may return more.
  [[nodiscard]] TimePoint next_poll() const;

  /// Sets whether a leader answers. Without one the end is unknown, and messages are requested more often;
  /// with one, messages from replicas that take() did not return are dropped.
  void leader_answers(bool does);
  /// The last unconfirmed message of a replica that take() returned.
  [[nodiscard]] std::optional<std::uint64_t> unconfirmed() const;
  /// True if everything returned after `last` is unconfirmed.
  [[nodiscard]] bool is_unconfirmed_after(std::uint64_t last) const;

  /// A message returned by take() that is not the stream's.
  [[nodiscard]] std::optional<std::uint64_t> forged() const { return forged_; }
  /// Number of pushed messages that were not the stream's and did no harm.
  [[nodiscard]] std::uint64_t false_messages() const { return false_messages_; }
  /// Number of gaps in the tail.
  [[nodiscard]] std::uint64_t gaps() const { return gaps_; }

 private:
  enum class From : std::uint8_t { tail, replica, leader };
  struct HeldMessage {
    std::vector<std::byte> bytes;
    From from = From::tail;
    std::optional<std::int64_t> time_ms{};
  };
  struct Digest {
    std::uint64_t low = 0;
    std::uint64_t high = 0;
    bool operator==(const Digest&) const = default;
  };
  struct ReturnedMessage {
    std::uint64_t sequence = 0;
    Digest digest;
    bool answered = false;
  };
  static constexpr std::size_t kRemembered = 1024;
  static constexpr std::size_t kMaxDoubts = 64;

  [[nodiscard]] Digest digest(std::span<const std::byte> bytes) const;
  void hold(std::uint64_t sequence, std::span<const std::byte> bytes, From from,
            std::optional<std::int64_t> time_ms = {});
  /// True if the leader returned a different message than `bytes`, which is then false. If the held message
  /// is not the leader's either, neither is kept.
  bool differs_from_leaders(std::uint64_t sequence, std::span<const std::byte> bytes);
  [[nodiscard]] std::chrono::milliseconds silence() const { return led_ ? kSilence : kSilenceUnled; }
  void drop(std::map<std::uint64_t, HeldMessage>::iterator at);
  void doubt(std::uint64_t sequence);
  void disputed();
  void progressed(TimePoint now);
  void claim_held();
  [[nodiscard]] bool asked_or_held(std::uint64_t sequence) const {
    return asked_.contains(sequence) || held_.contains(sequence);
  }
  [[nodiscard]] const ReturnedMessage* remembered(std::uint64_t sequence) const;

  std::uint64_t after_ = 0;
  std::uint64_t known_ = 0;    // in the stream, as the leader reported or as take() returned
  std::uint64_t claimed_ = 0;  // in the stream, as the tail claims
  std::map<std::uint64_t, HeldMessage> held_;
  std::size_t held_bytes_ = 0;
  std::map<std::uint64_t, TimePoint> asked_;  // with the due times of the answers
  std::set<std::uint64_t> doubted_;           // the tail had two of them
  TimePoint news_;
  TimePoint polled_{};
  TimePoint retry_{};
  TimePoint paused_{};  // when retry_ was last set
  std::chrono::milliseconds pause_ = kFirstRetry;
  // The same for claimed messages; progress of the tail does not affect it.
  TimePoint claim_retry_{};
  std::chrono::milliseconds claim_pause_ = kFirstRetry;
  std::size_t claim_requests_ = 1;  // number of claimed messages to request at once
  TimePoint ask_from_{};            // for messages known to exist that were not pushed
  /// The last messages returned by take(), by sequence.
  std::deque<ReturnedMessage> given_;
  std::optional<ReturnedMessage> altered_;  // undecodable and not from the leader
  struct UnconfirmedMessage {
    Digest digest;
    std::optional<std::int64_t> time_ms;
    bool operator==(const UnconfirmedMessage&) const = default;
  };
  std::map<std::uint64_t, UnconfirmedMessage> unconfirmed_;  // from replicas
  bool led_ = true;
  std::uint64_t seed_;
  std::optional<std::uint64_t> forged_;
  std::uint64_t false_messages_ = 0;
  std::uint64_t gaps_ = 0;
  std::uint64_t gap_up_to_ = 0;
};

}  // namespace talus::server::jetstream
