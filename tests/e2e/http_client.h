// A client of the server's HTTP that keeps its connection.
#pragma once

#include <cstdint>
#include <string>
#include <system_error>

#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/read.hpp>
#include <asio/read_until.hpp>
#include <asio/write.hpp>

namespace talus::e2e {

struct Answer {
  int status = 0;
  std::string head;
  std::string body;
};

/// Blocks.
class HttpClient {
 public:
  explicit HttpClient(std::uint16_t port) { socket_.connect({asio::ip::address_v4::loopback(), port}); }

  void send(const std::string& text) { asio::write(socket_, asio::buffer(text)); }
  static std::string request(const std::string& target, const std::string& fields = "") {
    return "GET " + target + " HTTP/1.1\r\nHost: talus\r\n" + fields + "\r\n";
  }
  Answer read() {
    Answer answer;
    const std::size_t head = asio::read_until(socket_, asio::dynamic_buffer(input_), "\r\n\r\n");
    answer.head = input_.substr(0, head);
    input_.erase(0, head);
    answer.status = std::stoi(answer.head.substr(9));
    const std::size_t at = answer.head.find("Content-Length: ");
    const std::size_t bytes = at == std::string::npos ? 0 : std::stoul(answer.head.substr(at + 16));
    if (input_.size() < bytes) {
      asio::read(socket_, asio::dynamic_buffer(input_), asio::transfer_exactly(bytes - input_.size()));
    }
    answer.body = input_.substr(0, bytes);
    input_.erase(0, bytes);
    return answer;
  }
  Answer get(const std::string& target, const std::string& fields = "") {
    send(request(target, fields));
    return read();
  }
  /// Whether the server has closed the connection; what it said before that is dropped.
  bool closed() {
    std::error_code ended;
    asio::read(socket_, asio::dynamic_buffer(input_), ended);
    return ended == asio::error::eof || ended == asio::error::connection_reset;
  }
  asio::ip::tcp::socket& socket() { return socket_; }
  std::string& input() { return input_; }

 private:
  asio::io_context io_;
  asio::ip::tcp::socket socket_{io_};
  std::string input_;
};

}  // namespace talus::e2e
