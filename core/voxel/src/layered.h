// Encoding of layers: FORMAT.md, "Layered".
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>
#include <talus/voxel/codec.h>

namespace talus::codec {

/// Appends everything after the two header bytes. Returns false and leaves `out` unchanged if that would take
/// more than `limit` bytes, or nearly as many as raw voxels.
[[nodiscard]] bool encode_layered(const Layers& layers, std::size_t limit, std::vector<std::byte>& out);

[[nodiscard]] tl::expected<Chunk, DecodeError> decode_layered(std::span<const std::byte> body);

}  // namespace talus::codec
