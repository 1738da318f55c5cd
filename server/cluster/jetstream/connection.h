// A connection to the NATS servers, which libnats makes anew, to any of them, whenever it breaks.
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

/// A message that came; it is there while a handler is called.
class Arrived {
 public:
  explicit Arrived(natsMsg* message) : message_{message} {}

  [[nodiscard]] std::string_view subject() const { return natsMsg_GetSubject(message_); }
  [[nodiscard]] std::span<const std::byte> bytes() const;
  [[nodiscard]] std::string_view text() const;
  /// Empty where it has none of the name.
  [[nodiscard]] std::string_view header(const char* name) const;
  /// Of the header "Nats-Sequence"; 0 where there is none.
  [[nodiscard]] std::uint64_t sequence() const;
  /// Of an answer that says no: 404, or 503 where nobody listens; 0 for others.
  [[nodiscard]] int status() const;

 private:
  natsMsg* message_;
};

/// What happens to a connection. Calls come from threads of libnats, must not wait, and may still come while
/// the connection is closed.
class ConnectionEvents {
 public:
  virtual ~ConnectionEvents() = default;
  virtual void connected(bool now) = 0;
  /// For good: libnats gives up once a server has refused the credentials twice.
  virtual void closed(const StreamFailure& why) = 0;
  /// NATS did not allow something, such as: Permissions Violation for Publish to "x".
  virtual void denied(std::string_view what) = 0;
};

enum class Retry : std::uint8_t {
  forever,  // open() succeeds whether or not a server answers
  never,    // open() says why none does; broken connections stay so
};

/// All calls may come from any thread.
class Connection {
 public:
  /// Tries `first` first, where that names a server, and `urls` in any order. Waits half a second a server at
  /// most, and twice that where none answers and it is to be tried again.
  [[nodiscard]] static tl::expected<std::shared_ptr<Connection>, StreamFailure> open(
      const ServerUrls& urls, std::shared_ptr<const Credentials> credentials,
      std::shared_ptr<ConnectionEvents> events, Retry retry, const ServerUrls& first = {});
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Whether a server is connected, without waiting for libnats.
  [[nodiscard]] bool connected() const { return link_->connected.load(std::memory_order_relaxed); }
  /// Waiting calls return, later ones fail.
  void close();

  using Handler = std::function<void(const Arrived&)>;
  /// `handler` is called on a thread of its own. What it leaves behind beyond so many messages and bytes is
  /// dropped. Holds over broken connections. On one that NATS has refused nothing comes: its events say why.
  [[nodiscard]] tl::expected<void, StreamFailure> subscribe(const std::string& subject, Handler handler,
                                                            int pending_messages, int pending_bytes);
  /// A subscription whose messages its reader takes himself, on one thread at a time. They wait in between.
  /// It may outlive the connection, and then has none.
  class Source {
   public:
    enum class Taken : std::uint8_t { message, none, closed };

    explicit Source(NatsSubscription subscription) : subscription_{std::move(subscription)} {}
    /// Calls `handler` with the next message, which is waited for so long.
    [[nodiscard]] Taken take(std::chrono::milliseconds patience, const Handler& handler);

   private:
    NatsSubscription subscription_;
    DiscardedMessages discarded_;
  };
  /// As subscribe().
  [[nodiscard]] tl::expected<std::shared_ptr<Source>, StreamFailure> open_source(const std::string& subject,
                                                                                 int pending_messages,
                                                                                 int pending_bytes);
  /// Sends, and forgets it: the answer comes to `reply`, if it comes.
  [[nodiscard]] tl::expected<void, StreamFailure> send(const std::string& subject, const std::string& reply,
                                                       std::string_view text);
  /// Sends, and waits for the answer.
  [[nodiscard]] tl::expected<NatsMessage, StreamFailure> request(const std::string& subject,
                                                                 std::string_view text,
                                                                 std::chrono::milliseconds patience);
  /// Publishes to a stream, and waits for its acknowledgement: what it says. One after another, whoever
  /// calls.
  struct Ack {
    std::string stream;
    std::uint64_t sequence = 0;
  };
  [[nodiscard]] tl::expected<Ack, StreamFailure> publish(const std::string& subject,
                                                         std::span<const std::byte> bytes,
                                                         std::chrono::milliseconds patience);
  /// Whether publish() to the subject would come through; the stream stays as it is, and its Raft log too. A
  /// message that all replicas have to refuse, as one of another sequence than it expects, is in that log: in
  /// nats-server 2.9.10 a replica that is killed and starts again then takes one message twice.
  [[nodiscard]] tl::expected<void, StreamFailure> try_publish(const std::string& subject,
                                                              std::chrono::milliseconds patience);
  /// Returns when the server has done all that was sent before.
  [[nodiscard]] tl::expected<void, StreamFailure> flush(std::chrono::milliseconds patience);
  /// Of the connected server.
  [[nodiscard]] std::int64_t max_payload() const;
  /// The last permission that was missing, where that was after `since`; else empty.
  [[nodiscard]] std::string denied_since(std::chrono::steady_clock::time_point since) const;
  /// The same; waits for it so long, as refusals come late.
  [[nodiscard]] std::string await_denial(std::chrono::steady_clock::time_point since,
                                         std::chrono::milliseconds patience) const;

 private:
  /// What libnats' threads know of it. It lives until they are done with it.
  struct Link {
    std::shared_ptr<const Credentials> credentials;
    std::shared_ptr<ConnectionEvents> events;
    natsStatus at_first = NATS_OK;  // what became of the first attempt; before there are callbacks
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
  /// Where acknowledgements come to publish().
  [[nodiscard]] natsStatus await_acks();
  [[nodiscard]] static tl::expected<Ack, StreamFailure> ack_of(const Arrived& answer);
  [[nodiscard]] StreamFailure failure_of(natsStatus status, std::chrono::steady_clock::time_point since,
                                         std::string_view doing) const;

  std::shared_ptr<Link> link_;
  std::unique_ptr<natsConnection, CloseConnection> connection_;
  JetStreamContext context_;
  std::mutex mutex_;
  std::vector<NatsSubscription> subscriptions_;
  // Of publish(). Who reads the socket wakes who waits there: libnats' own requests go by a thread in
  // between.
  std::mutex publishing_;
  NatsSubscription acks_;
  DiscardedMessages discarded_;
  std::string acks_to_;  // subject, without the number
  std::uint64_t published_ = 0;
};

}  // namespace talus::server::jetstream
