// Every open connection, so that the server can speak to all of them. Callable from any thread.
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

/// Never used twice in one process: later connections have greater ones.
using ConnectionId = std::uint64_t;

/// What the server says to a connection, whatever its stream and protocol are.
class Peer {
 public:
  virtual ~Peer() = default;
  /// Since when a player is on it; none: it has no session.
  [[nodiscard]] virtual std::optional<Clock::time_point> session_since() const = 0;
  /// To which it came at a proxy; 0: the proxy does not say. None: it came directly.
  [[nodiscard]] virtual std::optional<std::uint16_t> proxy_port() const { return std::nullopt; }
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

  /// Tells all peers to go away that were not told yet, and those that are added from now on.
  void tell_all_to_go(const std::string& reason, std::chrono::milliseconds retry_after);
  /// Tells those without a session.
  void tell_others_to_go(const std::string& reason);
  /// Tells at most so many sessions that came by such a port of a proxy (any sessions, where no ports are
  /// given), began before then and were not told yet, the longest connected first: who came last, perhaps
  /// sent here by another server, is the last to be sent on. Returns how many.
  std::size_t tell_to_go(std::size_t most, std::optional<PortRange> ports, Clock::time_point began_before,
                         const std::string& reason, std::chrono::milliseconds retry_after);
  struct Sessions {
    std::size_t staying = 0;
    std::size_t leaving = 0;  // told to go, and still here
  };
  /// Of those that came by such a port of a proxy; of all, where no ports are given.
  [[nodiscard]] Sessions sessions(std::optional<PortRange> ports = {}) const;

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

  struct Entry {
    std::weak_ptr<Peer> peer;
    std::optional<Clock::time_point> session_since;
    std::optional<std::uint16_t> proxy_port;
    bool told = false;  // to go

    [[nodiscard]] bool came_by(const std::optional<PortRange>& ports) const {
      return !ports || (proxy_port && ports->contains(*proxy_port));
    }
  };

  void tell_all(void (Peer::*what)());
  /// Those that are not told to go yet, and are now: `most` of those whom `which` takes. Under the mutex.
  template <typename Which>
  [[nodiscard]] std::vector<std::shared_ptr<Peer>> leave(std::size_t most, Which which);

  mutable std::mutex mutex_;
  std::map<ConnectionId, Entry> peers_;  // the longest connected first
  std::optional<Farewell> farewell_;
  std::function<void()> empty_;
};

}  // namespace talus::server
