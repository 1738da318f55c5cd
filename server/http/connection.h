// An HTTP connection over a stream: reads requests, has them answered one after the other, and closes in
// time. Answers to requests that came together leave together. Two coroutines on the stream's executor;
// nothing is locked. It lives as long as the last of them.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <asio/awaitable.hpp>
#include <asio/buffer.hpp>
#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>
#include <asio/redirect_error.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>

#include "clock/clock.h"
#include "http/handler.h"
#include "http/request_parser.h"
#include "http/response.h"
#include "http/service.h"
#include "log/escape.h"
#include "net/stream.h"
#include "net/timed_event.h"

namespace talus::server::http {

template <Stream S>
class Connection : public std::enable_shared_from_this<Connection<S>> {
 public:
  /// Takes the stream over after a response with status 101 is written, with what has been read already.
  using TakeOver = std::function<void(S stream, std::span<const std::byte> unread)>;

  Connection(S stream, const Service& service, std::shared_ptr<Handler> handler, TakeOver take_over = {})
      : stream_{std::move(stream)},
        service_{service},
        handler_{std::move(handler)},
        take_over_{std::move(take_over)},
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
    handler_->closed();
  }
  /// Closes after the response in flight: no further request is answered.
  void finish() {
    finishing_ = true;
    if (!answering_ && !parser_.mid_request()) close();
  }
  [[nodiscard]] bool open() const { return open_; }
  /// When the client last sent or took something.
  [[nodiscard]] Clock::time_point last_active() const { return last_active_; }
  /// Looks at the clock again: for who moves a ManualClock.
  void clock_moved() { watch_waits_.notify(); }

 private:
  // Responses wait for each other up to so many bytes.
  static constexpr std::size_t kBatchBytes = std::size_t{32} * 1024;

  [[nodiscard]] asio::awaitable<void> serve() {
    bool more = true;
    while (open_ && more) {
      const auto taken = parser_.feed(std::span{input_}.subspan(read_, filled_ - read_));
      if (!taken) {
        more = false;
        co_await add(handler_->refuse(taken.error()), false, false);
        continue;
      }
      read_ += *taken;
      if (parser_.has_request()) {
        more = co_await answer(parser_.request());
        if (parser_.has_request()) parser_.pop();
      } else {
        co_await flush();
        more = open_ && co_await read();
      }
    }
    if (!open_) co_return;
    co_await flush();
    if (open_) co_await end();
    close();
  }

  /// Returns whether another request may follow.
  [[nodiscard]] asio::awaitable<bool> answer(const Request& request) {
    answering_ = true;
    std::optional<Response> response = respond_now(request);
    if (!response) {
      co_await flush();
      wait_for_handler();
      response = co_await respond(request);
      if (!open_) co_return false;
      deadline_ = service_.clock.now() + service_.response_timeout;
      watch_waits_.notify();
    }
    const bool more = request.keep_alive && !finishing_;
    co_await add(*std::move(response), request.method == Method::head, more);
    if (!open_ || !upgraded_) {
      answering_ = false;
      co_return more;
    }
    co_await flush();
    if (!open_) co_return false;
    open_ = false;
    watch_waits_.notify();
    take_over_(std::move(stream_), std::span{input_}.subspan(read_, filled_ - read_));
    co_return false;
  }

  [[nodiscard]] std::optional<Response> respond_now(const Request& request) {
    try {
      return handler_->respond_now(request);
    } catch (const std::exception& error) {
      return failed(request, error);
    }
  }

  [[nodiscard]] asio::awaitable<Response> respond(const Request& request) {
    std::optional<Response> response;
    try {
      response = co_await handler_->respond(request);
    } catch (const std::exception& error) {
      response = failed(request, error);
    }
    co_return *std::move(response);
  }

  [[nodiscard]] Response failed(const Request& request, const std::exception& error) const {
    service_.log->error("{} failed: {}", escaped(std::string{request.path()}, 200), error.what());
    return {500, kPlainText, "the server failed to answer this; its log says more\n"};
  }

  // The handler keeps to times of its own.
  void wait_for_handler() { deadline_ = Clock::time_point::max(); }

  [[nodiscard]] asio::awaitable<bool> read() {
    const bool began = parser_.mid_request();
    if (!began && answered_) deadline_ = service_.clock.now() + service_.idle_timeout;
    std::error_code failed;
    read_ = 0;
    filled_ = co_await stream_.async_read_some(asio::buffer(input_),
                                               asio::redirect_error(asio::use_awaitable, failed));
    last_active_ = service_.clock.now();
    if (!began && answered_) {
      deadline_ = last_active_ + service_.request_timeout;
      watch_waits_.notify();
    }
    co_return !failed;
  }

  [[nodiscard]] asio::awaitable<void> add(Response response, bool head_only, bool keep_alive) {
    upgraded_ = response.status == 101;
    append_head(output_, response, keep_alive, service_.clock.wall());
    answered_ = true;
    if (head_only) {
      co_return;
    }
    const std::string_view content = response.content();
    if (output_.size() + content.size() <= kBatchBytes) {
      output_ += content;
      co_return;
    }
    co_await write(content);
  }

  [[nodiscard]] asio::awaitable<void> flush() {
    if (!output_.empty()) co_await write({});
  }

  /// What waits, and `body` after it.
  [[nodiscard]] asio::awaitable<void> write(std::string_view body) {
    deadline_ = service_.clock.now() + service_.response_timeout;
    const std::array<asio::const_buffer, 2> pieces{asio::buffer(output_), asio::buffer(body)};
    const auto progress = [this](const std::error_code& error, std::size_t) -> std::size_t {
      last_active_ = service_.clock.now();
      deadline_ = last_active_ + service_.response_timeout;
      return error ? 0 : SIZE_MAX;
    };
    std::error_code failed;
    auto token = asio::redirect_error(asio::use_awaitable, failed);
    if (body.empty()) {  // a cheaper system call
      co_await asio::async_write(stream_, pieces.front(), progress, token);
    } else {
      co_await asio::async_write(stream_, pieces, progress, token);
    }
    output_.clear();
    if (output_.capacity() > 2 * kBatchBytes) output_.shrink_to_fit();
    if (failed) close();
    deadline_ = service_.clock.now() + service_.request_timeout;
  }

  /// Closing over unread bytes would reset the connection, and could take the response with it.
  [[nodiscard]] asio::awaitable<void> end() {
    deadline_ = service_.clock.now() + service_.response_timeout;
    co_await stream_.say_end();
    if (!open_) co_return;
    stream_.shutdown();
    answered_ = false;  // what is read now begins no request
    for (bool more = true; open_ && more;) more = co_await read();
  }

  [[nodiscard]] asio::awaitable<void> watch() {
    while (open_ && service_.clock.now() < deadline_) co_await watch_waits_.wait_until(deadline_);
    close();
  }

  S stream_;
  const Service& service_;
  const std::shared_ptr<Handler> handler_;
  const TakeOver take_over_;
  RequestParser parser_;
  TimedEvent watch_waits_;
  Clock::time_point last_active_;
  Clock::time_point deadline_;  // who brings it forward notifies watch()
  bool open_ = true;
  bool finishing_ = false;
  bool answering_ = false;
  bool answered_ = false;  // some request
  bool upgraded_ = false;
  std::size_t read_ = 0;  // of input_
  std::size_t filled_ = 0;
  std::string output_;  // responses that wait for the next write
  std::array<std::byte, 4096> input_;
};

}  // namespace talus::server::http
