// A session's unanswered requests, by id. No I/O.
//
// A chunk request is unstarted until next_unstarted() returns it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>

#include "player/session/id_map.h"

namespace talus::server {

class PendingRequests {
 public:
  struct ChunkRequest {
    ChunkKey key;
    std::optional<ContentHash> known;  // hash of the client's chunk
  };

  /// A part of a file that outlives the session, and the size of the whole.
  struct FileRequest {
    std::string_view part;
    std::uint64_t size = 0;
  };

  [[nodiscard]] bool contains(std::uint32_t id) const { return requests_.find(id) != nullptr; }
  [[nodiscard]] std::size_t size() const { return requests_.size(); }
  [[nodiscard]] bool empty() const { return requests_.empty(); }

  /// REQUIRES: no request `id` is pending.
  void add_chunk(std::uint32_t id, const ChunkRequest& request);
  /// REQUIRES: no request `id` is pending. `bytes` is the memory of the request and its answer.
  void add_heights(std::uint32_t id, std::uint64_t ticket, std::size_t bytes);

  /// REQUIRES: no request `id` is pending.
  void add_file(std::uint32_t id, FileRequest request);

  [[nodiscard]] bool has_unstarted() const { return !unstarted_.empty(); }
  /// Starts and returns the oldest unstarted chunk request.
  [[nodiscard]] std::optional<std::uint32_t> next_unstarted();

  /// Null if `id` is not pending or is not a request for a chunk. Valid until the next change.
  [[nodiscard]] const ChunkRequest* chunk(std::uint32_t id) const {
    const auto* const request = requests_.find(id);
    return request == nullptr ? nullptr : std::get_if<ChunkRequest>(request);
  }
  /// Nullopt if `id` is not pending or is not a request for heights.
  [[nodiscard]] std::optional<std::uint64_t> heights_ticket(std::uint32_t id) const;

  /// Null if `id` is not pending or is not a request for a file. Valid until the next change.
  [[nodiscard]] const FileRequest* file(std::uint32_t id) const {
    const auto* const request = requests_.find(id);
    return request == nullptr ? nullptr : std::get_if<FileRequest>(request);
  }
  /// The oldest request for a file.
  [[nodiscard]] std::optional<std::uint32_t> next_file() const {
    return files_.empty() ? std::nullopt : std::optional{files_.front()};
  }

  /// The request was answered. No effect if `id` is not pending.
  void erase(std::uint32_t id);
  void clear();
  [[nodiscard]] std::vector<std::uint32_t> ids() const;

  [[nodiscard]] std::size_t heights_bytes() const { return heights_bytes_; }
  /// Memory of the requests themselves.
  [[nodiscard]] std::size_t bytes() const {
    return requests_.bytes() + (unstarted_.size() + files_.size()) * sizeof(std::uint32_t);
  }

 private:
  struct HeightsRequest {
    std::uint64_t ticket = 0;
    std::size_t bytes = 0;
  };

  IdMap<std::variant<ChunkRequest, HeightsRequest, FileRequest>> requests_;
  // Oldest first; each is in requests_.
  std::deque<std::uint32_t> unstarted_;  // for chunks
  std::deque<std::uint32_t> files_;
  std::size_t heights_bytes_ = 0;
};

}  // namespace talus::server
