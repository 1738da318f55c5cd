#include "player/session/pending_requests.h"

#include <algorithm>

namespace talus::server {

void PendingRequests::add_chunk(std::uint32_t id, const ChunkRequest& request) {
  requests_.insert(id, request);
  unstarted_.push_back(id);
}

void PendingRequests::add_heights(std::uint32_t id, std::uint64_t ticket, std::size_t bytes) {
  requests_.insert(id, HeightsRequest{ticket, bytes});
  heights_bytes_ += bytes;
}

void PendingRequests::add_file(std::uint32_t id, FileRequest request) {
  requests_.insert(id, request);
  files_.push_back(id);
}

std::optional<std::uint32_t> PendingRequests::next_unstarted() {
  if (unstarted_.empty()) return std::nullopt;
  const std::uint32_t id = unstarted_.front();
  unstarted_.pop_front();
  return id;
}

std::optional<std::uint64_t> PendingRequests::heights_ticket(std::uint32_t id) const {
  const auto* const request = requests_.find(id);
  const auto* const heights = request == nullptr ? nullptr : std::get_if<HeightsRequest>(request);
  return heights == nullptr ? std::nullopt : std::optional{heights->ticket};
}

void PendingRequests::erase(std::uint32_t id) {
  const auto* const request = requests_.find(id);
  if (request == nullptr) return;
  if (const auto* const heights = std::get_if<HeightsRequest>(request)) heights_bytes_ -= heights->bytes;
  requests_.erase(id);
  for (auto* const queue : {&unstarted_, &files_}) {  // mostly empty: most are started at once
    const auto at = std::find(queue->begin(), queue->end(), id);
    if (at != queue->end()) queue->erase(at);
  }
}

void PendingRequests::clear() {
  requests_.clear();
  unstarted_.clear();
  files_.clear();
  heights_bytes_ = 0;
}

std::vector<std::uint32_t> PendingRequests::ids() const {
  std::vector<std::uint32_t> ids;
  requests_.for_each([&](std::uint32_t id, const auto& /*request*/) { ids.push_back(id); });
  return ids;
}

}  // namespace talus::server
