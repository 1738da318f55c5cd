#include "generation/wanted_chunks.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace talus::server {
namespace {

std::uint64_t scrambled(std::uint64_t bits) {
  bits *= 0x9E3779B97F4A7C15U;
  return bits ^ (bits >> 29);
}

}  // namespace

std::size_t WantedChunks::CellHash::operator()(const Cell& cell) const noexcept {
  const auto kind = static_cast<std::uint64_t>(cell.scale * 16 + cell.level);
  return scrambled(scrambled(scrambled(kind) + static_cast<std::uint64_t>(cell.x)) +
                   static_cast<std::uint64_t>(cell.z));
}

template <typename Visit>
void WantedChunks::for_each_cell(const LevelBox& box, Visit&& visit) {
  const std::uint64_t width = std::max(box.x.size(), box.z.size());
  if (box.x.size() == 0 || box.z.size() == 0 || box.y.size() == 0) return;
  const auto scale = static_cast<int>(std::bit_width(width));
  for (std::int64_t z = box.z.first >> scale; z <= box.z.last >> scale; ++z) {
    for (std::int64_t x = box.x.first >> scale; x <= box.x.last >> scale; ++x)
      visit(Cell{x, z, scale, box.lod.value()});
  }
}

template <typename Visit>
void WantedChunks::for_each_box(ChunkKey column, Visit&& visit) const {
  const std::int64_t x = column.coord.x;
  const std::int64_t z = column.coord.z;
  for (int scale = 0; scale < kScales; ++scale) {
    if (entries_of_scale_[static_cast<std::size_t>(scale)] == 0) continue;
    const auto cell = cells_.find(Cell{x >> scale, z >> scale, scale, column.lod.value()});
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
      for_each_cell(box, [&](const Cell& cell) {
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

void WantedChunks::add(const Cell& cell, const LevelBox& box) {
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

void WantedChunks::remove(const Cell& cell, const LevelBox& box) {
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
    for_each_cell(box, [&](const Cell& cell) {
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
