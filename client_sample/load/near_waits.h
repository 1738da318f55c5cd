// For one player: the time until the two nearest rings of its Views were complete, and the longest time
// without any chunk while it waited for some. No I/O, no clock.
#pragma once

#include <utility>
#include <vector>

#include "pending_chunks.h"

namespace talus::load {

class NearWaits {
 public:
  /// The longest time without a chunk is measured from `from`.
  void measure_from(Time from) { from_ = from; }

  /// A View due at `due` was sent and passed to `pending`.
  void step(Time due, const PendingChunks& pending);
  /// An awaited chunk arrived.
  void came(Time now, const PendingChunks& pending);
  /// Ends all waits: the connection or the run ended.
  void stop(Time now);

  struct Wait {
    Time since{};
    Clock::duration time{};
  };
  /// Views whose nearest rings were completed or given up since the last call.
  [[nodiscard]] std::vector<Wait> take_done() { return std::exchange(done_, {}); }
  [[nodiscard]] Clock::duration longest_without() const { return longest_without_; }

 private:
  void close_steps(Time now);
  void end_fast(Time now);

  Time from_{};
  std::vector<Time> open_;  // Views with incomplete nearest rings
  std::vector<Wait> done_;
  bool waits_ = false;  // for a chunk
  Time fast_since_{};   // while waiting: start of the wait, or arrival of the last chunk
  Clock::duration longest_without_{};
};

}  // namespace talus::load
