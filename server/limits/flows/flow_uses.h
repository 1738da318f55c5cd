// The use of the server by all flows that are served, and the flows that recently used most. Callable from
// any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "limits/flows/flow_ids.h"
#include "limits/flows/flow_use.h"
#include "limits/flows/heavy_hitters.h"
#include "runtime/clock.h"

namespace talus::server {

/// The heaviest flows by one measure, and all flows together.
struct TopFlows {
  std::vector<FlowFigures> top;
  FlowFigures all;
};

class FlowUses {
 public:
  /// Number of flows by each measure that are remembered after they left. With their names they take at
  /// most 1.5 MiB in all; a flow that is served takes about 300 bytes of its session's memory
  /// (player/session/session.h).
  static constexpr std::size_t kListed = 1024;

  FlowUses();

  [[nodiscard]] const FlowIds& ids() const { return ids_; }

  /// Returns the object to add a flow's use to; keep it while the flow is served. `counted` are the bytes of
  /// the address that count (net/admission.h), `text` is that address.
  [[nodiscard]] FlowUsePtr of_address(std::span<const unsigned char> counted, std::string_view text);
  /// `subject`: of a signed token, not empty.
  [[nodiscard]] FlowUsePtr of_subject(std::string_view subject);

  /// Collects what was added since the last call: call it about once a second. Takes about 0.1 us a flow. If
  /// it throws, the next call collects the rest.
  void collect(Clock::time_point now);

  /// As of the last collect().
  [[nodiscard]] std::array<TopFlows, kFlowMeasures> top(std::size_t count) const;
  /// Returns the refusals of all flows so far, as of the last collect().
  [[nodiscard]] std::uint64_t refusals() const;
  /// Returns the number of flows that are served, or were until a few seconds ago.
  [[nodiscard]] std::size_t flows() const;

 private:
  struct KnownFlow {
    FlowUsePtr use;
    std::array<std::uint64_t, kFlowMeasures> collected{};
    bool left = false;  // it had no session at the last check
  };

  [[nodiscard]] FlowUsePtr join(FlowId id, FlowName::Kind kind, std::string_view text);
  // Called under the mutex.
  void check_all();

  const FlowIds ids_;
  mutable std::mutex mutex_;
  std::unordered_map<FlowId, KnownFlow> known_;
  std::size_t check_at_size_;  // size at which flows that left are searched for before the next collect()
  std::array<HeavyHitters, kFlowMeasures> heaviest_;
  Clock::time_point collected_{};
};

}  // namespace talus::server
