// Converts layers to voxels, one horizontal slice after another from the bottom: the order of dense voxels,
// so that they are written, or hashed, in one pass.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/voxel/chunk.h>

#include "kernels.h"

namespace talus {

class Slices {
 public:
  /// REQUIRES: layers.valid(). `layers` must outlive this object.
  explicit Slices(const Layers& layers);

  /// Writes the next slice of 1,024 voxels, z slowest, then x. May be called 32 times.
  void next(MaterialId* slice);

 private:
  const Layers& layers_;
  const VoxelKernels& kernels_;
  /// Slices are composed in bytes: material ids if all fit a byte, otherwise places in the list.
  std::array<std::uint8_t, Layers::kMaxMaterials> bytes_;
  bool bytes_are_materials_;
  std::array<Extent, Layers::kMaxMaterials - 1> extents_;  // by plane
  std::size_t first_ = 0;  // the first plane that reaches above the bottom of the slice
  std::uint8_t y_ = 0;
};

}  // namespace talus
