// The connections of a small HTTP server, at most `max` of them. A new one replaces the longest idle one of
// the address with most, so that a new client is always served, and an address with many connections closes
// no other's. For one thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "net/http/connection.h"
#include "net/stream.h"

namespace talus::server::http {

template <Stream S>
class Connections {
 public:
  /// `max` at least 1. `service` outlives the connections.
  Connections(const Service& service, std::size_t max) : service_{service}, max_{max} {}

  /// Call before the first connection.
  void set_handler(std::shared_ptr<Handler> handler) { handler_ = std::move(handler); }

  /// Call on the stream's executor.
  void add(S stream) { add(std::move(stream), handler_, {}); }
  /// Uses `handler` in place of the common one. `address`: the client's.
  std::shared_ptr<Connection<S>> add(S stream, std::shared_ptr<Handler> handler, std::string address) {
    forget_closed();
    if (open_.size() >= max_) close_one(address);
    auto connection = std::make_shared<Connection<S>>(std::move(stream), service_, std::move(handler));
    open_.push_back({connection, std::move(address)});
    connection->start();
    return connection;
  }

  /// Closes one connection; false if there are no open ones.
  bool make_room() {
    forget_closed();
    if (open_.empty()) return false;
    close_one({});
    return true;
  }

  void clock_moved() {
    for (const Open& each : open_) each.connection->clock_moved();
  }

 private:
  struct Open {
    std::shared_ptr<Connection<S>> connection;  // may be closed
    std::string address;
  };

  void forget_closed() {
    std::erase_if(open_, [](const Open& each) { return !each.connection->open(); });
  }
  /// For a connection of `newcomer`, which counts as one of that address.
  void close_one(const std::string& newcomer) {
    std::map<std::string_view, std::size_t> held{{newcomer, 1}};
    for (const Open& each : open_) ++held[each.address];
    const auto chosen = std::min_element(open_.begin(), open_.end(), [&](const Open& a, const Open& b) {
      if (held[a.address] != held[b.address]) return held[a.address] > held[b.address];
      return a.connection->last_active() < b.connection->last_active();
    });
    chosen->connection->close();
    open_.erase(chosen);
  }

  const Service& service_;
  std::shared_ptr<Handler> handler_;
  const std::size_t max_;
  std::vector<Open> open_;
};

}  // namespace talus::server::http
