// A gate that closes at one level and opens again at a lower one, so that it does not flap between the two.
// Callable from any thread, no locks.
#pragma once

#include <atomic>
#include <cstdint>

namespace talus::server {

class HysteresisGate {
 public:
  /// Closes when the level reaches `close_at`; opens when it is below `open_below`, which is no larger.
  ///
  /// While the level is settled, because nothing is under way that would lower it, the gate is open below
  /// `settled_close_at`: otherwise it could stay closed for ever.
  HysteresisGate(std::uint64_t close_at, std::uint64_t open_below, std::uint64_t settled_close_at)
      : close_at_{close_at}, open_below_{open_below}, settled_close_at_{settled_close_at} {}

  [[nodiscard]] bool open() const { return !closed_.load(); }

  /// Call it after every change of the level, or of whether it is settled; `level()` and `settled()` read
  /// them. Returns true if this call opened the gate.
  ///
  /// A thread that read the level before another changed it would leave the gate as of then. So a thread that
  /// changes the gate reads again: either it sees the other's level, or the other sees its gate.
  template <typename Level, typename Settled>
  bool update(Level&& level, Settled&& settled) {
    bool opened = false;
    for (;;) {
      bool closed = closed_.load();
      const std::uint64_t in_motion = closed ? open_below_ : close_at_;
      const bool close = level() >= (settled() ? settled_close_at_ : in_motion);
      if (close == closed) return opened;
      if (closed_.compare_exchange_strong(closed, close)) opened = !close;
    }
  }

 private:
  const std::uint64_t close_at_, open_below_, settled_close_at_;
  std::atomic<bool> closed_{false};
};

}  // namespace talus::server
