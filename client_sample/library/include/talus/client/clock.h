// Time and timers behind an interface, so that tests control time.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <system_error>

#include <asio/any_io_executor.hpp>

namespace talus::client {

/// Supports one wait at a time. Destroying a Timer cancels its wait.
class Timer {
 public:
  using Handler = std::function<void(std::error_code)>;

  virtual ~Timer() = default;
  /// Calls handler({}) on the timer's executor at `end`, never from inside this call. The handler receives
  /// operation_aborted after cancel(), a further wait, or destruction of the timer.
  virtual void async_wait_until(std::chrono::steady_clock::time_point end, Handler handler) = 0;
  virtual void cancel() = 0;
};

class Clock {
 public:
  using Time = std::chrono::steady_clock::time_point;

  virtual ~Clock() = default;
  [[nodiscard]] virtual Time now() const = 0;
  [[nodiscard]] virtual std::unique_ptr<Timer> make_timer(const asio::any_io_executor& executor) = 0;
};

/// std::chrono::steady_clock and asio::steady_timer. Holds no state.
[[nodiscard]] Clock& system_clock();

}  // namespace talus::client
