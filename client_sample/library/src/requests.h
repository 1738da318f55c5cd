// Unanswered requests, waiting for their turn or in flight.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <talus/client/client.h>

namespace talus::client {

struct ChunkRequest {
  ChunkKey key;
  std::optional<ContentHash> known;
  std::function<void(Result<ReceivedChunk>)> handler;
};

struct HeightsRequest {
  std::vector<Column> columns;
  bool looks = false;
  std::vector<std::string> fields;  // names: the next server may number them differently
  std::function<void(Result<ColumnPlaces>)> handler;
};

/// The part of a published file from `offset` on.
struct FileRequest {
  struct Part {
    std::uint64_t size = 0;  // of the whole file
    std::vector<std::byte> bytes;
  };
  std::string name;
  std::uint64_t offset = 0;
  std::function<void(Result<Part>)> handler;
};

using Request = std::variant<ChunkRequest, HeightsRequest, FileRequest>;

class Requests {
 public:
  [[nodiscard]] std::uint32_t add(Request request);

  /// Sends the next request and returns its id; nullopt if `limit` are in flight or nothing is waiting.
  [[nodiscard]] std::optional<std::uint32_t> send_next(std::uint32_t limit);
  [[nodiscard]] const Request& at(std::uint32_t id) const { return open_.at(id); }

  /// The request in flight with this id; null if there is none, so that the answer is unsolicited.
  [[nodiscard]] const Request* in_flight(std::uint32_t id) const;

  /// Removes a request in order to answer it.
  [[nodiscard]] Request take(std::uint32_t id);

  enum class CancelResult : std::uint8_t { unknown, waiting, in_flight };
  /// Returns the request's state. If it was waiting, the caller must take() and answer it.
  [[nodiscard]] CancelResult cancel(std::uint32_t id);

  /// The connection broke: requests in flight wait again, oldest first. Returns cancelled ones, which are not
  /// sent again.
  [[nodiscard]] std::vector<Request> send_again();

  /// The server refused the request temporarily: it waits again, before all never sent and in order of ids.
  /// Returns false if it had been cancelled: the caller must then take() and answer it.
  [[nodiscard]] bool put_back(std::uint32_t id);

  /// True if send_next() would return a request.
  [[nodiscard]] bool has_next(std::uint32_t limit) const {
    return !waiting_.empty() && in_flight_.size() < limit;
  }

  /// Removes all requests, oldest first.
  [[nodiscard]] std::vector<Request> take_all();

 private:
  std::map<std::uint32_t, Request> open_;
  std::map<std::uint32_t, bool> in_flight_;  // id, cancelled
  std::deque<std::uint32_t> waiting_;
  std::uint32_t last_id_ = 0;
};

/// Answers a request with an error.
void fail(const Request& request, const ClientError& error);

}  // namespace talus::client
