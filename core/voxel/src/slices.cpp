#include "slices.h"

#include <algorithm>

namespace talus {

Slices::Slices(const Layers& layers) : layers_{layers} {
  bytes_are_materials_ = std::all_of(layers.materials.begin(), layers.materials.end(),
                                     [](MaterialId material) { return to_integer(material) < 256; });
  for (std::size_t i = 0; i < layers.materials.size(); ++i) {
    bytes_[i] = static_cast<std::uint8_t>(bytes_are_materials_ ? to_integer(layers.materials[i]) : i);
  }
  const std::uint8_t* tops = layers.tops.data();
  for (std::size_t plane = 0; plane < layers.plane_count(); ++plane) {
    for (std::size_t z = 0; z < kChunkSize; ++z, tops += kChunkSize) {
      std::uint8_t low = kChunkSize;
      std::uint8_t high = 0;
      for (std::size_t x = 0; x < kChunkSize; ++x) {
        low = std::min(low, tops[x]);
        high = std::max(high, tops[x]);
      }
      extents_[z][plane] = {low, high};
    }
  }
}

void Slices::next(MaterialId* slice) {
  for (std::size_t z = 0; z < kChunkSize; ++z) write_line(z, slice + z * kChunkSize);
  ++y_;
}

void Slices::write_line(std::size_t z, MaterialId* voxels) {
  const std::size_t planes = layers_.plane_count();
  const auto& extents = extents_[z];
  std::size_t plane = under_[z];
  while (plane < planes && extents[plane].high <= y_) ++plane;
  under_[z] = static_cast<std::uint8_t>(plane);
  if (plane == planes || extents[plane].low > y_) {
    const MaterialId whole = layers_.materials[plane];
    for (std::size_t x = 0; x < kChunkSize; ++x) voxels[x] = whole;
    return;
  }
  // Where planes cut the line, what lies above each takes the columns in which it is not higher.
  const std::uint8_t y = y_;
  std::array<std::uint8_t, kChunkSize> row;
  row.fill(bytes_[plane]);
  for (; plane < planes && extents[plane].low <= y; ++plane) {
    const std::uint8_t* tops = layers_.tops.data() + plane * kChunkArea + z * kChunkSize;
    const std::uint8_t above = bytes_[plane + 1];
    for (std::size_t x = 0; x < kChunkSize; ++x) row[x] = tops[x] <= y ? above : row[x];
  }
  if (bytes_are_materials_) {
    for (std::size_t x = 0; x < kChunkSize; ++x) voxels[x] = MaterialId{row[x]};
  } else {
    for (std::size_t x = 0; x < kChunkSize; ++x) voxels[x] = layers_.materials[row[x]];
  }
}

}  // namespace talus
