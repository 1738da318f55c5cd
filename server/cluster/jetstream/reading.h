// Which messages of a stream have come, and which are to be asked for. Pure: bytes and times in, requests
// out.
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

/// Messages come by themselves (the tail), in order but with gaps, and as answers to requests, of the
/// stream's leader. Answers are the stream's own; of the tail it is only believed that others may not publish
/// to it, so a message of it that does not fit another is held against an answer. How far the stream goes the
/// leader says: a number ahead of the next one that the tail brings is a claim, for which the next message is
/// asked for, ever more seldom while there is none, and twice as many as were there while they are: a leader
/// that was just elected may give messages before it says how many it has.
///
/// Where no leader answers any replica is asked. A sound one has nothing that is not the stream's, though it
/// may lack some; of nats-server 2.9.10 some were seen to hold others. So they are believed until a leader
/// answers: nothing more is given out then before it has given each of those messages, too.
class Reading {
 public:
  using TimePoint = LogStream::TimePoint;

  static constexpr std::size_t kMostRequests = 64;
  static constexpr std::uint64_t kWindow = 1024;                  // messages ahead that are kept
  static constexpr std::size_t kWindowBytes = 16U << 20;          // of them all
  static constexpr std::chrono::milliseconds kSilence{1000};      // after it the next message is asked for
  static constexpr std::chrono::milliseconds kSilenceUnled{250};  // the same without a leader
  static constexpr std::size_t kMostUnconfirmed = 65'536;         // messages: 4 MiB
  static constexpr std::chrono::milliseconds kAnswerIn{500};      // after it a request is made again
  static constexpr std::chrono::milliseconds kOnItsWay{10};       // the tail may bring it
  static constexpr std::chrono::milliseconds kFirstRetry{5};      // it may be an old leader that answers
  static constexpr std::chrono::milliseconds kLastRetry{250};
  static constexpr std::chrono::milliseconds kSureOfNone{
      40};  // so long a retry, after some that found nothing
  /// So long after a question that found nothing another is asked, where the tail has another message for the
  /// number in dispute: the stream may have it now.
  static constexpr std::chrono::milliseconds kDisputed{20};

  /// `seed`: unknown to others, who could else make two messages of one digest.
  Reading(TimePoint now, std::uint64_t seed) : news_{now}, seed_{seed} {}

  /// The next message is that after `after`.
  void move_to(std::uint64_t after, TimePoint now);
  [[nodiscard]] std::uint64_t after() const { return after_; }

  /// From the tail. What does not fit into the window is dropped, and asked for later.
  void heard(std::uint64_t sequence, std::span<const std::byte> bytes, TimePoint now);
  /// To a request; `time_ms` is that of the message.
  void answered(std::uint64_t sequence, std::span<const std::byte> bytes, TimePoint now,
                std::optional<std::int64_t> time_ms = {});
  /// To a request, while no leader answers.
  void answered_by_replica(std::uint64_t sequence, std::span<const std::byte> bytes, TimePoint now,
                           std::optional<std::int64_t> time_ms = {});
  /// The leader has it not, or not yet: one that was deposed says so too.
  void not_found(std::uint64_t sequence, TimePoint now);
  /// The leader says that the stream has all up to `sequence`. Whether that is news.
  bool learned(std::uint64_t sequence, TimePoint now);
  /// The leader says that it has none above `last`: of one that was asked for in vain then nobody knows.
  void ends_at(std::uint64_t last);
  /// It says that it keeps none before `first`: nobody can tell any more which of two of those is the
  /// stream's.
  void starts_at(std::uint64_t first);

  /// The next message, if it came.
  [[nodiscard]] std::optional<StreamMessage> take();

  /// What take() gave out last is no message: what comes by the tail for that place is not believed, and
  /// take() gives it again once the leader has answered. Nothing where the leader gave it.
  void ask_again(TimePoint now);

  /// Sequences to ask for now; they count as asked for.
  [[nodiscard]] std::vector<std::uint64_t> wanted(TimePoint now);
  /// Whether an answer is on its way, as far as is known.
  [[nodiscard]] bool asks() const {
    return asked_.upper_bound(after_) != asked_.end() || (led_ && !unconfirmed_.empty() && !asked_.empty());
  }
  /// Whether the tail claims that there is more than the leader has said: it is to be asked how far the
  /// stream goes.
  [[nodiscard]] bool claims_more() const { return claimed_ > std::max(known_, after_); }
  /// When wanted() may have more.
  [[nodiscard]] TimePoint next_look() const;

