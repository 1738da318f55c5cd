// Framing: cuts a byte stream into frames. A frame is a u32 little-endian length and that many bytes of one
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

/// No Message is shorter: prefix, root offset and an empty table.
inline constexpr std::uint32_t kMinFrameBytes = 12;

/// The largest limit that a FrameReader takes, prefix included. What each side allows is in limits.h and in
/// Welcome.
inline constexpr std::uint32_t kMaxFrameBytes = 1U << 24;

/// A length that no frame of this connection may have; the connection must close.
struct FrameError {
  std::uint64_t claimed_bytes = 0;  // prefix included, so up to 2^32 + 3
  std::uint32_t limit_bytes = 0;
  [[nodiscard]] std::string message() const;
};

/// Holds at most one frame. Its memory grows with the bytes that have arrived, never with the length that was
/// claimed.
class FrameReader {
 public:
  /// REQUIRES: kMinFrameBytes <= limit_bytes <= kMaxFrameBytes. It counts the prefix too.
  explicit FrameReader(std::uint32_t limit_bytes);

  /// As of the constructor; for frames from the next on. REQUIRES: no part of a frame is held.
  void set_limit(std::uint32_t limit_bytes);

  /// Takes bytes from the front of `bytes` until a frame is whole or none are left, and returns how many.
  /// While has_frame() it takes none. After an error every call returns that error.
  [[nodiscard]] tl::expected<std::size_t, FrameError> feed(std::span<const std::byte> bytes);

  [[nodiscard]] bool has_frame() const;

  /// REQUIRES: has_frame(). The whole frame, prefix included, at an address aligned for FlatBuffers. Valid
  /// until pop().
  [[nodiscard]] std::span<const std::byte> frame() const;

  /// REQUIRES: has_frame(). Drops the frame; keeps up to 16 KiB of its memory for the next.
  void pop();

  /// Whether part of a frame is held: a stream that ends here was cut short.
  [[nodiscard]] bool mid_frame() const;

  /// Memory held: at most twice the bytes of the frame that have arrived, or 16 KiB.
  [[nodiscard]] std::size_t held_bytes() const { return buffer_.capacity(); }

 private:
  [[nodiscard]] std::size_t take(std::span<const std::byte> bytes, std::size_t wanted);

  std::uint32_t limit_bytes_;
  std::uint32_t frame_bytes_ = 0;  // 0 until the prefix is whole
  std::optional<FrameError> error_;
  std::vector<std::byte> buffer_;
};

}  // namespace talus::protocol
