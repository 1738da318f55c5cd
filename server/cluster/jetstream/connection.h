// A connection to the NATS servers. libnats reconnects to any of them whenever it breaks.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "cluster/jetstream/credentials.h"
#include "cluster/jetstream/discarded_messages.h"
#include "cluster/jetstream/nats_handles.h"
#include "cluster/log_stream.h"
#include "config/server_urls.h"

namespace talus::server::jetstream {

/// libnats does not say why it cannot connect again.
inline constexpr const char* kNoConnection = "no connection to NATS; \"talusd cluster check\" says why";

/// A received message, valid during the handler's call.
class ReceivedMessage {
 public:
  explicit ReceivedMessage(natsMsg* message) : message_{message} {}

  [[nodiscard]] std::string_view subject() const { return natsMsg_GetSubject(message_); }
  [[nodiscard]] std::span<const std::byte> bytes() const;
  [[nodiscard]] std::string_view text() const;
  /// Empty if the header is missing.
  [[nodiscard]] std::string_view header(const char* name) const;
  /// Value of the header "Nats-Sequence"; 0 if missing.
  [[nodiscard]] std::uint64_t sequence() const;
  /// Status of a negative answer: 404, or 503 if there is not a responder; otherwise 0.
  [[nodiscard]] int status() const;

 private:
  natsMsg* message_;
};

/// Events of a connection. Called on libnats' threads, possibly even while the connection is being closed;
/// must not wait.
class ConnectionEvents {
 public:
  virtual ~ConnectionEvents() = default;
  virtual void connected(bool now) = 0;
  /// Permanent: libnats gives up after a server has rejected the credentials twice.
  virtual void closed(const StreamFailure& why) = 0;
  /// NATS denied something, such as: Permissions Violation for Publish to "x".
  virtual void denied(std::string_view what) = 0;
};

enum class Retry : std::uint8_t {
  forever,  // open() succeeds even if no server answers
  never,    // open() fails if no server answers; broken connections stay broken
};

/// All calls are thread-safe.
class Connection {
 public:
  /// Tries the server `first`, if any, then `urls` in any order. Waits at most half a second per server, or
  /// twice that if none answers and retries follow.
  [[nodiscard]] static tl::expected<std::shared_ptr<Connection>, StreamFailure> open(
      const ServerUrls& urls, std::shared_ptr<const Credentials> credentials,
      std::shared_ptr<ConnectionEvents> events, Retry retry, const ServerUrls& first = {});
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// True if a server is connected. Does not wait for libnats.
  [[nodiscard]] bool connected() const { return link_->connected.load(std::memory_order_relaxed); }
  /// Pending calls return, later ones fail.
  void close();

  using Handler = std::function<void(const ReceivedMessage&)>;
  /// Calls `handler` on a separate thread. Messages beyond the pending limits are dropped. Survives
  /// reconnects. If NATS rejects the subscription, nothing arrives, and the connection's events report why.
  [[nodiscard]] tl::expected<void, StreamFailure> subscribe(const std::string& subject, Handler handler,
                                                            int pending_messages, int pending_bytes);
  /// A subscription polled by its reader, on one thread at a time; messages queue meanwhile. May outlive the
  /// connection, and is empty then.
  class Source {
   public:
    enum class TakeResult : std::uint8_t { message, none, closed };

    explicit Source(NatsSubscription subscription) : subscription_{std::move(subscription)} {}
    /// Waits up to `patience` for a message and calls `handler` with it.
    [[nodiscard]] TakeResult take(std::chrono::milliseconds patience, const Handler& handler);

   private:
    NatsSubscription subscription_;
    DiscardedMessages discarded_;
  };
  /// Like subscribe().
  [[nodiscard]] tl::expected<std::shared_ptr<Source>, StreamFailure> open_source(const std::string& subject,
                                                                                 int pending_messages,
                                                                                 int pending_bytes);
  /// Sends without waiting; an answer, if any, arrives at `reply`.
  [[nodiscard]] tl::expected<void, StreamFailure> send(const std::string& subject, const std::string& reply,
                                                       std::string_view text);
  /// Sends, and waits for the answer.
  [[nodiscard]] tl::expected<NatsMessage, StreamFailure> request(const std::string& subject,
                                                                 std::string_view text,
                                                                 std::chrono::milliseconds patience);
  /// Publishes to a stream and waits for the acknowledgement, which is returned. Calls are serialized.
  struct Ack {
    std::string stream;
    std::uint64_t sequence = 0;
  };
  [[nodiscard]] tl::expected<Ack, StreamFailure> publish(const std::string& subject,
                                                         std::span<const std::byte> bytes,
                                                         std::chrono::milliseconds patience);
  /// Tests if publish() to the subject would be allowed, without changing the stream or its Raft log. A
  /// message that all replicas must reject, such as one with a wrong expected sequence, would enter that log:
  /// in nats-server 2.9.10 a replica that is killed and restarted then takes one message twice.
  [[nodiscard]] tl::expected<void, StreamFailure> try_publish(const std::string& subject,
                                                              std::chrono::milliseconds patience);
  /// Waits until the server has processed everything sent before.
  [[nodiscard]] tl::expected<void, StreamFailure> flush(std::chrono::milliseconds patience);
  /// Limit of the connected server.
  [[nodiscard]] std::int64_t max_payload() const;
  /// The last denied permission if it was denied after `since`; otherwise empty.
  [[nodiscard]] std::string denied_since(std::chrono::steady_clock::time_point since) const;
  /// Like denied_since(), but waits up to `patience`, because denials arrive late.
  [[nodiscard]] std::string await_denial(std::chrono::steady_clock::time_point since,
                                         std::chrono::milliseconds patience) const;

 private:
  /// State shared with libnats' threads; lives until they are done with it.
  struct Link {
    std::shared_ptr<const Credentials> credentials;
    std::shared_ptr<ConnectionEvents> events;
    natsStatus at_first = NATS_OK;  // result of the first attempt, before there are callbacks
    std::atomic<bool> connected{false};
    std::atomic<bool> was_connected{false};  // ever
    mutable std::mutex mutex;
    mutable std::condition_variable was_denied;
    std::string denied;
    std::chrono::steady_clock::time_point denied_at{};
  };
  struct Callbacks;
  struct CloseConnection {
    void operator()(natsConnection* connection) const { natsConnection_Destroy(connection); }
  };

  explicit Connection(std::shared_ptr<Link> link) : link_{std::move(link)} {}
  /// Subscribes to the acknowledgements for publish().
  [[nodiscard]] natsStatus await_acks();
  [[nodiscard]] static tl::expected<Ack, StreamFailure> ack_of(const ReceivedMessage& answer);
  [[nodiscard]] StreamFailure failure_of(natsStatus status, std::chrono::steady_clock::time_point since,
                                         std::string_view doing) const;

  std::shared_ptr<Link> link_;
  std::unique_ptr<natsConnection, CloseConnection> connection_;
  JetStreamContext context_;
  std::mutex mutex_;
  std::vector<NatsSubscription> subscriptions_;
  // Used by publish(). The thread that reads the socket wakes the waiting caller directly; libnats' own
  // requests go through another thread.
  std::mutex publishing_;
  NatsSubscription acks_;
  DiscardedMessages discarded_;
  std::string acks_to_;  // subject prefix, without the number
  std::uint64_t published_ = 0;
};

}  // namespace talus::server::jetstream
