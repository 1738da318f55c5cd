// Voxels as runs in dense order, for content that neighbours predict poorly: FORMAT.md, "Runs".
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>
#include <talus/voxel/codec.h>

#include "volume_kernels.h"

namespace talus::codec {

/// Appends everything after the two header bytes. Returns false and leaves `out` unchanged if there are more
/// than 256 materials or the result would reach `limit` bytes.
[[nodiscard]] bool encode_runs(const DenseVoxels& voxels, std::size_t limit, std::vector<std::byte>& out,
                               const VolumeKernels& kernels = volume_kernels());

[[nodiscard]] tl::expected<Chunk, DecodeError> decode_runs(std::span<const std::byte> body,
                                                           const VolumeKernels& kernels = volume_kernels());

}  // namespace talus::codec
