#include "requests.h"

#include <algorithm>

#include "open_edits.h"

namespace talus::client {

std::uint32_t Requests::add(Request request) {
  do {
    last_id_ = (last_id_ + 1) & ~OpenEdits::kIdBit;
  } while (last_id_ == 0 || open_.contains(last_id_));
  open_.emplace(last_id_, std::move(request));
  waiting_.push_back(last_id_);
  return last_id_;
}

std::optional<std::uint32_t> Requests::send_next(std::uint32_t limit) {
  if (!has_next(limit)) return std::nullopt;
  const std::uint32_t id = waiting_.front();
  waiting_.pop_front();
  in_flight_.emplace(id, false);
  return id;
}

const Request* Requests::in_flight(std::uint32_t id) const {
  return in_flight_.contains(id) ? &open_.at(id) : nullptr;
}

Request Requests::take(std::uint32_t id) {
  Request request = std::move(open_.at(id));
  open_.erase(id);
  in_flight_.erase(id);
  return request;
}

Requests::CancelResult Requests::cancel(std::uint32_t id) {
  if (const auto sent = in_flight_.find(id); sent != in_flight_.end()) {
    if (sent->second) return CancelResult::unknown;
    sent->second = true;
    return CancelResult::in_flight;
  }
  const auto place = std::find(waiting_.begin(), waiting_.end(), id);
  if (place == waiting_.end()) return CancelResult::unknown;
  waiting_.erase(place);
  return CancelResult::waiting;
}

std::vector<Request> Requests::send_again() {
  std::vector<Request> cancelled;
  std::deque<std::uint32_t> again;
  for (const auto& [id, is_cancelled] : std::exchange(in_flight_, {})) {
    if (is_cancelled) {
      cancelled.push_back(take(id));
    } else {
      again.push_back(id);
    }
  }
  waiting_.insert(waiting_.begin(), again.begin(), again.end());
  return cancelled;
}

bool Requests::put_back(std::uint32_t id) {
  if (in_flight_.at(id)) return false;
  in_flight_.erase(id);
  waiting_.insert(
      std::find_if(waiting_.begin(), waiting_.end(), [id](std::uint32_t other) { return other > id; }), id);
  return true;
}

std::vector<Request> Requests::take_all() {
  std::vector<Request> all;
  for (auto& [id, request] : std::exchange(open_, {})) all.push_back(std::move(request));
  in_flight_.clear();
  waiting_.clear();
  return all;
}

void fail(const Request& request, const ClientError& error) {
  std::visit([&](const auto& r) { r.handler(tl::unexpected{error}); }, request);
}

}  // namespace talus::client
