// Waits for a Timer in a coroutine.
#pragma once

#include <memory>
#include <utility>

#include <asio/async_result.hpp>
#include <asio/awaitable.hpp>
#include <asio/experimental/as_tuple.hpp>
#include <asio/use_awaitable.hpp>

#include <talus/client/clock.h>

namespace talus::client {

/// Returns at `end`, or when the timer is cancelled.
[[nodiscard]] inline asio::awaitable<void> wait_until(Timer& timer, Clock::Time end) {
  auto token = asio::experimental::as_tuple(asio::use_awaitable);
  co_await asio::async_initiate<decltype(token), void(std::error_code)>(
      [&timer, end](auto handler) {
        // A Timer's handler must be copyable; Asio's are not.
        auto shared = std::make_shared<decltype(handler)>(std::move(handler));
        timer.async_wait_until(end, [shared](std::error_code error) { std::move (*shared)(error); });
      },
      token);
}

}  // namespace talus::client
