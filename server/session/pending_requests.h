// A session's requests that are not answered yet, by their id. No I/O.
//
// A chunk request is unstarted until next_unstarted() returns it.
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

class PendingRequests {
 public:
  struct ChunkRequest {
    ChunkKey key;
    std::optional<ContentHash> known;  // of what the client holds there
  };

  [[nodiscard]] bool contains(std::uint32_t id) const { return requests_.contains(id); }
  [[nodiscard]] std::size_t size() const { return requests_.size(); }
  [[nodiscard]] bool empty() const { return requests_.empty(); }

  /// REQUIRES: no request `id` is pending.
  void add_chunk(std::uint32_t id, ChunkRequest request);
  /// REQUIRES: no request `id` is pending. `bytes` is the memory of the request and its answer.
  void add_heights(std::uint32_t id, std::uint64_t ticket, std::size_t bytes);

  /// The oldest unstarted chunk request, which is started now.
  [[nodiscard]] std::optional<std::uint32_t> next_unstarted();

  /// Null where `id` is not pending, or is a request for heights.
  [[nodiscard]] const ChunkRequest* chunk(std::uint32_t id) const;
  /// None where `id` is not pending, or is a request for a chunk.
  [[nodiscard]] std::optional<std::uint64_t> heights_ticket(std::uint32_t id) const;

  /// The request is answered. No effect where `id` is not pending.
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
  static constexpr std::size_t kMaxSpareNodes = 16;

  void add(std::uint32_t id, const Entry& entry);

  Requests requests_;
  std::vector<Requests::node_type> spare_;  // nodes of answered requests, reused: requests come all the time
  std::deque<std::uint32_t> unstarted_;     // oldest first; each is in requests_
  std::size_t heights_bytes_ = 0;
};

}  // namespace talus::server
