#include "net/registry.h"

#include <utility>

namespace talus::server {

void Registry::add(ConnectionId id, const std::shared_ptr<Peer>& peer) {
  std::optional<Farewell> farewell;
  {
    const std::lock_guard lock{mutex_};
    peers_.insert_or_assign(id, peer);
    farewell = farewell_;
  }
  if (farewell) peer->go_away(farewell->reason, farewell->retry_after);
}

void Registry::remove(ConnectionId id) {
  std::function<void()> empty;
  {
    const std::lock_guard lock{mutex_};
    peers_.erase(id);
    if (peers_.empty()) empty = std::exchange(empty_, nullptr);
  }
  if (empty) empty();
}

bool Registry::empty() const {
  const std::lock_guard lock{mutex_};
  return peers_.empty();
}

void Registry::tell_all_to_go(const std::string& reason, std::chrono::milliseconds retry_after) {
  std::vector<std::shared_ptr<Peer>> peers;
  {
    const std::lock_guard lock{mutex_};
    farewell_ = Farewell{reason, retry_after};
    peers = open();
  }
  for (const auto& peer : peers) peer->go_away(reason, retry_after);
}

void Registry::access_changed() {
  tell_all(&Peer::access_changed);
}

void Registry::rates_changed() {
  tell_all(&Peer::rates_changed);
}

void Registry::tell_all(void (Peer::*what)()) {
  std::vector<std::shared_ptr<Peer>> peers;
  {
    const std::lock_guard lock{mutex_};
    peers = open();
  }
  for (const auto& peer : peers) ((*peer).*what)();
}

std::vector<std::shared_ptr<Peer>> Registry::open() const {
  std::vector<std::shared_ptr<Peer>> peers;
  for (const auto& [id, peer] : peers_) {
    if (auto alive = peer.lock()) peers.push_back(std::move(alive));
  }
  return peers;
}

void Registry::when_empty(std::function<void()> empty) {
  {
    const std::lock_guard lock{mutex_};
    if (!peers_.empty()) {
      empty_ = std::move(empty);
      return;
    }
  }
  empty();
}

}  // namespace talus::server
