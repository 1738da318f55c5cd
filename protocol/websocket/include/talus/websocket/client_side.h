// A client's side of one WebSocket: the opening handshake, then bytes out in masked frames and bytes in,
// whatever messages they come in. No I/O: the caller moves the bytes, and gives what is random.
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

/// Why nothing more is read.
struct Failure {
  enum class Kind : std::uint8_t {
    closed,    // the server sent a Close
    refused,   // it answered the handshake by `status`
    violation  // it broke HTTP or the WebSocket protocol
  };
  Kind kind{};
  std::string text;                       // one line
  int status = 0;                         // of HTTP, where refused
  std::uint32_t retry_after_seconds = 0;  // where refused; 0: no hint
};

class ClientSide {
 public:
  /// Of the server's answer to the handshake; a longer one is a violation.
  static constexpr std::size_t kMaxAnswerBytes = std::size_t{16} * 1024;

  /// `host`: as in a Host field. `nonce`: random bytes.
  ClientSide(std::string_view host, std::string_view path, std::span<const std::byte, kNonceBytes> nonce);

  /// The first that the caller sends; nothing else before is_open().
  [[nodiscard]] const std::string& request() const { return request_; }
  [[nodiscard]] bool is_open() const { return open_; }

  /// Takes all of `bytes`, and leaves what the frames carry in their place, at the front; returns how long it
  /// is. After a failure nothing more is taken, but what came before it is right.
  [[nodiscard]] std::size_t take(std::span<std::byte> bytes);
  [[nodiscard]] const std::optional<Failure>& failure() const { return failure_; }

  /// Appends a message with `payload`.
  static void append(std::vector<std::byte>& output, std::span<const std::byte> payload,
                     std::array<std::byte, 4> mask) {
    append_binary(output, payload, mask);
  }
  /// Whether a Pong or a Close waits to be sent.
  [[nodiscard]] bool has_control() const { return reader_.has_ping() || close_waits_.has_value(); }
  /// Appends the one that waits first. Only while has_control().
  void append_control(std::vector<std::byte>& output, std::array<std::byte, 4> mask);

 private:
  /// Returns how many bytes of `text` belong to the answer.
  std::size_t take_answer(std::string_view text);
  void check_answer();
  void fail(Failure::Kind kind, std::string text);

  std::string accept_;
  std::string request_;
  std::string answer_;  // as far as it has come
  bool open_ = false;
  FrameReader reader_{Sender::server};
  std::optional<CloseCode> close_waits_;
  std::optional<Failure> failure_;
};

}  // namespace talus::websocket