  /// Whether a leader answers. Without one nobody says how far the stream goes, and it is asked for more
  /// often; with one what replicas gave and take() did not is not wanted any more.
  void leader_answers(bool does);
  /// The last message that a replica gave and take() gave out, of those that the leader has not confirmed.
  [[nodiscard]] std::optional<std::uint64_t> unconfirmed() const;
  /// Whether all that was given out after that one is such.
  [[nodiscard]] bool is_unconfirmed_after(std::uint64_t last) const;

  /// Whether a message that take() gave out is not the stream's.
  [[nodiscard]] std::optional<std::uint64_t> forged() const { return forged_; }
  /// Messages of the tail that were not the stream's, and did no harm.
  [[nodiscard]] std::uint64_t false_messages() const { return false_messages_; }
  /// How often the tail lacked messages that it had been heard to come after.
  [[nodiscard]] std::uint64_t gaps() const { return gaps_; }

 private:
  enum class From : std::uint8_t { tail, replica, leader };
  struct Held {
    std::vector<std::byte> bytes;
    From from = From::tail;
    std::optional<std::int64_t> time_ms{};
  };
  struct Digest {
    std::uint64_t low = 0;
    std::uint64_t high = 0;
    bool operator==(const Digest&) const = default;
  };
  struct Given {
    std::uint64_t sequence = 0;
    Digest digest;
    bool answered = false;
  };
  static constexpr std::size_t kRemembered = 1024;
  static constexpr std::size_t kMostDoubts = 64;

  [[nodiscard]] Digest digest(std::span<const std::byte> bytes) const;
  void hold(std::uint64_t sequence, std::span<const std::byte> bytes, From from,
            std::optional<std::int64_t> time_ms = {});
  /// Of a message that is held: whether the leader gave another. Where who gave another is not to be believed
  /// either, neither is kept.
  bool differs_from_leaders(std::uint64_t sequence, std::span<const std::byte> bytes);
  [[nodiscard]] std::chrono::milliseconds silence() const { return led_ ? kSilence : kSilenceUnled; }
  void drop(std::map<std::uint64_t, Held>::iterator at);
  void doubt(std::uint64_t sequence);
  void disputed();
  void progressed(TimePoint now);
  void claim_held();
  [[nodiscard]] bool asked_or_held(std::uint64_t sequence) const {
    return asked_.contains(sequence) || held_.contains(sequence);
  }
  [[nodiscard]] const Given* remembered(std::uint64_t sequence) const;

  std::uint64_t after_ = 0;
  std::uint64_t known_ = 0;    // the stream has this one, by its leader or as it was given out
  std::uint64_t claimed_ = 0;  // and this one, by the tail
  std::map<std::uint64_t, Held> held_;
  std::size_t held_bytes_ = 0;
  std::map<std::uint64_t, TimePoint> asked_;  // when the answer should be there
  std::set<std::uint64_t> doubted_;           // of which the tail had two
  TimePoint news_;
  TimePoint looked_{};
  TimePoint retry_{};
  TimePoint paused_{};  // when retry_ was set last
  std::chrono::milliseconds pause_ = kFirstRetry;
  // The same for what is only claimed. Progress by the tail says nothing of it.
  TimePoint claim_retry_{};
  std::chrono::milliseconds claim_pause_ = kFirstRetry;
  std::size_t claim_requests_ = 1;  // of what is only claimed, at once
  TimePoint ask_from_{};            // what is known to be there and was not heard
  /// What take() gave out last, by sequence.
  std::deque<Given> given_;
  std::optional<Given> altered_;  // not of the leader, and no message
  struct Unconfirmed {
    Digest digest;
    std::optional<std::int64_t> time_ms;
    bool operator==(const Unconfirmed&) const = default;
  };
  std::map<std::uint64_t, Unconfirmed> unconfirmed_;  // of replicas
  bool led_ = true;
  std::uint64_t seed_;
  std::optional<std::uint64_t> forged_;
  std::uint64_t false_messages_ = 0;
  std::uint64_t gaps_ = 0;
  std::uint64_t gap_up_to_ = 0;
};

}  // namespace talus::server::jetstream
