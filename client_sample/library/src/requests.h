// Every request that has no answer yet: those that wait for their turn and those in flight.
#pragma once

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
  std::vector<std::string> fields;  // names, as the next server may count otherwise
  std::function<void(Result<ColumnPlaces>)> handler;
};

using Request = std::variant<ChunkRequest, HeightsRequest>;

class Requests {
 public:
  [[nodiscard]] std::uint32_t add(Request request);

  /// The next request to send, now in flight; none when `limit` are in flight or none waits.
  [[nodiscard]] std::optional<std::uint32_t> send_next(std::uint32_t limit);
  [[nodiscard]] const Request& at(std::uint32_t id) const { return open_.at(id); }

  /// The request in flight that `id` names, or null: such an answer was never asked for.
  [[nodiscard]] const Request* in_flight(std::uint32_t id) const;

  /// Takes a request out, to answer it.
  [[nodiscard]] Request take(std::uint32_t id);

  enum class Cancelled : std::uint8_t { unknown, waiting, in_flight };
  /// Where the request stood. One that waited has to be taken out and answered by the caller.
  [[nodiscard]] Cancelled cancel(std::uint32_t id);

  /// The connection broke: what was in flight waits again, the oldest first. Returns those that had been
  /// cancelled, which are not worth asking again.
  [[nodiscard]] std::vector<Request> send_again();

  /// The server refused it for now: it waits again, before all that were never sent and in the order of ids.
  /// False where it had been cancelled: then the caller takes it out and answers it.
  [[nodiscard]] bool put_back(std::uint32_t id);

  /// Whether a request waits that send_next() would give out.
  [[nodiscard]] bool has_next(std::uint32_t limit) const {
    return !waiting_.empty() && in_flight_.size() < limit;
  }

  /// Takes all out, oldest first.
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
