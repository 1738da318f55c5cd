// Client side of a WebSocket: the opening handshake, then bytes out in masked frames and bytes in, regardless
// of message boundaries. No I/O: the caller moves the bytes and supplies random ones.
// Source: RFC 6455, sections 4.1, 5 and 7.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <talus/websocket/frame_reader.h>
#include <talus/websocket/frame_writer.h>
#include <talus/websocket/handshake.h>

namespace talus::websocket {

/// Reason why reading stopped.
struct Failure {
  enum class Kind : std::uint8_t {
    closed,    // the server sent a Close
    refused,   // the server answered the handshake with `status`
    violation  // the server violated HTTP or the WebSocket protocol
  };
  Kind kind{};
  std::string text;                       // one line
  int status = 0;                         // HTTP status, if refused
  std::uint32_t retry_after_seconds = 0;  // if refused; 0: no hint
};

class ClientSide {
 public:
  /// Maximum length of the server's handshake answer; a longer one is a violation.
  static constexpr std::size_t kMaxAnswerBytes = std::size_t{16} * 1024;

  /// `host`: value of the Host field. `nonce`: random bytes.
  ClientSide(std::string_view host, std::string_view path, std::span<const std::byte, kNonceBytes> nonce);

  /// The handshake request, to be sent first. Nothing else may be sent before is_open().
  [[nodiscard]] const std::string& request() const { return request_; }
  [[nodiscard]] bool is_open() const { return open_; }

  /// Consumes all of `bytes`, moves the payload of the frames to the front of `bytes`, and returns its
  /// length. After a failure nothing is consumed; payload returned before is valid.
  [[nodiscard]] std::size_t take(std::span<std::byte> bytes);
  [[nodiscard]] const std::optional<Failure>& failure() const { return failure_; }

  /// Appends a frame with `payload`.
  static void append(std::vector<std::byte>& output, std::span<const std::byte> payload,
                     std::array<std::byte, 4> mask) {
    append_binary(output, payload, mask);
  }
  /// True if a Pong or a Close is pending.
  [[nodiscard]] bool has_control() const { return reader_.has_ping() || close_waits_.has_value(); }
  /// Appends the first pending control frame. REQUIRES: has_control().
  void append_control(std::vector<std::byte>& output, std::array<std::byte, 4> mask);

 private:
  /// Returns the number of bytes of `text` that belong to the answer.
  std::size_t take_answer(std::string_view text);
  void check_answer();
  void fail(Failure::Kind kind, std::string text);

  std::string accept_;
  std::string request_;
  std::string answer_;  // the part received
  bool open_ = false;
  FrameReader reader_{Sender::server};
  std::optional<CloseCode> close_waits_;
  std::optional<Failure> failure_;
};

}  // namespace talus::websocket
