// The flows that use most of something, of any number of flows, in a table of fixed size. For one thread; its
// users lock.
//
// Space-Saving (Metwally, Agrawal and El Abbadi, 2005), fed with many flows at once and then cut to its size,
// as summaries are merged (Agarwal et al., 2012). A flow that is not listed weighs at most as much as the
// heaviest that was ever cut off; a flow that comes back begins with that. So with a table of k entries every
// flow that has more than 1 / (k + 1) of all weight is listed, and no weight is wrong by more than that.
//
// A weight is a rate, like a load average: use counts less by the factor e each minute.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "limits/flows/flow_use.h"

namespace talus::server {

/// Figures of one flow, or of all.
struct FlowFigures {
  FlowNamePtr name;           // null: figures of all flows
  double in_ten_seconds = 0;  // per second, weighted by age with a time constant of 10 s
  double in_a_minute = 0;     // the same with a minute
  std::uint64_t total = 0;    // since it is listed
};

class HeavyHitters {
 public:
  /// At least 1.
  explicit HeavyHitters(std::size_t entries);

  /// `time` has passed: all rates fall. Call it about once a second, before add() of the use in that time.
  void pass(std::chrono::duration<double> time);
  /// The flow has used `amount` more. If it throws, nothing has changed.
  void add(const FlowUse& flow, std::uint64_t amount);
  /// Keeps the heaviest. Call it after a number of add().
  void cut();

  /// Returns the flows that used most in a minute, in falling order.
  [[nodiscard]] std::vector<FlowFigures> top(std::size_t count) const;
  [[nodiscard]] const FlowFigures& all() const { return all_; }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    FlowId flow{};
    FlowFigures figures;  // since it is listed
    double unseen = 0;    // the most that it may have used in a minute before
    [[nodiscard]] double weight() const { return figures.in_a_minute + unseen; }
  };

  const std::size_t max_;
  std::vector<Entry> entries_;
  std::unordered_map<FlowId, std::size_t> place_;  // in entries_
  double unlisted_ = 0;                            // no flow that is not listed weighs more
  FlowFigures all_;
};

}  // namespace talus::server
