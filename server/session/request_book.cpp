#include "session/request_book.h"

#include <algorithm>
#include <utility>

namespace talus::server {

void RequestBook::add(std::uint32_t id, const Entry& entry) {
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

void RequestBook::add_chunk(std::uint32_t id, ChunkRequest request) {
  add(id, {request, 0, 0});
  waiting_.push_back(id);
}

void RequestBook::add_heights(std::uint32_t id, std::uint64_t ticket, std::size_t bytes) {
  add(id, {std::nullopt, ticket, bytes});
  heights_bytes_ += bytes;
}

std::optional<std::uint32_t> RequestBook::next_waiting() {
  if (waiting_.empty()) return std::nullopt;
  const std::uint32_t id = waiting_.front();
  waiting_.pop_front();
  return id;
}

const RequestBook::ChunkRequest* RequestBook::chunk(std::uint32_t id) const {
  const auto found = requests_.find(id);
  return found != requests_.end() && found->second.chunk ? &*found->second.chunk : nullptr;
}

std::optional<std::uint64_t> RequestBook::heights_ticket(std::uint32_t id) const {
  const auto found = requests_.find(id);
  if (found == requests_.end() || found->second.chunk) return std::nullopt;
  return found->second.heights_ticket;
}

void RequestBook::erase(std::uint32_t id) {
  const auto found = requests_.find(id);
  if (found == requests_.end()) return;
  heights_bytes_ -= found->second.heights_bytes;
  Requests::node_type node = requests_.extract(found);
  if (spare_.size() < kSpareNodes) spare_.push_back(std::move(node));
  // Ids leave in any order, but those that still wait are few, and most leave from the front before.
  const auto place = std::find(waiting_.begin(), waiting_.end(), id);
  if (place != waiting_.end()) waiting_.erase(place);
}

void RequestBook::clear() {
  requests_.clear();
  waiting_.clear();
  heights_bytes_ = 0;
}

std::vector<std::uint32_t> RequestBook::ids() const {
  std::vector<std::uint32_t> ids;
  for (const auto& [id, entry] : requests_) ids.push_back(id);
  return ids;
}

}  // namespace talus::server
