// The operators' HTTP: /metrics, /-/healthy, /-/ready. Nothing of it is for players or for the open network.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <tl/expected.hpp>

namespace talus::server {

class AdminServer {
 public:
  /// Open at once.
  static constexpr std::size_t kMostConnections = 32;

  /// Asked on the io_context's thread, for each request.
  struct Answers {
    std::function<std::string()> metrics;
    std::function<bool()> ready;  // false: clients are not to be sent here
  };

  /// Listens and serves on `io`, which one thread runs and which outlives it. An error says what is wrong
  /// with the address.
  [[nodiscard]] static tl::expected<AdminServer, std::string> open(asio::io_context& io,
                                                                   const asio::ip::tcp::endpoint& wanted,
                                                                   Answers answers);

  AdminServer(AdminServer&&) noexcept;
  AdminServer& operator=(AdminServer&&) noexcept;
  /// On the io_context's thread, or when that has ended.
  ~AdminServer();

  /// With the port that it got.
  [[nodiscard]] const asio::ip::tcp::endpoint& address() const;

 private:
  struct Http;
  explicit AdminServer(std::unique_ptr<Http> http);
  std::unique_ptr<Http> http_;
};

}  // namespace talus::server
