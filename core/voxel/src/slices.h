// Layers as voxels, one horizontal slice after another from the bottom up: the order in which dense voxels
// lie, so that they are written, or hashed, in one go.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/voxel/chunk.h>

#include "kernels.h"

namespace talus {

class Slices {
 public:
  /// `layers` must be valid() and outlive the slices.
  explicit Slices(const Layers& layers);

  /// Writes the next slice, z slowest, then x: 1024 voxels. For 32 times.
  void next(MaterialId* slice);

 private:
  const Layers& layers_;
  const VoxelKernels& kernels_;
  /// Slices are put together in bytes: the material where all fit in one, else its place in the list.
  std::array<std::uint8_t, Layers::kMaxMaterials> bytes_;
  bool bytes_are_materials_;
  std::array<Extent, Layers::kMaxMaterials - 1> extents_;  // of each plane
  std::size_t first_ = 0;  // the first plane that does not lie wholly below the slice
  std::uint8_t y_ = 0;
};

}  // namespace talus
