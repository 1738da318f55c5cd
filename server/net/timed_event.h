// An event with a deadline of the injected clock. For one thread.
#pragma once

#include <system_error>
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

  /// Ends at `deadline`, at notify(), or spuriously: check the condition again. max(): no deadline. One wait
  /// at a time, of either kind.
  [[nodiscard]] asio::awaitable<void> wait_until(Clock::time_point deadline) {
    set(deadline);
    std::error_code cancelled;
    co_await timer_.async_wait(asio::redirect_error(asio::use_awaitable, cancelled));
    deadline_ = Clock::time_point::min();
  }
  /// Calls `then` at the end of the wait. `then` keeps this object alive.
  template <typename Call>
  void wait_until(Clock::time_point deadline, Call then) {
    set(deadline);
    timer_.async_wait([this, then = std::move(then)](std::error_code /*cancelled*/) {
      deadline_ = Clock::time_point::min();
      then();
    });
  }

  /// Deadline of the wait in progress; min() if there is none.
  [[nodiscard]] Clock::time_point deadline() const { return deadline_; }

  void notify() { timer_.cancel(); }

 private:
  void set(Clock::time_point deadline) {
    deadline_ = deadline;
    if (deadline == Clock::time_point::max()) {
      timer_.expires_at(Clock::time_point::max());
    } else {
      timer_.expires_after(deadline - clock_.now());
    }
  }

  const Clock& clock_;
  asio::steady_timer timer_;
  Clock::time_point deadline_ = Clock::time_point::min();
};

}  // namespace talus::server
