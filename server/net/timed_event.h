// An event with a deadline of the injected clock, for a coroutine. For one thread.
#pragma once

#include <utility>

#include <asio/any_io_executor.hpp>
#include <asio/awaitable.hpp>
#include <asio/redirect_error.hpp>
#include <asio/steady_timer.hpp>
#include <asio/use_awaitable.hpp>

#include "runtime/clock.h"

namespace talus::server {

class TimedEvent {
 public:
  /// `clock` outlives it.
  TimedEvent(const asio::any_io_executor& executor, const Clock& clock) : clock_{clock}, timer_{executor} {}

  /// Ends at `deadline`, at notify(), or spuriously: check the condition again. max(): no deadline. One
  /// coroutine at a time.
  [[nodiscard]] asio::awaitable<void> wait_until(Clock::time_point deadline) {
    deadline_ = deadline;
    if (deadline == Clock::time_point::max()) {
      timer_.expires_at(Clock::time_point::max());
    } else {
      timer_.expires_after(deadline - clock_.now());
    }
    std::error_code cancelled;
    co_await timer_.async_wait(asio::redirect_error(asio::use_awaitable, cancelled));
    deadline_ = Clock::time_point::min();
  }

  /// Deadline of the waiting coroutine; min() if there is none.
  [[nodiscard]] Clock::time_point deadline() const { return deadline_; }

  void notify() { timer_.cancel(); }

 private:
  const Clock& clock_;
  asio::steady_timer timer_;
  Clock::time_point deadline_ = Clock::time_point::min();
};

}  // namespace talus::server
