// One talus_connect(): a C++ client with an event loop of its own, and its callbacks as a queue.
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

namespace talus::c_api {

/// What waits to become a talus_event.
struct QueuedEvent {
  std::uint32_t type = 0;
  std::uint32_t request = 0;
  client::ReceivedChunk chunk;
  std::optional<client::ClientError> error;
  client::ColumnPlaces places;
  std::uint32_t field_count = 0;
  std::chrono::nanoseconds round_trip{0};
  client::EditDone done;
  std::shared_ptr<const client::WorldInfo> world;  // of those that tell of one
};

/// Everything happens inside its functions, in the thread that calls them. An allocation that fails leaves by
/// std::bad_alloc; then the session is of no more use than to be destroyed.
class Session {
 public:
  Session(const std::string& host, const std::string& port, client::Options options);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Whether it has given its last event.
  [[nodiscard]] bool is_over() const { return over_; }
  /// Whether more events wait than a program that polls ever leaves.
  [[nodiscard]] bool is_full() const { return queue_.size() >= kMaxQueued; }
  /// Whether the client has joined, and has not said since that the connection is over.
  [[nodiscard]] bool takes_requests() const { return client_->world() != nullptr && !closed_ && !over_; }
  [[nodiscard]] const client::WorldInfo* newest_world() const { return client_->world(); }

  /// Works for the network until an event waits, at most for `timeout_ms` (negative: without limit); the
  /// event, which stays in the queue until pop(). None: none came.
  [[nodiscard]] const QueuedEvent* wait(std::int32_t timeout_ms);
  [[nodiscard]] QueuedEvent pop();

  [[nodiscard]] client::Result<void> set_view(const client::View& view);
  // Each returns the number of its request, never 0.
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
  /// In a callback of the client, which must not throw: does `work`, and remembers that memory ran out.
  template <typename Work>
  void remember(Work&& work) noexcept;

  asio::io_context io_;
  std::deque<QueuedEvent> queue_;
  std::optional<QueuedEvent> closed_;  // comes after all that waits
  bool over_ = false;
  bool out_of_memory_ = false;
  std::optional<client::View> view_;
  std::uint32_t last_number_ = 0;
  std::unordered_map<std::uint32_t, client::RequestId> chunk_requests_;  // that are not answered
  std::optional<client::Client> client_;  // last: the first to go, and its handlers know the rest
};

}  // namespace talus::c_api
