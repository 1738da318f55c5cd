// Frames: how messages lie in a byte stream. A frame is a u32 little-endian length and that many bytes
// of one FlatBuffers Message, which is what FlatBuffers calls a size-prefixed buffer.
//
// No sockets here: bytes in, frames out. A reader belongs to one connection and one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace talus::protocol {

inline constexpr std::size_t kPrefixBytes = 4;

/// No Message is shorter: prefix, root offset and an empty table.
inline constexpr std::uint32_t kMinFrameBytes = 12;

/// The largest frame that either side may ever allow, prefix included; what each really allows is in
/// limits.h and in Welcome.
inline constexpr std::uint32_t kMaxFrameBytes = 1U << 24;

/// A length that no frame of this connection can have. The connection cannot go on.
struct FrameError {
  std::uint64_t claimed_bytes = 0;  // prefix included, so up to 2^32 + 3
  std::uint32_t limit_bytes = 0;
  [[nodiscard]] std::string message() const;
};

/// Cuts a stream of bytes into frames, however the stream was cut into pieces. Holds one frame at the
/// most, and grows with the bytes that have arrived, never with the length that was claimed.
class FrameReader {
 public:
  /// `limit_bytes` counts the prefix too; kMinFrameBytes <= limit_bytes <= kMaxFrameBytes.
  explicit FrameReader(std::uint32_t limit_bytes);

  /// Takes bytes from the front of `bytes` until a frame is whole or none are left; returns how many it
  /// took. While has_frame(), takes none. After an error every call returns the error.
  [[nodiscard]] tl::expected<std::size_t, FrameError> feed(std::span<const std::byte> bytes);

  [[nodiscard]] bool has_frame() const;

  /// The whole frame, prefix included, at an address aligned for FlatBuffers. Valid until pop(). Only
  /// while has_frame().
  [[nodiscard]] std::span<const std::byte> frame() const;

  /// Forgets the frame, keeping its memory for the next up to a small size.
  void pop();

  /// Whether bytes of an unfinished frame are held: a stream that ends here ended too early.
  [[nodiscard]] bool mid_frame() const;

  /// Memory held for the frame, for whoever accounts for it: at most twice the bytes that have arrived,
  /// or 16 KiB.
  [[nodiscard]] std::size_t held_bytes() const { return buffer_.capacity(); }

 private:
  [[nodiscard]] std::size_t take(std::span<const std::byte> bytes, std::size_t wanted);

  std::uint32_t limit_bytes_;
  std::uint32_t frame_bytes_ = 0;  // 0 until the prefix is whole
  std::optional<FrameError> error_;
  std::vector<std::byte> buffer_;
};

}  // namespace talus::protocol
