#include "chunks/generation/wanted_chunks.h"

#include <algorithm>

namespace talus::server {
template <typename Visit>
void WantedChunks::for_each_box(ChunkKey column, Visit&& visit) const {
  const std::int64_t x = column.coord.x;
  const std::int64_t z = column.coord.z;
  for (int scale = 0; scale < BoxCell::kScales; ++scale) {
    if (entries_of_scale_[static_cast<std::size_t>(scale)] == 0) continue;
    const auto cell = cells_.find(BoxCell::of(column, scale));
    if (cell == cells_.end()) continue;
    for (const Entry& entry : cell->second) {
      if (entry.box.has_column(x, z) && !visit(entry.box)) return;
    }
  }
}

void WantedChunks::set(ClientId client, std::span<const LevelBox> boxes) {
  const std::lock_guard lock{mutex_};
  if (const auto known = boxes_.find(client); known != boxes_.end()) {
    if (std::equal(boxes.begin(), boxes.end(), known->second.begin(), known->second.end())) return;
    remove(known->second, SIZE_MAX);
    boxes_.erase(known);
  }
  if (boxes.empty()) return;
  std::size_t places = 0;
  try {
    boxes_.emplace(client, std::vector(boxes.begin(), boxes.end()));
    for (const LevelBox& box : boxes) {
      for_each_cell(box, [&](const BoxCell& cell) {
        add(cell, box);
        ++places;
      });
    }
  } catch (...) {
    remove(boxes, places);
    boxes_.erase(client);
    throw;
  }
}

void WantedChunks::add(const BoxCell& cell, const LevelBox& box) {
  const auto [found, is_new] = cells_.try_emplace(cell);
  std::vector<Entry>& entries = found->second;
  const auto entry =
      std::find_if(entries.begin(), entries.end(), [&](const Entry& each) { return each.box == box; });
  if (entry != entries.end()) {
    ++entry->clients;
    return;
  }
  try {
    entries.push_back({box, 1});
  } catch (...) {
    if (is_new) cells_.erase(found);
    throw;
  }
  ++entries_of_scale_[static_cast<std::size_t>(cell.scale)];
}

void WantedChunks::remove(const BoxCell& cell, const LevelBox& box) {
  const auto found = cells_.find(cell);
  std::vector<Entry>& entries = found->second;
  const auto entry =
      std::find_if(entries.begin(), entries.end(), [&](const Entry& each) { return each.box == box; });
  if (--entry->clients > 0) return;
  *entry = entries.back();
  entries.pop_back();
  --entries_of_scale_[static_cast<std::size_t>(cell.scale)];
  if (entries.empty()) cells_.erase(found);
}

void WantedChunks::remove(std::span<const LevelBox> boxes, std::size_t places) {
  for (const LevelBox& box : boxes) {
    for_each_cell(box, [&](const BoxCell& cell) {
      if (places == 0) return;
      --places;
      remove(cell, box);
    });
  }
}

bool WantedChunks::empty() const {
  const std::lock_guard lock{mutex_};
  return boxes_.empty() && cells_.empty();
}

ChunkRange WantedChunks::rows_of(ChunkKey column, ChunkRange rows) const {
  ChunkRange wanted;
  const std::lock_guard lock{mutex_};
  for_each_box(column, [&](const LevelBox& box) {
    const ChunkRange shared = overlap(rows, box.y);
    if (shared.size() == 0) return true;
    wanted = wanted.size() == 0
                 ? shared
                 : ChunkRange{std::min(wanted.first, shared.first), std::max(wanted.last, shared.last)};
    return wanted != rows;
  });
  return wanted;
}

bool WantedChunks::has_column(ChunkKey column) const {
  bool has = false;
  const std::lock_guard lock{mutex_};
  for_each_box(column, [&](const LevelBox&) {
    has = true;
    return false;
  });
  return has;
}

}  // namespace talus::server
