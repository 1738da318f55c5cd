// A cluster's log as a NATS JetStream stream.
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

/// Reads without a consumer: messages that NATS republishes to the tail subject, and single messages by
/// number if the tail has a gap or is silent. The latter are requested from the leader, not from any replica
/// (Direct Get): a lagging replica lacks some, and with nats-server 2.9.10 some were seen to hold others. The
/// leader also reports the stream's extent, every second. If no leader answers for a second, as during an
/// election, any replica is asked; state() then fails until the leader has confirmed what it returned.
///
/// A client that may publish to the tail subject can make a server apply forged messages; NATS' permissions
/// must forbid that to all. If it happens, the true message follows with the same number, and next() fails
/// with `false_message`. Damaged bytes are harmless: ask_again() reads the message from the leader.
class JetStreamLog final : public LogStream {
 public:
  struct Settings {
    ServerUrls urls;
    StreamNames names;
    /// Expected replicas. state() fails with `refused` if the stream has other settings when first seen;
    /// later ones are only logged. 0: accepts any settings.
    std::uint64_t replicas = 0;
  };

  /// Succeeds even if no NATS server answers; an error is wrong credentials on this side.
  [[nodiscard]] static tl::expected<std::unique_ptr<JetStreamLog>, StreamFailure> open(
      Settings settings, std::shared_ptr<const Credentials> credentials, Logger log);
  ~JetStreamLog() override;

  [[nodiscard]] tl::expected<std::uint64_t, StreamFailure> publish(
      std::span<const std::byte> message) override;
  /// Without a connection fails with `unavailable` at `until`.
  [[nodiscard]] tl::expected<std::optional<StreamMessage>, StreamFailure> next(std::uint64_t after,
                                                                               TimePoint until) override;
  void ask_again() override { inbox_->ask_again(); }
  /// Also fails if the leader does not answer requests for messages, such as without permission, because the
  /// tail alone guarantees nothing; and until the leader has confirmed what replicas returned.
  [[nodiscard]] tl::expected<StreamState, StreamFailure> state() override;
  [[nodiscard]] tl::expected<std::int64_t, StreamFailure> time_of(std::uint64_t sequence) override;
  [[nodiscard]] StreamFigures figures() const override;
  void wake() override;
  void stop() override;

 private:
  JetStreamLog(Settings settings, std::shared_ptr<const Credentials> credentials, Logger log);
  [[nodiscard]] tl::expected<std::shared_ptr<Connection>, StreamFailure> connect();
  /// Returns the connection, with rejected subscriptions restored once NATS allows them. Recreates a
  /// permanently closed one, at most once per second.
  [[nodiscard]] tl::expected<std::shared_ptr<Connection>, StreamFailure> connection();
  [[nodiscard]] tl::expected<StreamState, StreamFailure> ask_leader();
  /// Adds the reason for missing answers, if known.
  [[nodiscard]] StreamFailure explained(StreamFailure failure) const;
  /// Requests a message from the leader; nullopt if the leader lacks it.
  [[nodiscard]] tl::expected<std::optional<StoredMessage>, StreamFailure> ask_for(std::uint64_t sequence);

  /// Handles a leader that does not answer: if that persists although a NATS server is connected, looks for
  /// another server or connection on which it does, and reads from replicas.
  void find_leader();
  /// Logs what differs from the expected settings, once.
  void tell_settings(std::string other);
  /// If the next message stays away though the stream goes on behind it: passes over its number if no message
  /// had it, else says that it is lost.
  void look_for_gap(const StreamState& stream);

  Settings settings_;
  std::shared_ptr<const Credentials> credentials_;
  Logger log_;
  std::shared_ptr<Inbox> inbox_;
  std::atomic<bool> has_settings_{false};  // the stream has the expected settings
  std::mutex connection_mutex_;
  std::shared_ptr<Connection> connection_;
  TimePoint connected_at_{};  // when it was created
  std::optional<TimePoint> silent_since_{};
  ServerUrls first_;  // server to try first
  std::mutex scouting_;
  LeaderScout scout_;
  struct Missing {
    std::uint64_t sequence = 0;
    TimePoint since{};
    bool is_told = false;
  };
  std::mutex telling_;
  std::string other_settings_;  // as logged last
  std::mutex looking_;
  Missing missing_;
};

}  // namespace talus::server::jetstream
