// Of one player: how long its Views took until their two nearest rings were there, and how long it went
// without any chunk while it waited for some. No I/O, no clock.
#pragma once

#include <utility>
#include <vector>

#include "pending_chunks.h"

namespace talus::load {

class NearWaits {
 public:
  /// The longest time without a chunk is looked for from `from` on.
  void measure_from(Time from) { from_ = from; }

  /// A View due at `due` was sent, and `pending` knows it.
  void step(Time due, const PendingChunks& pending);
  /// A chunk that was waited for came.
  void came(Time now, const PendingChunks& pending);
  /// Nothing is waited for any more: the connection ended, or the run.
  void stop(Time now);

  struct Wait {
    Time since{};
    Clock::duration time{};
  };
  /// Views whose nearest rings are there, or never will be, since the last call.
  [[nodiscard]] std::vector<Wait> take_done() { return std::exchange(done_, {}); }
  [[nodiscard]] Clock::duration longest_without() const { return longest_without_; }

 private:
  void close_steps(Time now);
  void end_fast(Time now);

  Time from_{};
  std::vector<Time> open_;  // Views whose nearest rings are not there
  std::vector<Wait> done_;
  bool waits_ = false;  // for a chunk
  Time fast_since_{};   // where it waits: when it began to, or the last chunk came
  Clock::duration longest_without_{};
};

}  // namespace talus::load
