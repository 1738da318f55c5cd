// Decides whose View a thread applies next. A View may take milliseconds, during which the thread serves no
// other session. So all Views together get a quarter of its time, which flows share. Sending chunks
// that a View finds in memory is bounded by rates: its cost is not charged to that View, but to the next one
// if it drops them.
#pragma once

#include <chrono>
#include <unordered_map>

#include <asio/execution_context.hpp>

#include "limits/flows/fair_queue.h"
#include "limits/flows/flow_ids.h"
#include "net/timed_event.h"
#include "runtime/clock.h"

namespace talus::server {

/// One for each io_context (asio::use_service), used by the thread that runs it.
class ViewTurns final : public asio::execution_context::service {
 public:
  static inline asio::execution_context::id id;

  /// The next View begins no earlier than this many times the cost after the last began.
  static constexpr int kIntervalPerCost = 4;
  /// A flow that had no View queued goes first for this time.
  static constexpr std::chrono::nanoseconds kLead = std::chrono::milliseconds{5};

  explicit ViewTurns(asio::execution_context& context) : service{context} {}

  /// Queues a View, identified by `waiter`, which is notified when its turn comes. `waiter` must not move
  /// before applied() or leave(). Throws std::bad_alloc without changing anything.
  void enter(FlowId flow, TimedEvent& waiter);
  /// No effect if it is not queued.
  void leave(TimedEvent& waiter) noexcept;
  /// Time at which the View may be applied; max() while it is another's turn.
  [[nodiscard]] Clock::time_point due(const TimedEvent& waiter) const;
  /// The View was applied, starting at `began`, for `cost` of the thread's processor time.
  void applied(TimedEvent& waiter, Clock::time_point began, std::chrono::nanoseconds cost) noexcept;

 private:
  void shutdown() override {}
  /// Gives the turn to a waiter if it is free.
  void choose() noexcept;

  std::unordered_map<const TimedEvent*, FlowId> flow_of_;
  FairQueue<FlowId, TimedEvent*> turns_{{FairRule{static_cast<double>(kLead.count())}, FairRule{}}};
  TimedEvent* next_ = nullptr;
  Clock::time_point free_at_{};
};

}  // namespace talus::server
