// Every open connection, so that the server can speak to all of them. Callable from any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace talus::server {

class Connection;
using ConnectionId = std::uint64_t;

class Registry {
 public:
  void add(ConnectionId id, const std::shared_ptr<Connection>& connection);
  void remove(ConnectionId id);

  [[nodiscard]] std::vector<std::shared_ptr<Connection>> all() const;

  /// Calls `empty` once, in any thread, when no connection is open: at once if there is none now.
  void when_empty(std::function<void()> empty);

 private:
  mutable std::mutex mutex_;
  std::unordered_map<ConnectionId, std::weak_ptr<Connection>> connections_;
  std::function<void()> empty_;
};

}  // namespace talus::server
