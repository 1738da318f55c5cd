// A client that speaks frames and keeps no rule: what a test needs to break them. By TCP, or the same bytes
// inside a WebSocket.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <talus/protocol/frame.h>
#include <talus/protocol/message.h>
#include <talus/websocket/client_side.h>

#include "server_process.h"

namespace talus::e2e {

/// A received frame and its verified message.
class ReceivedFrame {
 public:
  explicit ReceivedFrame(protocol::Frame frame);
  [[nodiscard]] wire::Body kind() const { return message_->body_type(); }
  /// The body; fails the test if it is of another kind.
  template <typename Table>
  [[nodiscard]] const Table& as() const {
    check_kind(wire::BodyTraits<Table>::enum_value);
    return *static_cast<const Table*>(message_->body());
  }
  [[nodiscard]] std::size_t bytes() const { return frame_.size(); }

 private:
  void check_kind(wire::Body expected) const;

  protocol::Frame frame_;
  const wire::Message* message_;
};

inline constexpr std::uint32_t kLoopback = 0x7F000001U;  // 127.0.0.1

class RawClient {
 public:
  /// The server does not open the WebSocket, as where it has no memory to spare; says what it answered.
  struct NotOpened : std::runtime_error {
    using std::runtime_error::runtime_error;
  };

  /// Connects to 127.0.0.1, from an address of the loopback network: 127.0.0.1 unless another is given. By
  /// WebSocket `port` is that of the server's HTTP, and it throws NotOpened.
  explicit RawClient(std::uint16_t port, std::uint32_t from = kLoopback,
                     Transport transport = tested_transport());
  ~RawClient();
  RawClient(RawClient&& other) noexcept;
  RawClient& operator=(RawClient&&) = delete;

  /// Sends all of it; false where the server has closed the connection.
  bool send(std::span<const std::byte> bytes);
  /// The same past the WebSocket, whatever that makes of it.
  bool send_raw(std::span<const std::byte> bytes);
  /// Takes what fits into the socket now, or a WebSocket frame of it; the count, or none where the connection
  /// is closed. The rest of a frame goes first with the next call.
  [[nodiscard]] std::optional<std::size_t> send_some(std::span<const std::byte> bytes);
  /// Whatever has come, unread: nothing can be received after it.
  void drop_received();

  /// The next frame; none where the server has closed the connection. Fails the test where neither
  /// happens for a long time.
  [[nodiscard]] std::optional<ReceivedFrame> receive();
  /// The next frame if it begins to come within `patience`.
  [[nodiscard]] std::optional<ReceivedFrame> receive_within(std::chrono::milliseconds patience);
  /// The next frame, which must be one.
  [[nodiscard]] ReceivedFrame expect();
  /// Whether the server closes the connection, having said nothing more.
  [[nodiscard]] bool closed();

  /// As expect(), and it must be of this kind: returns the frame.
  template <typename Table>
  [[nodiscard]] ReceivedFrame expect_kind() {
    ReceivedFrame received = expect();
    (void)received.as<Table>();
    return received;
  }

  /// Sends no more, and still reads.
  void end_sending();
  void close();
  /// Closes with a RST.
  void reset();

 private:
  void open_websocket();
  [[noreturn]] void not_opened(const std::string& why);
  /// `bytes` in messages and fragments of many sizes, behind what the WebSocket itself has to say.
  [[nodiscard]] std::vector<std::byte> wrapped(std::span<const std::byte> bytes);
  void take(std::span<std::byte> bytes);
  [[nodiscard]] bool fill(int patience_ms);

  int socket_;
  std::optional<websocket::ClientSide> websocket_;
  std::vector<std::byte> unsent_;  // of a WebSocket frame that send_some() has begun
  std::minstd_rand sizes_;
  bool ended_ = false;
  protocol::FrameReader frames_{protocol::kMaxFrameBytes};
  std::deque<protocol::Frame> whole_;
};

/// A client that has said Hello and heard Welcome.
[[nodiscard]] RawClient greeted(std::uint16_t port, std::uint64_t window_bytes = 0,
                                std::uint32_t from = kLoopback);

}  // namespace talus::e2e
