// Palettes of version 3, which are read but no longer written: FORMAT.md, "Version 3: palette".
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>
#include <talus/voxel/codec.h>

namespace talus::codec {

inline constexpr std::size_t kMaxPalette = 256;

[[nodiscard]] tl::expected<Chunk, DecodeError> decode_palette(std::span<const std::byte> body);

}  // namespace talus::codec
