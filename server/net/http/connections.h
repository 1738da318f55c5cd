// The connections of a small HTTP server, at most `max` of them. A new one replaces the longest idle one, so
// that a new client is always served, however many connections others hold open. For one thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
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
  void add(S stream) { add(std::move(stream), handler_); }
  /// Uses `handler` in place of the common one.
  void add(S stream, std::shared_ptr<Handler> handler) {
    forget_closed();
    if (open_.size() >= max_) close_quietest();
    open_.push_back(std::make_shared<Connection<S>>(std::move(stream), service_, std::move(handler)));
    open_.back()->start();
  }

  /// Closes the longest idle connection; false if there are no open ones.
  bool make_room() {
    forget_closed();
    if (open_.empty()) return false;
    close_quietest();
    return true;
  }

  void clock_moved() {
    for (const auto& connection : open_) connection->clock_moved();
  }

 private:
  void forget_closed() {
    std::erase_if(open_, [](const auto& connection) { return !connection->open(); });
  }
  void close_quietest() {
    const auto quiet = std::min_element(open_.begin(), open_.end(), [](const auto& a, const auto& b) {
      return a->last_active() < b->last_active();
    });
    (*quiet)->close();
    open_.erase(quiet);
  }

  const Service& service_;
  std::shared_ptr<Handler> handler_;
  const std::size_t max_;
  std::vector<std::shared_ptr<Connection<S>>> open_;  // some may be closed
};

}  // namespace talus::server::http
