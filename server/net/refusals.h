// Refused connections: each gets a message and is then closed.
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include <asio/ip/tcp.hpp>

namespace talus::server {

class Refusals {
 public:
  /// Maximum number of refusals in flight; any more are closed without a message.
  static constexpr std::size_t kMax = 64;
  /// Additional refusals on spare descriptors.
  static constexpr std::size_t kMaxSpare = 4;

  /// Sends `message` and closes after the client has had time to read it. Must outlive the socket's
  /// io_context.
  void refuse(asio::ip::tcp::socket socket, std::vector<std::byte> message);

 private:
  std::atomic<std::size_t> in_flight_{0};
  std::atomic<std::size_t> spare_in_flight_{0};
};

}  // namespace talus::server
