// Voxels of any shape, each coded by what its neighbours let expect: FORMAT.md, "Volume".
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>
#include <talus/voxel/codec.h>

#include "volume_kernels.h"

namespace talus::codec {

/// The probabilities of a table; null where there is no such table.
[[nodiscard]] const VolumeIntervals* volume_intervals(std::size_t table);

/// Appends what follows the two header bytes. False, with `out` as it was, where the voxels are noise, where
/// exceptions and escapes have more than 256 materials, or where the result would not be smaller than raw
/// voxels. `changes` gets how many voxels differ from the one to their west; 0 of noise.
[[nodiscard]] bool encode_volume(const DenseVoxels& voxels, std::vector<std::byte>& out,
                                 const VolumeKernels& kernels = volume_kernels(),
                                 std::size_t* changes = nullptr);

[[nodiscard]] tl::expected<Chunk, DecodeError> decode_volume(std::span<const std::byte> body,
                                                             const VolumeKernels& kernels = volume_kernels());

}  // namespace talus::codec
