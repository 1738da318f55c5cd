// One talus_connect(): a C++ client with its own event loop, and its callbacks as a queue.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include <asio/io_context.hpp>

#include <talus.h>
#include <talus/client/client.h>

#include "sockets.h"

namespace talus::c_api {

/// A queued event, to be returned as a talus_event.
struct QueuedEvent {
  std::uint32_t type = 0;
  std::uint32_t request = 0;
  client::ReceivedChunk chunk;
  std::optional<client::ClientError> error;
  client::ColumnPlaces places;
  std::uint32_t field_count = 0;
  std::chrono::nanoseconds round_trip{0};
  client::EditDone done;
  std::shared_ptr<const client::WorldInfo> world;  // for events that report one
};

/// All work happens inside its functions, in the calling thread. A failed allocation throws std::bad_alloc;
/// the session must then be destroyed.
class Session {
 public:
  Session(const std::string& host, const std::string& port, client::Options options);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// True if the last event was delivered.
  [[nodiscard]] bool is_over() const { return over_; }
  /// True if the event queue has reached kMaxQueued.
  [[nodiscard]] bool is_full() const { return queue_.size() >= kMaxQueued; }
  /// True after joining, until the client reports the end of the connection.
  [[nodiscard]] bool takes_requests() const { return client_->world() != nullptr && !closed_ && !over_; }
  [[nodiscard]] const client::WorldInfo* newest_world() const { return client_->world(); }

  /// Does network work until an event is queued, at most `timeout_ms` (negative: without limit). The event
  /// stays in the queue until pop(). Null if there is none in time.
  [[nodiscard]] const QueuedEvent* wait(std::int32_t timeout_ms);
  [[nodiscard]] QueuedEvent pop();

  [[nodiscard]] client::Result<void> set_view(const client::View& view);
  // Each function returns the number of its request, never 0.
  [[nodiscard]] std::uint32_t get_chunk(const ChunkKey& key, std::optional<ContentHash> known);
  [[nodiscard]] std::uint32_t get_heights(std::vector<client::Column> columns);
  [[nodiscard]] std::uint32_t get_places(std::vector<client::Column> columns,
                                         std::vector<std::string> fields);
  [[nodiscard]] std::uint32_t edit(client::Edit edit);
  [[nodiscard]] std::uint32_t ping();
  void cancel(std::uint32_t request);
  [[nodiscard]] const client::Stats& stats() const { return client_->stats(); }

 private:
  static constexpr std::size_t kMaxQueued = std::size_t{1} << 18;

  [[nodiscard]] client::Events events();
  void on_joined(const client::Result<client::WorldInfo>& world);
  void on_disconnect(const client::ClientError& error, bool retrying);
  [[nodiscard]] std::uint32_t new_number();
  void run_some(std::int32_t timeout_ms);
  /// For callbacks of the client, which must not throw: runs `work` and records a failed allocation.
  template <typename Work>
  void remember(Work&& work) noexcept;

  Sockets sockets_;
  asio::io_context io_;
  std::deque<QueuedEvent> queue_;
  std::optional<QueuedEvent> closed_;  // delivered after all queued events
  bool over_ = false;
  bool out_of_memory_ = false;
  std::optional<client::View> view_;
  std::uint32_t last_number_ = 0;
  std::unordered_map<std::uint32_t, client::RequestId> chunk_requests_;  // unanswered requests
  std::optional<client::Client> client_;  // last member: destroyed first, as its handlers use the others
};

}  // namespace talus::c_api
