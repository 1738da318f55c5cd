#include "generation/wanted_chunks.h"

#include <algorithm>
#include <bit>

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

void WantedChunks::set(ClientId client, std::span<const LevelBox> boxes) {
  const std::lock_guard lock{mutex_};
  if (const auto known = boxes_.find(client); known != boxes_.end()) {
    remove(client, known->second);
    boxes_.erase(known);
  }
  if (boxes.empty()) return;
  try {
    boxes_.emplace(client, std::vector(boxes.begin(), boxes.end()));
    for (const LevelBox& box : boxes) {
      for_each_cell(box, [&](const Cell& cell) {
        cells_[cell].push_back({client, box});
        ++boxes_of_scale_[static_cast<std::size_t>(cell.scale)];
      });
    }
  } catch (...) {
    remove(client, boxes);
    boxes_.erase(client);
    throw;
  }
}

void WantedChunks::remove(ClientId client, std::span<const LevelBox> boxes) {
  for (const LevelBox& box : boxes) {
    for_each_cell(box, [&](const Cell& cell) {
      const auto found = cells_.find(cell);
      if (found == cells_.end()) return;
      const std::size_t erased =
          std::erase_if(found->second, [&](const Entry& entry) { return entry.client == client; });
      boxes_of_scale_[static_cast<std::size_t>(cell.scale)] -= erased;
      if (found->second.empty()) cells_.erase(found);
    });
  }
}

bool WantedChunks::empty() const {
  const std::lock_guard lock{mutex_};
  return boxes_.empty() && cells_.empty();
}

ChunkRange WantedChunks::rows_of(ChunkKey column, ChunkRange rows) const {
  const std::int64_t x = column.coord.x;
  const std::int64_t z = column.coord.z;
  ChunkRange wanted;
  const std::lock_guard lock{mutex_};
  for (int scale = 0; scale < kScales; ++scale) {
    if (boxes_of_scale_[static_cast<std::size_t>(scale)] == 0) continue;
    const auto cell = cells_.find(Cell{x >> scale, z >> scale, scale, column.lod.value()});
    if (cell == cells_.end()) continue;
    for (const auto& [client, box] : cell->second) {
      if (!box.has_column(x, z)) continue;
      const ChunkRange shared = overlap(rows, box.y);
      if (shared.size() == 0) continue;
      wanted = wanted.size() == 0
                   ? shared
                   : ChunkRange{std::min(wanted.first, shared.first), std::max(wanted.last, shared.last)};
      if (wanted == rows) return wanted;
    }
  }
  return wanted;
}

}  // namespace talus::server
