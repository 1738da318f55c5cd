#include "slices.h"

#include <algorithm>

namespace talus {

Slices::Slices(const Layers& layers) : layers_{layers}, kernels_{voxel_kernels()} {
  bytes_are_materials_ = std::all_of(layers.materials.begin(), layers.materials.end(),
                                     [](MaterialId material) { return to_integer(material) < 256; });
  for (std::size_t i = 0; i < layers.materials.size(); ++i) {
    bytes_[i] = static_cast<std::uint8_t>(bytes_are_materials_ ? to_integer(layers.materials[i]) : i);
  }
  for (std::size_t plane = 0; plane < layers.plane_count(); ++plane) {
    extents_[plane] = kernels_.extent(layers.plane(plane).data());
  }
}

void Slices::next(MaterialId* slice) {
  const std::size_t planes = layers_.plane_count();
  while (first_ < planes && extents_[first_].high <= y_) ++first_;
  CutSlice cut{layers_.tops.data() + first_ * kChunkArea, 0, bytes_.data() + first_, y_};
  while (first_ + cut.planes < planes && extents_[first_ + cut.planes].low <= y_) ++cut.planes;
  ++y_;
  if (bytes_are_materials_) {
    kernels_.slice(cut, slice);
    return;
  }
  std::array<std::uint8_t, kChunkArea> places;
  kernels_.slice_bytes(cut, places.data());
  for (std::size_t i = 0; i < kChunkArea; ++i) slice[i] = layers_.materials[places[i]];
}

}  // namespace talus
