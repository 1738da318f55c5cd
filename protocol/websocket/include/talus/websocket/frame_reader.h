// Reads what the other end of a WebSocket sends: a stream of bytes in frames, masked where a client sends
// them. No I/O, and no payload is kept.
// Source: RFC 6455 (The WebSocket Protocol), section 5.
//
// Message boundaries mean nothing here, so binary frames and their continuations are bytes one after the
// other. Text has no meaning, and no extension is negotiated.
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

/// Why nothing more is read. As a std::error_code its message is one line.
enum class End : std::uint8_t {
  none,
  closed,  // by the other end
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
/// With which code to close then.
[[nodiscard]] CloseCode close_code(End end);

/// Whose frames are read. A client masks them, a server must not (section 5.1).
enum class Sender : std::uint8_t { client, server };

class FrameReader {
 public:
  explicit FrameReader(Sender sender) : sender_{sender} {}

  /// Of a control frame (section 5.5).
  static constexpr std::size_t kMaxControlBytes = 125;

  /// Takes all of `bytes`, and leaves the payload of data frames in their place, at the front; returns how
  /// long it is. After the end nothing more is taken.
  [[nodiscard]] std::size_t take(std::span<std::byte> bytes);

  [[nodiscard]] End end() const { return end_; }

  /// Whether a Ping waits for its Pong. Of several only the last is answered (section 5.5.3).
  [[nodiscard]] bool has_ping() const { return has_ping_; }
  /// Its payload.
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

  /// How long the head is, as far as its first bytes tell.
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
  bool in_frame_ = false;    // the head is whole
  bool in_message_ = false;  // the next data frame continues it
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
