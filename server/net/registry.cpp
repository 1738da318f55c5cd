#include "net/registry.h"

#include <limits>
#include <utility>

namespace talus::server {
namespace {

constexpr std::size_t kEverybody = std::numeric_limits<std::size_t>::max();

}  // namespace

template <typename Which>
std::vector<std::shared_ptr<Peer>> Registry::leave(std::size_t max_peers, Which which) {
  std::vector<std::shared_ptr<Peer>> leaving;
  for (auto& [id, entry] : peers_) {
    if (leaving.size() >= max_peers) break;
    if (entry.told || !which(entry)) continue;
    auto peer = entry.peer.lock();
    if (peer == nullptr) continue;
    entry.told = true;
    leaving.push_back(std::move(peer));
  }
  return leaving;
}

void Registry::add(ConnectionId id, const std::shared_ptr<Peer>& peer) {
  std::optional<Farewell> farewell;
  {
    const std::lock_guard lock{mutex_};
    farewell = farewell_;
    peers_.insert_or_assign(id, Entry{peer, peer->session_since(), peer->proxy_port(), farewell.has_value()});
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
    peers = leave(kEverybody, [](const auto&) { return true; });
  }
  for (const auto& peer : peers) peer->go_away(reason, retry_after);
}

void Registry::tell_others_to_go(const std::string& reason) {
  std::vector<std::shared_ptr<Peer>> peers;
  {
    const std::lock_guard lock{mutex_};
    peers = leave(kEverybody, [](const Entry& entry) { return !entry.session_since; });
  }
  for (const auto& peer : peers) peer->go_away(reason, {});
}

std::size_t Registry::tell_to_go(std::size_t max_peers, std::optional<PortRange> ports,
                                 Clock::time_point began_before, const std::string& reason,
                                 std::chrono::milliseconds retry_after) {
  std::vector<std::shared_ptr<Peer>> peers;
  {
    const std::lock_guard lock{mutex_};
    peers = leave(max_peers, [&](const Entry& entry) {
      return entry.session_since && *entry.session_since < began_before && entry.came_by(ports);
    });
  }
  for (const auto& peer : peers) peer->go_away(reason, retry_after);
  return peers.size();
}

Registry::Sessions Registry::sessions(std::optional<PortRange> ports) const {
  Sessions sessions;
  const std::lock_guard lock{mutex_};
  for (const auto& [id, entry] : peers_) {
    if (entry.session_since && entry.came_by(ports)) ++(entry.told ? sessions.leaving : sessions.staying);
  }
  return sessions;
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
    for (const auto& [id, entry] : peers_) {
      if (auto alive = entry.peer.lock()) peers.push_back(std::move(alive));
    }
  }
  for (const auto& peer : peers) ((*peer).*what)();
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
