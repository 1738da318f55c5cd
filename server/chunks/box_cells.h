// A grid that finds boxes of chunks by column. A box lies in one to four cells of a grid as coarse as the box
// is wide, so a wide View costs no more than a small one.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <talus/voxel/view_shape.h>

namespace talus::server {

struct BoxCell {
  // Along x and z, starting with cells of 2^0 chunks.
  static constexpr int kScales = 40;

  std::int64_t x = 0;
  std::int64_t z = 0;
  int scale = 0;  // the edge is 2^scale chunks
  int level = 0;
  bool operator==(const BoxCell&) const = default;

  /// Returns the cell of `scale` that contains a column.
  [[nodiscard]] static BoxCell of(ChunkKey column, int scale) {
    return {std::int64_t{column.coord.x} >> scale, std::int64_t{column.coord.z} >> scale, scale,
            column.lod.value()};
  }
};

struct BoxCellHash {
  std::size_t operator()(const BoxCell& cell) const noexcept {
    const auto kind = static_cast<std::uint64_t>(cell.scale * 16 + cell.level);
    return scrambled(scrambled(scrambled(kind) + static_cast<std::uint64_t>(cell.x)) +
                     static_cast<std::uint64_t>(cell.z));
  }

 private:
  static std::uint64_t scrambled(std::uint64_t bits) {
    bits *= 0x9E3779B97F4A7C15U;
    return bits ^ (bits >> 29);
  }
};

/// Calls visit(BoxCell) for each cell that the box lies in.
template <typename Visit>
void for_each_cell(const LevelBox& box, Visit&& visit) {
  const std::uint64_t width = std::max(box.x.size(), box.z.size());
  if (box.x.size() == 0 || box.z.size() == 0 || box.y.size() == 0) return;
  const auto scale = static_cast<int>(std::bit_width(width));
  for (std::int64_t z = box.z.first >> scale; z <= box.z.last >> scale; ++z) {
    for (std::int64_t x = box.x.first >> scale; x <= box.x.last >> scale; ++x)
      visit(BoxCell{x, z, scale, box.lod.value()});
  }
}

}  // namespace talus::server
