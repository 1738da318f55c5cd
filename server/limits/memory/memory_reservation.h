// The bytes that one holder has reported to a MemoryBudget; given back when the holder goes. For one thread
// at a time.
#pragma once

#include <cstdint>

#include "limits/memory/memory_budget.h"

namespace talus::server {

class MemoryReservation {
 public:
  /// `budget` outlives this.
  MemoryReservation(MemoryBudget& budget, MemoryUse use) : budget_{budget}, use_{use} {}
  ~MemoryReservation() { tell(0); }
  MemoryReservation(const MemoryReservation&) = delete;
  MemoryReservation& operator=(const MemoryReservation&) = delete;

  /// The holder has `bytes` now. Changes of less than a page are not reported to the budget.
  void hold(std::uint64_t bytes) {
    constexpr std::uint64_t kWorthTelling = 4096;
    const std::uint64_t difference = bytes > told_ ? bytes - told_ : told_ - bytes;
    if (difference >= kWorthTelling) tell(bytes);
  }

 private:
  void tell(std::uint64_t bytes) {
    budget_.add(use_, static_cast<std::int64_t>(bytes) - static_cast<std::int64_t>(told_));
    told_ = bytes;
  }

  MemoryBudget& budget_;
  const MemoryUse use_;
  std::uint64_t told_ = 0;
};

}  // namespace talus::server
