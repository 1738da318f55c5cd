// The log of a cluster as a stream of NATS JetStream.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "cluster/jetstream/connection.h"
#include "cluster/jetstream/credentials.h"
#include "cluster/jetstream/inbox.h"
#include "cluster/jetstream/leader_scout.h"
#include "cluster/jetstream/stored_message.h"
#include "cluster/jetstream/stream_names.h"
#include "cluster/log_stream.h"
#include "config/server_urls.h"
#include "runtime/log/logger.h"

namespace talus::server::jetstream {

/// Reads without a consumer: what NATS republishes to the tail subject, and single messages by number where
/// the tail has a gap or is silent. Those are asked of the leader, not of any replica (Direct Get): one that
/// lags has not all of them, and of nats-server 2.9.10 some were seen to hold others. What the stream has in
/// all the leader says, too, which is asked each second. Where no leader answers for a second, as while one
/// is elected, any replica is asked; state() fails then until the leader has confirmed what it gave.
///
/// Whoever may publish to the tail subject can make a server apply what is no message of the log; NATS'
/// subject permissions have to forbid it to all. Where it happens nevertheless, the true message follows with
/// the same number: next() then fails with `false_message`. What can be no message, as it is damaged, does no
/// harm: ask_again() reads it from the leader.
class JetStreamLog final : public LogStream {
 public:
  struct Settings {
    ServerUrls urls;
    StreamNames names;
    /// That the stream is to have. state() then fails with `refused` where it has other settings when it is
    /// seen first: a person may change them later. 0: whatever it has is right.
    std::uint64_t replicas = 0;
  };

  /// Succeeds whether or not a NATS server answers; an error is wrong credentials on this side.
  [[nodiscard]] static tl::expected<std::unique_ptr<JetStreamLog>, StreamFailure> open(
      Settings settings, std::shared_ptr<const Credentials> credentials, Logger log);
  ~JetStreamLog() override;

  [[nodiscard]] tl::expected<std::uint64_t, StreamFailure> publish(
      std::span<const std::byte> message) override;
  /// Without a connection it fails with `unavailable` at `until`.
  [[nodiscard]] tl::expected<std::optional<StreamMessage>, StreamFailure> next(std::uint64_t after,
                                                                               TimePoint until) override;
  void ask_again() override { inbox_->ask_again(); }
  /// Fails too where the leader says nothing of messages that were asked for, as without the permission for
  /// that: the tail alone is no promise; and until the leader has confirmed what replicas gave.
  [[nodiscard]] tl::expected<StreamState, StreamFailure> state() override;
  [[nodiscard]] tl::expected<std::int64_t, StreamFailure> time_of(std::uint64_t sequence) override;
  [[nodiscard]] StreamFigures figures() const override;
  void wake() override;
  void stop() override;

 private:
  JetStreamLog(Settings settings, std::shared_ptr<const Credentials> credentials, Logger log);
  [[nodiscard]] tl::expected<std::shared_ptr<Connection>, StreamFailure> connect();
  /// The connection there is, with the subscriptions that NATS had refused and allows again. One that was
  /// closed for good is made anew, each second at most.
  [[nodiscard]] tl::expected<std::shared_ptr<Connection>, StreamFailure> connection();
  [[nodiscard]] tl::expected<StreamState, StreamFailure> ask_leader();
  /// With why there are no answers, where it is that.
  [[nodiscard]] StreamFailure explained(StreamFailure failure) const;
  /// Asks the leader for a message; nothing where it has none of the number.
  [[nodiscard]] tl::expected<std::optional<StoredMessage>, StreamFailure> ask_for(std::uint64_t sequence);

  /// It does not answer. Where that stays so, though a NATS server is connected, another server is looked
  /// for by which it does, or the same by another connection; and replicas are read.
  void look_for_leader();

  Settings settings_;
  std::shared_ptr<const Credentials> credentials_;
  Logger log_;
  std::shared_ptr<Inbox> inbox_;
  std::atomic<bool> has_settings_{false};  // as it should
  std::mutex connection_mutex_;
  std::shared_ptr<Connection> connection_;
  TimePoint connected_at_{};  // when it was made
  std::optional<TimePoint> silent_since_{};
  ServerUrls first_;  // to be connected
  std::mutex scouting_;
  LeaderScout scout_;
};

}  // namespace talus::server::jetstream
