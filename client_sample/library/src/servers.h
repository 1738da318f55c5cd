// Which server is next, and which of the addresses of its name. No I/O.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include <asio/ip/tcp.hpp>

#include <talus/client/clock.h>
#include <talus/client/options.h>

namespace talus::client {

class Servers {
 public:
  /// `seed`: of what is random; none: every client's is its own.
  Servers(ServerAddress first, const std::vector<ServerAddress>& more, std::optional<std::uint64_t> seed);

  [[nodiscard]] const ServerAddress& current() const { return servers_[current_].address; }
  [[nodiscard]] std::size_t count() const { return servers_.size(); }
  /// The current one failed, or goes away and asked for that wait before anybody comes back: the next one is
  /// current from now on. Returns how long that asked to wait.
  std::chrono::milliseconds leave(Clock::Time now, std::chrono::milliseconds retry_after);

  /// In which order to try the addresses of the current one's name: of each family at random, so that
  /// players spread where a name has the addresses of several servers, but last the one that was reached
  /// before. Families stay in the system's order.
  [[nodiscard]] std::vector<asio::ip::tcp::endpoint> in_order(
      const asio::ip::tcp::resolver::results_type& found);
  void reached(const asio::ip::tcp::endpoint& address) { reached_ = address; }

 private:
  struct Server {
    ServerAddress address;
    Clock::Time not_before{};
  };

  std::vector<Server> servers_;
  std::size_t current_ = 0;
  std::optional<asio::ip::tcp::endpoint> reached_;
  std::mt19937_64 random_;
};

}  // namespace talus::client
