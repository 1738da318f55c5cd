// A TCP proxy on loopback that does to connections what networks do. It runs in a thread of its own until its
// object ends.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <thread>

#include <asio/awaitable.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>

namespace talus::load {

/// What happens to the bytes of one direction.
struct Faults {
  std::chrono::milliseconds delay{0};
  std::chrono::milliseconds jitter{0};            // up to so much more, bytes never overtaking each other
  std::uint64_t bytes_per_second = 0;             // 0: as fast as they come
  std::optional<std::uint64_t> cut_after;         // bytes: then both ends are reset
  std::optional<std::uint64_t> half_close_after;  // bytes: then this direction ends, and the other goes on
  std::uint64_t queue_bytes =
      256 * 1024;                // on their way; beyond them the sender is held up, as by a full pipe
  std::uint64_t flip_every = 0;  // bytes: the last of so many has a bit flipped; 0: none
};

class FaultProxy {
 public:
  static constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();

  /// The first `faulty` connections suffer; those after are left alone. The seed decides the jitter.
  FaultProxy(std::uint16_t server_port, Faults to_server, Faults to_client, std::uint64_t faulty = kAll,
             std::uint64_t seed = 1);
  ~FaultProxy();
  FaultProxy(const FaultProxy&) = delete;
  FaultProxy& operator=(const FaultProxy&) = delete;

  /// Of 127.0.0.1.
  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// So far.
  [[nodiscard]] std::uint64_t connections() const { return connections_; }

 private:
  struct Pair;
  struct Lane;

  asio::awaitable<void> accept();
  asio::awaitable<void> serve(asio::ip::tcp::socket client, std::uint64_t number);

  asio::io_context io_{1};
  asio::ip::tcp::acceptor acceptor_;
  asio::ip::tcp::endpoint server_;
  Faults to_server_, to_client_;
  std::uint64_t faulty_, seed_;
  std::uint16_t port_;
  std::atomic<std::uint64_t> connections_{0};
  std::thread thread_;
};

}  // namespace talus::load
