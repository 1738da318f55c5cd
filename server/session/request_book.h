// A session's requests that are not yet answered. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <vector>

#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>

namespace talus::server {

class RequestBook {
 public:
  struct ChunkRequest {
    ChunkKey key;
    std::optional<ContentHash> known;  // what the client holds there
  };

  [[nodiscard]] bool contains(std::uint32_t id) const { return requests_.contains(id); }
  [[nodiscard]] std::size_t size() const { return requests_.size(); }
  [[nodiscard]] bool empty() const { return requests_.empty(); }

  /// `id` must not be in the book.
  void add_chunk(std::uint32_t id, ChunkRequest request);
  /// `bytes` is what the request and its answer occupy.
  void add_heights(std::uint32_t id, std::uint64_t ticket, std::size_t bytes);

  /// The chunk request that has waited longest to be worked on, now no longer waiting.
  [[nodiscard]] std::optional<std::uint32_t> next_waiting();

  /// Null where the id is not in the book, or is of heights.
  [[nodiscard]] const ChunkRequest* chunk(std::uint32_t id) const;
  /// The ticket of a heights request; none where the id is not in the book, or is of a chunk.
  [[nodiscard]] std::optional<std::uint64_t> heights_ticket(std::uint32_t id) const;

  /// The request is answered. No effect where the id is not in the book.
  void erase(std::uint32_t id);
  void clear();
  [[nodiscard]] std::vector<std::uint32_t> ids() const;

  [[nodiscard]] std::size_t heights_bytes() const { return heights_bytes_; }

 private:
  struct Entry {
    std::optional<ChunkRequest> chunk;  // none: heights
    std::uint64_t heights_ticket = 0;
    std::size_t heights_bytes = 0;
  };
  using Requests = std::unordered_map<std::uint32_t, Entry>;
  static constexpr std::size_t kSpareNodes = 16;

  void add(std::uint32_t id, const Entry& entry);

  Requests requests_;
  std::vector<Requests::node_type> spare_;  // of answered requests, for the next: a client asks all the time
  std::deque<std::uint32_t> waiting_;       // ids of the book
  std::size_t heights_bytes_ = 0;
};

}  // namespace talus::server
