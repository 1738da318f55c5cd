// What talusd knows that it holds in memory, against what it may hold. Callable from any thread, no locks.
//
// Caches give way first: they may have what everything else leaves. New work, and before it new connections,
// are refused when everything else has come near the budget, until it is well below again; so what is under
// way can end, and nothing flaps.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace talus::server {

/// Closes when `used` reaches `stop`, opens when it is below `resume`.
class Floodgate {
 public:
  Floodgate(std::uint64_t stop, std::uint64_t resume) : stop_{stop}, resume_{resume} {}
  [[nodiscard]] bool open(std::uint64_t used) {
    const bool was_closed = closed_.load(std::memory_order_relaxed);
    const bool closed = used >= (was_closed ? resume_ : stop_);
    if (closed != was_closed) closed_.store(closed, std::memory_order_relaxed);
    return !closed;
  }

 private:
  const std::uint64_t stop_, resume_;
  std::atomic<bool> closed_{false};
};

enum class MemoryUse : std::uint8_t { program, sessions, jobs, generators, chunk_cache, patch_cache };
inline constexpr std::array<std::string_view, 6> kMemoryUses{"program",    "sessions",    "jobs",
                                                             "generators", "chunk_cache", "patch_cache"};

class MemoryBudget {
 public:
  /// What the program takes before it serves anybody: its code, its threads, its log.
  static constexpr std::uint64_t kProgramBytes = std::uint64_t{24} << 20;

  /// 0: none, nothing is ever refused.
  explicit MemoryBudget(std::uint64_t limit_bytes);

  [[nodiscard]] std::uint64_t limit_bytes() const { return limit_; }
  [[nodiscard]] std::uint64_t used(MemoryUse use) const;
  [[nodiscard]] std::uint64_t used() const;

  void add(MemoryUse use, std::int64_t bytes);
  void set(MemoryUse use, std::uint64_t bytes);

  /// Whether new chunks and heights may be asked of generators; false from 3/4 of the budget on, until below
  /// 5/8.
  [[nodiscard]] bool takes_work();
  /// Whether new connections may be; false from 5/8 on, until below 1/2: those that are there need room to
  /// work.
  [[nodiscard]] bool takes_connections();

  /// How much of `wanted` bytes caches may hold now: what everything else leaves of 7/8 of the budget, and at
  /// least 1/16 of it.
  [[nodiscard]] std::uint64_t for_caches(std::uint64_t wanted) const;

 private:
  [[nodiscard]] std::uint64_t beside_caches() const;

  const std::uint64_t limit_;
  std::array<std::atomic<std::int64_t>, kMemoryUses.size()> used_{};
  Floodgate work_, connections_;
};

/// What one holder has told a budget; given back with it.
class MemoryShare {
 public:
  MemoryShare(MemoryBudget& budget, MemoryUse use) : budget_{budget}, use_{use} {}
  ~MemoryShare() { tell(0); }
  MemoryShare(const MemoryShare&) = delete;
  MemoryShare& operator=(const MemoryShare&) = delete;

  /// Changes below a page are kept to itself.
  void hold(std::uint64_t bytes) {
    constexpr std::uint64_t kWorthTelling = 4096;
    const std::uint64_t apart = bytes > told_ ? bytes - told_ : told_ - bytes;
    if (apart >= kWorthTelling) tell(bytes);
  }

 private:
  void tell(std::uint64_t bytes) {
    budget_.add(use_, static_cast<std::int64_t>(bytes) - static_cast<std::int64_t>(told_));
    told_ = bytes;
  }

  MemoryBudget& budget_;
  MemoryUse use_;
  std::uint64_t told_ = 0;
};

}  // namespace talus::server
