#include "view_waits.h"

#include <algorithm>

namespace talus::cli {

void ViewWaits::chunk_arrived(const ChunkKey& key, Time now) {
  if (!seen_.insert(key).second) return;
  const auto first =
      std::find_if(views_.begin(), views_.end(), [&](const auto& view) { return view.second.covers(key); });
  if (first != views_.end()) waits_.record(now - first->first);
}

}  // namespace talus::cli
