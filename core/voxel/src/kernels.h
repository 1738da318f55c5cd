// Conversion of planes to voxels, one implementation per instruction set.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/vectors/instruction_set.h>
#include <talus/voxel/chunk.h>

namespace talus {

/// Lowest and highest row of a plane.
struct Extent {
  std::uint8_t low = 0;
  std::uint8_t high = 0;
};

/// A horizontal slice of voxels at row y and the planes that cut it, lowest first.
struct CutSlice {
  const std::uint8_t* tops = nullptr;  // tops of the first plane, followed by the others
  std::size_t planes = 0;
  const std::uint8_t* bytes = nullptr;  // values to write: below the first plane, then above each plane
  std::uint8_t y = 0;
};

struct VoxelKernels {
  Extent (*extent)(const std::uint8_t* plane);
  /// Writes the 1,024 voxels of a slice, taking the bytes as material ids.
  void (*slice)(const CutSlice& slice, MaterialId* voxels);
  /// Writes the bytes unchanged.
  void (*slice_bytes)(const CutSlice& slice, std::uint8_t* bytes);
};

[[nodiscard]] const VoxelKernels& voxel_kernels(InstructionSet set);

/// The kernels of instruction_set().
[[nodiscard]] const VoxelKernels& voxel_kernels();

}  // namespace talus
