// Layers as bytes: FORMAT.md, "Layered".
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>
#include <talus/voxel/codec.h>

namespace talus::codec {

/// Appends what follows the two header bytes.
void encode_layered(const Layers& layers, std::vector<std::byte>& out);

[[nodiscard]] tl::expected<Chunk, DecodeError> decode_layered(std::span<const std::byte> body);

}  // namespace talus::codec
