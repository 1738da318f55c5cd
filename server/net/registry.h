// Every open connection, for messages to all of them. Callable from any thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "net/port_range.h"
#include "runtime/clock.h"

namespace talus::server {

/// Unique within a process; later connections have greater ids.
using ConnectionId = std::uint64_t;

/// The server's view of a connection, independent of its stream and protocol.
class Peer {
 public:
  virtual ~Peer() = default;
  /// Start of its session; nullopt if it has no session.
  [[nodiscard]] virtual std::optional<Clock::time_point> session_since() const = 0;
  /// Port of the proxy that it arrived through; 0 if the proxy does not report it, nullopt if it came
  /// directly.
  [[nodiscard]] virtual std::optional<std::uint16_t> proxy_port() const { return std::nullopt; }
  /// From any thread: sends a farewell and closes once pending requests are answered.
  virtual void go_away(const std::string& reason, std::chrono::milliseconds retry_after) = 0;
  /// From any thread: the lists of revoked tokens and blocked flows have changed; it may be on one of them.
  virtual void access_changed() = 0;
  /// From any thread: the rates of sessions and addresses have changed.
  virtual void rates_changed() = 0;
};

class Registry {
 public:
  /// After tell_all_to_go() the new peer is sent away at once. A peer with an existing id replaces the older
  /// one.
  void add(ConnectionId id, const std::shared_ptr<Peer>& peer);
  void remove(ConnectionId id);
  [[nodiscard]] bool empty() const;

  /// Sends GoAway to all peers not sent one yet, and to any added later.
  void tell_all_to_go(const std::string& reason, std::chrono::milliseconds retry_after);
  /// Sends GoAway to peers without a session.
  void tell_others_to_go(const std::string& reason);
  /// Sends GoAway to at most `max_peers` sessions that arrived through `ports` (all if empty) before
  /// `began_before`, oldest first, so that a session just redirected here is not redirected again. Returns
  /// their number.
  std::size_t tell_to_go(std::size_t max_peers, std::optional<PortRange> ports,
                         Clock::time_point began_before, const std::string& reason,
                         std::chrono::milliseconds retry_after);
  struct Sessions {
    std::size_t staying = 0;
    std::size_t leaving = 0;  // sent a GoAway and still connected
  };
  /// Counts the sessions that arrived through `ports` (all if empty).
  [[nodiscard]] Sessions sessions(std::optional<PortRange> ports = {}) const;

  /// Notifies all peers.
  void access_changed();
  void rates_changed();

  /// Calls `empty` once, in any thread, as soon as there are no connections (at once if there are none now).
  void when_empty(std::function<void()> empty);

 private:
  struct Farewell {
    std::string reason;
    std::chrono::milliseconds retry_after;
  };

  struct Entry {
    std::weak_ptr<Peer> peer;
    std::optional<Clock::time_point> session_since;
    std::optional<std::uint16_t> proxy_port;
    bool told = false;  // to go away

    [[nodiscard]] bool came_by(const std::optional<PortRange>& ports) const {
      return !ports || (proxy_port && ports->contains(*proxy_port));
    }
  };

  void tell_all(void (Peer::*what)());
  /// Marks up to `max_peers` peers accepted by `which` as told, skipping any already told, and returns them.
  /// Call under the mutex.
  template <typename Which>
  [[nodiscard]] std::vector<std::shared_ptr<Peer>> leave(std::size_t max_peers, Which which);

  mutable std::mutex mutex_;
  std::map<ConnectionId, Entry> peers_;  // the longest connected first
  std::optional<Farewell> farewell_;
  std::function<void()> empty_;
};

}  // namespace talus::server
