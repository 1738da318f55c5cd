// Tells how long a disk has kept the thread that writes to it waiting.
#pragma once

#include <atomic>
#include <utility>

#include "runtime/clock.h"

namespace talus::server {

class PendingWrite {
 public:
  /// `clock` outlives this.
  explicit PendingWrite(const Clock& clock) : clock_{clock} {}

  /// Calls `write`, which may block for the disk, and returns its result. One at a time.
  template <typename Write>
  auto run(Write&& write) {
    struct End {
      std::atomic<Clock::time_point>& began;
      ~End() { began = kNone; }
    };
    began_ = clock_.now();
    const End end{began_};
    return std::forward<Write>(write)();
  }
  /// Time since run() was called; 0 if it has returned. Any thread.
  [[nodiscard]] Clock::duration age() const {
    const Clock::time_point began = began_;
    return began == kNone ? Clock::duration{} : clock_.now() - began;
  }

 private:
  static constexpr Clock::time_point kNone = Clock::time_point::min();

  const Clock& clock_;
  std::atomic<Clock::time_point> began_{kNone};
};

}  // namespace talus::server
