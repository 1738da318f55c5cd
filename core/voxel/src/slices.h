// Layers as voxels, one horizontal slice after another from the bottom up: the order in which dense voxels
// lie, so that they are written, or hashed, in one go.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/voxel/chunk.h>

namespace talus {

class Slices {
 public:
  /// `layers` must be valid() and outlive the slices.
  explicit Slices(const Layers& layers);

  /// Writes the next slice, z slowest, then x: 1024 voxels. For 32 times.
  void next(MaterialId* slice);

 private:
  /// Where one line of 32 columns of a plane lies.
  struct Extent {
    std::uint8_t low = 0;
    std::uint8_t high = 0;
  };
  static constexpr std::size_t kMaxPlanes = Layers::kMaxMaterials - 1;

  void write_line(std::size_t z, MaterialId* voxels);

  const Layers& layers_;
  std::uint8_t y_ = 0;
  /// Lines are put together in bytes: the material where all fit in one, else its place in the list.
  bool bytes_are_materials_;
  std::array<std::uint8_t, Layers::kMaxMaterials> bytes_;
  std::array<std::array<Extent, kMaxPlanes>, kChunkSize> extents_;  // a line: of each plane
  std::array<std::uint8_t, kChunkSize> under_{};  // a line: the first plane that does not lie wholly below y_
};

}  // namespace talus
