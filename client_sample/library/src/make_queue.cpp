#include "make_queue.h"

#include <algorithm>

namespace talus::client {

MakeQueue::MakeQueue(const View& view, const std::vector<ChunkKey>& chunks) {
  const ViewOrder order{{floor_div(view.centre.x, kChunkSize), floor_div(view.centre.y, kChunkSize),
                         floor_div(view.centre.z, kChunkSize)},
                        view.direction};
  std::map<PatchName, std::size_t> places;
  for (const ChunkKey& key : chunks) {
    const auto patch_of = [](std::int32_t column) { return column & -kPatchColumns; };
    const PatchName name{key.lod, patch_of(key.coord.x), patch_of(key.coord.z)};
    const auto place = places.try_emplace(name, patches_.size()).first->second;
    if (place == patches_.size()) patches_.emplace_back();
    patches_[place].push_back({order.rank(key), key});
  }
  for (std::size_t place = 0; place < patches_.size(); ++place) {
    std::sort(patches_[place].begin(), patches_[place].end(), std::greater<>{});
    order_.emplace(patches_[place].back().rank, place);
  }
}

std::vector<ChunkKey> MakeQueue::next() {
  std::vector<ChunkKey> batch;
  if (order_.empty()) return batch;
  const auto [rank, place] = order_.top();
  order_.pop();
  Patch& patch = patches_[place];
  const auto farthest = ViewOrder::ring_of(rank) + (kFarther << patch.back().key.lod.value());
  while (!patch.empty() && batch.size() < kMaxBatch && ViewOrder::ring_of(patch.back().rank) <= farthest) {
    batch.push_back(patch.back().key);
    patch.pop_back();
  }
  if (!patch.empty()) order_.emplace(patch.back().rank, place);
  return batch;
}

}  // namespace talus::client
