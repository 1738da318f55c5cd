// Planes as voxels, once for each instruction set.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/vectors/instruction_set.h>
#include <talus/voxel/chunk.h>

namespace talus {

/// Where a plane lies: its lowest and highest row.
struct Extent {
  std::uint8_t low = 0;
  std::uint8_t high = 0;
};

/// A horizontal slice of voxels at row y and the planes that cut it, lowest first.
struct CutSlice {
  const std::uint8_t* tops = nullptr;  // of the first plane; the others follow
  std::size_t planes = 0;
  const std::uint8_t* bytes = nullptr;  // what to write: under the first plane, then above each
  std::uint8_t y = 0;
};

struct VoxelKernels {
  Extent (*extent)(const std::uint8_t* plane);
  /// The 1024 voxels of a slice: materials whose numbers are the bytes.
  void (*slice)(const CutSlice& slice, MaterialId* voxels);
  /// The bytes themselves.
  void (*slice_bytes)(const CutSlice& slice, std::uint8_t* bytes);
};

[[nodiscard]] const VoxelKernels& voxel_kernels(InstructionSet set);

/// Those of instruction_set().
[[nodiscard]] const VoxelKernels& voxel_kernels();

}  // namespace talus
