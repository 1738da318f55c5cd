// Voxels of any shape, each coded by prediction from its neighbours: FORMAT.md, "Volume".
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>
#include <talus/voxel/codec.h>

#include "volume_kernels.h"

namespace talus::codec {

/// The probabilities of a table; null if the table does not exist.
[[nodiscard]] const VolumeIntervals* volume_intervals(std::size_t table);

/// Appends everything after the header. Returns false and leaves `out` unchanged if the voxels are noise,
/// exceptions and escapes have more than 256 materials, or the result would not be smaller than raw voxels.
/// Stores in `changes` the number of voxels that differ from the one to their west; 0 for noise.
[[nodiscard]] bool encode_volume(const DenseVoxels& voxels, std::vector<std::byte>& out,
                                 const VolumeKernels& kernels = volume_kernels(),
                                 std::size_t* changes = nullptr);

[[nodiscard]] tl::expected<Chunk, DecodeError> decode_volume(std::span<const std::byte> body,
                                                             const VolumeKernels& kernels = volume_kernels());

}  // namespace talus::codec
