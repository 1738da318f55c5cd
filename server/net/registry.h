// Every open connection, so that the server can speak to all of them. Callable from any thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace talus::server {

/// Never used twice in one process.
using ConnectionId = std::uint64_t;

/// What the server says to a connection, whatever its stream and protocol are.
class Peer {
 public:
  virtual ~Peer() = default;
  /// From any thread: says so and closes when what was asked is answered.
  virtual void go_away(const std::string& reason, std::chrono::milliseconds retry_after) = 0;
  /// From any thread: the lists of revoked tokens and of blocked flows have changed, and it may be on one.
  virtual void access_changed() = 0;
  /// From any thread: the rates of sessions and addresses have changed.
  virtual void rates_changed() = 0;
};

class Registry {
 public:
  /// Once tell_all_to_go() was called the peer is told at once. A peer with the id of another takes its
  /// place.
  void add(ConnectionId id, const std::shared_ptr<Peer>& peer);
  void remove(ConnectionId id);
  [[nodiscard]] bool empty() const;

  /// Tells all peers to go away, and those that are added from now on.
  void tell_all_to_go(const std::string& reason, std::chrono::milliseconds retry_after);

  /// Tells all peers.
  void access_changed();
  void rates_changed();

  /// Calls `empty` once, in any thread, when no connection is open: at once if there is none now.
  void when_empty(std::function<void()> empty);

 private:
  struct Farewell {
    std::string reason;
    std::chrono::milliseconds retry_after;
  };

  void tell_all(void (Peer::*what)());
  /// Under the mutex.
  [[nodiscard]] std::vector<std::shared_ptr<Peer>> open() const;

  mutable std::mutex mutex_;
  std::unordered_map<ConnectionId, std::weak_ptr<Peer>> peers_;
  std::optional<Farewell> farewell_;
  std::function<void()> empty_;
};

}  // namespace talus::server
