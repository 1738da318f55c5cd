// Layers as bytes: FORMAT.md, "Layered".
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>
#include <talus/voxel/codec.h>

namespace talus::codec {

/// Appends what follows the two header bytes. False, with `out` as it was, where that would take more than
/// `limit` bytes, or about as much as raw voxels do.
[[nodiscard]] bool encode_layered(const Layers& layers, std::size_t limit, std::vector<std::byte>& out);

[[nodiscard]] tl::expected<Chunk, DecodeError> decode_layered(std::span<const std::byte> body);

}  // namespace talus::codec
