// The bytes that one holder has reported to a MemoryBudget; given back when the holder goes. For one thread
// at a time.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>

#include "limits/flows/flow_shares.h"
#include "limits/memory/memory_budget.h"
#include "runtime/clock.h"

namespace talus::server {

class MemoryReservation {
 public:
  /// `budget` outlives this.
  MemoryReservation(MemoryBudget& budget, MemoryUse use) : budget_{budget}, use_{use} {}
  ~MemoryReservation() { tell(0); }
  MemoryReservation(const MemoryReservation&) = delete;
  MemoryReservation& operator=(const MemoryReservation&) = delete;

  /// From here on the flow shares the memory with others, and this holder gives way to them.
  void share(FlowId flow, FlowShares::GiveWay give_way) {
    part_.emplace(budget_.shares(), flow, told_, Clock::time_point::max());
    part_->set_give_way(std::move(give_way));
  }
  void move_to(FlowId flow) {
    if (part_) part_->move_to(flow);
  }

  /// The holder has `bytes` now. Changes of less than a page are not reported to the budget.
  void hold(std::uint64_t bytes) {
    constexpr std::uint64_t kWorthTelling = 4096;
    const std::uint64_t difference = bytes > told_ ? bytes - told_ : told_ - bytes;
    if (difference >= kWorthTelling) tell(bytes);
  }

  /// The holder waits from `now` on for its client to drain `bytes`; 0: for its permission to send.
  void drain_begins(Clock::time_point now, std::uint64_t bytes) {
    if (!part_) return;
    due_ = now - late_ + std::chrono::nanoseconds{std::chrono::seconds{bytes}} / MemoryBudget::kDrainedBytes;
    part_->progress(due_);
  }
  /// The client has drained everything so far, and may take the time of `bytes` more.
  void drain_goes_on(std::uint64_t bytes) {
    if (!part_) return;
    due_ += std::chrono::nanoseconds{std::chrono::seconds{bytes}} / MemoryBudget::kDrainedBytes;
    part_->progress(due_);
  }
  void drain_ends(Clock::time_point now) {
    if (!part_) return;
    late_ = std::max(Clock::duration::zero(), now - due_);
    part_->progress(Clock::time_point::max());
  }
  /// The client has drained everything.
  void drained() {
    if (!part_) return;
    late_ = {};
    part_->progress(Clock::time_point::max());
  }

 private:
  void tell(std::uint64_t bytes) {
    budget_.add(use_, static_cast<std::int64_t>(bytes) - static_cast<std::int64_t>(told_));
    told_ = bytes;
    if (part_) part_->hold(bytes);
  }

  MemoryBudget& budget_;
  const MemoryUse use_;
  std::uint64_t told_ = 0;
  std::optional<FlowShares::Part> part_;
  Clock::time_point due_{};  // when the client would have drained everything so far at kDrainedBytes
  Clock::duration late_{};   // by how much it was later
};

}  // namespace talus::server
