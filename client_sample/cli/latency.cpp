#include "latency.h"

#include <algorithm>
#include <cmath>

namespace talus::cli {

void Latency::arrived(const ChunkKey& key, Time now) {
  if (!seen_.insert(key).second) return;
  const auto first =
      std::find_if(views_.begin(), views_.end(), [&](const auto& view) { return view.second.covers(key); });
  if (first != views_.end()) waits_.emplace_back(now - first->first);
}

std::chrono::duration<double, std::milli> Latency::percentile(double part) const {
  if (waits_.empty()) return {};
  auto sorted = waits_;
  const auto rank = static_cast<std::size_t>(std::ceil(part * static_cast<double>(sorted.size())));
  const auto place =
      sorted.begin() + static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(rank, 1, sorted.size()) - 1);
  std::nth_element(sorted.begin(), place, sorted.end());
  return *place;
}

}  // namespace talus::cli
