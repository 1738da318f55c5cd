// What NATS sends to one log of a cluster: messages, answers, and what becomes of the connection.
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
#include "cluster/jetstream/reading.h"
#include "cluster/jetstream/refused_subscription.h"
#include "cluster/jetstream/stored_message.h"
#include "cluster/jetstream/stream_info.h"
#include "cluster/jetstream/stream_names.h"
#include "cluster/log_stream.h"
#include "runtime/log/logger.h"

namespace talus::server::jetstream {

[[nodiscard]] inline tl::unexpected<StreamFailure> stream_failure(StreamFailure::Kind kind,
                                                                  std::string reason) {
  return tl::unexpected{StreamFailure{kind, std::move(reason)}};
}

/// Shared by libnats' threads, the log's reader and those who ask; each call says whose it is.
class Inbox final : public ConnectionEvents, public std::enable_shared_from_this<Inbox> {
 public:
  using TimePoint = LogStream::TimePoint;
  /// The connection there is, or another in place of one that was closed for good.
  using Connect = std::function<tl::expected<std::shared_ptr<Connection>, StreamFailure>()>;

  Inbox(StreamNames names, Logger log);

  /// Has all come here that the connection brings. Of who makes it.
  [[nodiscard]] tl::expected<void, StreamFailure> listen(Connection& connection);
  /// Subscribes again to what NATS has refused, now and then. Whether the connection is to be made anew: then
  /// answers are allowed again, which come to several subscriptions, of libnats too. Of who made it.
  [[nodiscard]] bool renew(Connection& connection);

  // Of the connection.
  void connected(bool now) override;
  void closed(const StreamFailure& why) override;
  void denied(std::string_view what) override;

  // Any thread.
  /// The connection is closed next, to make it anew; the log says why.
  void leaves(std::string_view why);
  /// Why NATS gives this server no answers; empty: it does.
  [[nodiscard]] std::string without_answers() const;
  /// A message was asked for, or one is about to be.
  void asks();
  /// The leader gave a message, or said that it has none of the number.
  void answers();
  /// Whether a message was asked for, and nothing was said of any since then for as long as answers take.
  [[nodiscard]] bool is_unanswered() const;
  /// Whether a leader answers by this connection. While none does, messages are asked of any replica.
  void leader_answers(bool does);
  /// Replicas gave messages that the leader has not confirmed.
  [[nodiscard]] bool awaits_confirmation() const;
  /// As a failure, where the leader's last message is `last`. Asks for those that are not asked for, whether
  /// or not somebody reads. Where it stays so that the leader has less than replicas gave, for good.
  [[nodiscard]] std::optional<StreamFailure> unconfirmed(const Connect& connect, std::uint64_t last);
  /// What the leader says; `after`: how far the stream had been read when it was asked.
  tl::expected<void, StreamFailure> told(std::uint64_t after, const StreamState& state);
  /// Why nothing may be read or published any more.
  [[nodiscard]] std::optional<StreamFailure> fault() const;
  /// It is not the stream that was read.
  StreamFailure failed_for_good(std::string reason);
  void learned(std::uint64_t sequence);
  [[nodiscard]] std::uint64_t after() const;
  /// The stream that was read, as far as a leader has said or confirmed it.
  [[nodiscard]] LeaderScout::Wanted wanted_stream() const;
  [[nodiscard]] std::optional<StreamFailure> why_closed() const;
  void reopened();
  void wake();
  void stop();
  [[nodiscard]] bool stopped() const;
  [[nodiscard]] StreamFigures figures() const;

  /// LogStream's. Of the reader.
  void ask_again();
  tl::expected<std::optional<StreamMessage>, StreamFailure> next(const Connect& connect, std::uint64_t after,
                                                                 TimePoint until);

 private:
  void tail(const Arrived& arrived);
  /// The leader's answer to a question for one.
  void message(const Arrived& arrived);
  /// A replica's.
  void message_of_replica(const Arrived& arrived);
  void look_for_forged();
  [[nodiscard]] bool asks_replicas(TimePoint now) const;
  void info(std::uint64_t after, std::string_view text);
  void count_false();
  /// Which it says is refused; null: none.
  [[nodiscard]] RefusedSubscription* subscription_of(std::string_view denial);
  tl::expected<void, StreamFailure> judge(const StreamState& state, std::uint64_t after);
  [[nodiscard]] std::optional<StreamFailure> check_kept() const;
  [[nodiscard]] bool waits_for_answers() const { return created_ns_ == 0 || reading_.asks(); }
  /// Takes what waits there.
  void read_tail(std::unique_lock<std::mutex>& lock);
  /// Until something comes, or `until`. The reader takes the tail itself: a thread in between would be one
  /// more to wake for each message. All else comes by other threads: answers, where there are any on their
  /// way, are waited for, and the rest can wait a little.
  void wait(std::unique_lock<std::mutex>& lock, TimePoint until);
  /// Sends the questions that are due; whether there were any.
  bool ask(const Connect& connect, std::unique_lock<std::mutex>& lock, TimePoint now);

  const StreamNames names_;
  const Logger log_;
  const std::string reply_;  // subject of answers, without what each is to
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Reading reading_;
  std::shared_ptr<Connection::Source> tail_;
  std::shared_ptr<Connection::Source> probe_;  // whether answers are allowed
  RefusedSubscription refused_tail_;
  RefusedSubscription refused_answers_;
  bool connected_ = false;
  bool woken_ = false;
  bool stopped_ = false;
  bool leaves_ = false;
  bool led_ = true;
  std::optional<TimePoint> replicas_denied_at_;
  std::optional<TimePoint> lacks_since_;
  std::optional<StreamFailure> closed_;   // the connection, for good
  std::optional<StreamFailure> trouble_;  // told once
  std::optional<StreamFailure> fault_;    // told from now on
  std::string denial_told_;               // in the log
  TimePoint denial_told_at_{};
  std::int64_t created_ns_ = 0;  // of the stream that was seen first
  std::uint64_t first_ = 0;
  TimePoint question_due_{};
  TimePoint asked_at_{};
  std::optional<TimePoint> unanswered_since_;  // of questions for messages
  std::uint64_t false_messages_ = 0;
};

}  // namespace talus::server::jetstream
