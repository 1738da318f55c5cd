#include "pending_rings.h"

namespace talus::load {
namespace {

template <typename Visit>
void for_each_of_rings(const client::ViewShape& shape, Visit&& visit) {
  shape.for_each([&](const ChunkKey& key) {
    if (key.lod != Lod{}) visit(key);
  });
}

}  // namespace

void PendingRings::move_to(const client::ViewShape& shape) {
  for_each_of_rings(shape_, [&](const ChunkKey& key) {
    if (shape.covers(key)) return;
    left_.insert(key);
    held_.erase(key);
  });
  shape_ = shape;
  waiting_ = 0;
  for_each_of_rings(shape_, [&](const ChunkKey& key) {
    if (!held_.contains(key) && !left_.contains(key)) ++waiting_;
  });
}

std::size_t PendingRings::make_all() {
  std::size_t made = 0;
  for_each_of_rings(shape_, [&](const ChunkKey& key) { made += held_.insert(key).second; });
  waiting_ = 0;
  return made;
}

PendingRings::Verdict PendingRings::arrive(ChunkKey chunk) {
  const bool has_left = left_.contains(chunk);
  if (!shape_.covers(chunk)) return has_left ? Verdict::stale : Verdict::outside;
  if (!held_.insert(chunk).second) return has_left ? Verdict::repeated : Verdict::duplicate;
  if (!has_left) --waiting_;
  return Verdict::came;
}

}  // namespace talus::load
