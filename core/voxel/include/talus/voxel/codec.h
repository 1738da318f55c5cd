// A chunk as bytes. FORMAT.md beside this module gives every byte and worked examples.
//
// The encoder is a pure function of the voxels' form: the same chunk gives the same bytes on every
// machine and compiler, because no external compressor takes part. The decoder accepts any bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>

namespace talus {

/// What a session agrees on. The first byte of a payload of this codec is 4, or 3 where the chunk is layered:
/// these payloads are as they were in version 3.
inline constexpr std::uint8_t kCodecVersion = 4;

/// What decode still reads, down from kCodecVersion.
inline constexpr std::uint8_t kOldestCodecVersion = 3;

/// The largest payload the encoder makes and the decoder reads: raw voxels after two header bytes.
inline constexpr std::size_t kMaxPayloadBytes = 2 + sizeof(DenseVoxels);

enum class DecodeError : std::uint8_t {
  empty,             // no bytes at all
  unknown_version,   // the first byte is a codec this library does not read
  unknown_encoding,  // the second byte names no encoding
  truncated,         // the bytes end before the chunk does
  too_long,          // bytes follow the chunk's end, or there are more than kMaxPayloadBytes
  bad_materials,  // the list of materials is empty, too long, unordered where it must not be, or not minimal
  bad_number,     // a number is written with more bytes than it needs, or past its range
  bad_ending,     // the last bytes are not those with which the encoder ends this chunk
};

/// One line for people: what is wrong, and what would be right.
[[nodiscard]] std::string_view describe(DecodeError error);

/// Appends `chunk` as layers where it is held as layers and these take at most 1 KiB, else by what voxels
/// take the fewest bytes as: FORMAT.md, "What the encoder chooses". A chunk with overrides gives the bytes of
/// its dense voxels. Never more than kMaxPayloadBytes. Takes some 300 KiB of the stack, and 64 KiB from the
/// heap for layers that are not written as such.
void encode(const Chunk& chunk, std::vector<std::byte>& out);

/// Reads a whole payload. Any bytes are safe: what is not a chunk is an error, no byte past the payload is
/// read, and the memory taken is that of the chunk (64 KiB at most) and some 70 KiB of the stack.
[[nodiscard]] tl::expected<Chunk, DecodeError> decode(std::span<const std::byte> payload);

}  // namespace talus
