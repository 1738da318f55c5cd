// Voxels as runs in dense order, for content of which neighbours tell little: FORMAT.md, "Runs".
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>
#include <talus/voxel/codec.h>

#include "volume_kernels.h"

namespace talus::codec {

/// Appends what follows the two header bytes. False, with `out` as it was, where there are more than 256
/// materials or the result would reach `limit` bytes.
[[nodiscard]] bool encode_runs(const DenseVoxels& voxels, std::size_t limit, std::vector<std::byte>& out,
                               const VolumeKernels& kernels = volume_kernels());

[[nodiscard]] tl::expected<Chunk, DecodeError> decode_runs(std::span<const std::byte> body,
                                                           const VolumeKernels& kernels = volume_kernels());

}  // namespace talus::codec
