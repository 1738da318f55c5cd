// Whose View a thread applies next. A View may cost milliseconds, in which the thread hears nobody: so all
// Views together get a quarter of its time, which flows share in turns. Chunks that a View finds in memory
// are sent, which rates bound: they are no cost of the View, but of the next one if that drops them.
#pragma once

#include <chrono>
#include <deque>
#include <unordered_map>

#include <asio/execution_context.hpp>

#include "limits/flows/deficit_round_robin.h"
#include "limits/flows/flow_ids.h"
#include "net/timed_event.h"
#include "runtime/clock.h"

namespace talus::server {

/// One for each io_context (asio::use_service), for the thread that runs it.
class ViewTurns final : public asio::execution_context::service {
 public:
  static inline asio::execution_context::id id;

  /// After a View so many times its cost passes until the next begins.
  static constexpr int kIntervalPerCost = 4;
  /// What a flow may spend in one turn. The last View may overdraw it.
  static constexpr std::chrono::nanoseconds kTurn = std::chrono::milliseconds{5};

  explicit ViewTurns(asio::execution_context& context) : service{context} {}

  /// A View waits, of whom `waiter` stands for. When its turn comes `waiter` is notified. It stays where it
  /// is until applied() or leave(). Throws std::bad_alloc, and then has changed nothing.
  void enter(FlowId flow, TimedEvent& waiter);
  /// No effect where it does not wait.
  void leave(TimedEvent& waiter) noexcept;
  /// When the View may be applied; max() where another's turn it is.
  [[nodiscard]] Clock::time_point due(const TimedEvent& waiter) const;
  /// It was applied from `began` on, at the cost of so much of the thread's processor time.
  void applied(TimedEvent& waiter, Clock::time_point began, std::chrono::nanoseconds cost) noexcept;

 private:
  void shutdown() override {}
  /// Gives somebody the turn, where nobody has it.
  void choose() noexcept;

  std::unordered_map<const TimedEvent*, FlowId> flow_of_;
  std::unordered_map<FlowId, std::deque<TimedEvent*>> waiting_;  // none is empty
  DeficitRoundRobin<FlowId> turns_{Newcomers::first};
  TimedEvent* next_ = nullptr;
  Clock::time_point free_at_{};
};

}  // namespace talus::server
