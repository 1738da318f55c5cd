// Connections for which there is no place: told so, then closed.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

#include <asio/ip/tcp.hpp>

namespace talus::server {

class Refusals {
 public:
  /// Refusals under way; beyond them a socket is closed without a word.
  static constexpr std::size_t kMost = 64;

  /// Sends Error{overloaded, text, retry_after} and closes once the client has had time to read it. Must
  /// outlive the socket's io_context.
  void refuse(asio::ip::tcp::socket socket, const std::string& text, std::chrono::milliseconds retry_after);

 private:
  std::atomic<std::size_t> under_way_{0};
};

}  // namespace talus::server
