// An HTTP connection over a stream: reads requests, has them answered one after the other, and closes in
// time. Two coroutines on the stream's executor; nothing is locked. It lives as long as the last of them.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include <asio/awaitable.hpp>
#include <asio/buffer.hpp>
#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>
#include <asio/redirect_error.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>

#include "clock/clock.h"
#include "http/request_parser.h"
#include "http/response.h"
#include "log/escape.h"
#include "log/logger.h"
#include "net/stream.h"
#include "net/timed_event.h"

namespace talus::server::http {

/// Answers at once. What it throws becomes a 500.
using Handler = std::function<Response(const Request&)>;

/// What connections share; outlives them.
struct Service {
  Handler handler;
  const Clock& clock;
  Logger log;
  RequestBounds bounds{};
  std::chrono::milliseconds request_timeout{5000};   // from the last response to the next whole request
  std::chrono::milliseconds response_timeout{5000};  // to take a response
};

template <Stream S>
class Connection : public std::enable_shared_from_this<Connection<S>> {
 public:
  Connection(S stream, const Service& service)
      : stream_{std::move(stream)},
        service_{service},
        parser_{service.bounds},
        watch_waits_{stream_.get_executor(), service.clock},
        last_active_{service.clock.now()} {}

  /// Once, on the stream's executor.
  void start() {
    deadline_ = last_active_ + service_.request_timeout;
    for (const auto loop : {&Connection::serve, &Connection::watch}) {
      asio::co_spawn(
          stream_.get_executor(), [self = this->shared_from_this(), loop] { return ((*self).*loop)(); },
          [self = this->shared_from_this()](const std::exception_ptr&) { self->close(); });
    }
  }

  /// At once, whatever is in flight. On the stream's executor, as all that follows.
  void close() {
    if (!std::exchange(open_, false)) return;
    stream_.close();
    watch_waits_.notify();
  }
  [[nodiscard]] bool open() const { return open_; }
  /// When the client last sent or took something.
  [[nodiscard]] Clock::time_point last_active() const { return last_active_; }
  /// Looks at the clock again: for who moves a ManualClock.
  void clock_moved() { watch_waits_.notify(); }

 private:
  [[nodiscard]] asio::awaitable<void> serve() {
    bool more = true;
    while (open_ && more) {
      const auto taken = parser_.feed(std::span{input_}.subspan(read_, filled_ - read_));
      if (!taken) {
        more = false;
        co_await respond(response_to(taken.error()), false, false);
        continue;
      }
      read_ += *taken;
      if (parser_.has_request()) {
        const Request& request = parser_.request();
        more = request.keep_alive;
        co_await respond(answer(request), request.method == Method::head, more);
        parser_.pop();
      } else {
        more = co_await read();
      }
    }
    if (open_) co_await end();
    close();
  }

  [[nodiscard]] asio::awaitable<bool> read() {
    std::error_code failed;
    read_ = 0;
    filled_ = co_await stream_.async_read_some(asio::buffer(input_),
                                               asio::redirect_error(asio::use_awaitable, failed));
    last_active_ = service_.clock.now();
    co_return !failed;
  }

  [[nodiscard]] Response answer(const Request& request) const {
    try {
      return service_.handler(request);
    } catch (const std::exception& error) {
      service_.log->error("{} failed: {}", escaped(std::string{request.path()}, 200), error.what());
      return {500, kPlainText, "the server failed to answer this; its log says more\n"};
    }
  }

  [[nodiscard]] asio::awaitable<void> respond(const Response response, bool head_only, bool keep_alive) {
    deadline_ = service_.clock.now() + service_.response_timeout;
    const std::string head = head_of(response, keep_alive, service_.clock.wall());
    const std::array<asio::const_buffer, 2> pieces{asio::buffer(head),
                                                   asio::buffer(head_only ? kNothing : response.body)};
    const auto progress = [this](const std::error_code& error, std::size_t) -> std::size_t {
      last_active_ = service_.clock.now();
      return error ? 0 : SIZE_MAX;
    };
    std::error_code failed;
    co_await asio::async_write(stream_, pieces, progress, asio::redirect_error(asio::use_awaitable, failed));
    if (failed) close();
    deadline_ = service_.clock.now() + service_.request_timeout;
  }

  /// Closing over unread bytes would reset the connection, and could take the response with it.
  [[nodiscard]] asio::awaitable<void> end() {
    deadline_ = service_.clock.now() + service_.response_timeout;
    co_await stream_.say_end();
    if (!open_) co_return;
    stream_.shutdown();
    for (bool more = true; open_ && more;) more = co_await read();
  }

  [[nodiscard]] asio::awaitable<void> watch() {
    while (open_ && service_.clock.now() < deadline_) co_await watch_waits_.wait_until(deadline_);
    close();
  }

  static inline const std::string kNothing;

  S stream_;
  const Service& service_;
  RequestParser parser_;
  TimedEvent watch_waits_;
  Clock::time_point last_active_;
  Clock::time_point deadline_;  // moved on only: watch() looks again when the one before is over
  bool open_ = true;
  std::size_t read_ = 0;  // of input_
  std::size_t filled_ = 0;
  std::array<std::byte, 4096> input_;
};

}  // namespace talus::server::http
