// A pool that flows share: places, or bytes. A flow takes what is free. If nothing is free and another flow
// wants some, one part gives way: one whose client has made no progress for longer than `patience`, or else
// one of the flow that holds most, or else one without progress for a fifth of `patience`. So one flow cannot
// keep the others out, with however many parts, nor many flows that make no progress.
//
// pools.h lists the pools. Callable from any thread.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <vector>

#include "limits/flows/flow_ids.h"
#include "runtime/clock.h"

namespace talus::server {

class FlowShares {
  struct Flow;

 public:
  /// Makes the holder of a part end soon. Called once, on the thread of the flow that wants room; must not
  /// wait, throw, or call the pool.
  using GiveWay = std::function<void()>;

  /// `patience`: longest time without progress.
  explicit FlowShares(Clock::duration patience) : patience_{patience} {}

  /// One holder's part of the pool; given back when it is destroyed. hold() and progress() are for one thread
  /// at a time, and lock nothing.
  class Part {
   public:
    /// `shares` outlives it. It gives way only after set_give_way(). Throws std::bad_alloc.
    Part(FlowShares& shares, FlowId flow, std::uint64_t amount, Clock::time_point progress);
    ~Part();
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

    void set_give_way(GiveWay give_way);
    void move_to(FlowId flow);
    void hold(std::uint64_t amount) { amount_.store(amount, std::memory_order_relaxed); }
    /// Its client made progress at `time`, which may lie ahead; max(): the client owes no progress.
    void progress(Clock::time_point time) { progress_.store(time, std::memory_order_relaxed); }

   private:
    friend class FlowShares;

    FlowShares& shares_;
    std::atomic<std::uint64_t> amount_;
    std::atomic<Clock::time_point> progress_;
    // Under the mutex:
    Flow* flow_ = nullptr;
    GiveWay give_way_;
    std::size_t place_ = 0;      // in parts_; kGone if it gave way
    std::uint64_t leaving_ = 0;  // amount when it gave way
  };

  /// Number of parts that have not given way.
  [[nodiscard]] std::size_t size() const;
  /// Amount of the parts that have given way and are not destroyed yet.
  [[nodiscard]] std::uint64_t leaving() const { return leaving_.load(std::memory_order_relaxed); }

  /// Returns what the part held that gives way to `flow`, which wants `amount`; nullopt if none does. A part
  /// that makes progress gives way only if its flow has another one, and holds more than `flow` then would,
  /// and more than `sure`. If there is not one, a part without progress for patience / kLastResort gives way
  /// whose flow holds more than `flow` then would. Takes about 20 ns a part.
  std::optional<std::uint64_t> make_room(FlowId flow, std::uint64_t amount, std::uint64_t sure,
                                         Clock::time_point now);

  /// Parts without progress for longer than `patience` give way until they held `amount` in all.
  void end_still(std::uint64_t amount, Clock::time_point now);

 private:
  static constexpr std::size_t kGone = SIZE_MAX;
  static constexpr int kLastResort = 5;

  struct Flow {
    FlowId id{};
    std::size_t parts = 0;
    // As of the last make_room():
    std::uint64_t held = 0;
    std::size_t yielding = 0;  // parts that may give way
  };

  // Called under the mutex.
  [[nodiscard]] Flow& enter(FlowId flow);
  void leave(Flow& flow) noexcept;
  [[nodiscard]] static bool is_still(const Part& part, Clock::time_point now, Clock::duration patience);
  [[nodiscard]] Part* choose(FlowId flow, std::uint64_t amount, std::uint64_t sure, Clock::time_point now);
  void remove(Part& part) noexcept;
  /// Returns the function to call without the mutex.
  [[nodiscard]] GiveWay let_go(Part& part) noexcept;

  const Clock::duration patience_;
  std::atomic<std::uint64_t> leaving_{0};
  mutable std::mutex mutex_;
  std::vector<Part*> parts_;
  std::unordered_map<FlowId, Flow> flows_;
};

}  // namespace talus::server
