// Receives everything that NATS sends to a cluster's log: messages, answers, and connection events.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <tl/expected.hpp>

#include "cluster/jetstream/connection.h"
#include "cluster/jetstream/leader_questions.h"
#include "cluster/jetstream/leader_scout.h"
#include "cluster/jetstream/message_reassembler.h"
#include "cluster/jetstream/refused_subscription.h"
#include "cluster/jetstream/stored_message.h"
#include "cluster/jetstream/stream_info.h"
#include "cluster/jetstream/stream_names.h"
#include "cluster/jetstream/told_reason.h"
#include "cluster/log_stream.h"
#include "runtime/log/logger.h"

namespace talus::server::jetstream {

[[nodiscard]] inline tl::unexpected<StreamFailure> stream_failure(StreamFailure::Kind kind,
                                                                  std::string reason) {
  return tl::unexpected{StreamFailure{kind, std::move(reason)}};
}

/// Shared by libnats' threads, the log's reader and requesting threads; comments name the caller's thread.
class Inbox final : public ConnectionEvents, public std::enable_shared_from_this<Inbox> {
 public:
  using TimePoint = LogStream::TimePoint;
  /// Returns the connection, replacing one that was closed permanently.
  using Connect = std::function<tl::expected<std::shared_ptr<Connection>, StreamFailure>()>;

  Inbox(StreamNames names, Logger log);

  /// Subscribes to everything that the connection receives. Called by the connection's creator.
  [[nodiscard]] tl::expected<void, StreamFailure> listen(Connection& connection);
  /// Retries rejected subscriptions periodically. True if the connection must be recreated: answers, which
  /// several subscriptions (some of libnats) receive, are allowed again. Called by the connection's creator.
  [[nodiscard]] bool renew(Connection& connection);

  // Called by the connection.
  void connected(bool now) override;
  void closed(const StreamFailure& why) override;
  void denied(std::string_view what) override;

  // Callable from any thread.
  /// Announces that the connection will be closed and recreated; logs why.
  void leaves(std::string_view why);
  /// Why NATS does not let this server receive answers; empty if it does.
  [[nodiscard]] std::string without_answers() const;
  /// A message is being requested.
  void asks();
  /// The leader returned a message, or reported that it lacks it.
  void answers();
  /// True if messages were requested, and none was answered within the usual time.
  [[nodiscard]] bool is_unanswered() const;
  /// Sets whether a leader answers on this connection. If not, messages are requested from any replica.
  void leader_answers(bool does);
  /// True if replicas returned messages that the leader has not confirmed.
  [[nodiscard]] bool awaits_confirmation() const;
  /// Returns a failure if messages are unconfirmed, given the leader's last message; requests missing ones
  /// even without a reader. Permanent if the leader keeps having fewer than replicas returned.
  [[nodiscard]] std::optional<StreamFailure> unconfirmed(const Connect& connect, std::uint64_t last);
  /// Processes the leader's state; `after` is the position read when it was requested.
  tl::expected<void, StreamFailure> told(std::uint64_t after, const StreamState& state);
  /// Permanent failure, after which nothing may be read or published.
  [[nodiscard]] std::optional<StreamFailure> fault() const;
  /// Records that the stream is not the one that was read before.
  StreamFailure failed_for_good(std::string reason);
  void learned(std::uint64_t sequence);
  /// The next message, if it has not arrived.
  [[nodiscard]] std::optional<std::uint64_t> missing() const;
  /// The leader has no messages for `count` numbers from `first` on: next() returns empty ones. Returns how
  /// many of them fit into the window.
  std::uint64_t pass_over(std::uint64_t first, std::uint64_t count);
  /// The leader lost the next message: next() fails once with this reason.
  void lost(std::string reason);
  [[nodiscard]] std::uint64_t after() const;
  /// The stream that was read, up to what a leader has reported or confirmed.
  [[nodiscard]] LeaderScout::Requirement wanted_stream() const;
  [[nodiscard]] std::optional<StreamFailure> why_closed() const;
  void reopened();
  void wake();
  void stop();
  [[nodiscard]] bool stopped() const;
  [[nodiscard]] StreamFigures figures() const;

  /// See LogStream. Called on the reader's thread.
  void ask_again();
  tl::expected<std::optional<StreamMessage>, StreamFailure> next(const Connect& connect, std::uint64_t after,
                                                                 TimePoint until);

 private:
  void tail(const ReceivedMessage& arrived);
  /// Processes the leader's answer to a request for a message.
  void message(const ReceivedMessage& arrived);
  /// Processes a replica's answer.
  void message_of_replica(const ReceivedMessage& arrived);
  void find_forged();
  [[nodiscard]] bool asks_replicas(TimePoint now) const;
  void info(std::uint64_t after, std::string_view text);
  void count_false();
  /// The subscription that the denial is about; null if it is about something else.
  [[nodiscard]] RefusedSubscription* subscription_of(std::string_view denial);
  tl::expected<void, StreamFailure> judge(const StreamState& state, std::uint64_t after);
  [[nodiscard]] std::optional<StreamFailure> check_kept() const;
  [[nodiscard]] bool waits_for_answers() const { return created_ns_ == 0 || reassembler_.asks(); }
  /// Reads the pending messages of the tail.
  void read_tail(std::unique_lock<std::mutex>& lock);
  /// Waits for input or `until`. The reader receives the tail itself, because another thread would add a
  /// wake-up per message. Other input arrives on other threads: if answers are pending, it waits for them;
  /// the rest may be noticed later.
  void wait(std::unique_lock<std::mutex>& lock, TimePoint until);
  /// Sends due requests; true if there were any.
  bool ask(const Connect& connect, std::unique_lock<std::mutex>& lock, TimePoint now);

  const StreamNames names_;
  const Logger log_;
  const std::string reply_;  // prefix of the subjects of answers
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  MessageReassembler reassembler_;
  std::shared_ptr<Connection::Source> tail_;
  std::shared_ptr<Connection::Source> probe_;  // tests if answers are allowed
  RefusedSubscription refused_tail_;
  RefusedSubscription refused_answers_;
  bool connected_ = false;
  bool woken_ = false;
  bool stopped_ = false;
  bool leaves_ = false;
  bool led_ = true;
  std::optional<TimePoint> replicas_denied_at_;
  std::optional<TimePoint> lacks_since_;
  std::optional<StreamFailure> closed_;   // the connection closed permanently
  std::optional<StreamFailure> trouble_;  // reported once
  std::optional<StreamFailure> fault_;    // reported from now on
  ToldReason denial_told_;
  ToldReason closing_told_;
  std::int64_t created_ns_ = 0;  // of the stream seen first
  std::uint64_t first_ = 0;
  TimePoint question_due_{};
  TimePoint asked_at_{};
  std::optional<TimePoint> unanswered_since_;  // requests for messages
  std::uint64_t false_messages_ = 0;
};

}  // namespace talus::server::jetstream
