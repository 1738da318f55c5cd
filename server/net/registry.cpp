#include "net/registry.h"

#include <utility>

namespace talus::server {

void Registry::add(ConnectionId id, const std::shared_ptr<Connection>& connection) {
  const std::lock_guard lock{mutex_};
  connections_.emplace(id, connection);
}

void Registry::remove(ConnectionId id) {
  std::function<void()> empty;
  {
    const std::lock_guard lock{mutex_};
    connections_.erase(id);
    if (connections_.empty()) empty = std::exchange(empty_, nullptr);
  }
  if (empty) empty();
}

std::vector<std::shared_ptr<Connection>> Registry::all() const {
  const std::lock_guard lock{mutex_};
  std::vector<std::shared_ptr<Connection>> open;
  for (const auto& [id, connection] : connections_) {
    if (auto alive = connection.lock()) open.push_back(std::move(alive));
  }
  return open;
}

void Registry::when_empty(std::function<void()> empty) {
  {
    const std::lock_guard lock{mutex_};
    if (!connections_.empty()) {
      empty_ = std::move(empty);
      return;
    }
  }
  empty();
}

}  // namespace talus::server
