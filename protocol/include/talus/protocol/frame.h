// Splits a byte stream into frames. A frame is a little-endian u32 length and that many bytes of one
// FlatBuffers Message: a size-prefixed buffer. PROTOCOL.md, Frames.
//
// No I/O. A reader belongs to one connection and one thread.
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

/// The shortest Message: prefix, root offset and an empty table.
inline constexpr std::uint32_t kMinFrameBytes = 12;

/// Maximum limit of a FrameReader, prefix included. limits.h and Welcome define what each side allows.
inline constexpr std::uint32_t kMaxFrameBytes = 1U << 24;

/// A length that no frame of this connection may have; the connection must be closed.
struct FrameError {
  std::uint64_t claimed_bytes = 0;  // prefix included, so up to 2^32 + 3
  std::uint32_t limit_bytes = 0;
  [[nodiscard]] std::string message() const;
};

/// Holds at most one frame. Its memory grows with the bytes received, never with the length claimed.
class FrameReader {
 public:
  /// `limit_bytes` includes the prefix. REQUIRES: kMinFrameBytes <= limit_bytes <= kMaxFrameBytes.
  explicit FrameReader(std::uint32_t limit_bytes);

  /// Sets the limit of further frames, as in the constructor. REQUIRES: no part of a frame is held.
  void set_limit(std::uint32_t limit_bytes);

  /// Consumes bytes of `bytes` up to the end of a frame, and returns their number; 0 while has_frame(). After
  /// an error every call returns that error.
  [[nodiscard]] tl::expected<std::size_t, FrameError> feed(std::span<const std::byte> bytes);

  [[nodiscard]] bool has_frame() const;

  /// The complete frame, prefix included, aligned for FlatBuffers. Valid until pop(). REQUIRES: has_frame().
  [[nodiscard]] std::span<const std::byte> frame() const;

  /// Drops the frame; keeps up to 16 KiB of its memory for the next one. REQUIRES: has_frame().
  void pop();

  /// True if part of a frame is held: a stream that ends here was truncated.
  [[nodiscard]] bool mid_frame() const;

  /// Memory in use: at most twice the received bytes of the frame, or 16 KiB.
  [[nodiscard]] std::size_t held_bytes() const { return buffer_.capacity(); }

 private:
  [[nodiscard]] std::size_t take(std::span<const std::byte> bytes, std::size_t wanted);

  std::uint32_t limit_bytes_;
  std::uint32_t frame_bytes_ = 0;  // 0 until the prefix is complete
  std::optional<FrameError> error_;
  std::vector<std::byte> buffer_;
};

}  // namespace talus::protocol
