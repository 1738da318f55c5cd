// Talks HTTP/1.1 to a talusd.
#pragma once

#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/read.hpp>
#include <asio/read_until.hpp>
#include <asio/write.hpp>
#include <catch2/catch.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace talus::e2e {

inline const std::vector<std::string> kWithHttp{"--http", "127.0.0.1:0"};

struct Answer {
  int status = 0;
  std::string head;  // with the status line
  std::string body;

  /// A field's value; empty: there is none.
  [[nodiscard]] std::string field(const std::string& name) const {
    const std::size_t at = head.find("\r\n" + name + ": ");
    if (at == std::string::npos) return "";
    const std::size_t from = at + name.size() + 4;
    return head.substr(from, head.find("\r\n", from) - from);
  }
};

/// A connection that is kept; blocking.
class HttpClient {
 public:
  /// Connects to 127.0.0.1, from an address of the loopback network.
  explicit HttpClient(std::uint16_t port, std::uint32_t from = 0x7F000001U) {
    socket_.open(asio::ip::tcp::v4());
    if (from != 0x7F000001U) socket_.bind({asio::ip::address_v4{from}, 0});
    socket_.connect({asio::ip::address_v4::loopback(), port});
  }

  void send(const std::string& text) { asio::write(socket_, asio::buffer(text)); }
  static std::string request(const std::string& target, const std::string& fields = "") {
    return "GET " + target + " HTTP/1.1\r\nHost: talus\r\n" + fields + "\r\n";
  }
  /// Reads an answer's head; its body stays unread.
  std::string read_head() {
    const std::size_t head = asio::read_until(socket_, asio::dynamic_buffer(input_), "\r\n\r\n");
    return input_.substr(0, head);
  }
  /// `to_head`: the answer to a HEAD request, which has no body.
  Answer read(bool to_head = false) {
    Answer answer;
    const std::size_t head = asio::read_until(socket_, asio::dynamic_buffer(input_), "\r\n\r\n");
    answer.head = input_.substr(0, head);
    input_.erase(0, head);
    answer.status = std::stoi(answer.head.substr(9));
    const std::string length = answer.field("Content-Length");
    const std::size_t bytes = length.empty() || to_head ? 0 : std::stoul(length);
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

/// "/v1/FINGERPRINT/CODEC" of the server.
inline std::string root_of(HttpClient& client) {
  const Answer world = client.get("/v1/world");
  REQUIRE(world.status == 200);
  return "/v1/" + nlohmann::json::parse(world.body)["fingerprint"].get<std::string>() + "/4";
}

}  // namespace talus::e2e
