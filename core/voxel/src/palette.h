// Any voxels as a list of materials and, for each voxel, its place in it: FORMAT.md, "Palette".
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>
#include <talus/voxel/codec.h>

namespace talus::codec {

inline constexpr std::size_t kMaxPalette = 256;

/// Appends what follows the two header bytes. False, with `out` as it was, where the voxels have more than
/// kMaxPalette materials or the result would reach `limit` bytes.
[[nodiscard]] bool encode_palette(std::span<const MaterialId, kChunkVolume> voxels, std::size_t limit,
                                  std::vector<std::byte>& out);

[[nodiscard]] tl::expected<Chunk, DecodeError> decode_palette(std::span<const std::byte> body);

}  // namespace talus::codec
