// Selects the next server and the address of its name to try. No I/O.
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
  /// `seed` of random choices; nullopt: each client draws its own.
  Servers(ServerAddress first, const std::vector<ServerAddress>& more, std::optional<std::uint64_t> seed);

  [[nodiscard]] const ServerAddress& current() const { return servers_[current_].address; }
  [[nodiscard]] std::size_t count() const { return servers_.size(); }
  /// The current server failed, or went away and asked clients to stay away for `retry_after`. Makes the next
  /// server current and returns the remaining wait that it had asked for.
  std::chrono::milliseconds leave(Clock::Time now, std::chrono::milliseconds retry_after);

  /// Order in which to try the addresses of the current server's name. Families stay in the system's order;
  /// within each family the order is random, so that players spread over several servers of one name, except
  /// that the address reached before comes last.
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
