#include "open_writes.h"

#include <algorithm>
#include <utility>

namespace talus::load {

std::uint64_t OpenWrites::add(const OpenWrite& write) {
  open_.emplace(++last_sequence_, write);
  return last_sequence_;
}

std::optional<std::uint64_t> OpenWrites::send_next() {
  const auto next = std::ranges::find_if(open_, [](const auto& each) { return !each.second.in_flight; });
  if (next == open_.end()) return std::nullopt;
  next->second.in_flight = true;
  return next->first;
}

std::optional<std::uint64_t> OpenWrites::in_flight(std::uint32_t id) const {
  for (const auto& [sequence, write] : open_) {
    if (write.in_flight && id_of(sequence) == id) return sequence;
  }
  return std::nullopt;
}

OpenWrite OpenWrites::take(std::uint64_t sequence) {
  return open_.extract(sequence).mapped();
}

void OpenWrites::put_all_back() {
  for (auto& [sequence, write] : open_) write.in_flight = false;
}

std::vector<OpenWrite> OpenWrites::attached(bool known, std::uint64_t last_sequence) {
  std::vector<OpenWrite> lost;
  if (!known) {
    for (auto& [sequence, write] : std::exchange(open_, {})) lost.push_back(write);
  }
  last_sequence_ = std::max(last_sequence_, last_sequence);
  return lost;
}

}  // namespace talus::load
