// Reads one direction of a WebSocket: a byte stream in frames, masked if a client sends them. No I/O; payload
// is not stored.
// Source: RFC 6455 (The WebSocket Protocol), section 5.
//
// Message boundaries are ignored, so binary frames and their continuations form one byte stream. Text frames
// are rejected, and no extension is negotiated.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <system_error>
#include <type_traits>

namespace talus::websocket {

/// Codes of the Close frames sent here (section 7.4.1).
enum class CloseCode : std::uint16_t {
  normal = 1000,
  protocol_error = 1002,
  unsupported_data = 1003,
  invalid_payload = 1007,
};

/// Reason why reading stopped. As a std::error_code its message is one line.
enum class End : std::uint8_t {
  none,
  closed,  // by the peer
  not_masked,
  masked,
  reserved_bit,
  unknown_opcode,
  text,
  lone_continuation,
  nested_message,
  too_long,
  fragmented_control,
  long_control,
  long_length,
  malformed_close,
  bad_close_code,
  bad_close_reason,
};
[[nodiscard]] std::error_code make_error_code(End end);
/// Code of the Close frame to send in answer.
[[nodiscard]] CloseCode close_code(End end);

/// Sender of the frames. A client must mask them, a server must not (section 5.1).
enum class Sender : std::uint8_t { client, server };

class FrameReader {
 public:
  explicit FrameReader(Sender sender) : sender_{sender} {}

  /// Maximum payload of a control frame (section 5.5).
  static constexpr std::size_t kMaxControlBytes = 125;

  /// Consumes all of `bytes`, moves the payload of data frames to the front of `bytes`, and returns its
  /// length. After the end nothing is consumed.
  [[nodiscard]] std::size_t take(std::span<std::byte> bytes);

  [[nodiscard]] End end() const { return end_; }

  /// True if a Pong must be sent. Only the last of several Pings is answered (section 5.5.3).
  [[nodiscard]] bool has_ping() const { return has_ping_; }
  /// The Ping's payload.
  [[nodiscard]] std::span<const std::byte> ping() const { return std::span{ping_}.first(ping_bytes_); }
  void pop_ping() { has_ping_ = false; }

 private:
  enum class Opcode : std::uint8_t {
    continuation = 0,
    text = 1,
    binary = 2,
    close = 8,
    ping = 9,
    pong = 10,
  };

  /// Length of the header, as far as its first bytes determine it.
  [[nodiscard]] std::size_t head_bytes() const;
  void begin_frame();
  [[nodiscard]] std::uint64_t payload_bytes() const;
  void end_frame();
  [[nodiscard]] bool is_control() const { return static_cast<std::uint8_t>(opcode_) >= 8; }

  Sender sender_;
  std::array<std::byte, 14> head_{};  // flags and opcode, length, mask
  std::size_t head_filled_ = 0;
  std::array<std::byte, 4> mask_{};
  Opcode opcode_ = Opcode::binary;
  bool last_ = true;         // of its message
  bool in_frame_ = false;    // the header is complete
  bool in_message_ = false;  // the next data frame is a continuation
  std::uint64_t frame_bytes_ = 0;
  std::uint64_t frame_taken_ = 0;
  std::array<std::byte, kMaxControlBytes> control_{};

  bool has_ping_ = false;
  std::size_t ping_bytes_ = 0;
  std::array<std::byte, kMaxControlBytes> ping_{};

  End end_ = End::none;
};

}  // namespace talus::websocket

template <>
struct std::is_error_code_enum<talus::websocket::End> : std::true_type {};
