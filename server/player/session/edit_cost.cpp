#include "player/session/edit_cost.h"

#include <algorithm>

namespace talus::server {

EditCosts::Priced EditCosts::price(const CheckedEdit& edit, bool settles) const {
  Priced priced{{edit.voxels, 0}, edits::touched_chunks(edit.edit, settles)};
  std::erase_if(priced.new_chunks, [&](ChunkCoord chunk) {
    return chunks_.revision({chunk, Lod{}}) != kBaseRevision ||
           std::ranges::find(paid_, chunk) != paid_.end();
  });
  priced.cost.new_chunks = priced.new_chunks.size();
  return priced;
}

void EditCosts::pay(const Priced& priced) {
  for (const ChunkCoord chunk : priced.new_chunks) {
    if (paid_.size() < kRemembered) {
      paid_.push_back(chunk);
    } else {
      paid_[oldest_] = chunk;
      oldest_ = (oldest_ + 1) % kRemembered;
    }
  }
}

}  // namespace talus::server
