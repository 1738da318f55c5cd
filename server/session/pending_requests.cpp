#include "session/pending_requests.h"

#include <algorithm>
#include <utility>

namespace talus::server {

void PendingRequests::add(std::uint32_t id, const Entry& entry) {
  if (spare_.empty()) {
    requests_.emplace(id, entry);
    return;
  }
  Requests::node_type node = std::move(spare_.back());
  spare_.pop_back();
  node.key() = id;
  node.mapped() = entry;
  requests_.insert(std::move(node));
}

void PendingRequests::add_chunk(std::uint32_t id, ChunkRequest request) {
  add(id, {request, 0, 0});
  unstarted_.push_back(id);
}

void PendingRequests::add_heights(std::uint32_t id, std::uint64_t ticket, std::size_t bytes) {
  add(id, {std::nullopt, ticket, bytes});
  heights_bytes_ += bytes;
}

std::optional<std::uint32_t> PendingRequests::next_unstarted() {
  if (unstarted_.empty()) return std::nullopt;
  const std::uint32_t id = unstarted_.front();
  unstarted_.pop_front();
  return id;
}

const PendingRequests::ChunkRequest* PendingRequests::chunk(std::uint32_t id) const {
  const auto found = requests_.find(id);
  return found != requests_.end() && found->second.chunk ? &*found->second.chunk : nullptr;
}

std::optional<std::uint64_t> PendingRequests::heights_ticket(std::uint32_t id) const {
  const auto found = requests_.find(id);
  if (found == requests_.end() || found->second.chunk) return std::nullopt;
  return found->second.heights_ticket;
}

void PendingRequests::erase(std::uint32_t id) {
  const auto found = requests_.find(id);
  if (found == requests_.end()) return;
  heights_bytes_ -= found->second.heights_bytes;
  Requests::node_type node = requests_.extract(found);
  if (spare_.size() < kMaxSpareNodes) spare_.push_back(std::move(node));
  // Linear, but few requests are unstarted, and most were started before.
  const auto at = std::find(unstarted_.begin(), unstarted_.end(), id);
  if (at != unstarted_.end()) unstarted_.erase(at);
}

void PendingRequests::clear() {
  requests_.clear();
  unstarted_.clear();
  heights_bytes_ = 0;
}

std::vector<std::uint32_t> PendingRequests::ids() const {
  std::vector<std::uint32_t> ids;
  for (const auto& [id, entry] : requests_) ids.push_back(id);
  return ids;
}

}  // namespace talus::server
