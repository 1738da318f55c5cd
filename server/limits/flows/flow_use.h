// Adds up the use that one flow makes of the server.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "limits/flows/flow_ids.h"

namespace talus::server {

enum class FlowMeasure : std::uint8_t {
  generator,  // ns of processor time of generator threads, in its turns
  sent,       // bytes written to the flow's clients
  refusals,   // requests that were refused as too many or too fast or for want of room, and connections
              // refused
};
inline constexpr std::size_t kFlowMeasures = 3;

/// Names a flow for operators. Untrusted: escape it.
struct FlowName {
  /// Maximum length of a subject's name; the rest is cut.
  static constexpr std::size_t kMaxBytes = 120;

  enum class Kind : std::uint8_t { address, subject };
  Kind kind = Kind::address;
  std::string text;
  bool cut = false;  // the subject is longer
};
using FlowNamePtr = std::shared_ptr<const FlowName>;

/// Callable from any thread: one relaxed addition, on memory that only threads that serve the flow write.
class FlowUse {
 public:
  FlowUse(FlowId id, FlowName name) : id_{id}, name_{std::make_shared<const FlowName>(std::move(name))} {}

  [[nodiscard]] FlowId id() const { return id_; }
  [[nodiscard]] const FlowNamePtr& name() const { return name_; }

  void add(FlowMeasure measure, std::uint64_t amount) {
    used_[static_cast<std::size_t>(measure)].fetch_add(amount, std::memory_order_relaxed);
  }
  /// Returns the sum of all that was added so far.
  [[nodiscard]] std::uint64_t used(FlowMeasure measure) const {
    return used_[static_cast<std::size_t>(measure)].load(std::memory_order_relaxed);
  }

 private:
  const FlowId id_;
  const FlowNamePtr name_;
  std::array<std::atomic<std::uint64_t>, kFlowMeasures> used_{};
};
using FlowUsePtr = std::shared_ptr<FlowUse>;

}  // namespace talus::server
