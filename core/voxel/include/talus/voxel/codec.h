// Encodes a chunk as bytes. FORMAT.md in this module specifies every byte, with worked examples.
//
// The encoder is a pure function of the voxels and their form: the same chunk gives the same bytes on every
// machine and compiler, as no external compressor is used. The decoder accepts any bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>

namespace talus {

/// Version negotiated by sessions. The first byte of a payload is 4, or 3 for a layered chunk, whose encoding
/// has not changed since version 3.
inline constexpr std::uint8_t kCodecVersion = 4;

/// Maximum payload that the encoder writes and the decoder accepts: raw voxels after two header bytes.
inline constexpr std::size_t kMaxPayloadBytes = 2 + sizeof(DenseVoxels);

enum class DecodeError : std::uint8_t {
  empty,             // empty input
  unknown_version,   // the first byte is an unsupported codec version
  unknown_encoding,  // the second byte is not a known encoding
  truncated,         // the payload ends before the chunk is complete
  too_long,          // bytes follow the end of the chunk, or the payload exceeds kMaxPayloadBytes
  bad_materials,     // the list of materials is empty, too long, not minimal, or not in the required order
  bad_number,        // a number is out of range, or has more bytes than it needs
  bad_ending,        // the last bytes differ from the encoder's for this chunk
};

/// One line for humans: the error and what is expected.
[[nodiscard]] std::string_view describe(DecodeError error);

/// Appends `chunk` in the form of layers if it is held as layers and they take at most 1 KiB; otherwise in
/// the shortest form: FORMAT.md, "What the encoder chooses". A chunk with overrides gives the bytes of its
/// dense voxels. Appends at most kMaxPayloadBytes. Uses about 300 KiB of stack, and 64 KiB of heap for layers
/// that are not written as layers.
void encode(const Chunk& chunk, std::vector<std::byte>& out);

/// Decodes a complete payload. Safe for any bytes: invalid ones give an error, and nothing is read beyond the
/// payload. Allocates only the chunk (at most 64 KiB) and uses about 70 KiB of stack.
[[nodiscard]] tl::expected<Chunk, DecodeError> decode(std::span<const std::byte> payload);

}  // namespace talus
