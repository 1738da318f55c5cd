// An HTTP connection over a stream: reads requests, answers them one after the other, and closes in time.
// Responses to pipelined requests are written together. Everything runs on the stream's executor, without
// locks. It lives as long as an operation is in flight.
#pragma once

#include <algorithm>
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
#include <asio/execution/context.hpp>
#include <asio/post.hpp>
#include <asio/query.hpp>
#include <asio/redirect_error.hpp>
#include <asio/use_awaitable.hpp>

#include "net/http/handler.h"
#include "net/http/request_parser.h"
#include "net/http/response.h"
#include "net/http/service.h"
#include "net/io_turns.h"
#include "net/rounds.h"
#include "net/stream.h"
#include "net/timed_event.h"
#include "runtime/clock.h"
#include "runtime/log/escape.h"

namespace talus::server::http {

template <Stream S>
class Connection final : public IoTurns::Waiter, public std::enable_shared_from_this<Connection<S>> {
 public:
  /// Takes over the stream after a response with status 101 is written, with the bytes already read.
  using TakeOver = std::function<void(S stream, std::span<const std::byte> unread)>;

  Connection(S stream, const Service& service, std::shared_ptr<Handler> handler, TakeOver take_over = {})
      : stream_{std::move(stream)},
        service_{service},
        handler_{std::move(handler)},
        take_over_{std::move(take_over)},
        parser_{service.bounds},
        rounds_{asio::use_service<Rounds<Connection>>(
            asio::query(stream_.get_executor(), asio::execution::context))},
        turns_{asio::use_service<IoTurns>(asio::query(stream_.get_executor(), asio::execution::context))},
        watch_waits_{stream_.get_executor(), service.clock},
        turn_comes_{stream_.get_executor(), service.clock},
        now_{service.clock.now()},
        last_active_{now_} {}

  /// Call once, on the stream's executor.
  void start() {
    deadline_ = last_active_ + service_.request_timeout;
    go_on(Next::input);
    asio::co_spawn(
        stream_.get_executor(), [self = this->shared_from_this()] { return self->watch(); },
        keeping(&Connection::ended));
  }

  /// Closes at once, whatever is in flight. On the stream's executor, as all functions below.
  void close() {
    if (!std::exchange(open_, false)) return;
    stream_.close();
    watch_waits_.notify();
    handler_->closed();
  }
  /// Closes after the current request and the queued responses. No further request is answered.
  void finish() {
    finishing_ = true;
    if (between_requests_) close();
  }
  [[nodiscard]] bool open() const { return open_; }
  /// Time at which bytes last moved in either direction.
  [[nodiscard]] Clock::time_point last_active() const { return last_active_; }
  /// Re-evaluates all timers. For tests that advance a ManualClock.
  void clock_moved() { watch_waits_.notify(); }

 private:
  friend class Rounds<Connection>;

  // Responses are gathered into one write up to this size.
  static constexpr std::size_t kBatchBytes = std::size_t{32} * 1024;
  // Of a body that one write offers: the system copies it meanwhile.
  static constexpr std::size_t kBodyPiece = std::size_t{128} * 1024;
  // Interval of checks for a hang-up while a request waits: its work is dropped if its client has gone.
  static constexpr std::chrono::milliseconds kHangUpCheck{250};

  // True if the stream can write at once, without resuming a coroutine. Responses from memory then need no
  // coroutine at all: each resumption would cost as much as finding the chunk.
  static constexpr bool kWritesNow = requires(S & stream) { stream.write_now(asio::const_buffer{}); };

  /// The event that the connection needs to go on; `request`: none if another request was read.
  enum class Next : std::uint8_t { request, input, room, response, body, turn, hand_over, end };

  void go_on(Next next) {
    if constexpr (kWritesNow) {
      // Read after other connections with waiting requests: a client that answers quickly has sent its next
      // request by then. An immediate read would mostly find nothing and cost a system call.
      if (next == Next::input) return rounds_.enter(this->shared_from_this(), stream_.get_executor());
    }
    if (next == Next::turn) return turns_.wait(flow_, this->shared_from_this(), stream_.get_executor());
    asio::co_spawn(
        stream_.get_executor(), [self = this->shared_from_this(), next] { return self->serve(next); },
        keeping(&Connection::ended));
  }
  void read() noexcept {
    if (!open_) return;
    try {
      if (finishing_ && !parser_.mid_request()) return go_on(Next::end);
      begin_reading();
      between_requests_ = !parser_.mid_request();
      stream_.async_read_some(asio::buffer(input_), keeping(&Connection::take_input));
    } catch (const std::exception& error) {
      fail(error);
    }
  }
  void take_input(std::error_code failed, std::size_t bytes) {
    read_error_ = failed;
    end_reading(bytes);
    between_requests_ = false;
    take_turn();
  }
  void take_turn() override {
    if (write_waits_ > 0) {
      turns_.charge(flow_, std::exchange(write_waits_, 0));
      return turn_comes_.notify();
    }
    if (!open_) return;
    try {
      go_on(read_error_ ? Next::end : answer());
    } catch (const std::exception& error) {
      fail(error);
    }
  }
  void fail(const std::exception& error) {
    service_.log->error("a connection failed: {}", error.what());
    close();
  }

  /// Completion of serve() and watch().
  void ended(const std::exception_ptr& failed) {
    if (failed) close();
  }
  /// Returns a completion handler that keeps the connection alive.
  template <typename Result, typename... Arguments>
  [[nodiscard]] auto keeping(Result (Connection::*call)(Arguments...)) {
    return [self = this->shared_from_this(), call](auto&&... arguments) { ((*self).*call)(arguments...); };
  }

  /// Handles everything that the stream cannot do at once.
  [[nodiscard]] asio::awaitable<void> serve(Next next) {
    while (open_) {
      switch (next) {
        case Next::request:
          next = answer();
          break;
        case Next::input:
          if (kWritesNow) co_return go_on(next);
          begin_reading();
          between_requests_ = !parser_.mid_request();
          end_reading(co_await stream_.async_read_some(
              asio::buffer(input_), asio::redirect_error(asio::use_awaitable, read_error_)));
          between_requests_ = false;
          next = read_error_ ? Next::end : answer();
          break;
        case Next::room:
          co_await write({});
          next = answer();
          break;
        case Next::response:
          response_ = co_await wait_for_response(parser_.request());
          next = take_response();
          break;
        case Next::body:
          co_await write_body(*response_);
          next = after_response();
          break;
        case Next::turn:
          co_return go_on(next);
        case Next::hand_over:
          co_return co_await hand_over();
        case Next::end:
          if (!output_.empty()) co_await write({});
          if (open_) co_await end();
          close();
          break;
      }
    }
    response_.reset();  // a closed connection that is kept for a while holds no checkpoint
  }

  /// Answers the requests that were read until it has to wait.
  [[nodiscard]] Next answer() {
    while (open_) {
      if (!parser_.has_request()) {
        const auto taken = parser_.feed(std::span{input_}.subspan(read_, filled_ - read_));
        if (!taken) {
          response_ = handler_->refuse(taken.error());
          more_ = false;
          return add(*response_, false, false) ? Next::end : Next::body;
        }
        read_ += *taken;
      }
      if (!parser_.has_request()) {
        if (!output_.empty() && !write_now()) return Next::room;
        return finishing_ && !parser_.mid_request() ? Next::end : Next::input;
      }
      flow_ = handler_->flow_of(parser_.request());
      if (!turns_.go_on(flow_, IoTurns::input_cost(parser_.head_bytes()))) return Next::turn;
      response_ = respond_now(parser_.request());
      if (!response_) return Next::response;
      if (const Next next = take_response(); next != Next::request) return next;
    }
    return Next::end;
  }

  [[nodiscard]] Next take_response() {
    if (!open_) return Next::end;
    const Request& request = parser_.request();
    upgraded_ = response_->status == 101;
    // After an upgrade request a proxy forwards any bytes that follow, which may contain other clients'
    // names.
    more_ = request.keep_alive && !request.upgrade && !response_->last && !finishing_;
    return add(*response_, request.method == Method::head, more_) ? after_response() : Next::body;
  }
  [[nodiscard]] Next after_response() {
    response_.reset();  // does not keep a checkpoint or a chunk while the client is idle
    if (open_ && upgraded_) return Next::hand_over;
    if (!open_ || !more_) return Next::end;
    parser_.pop();
    return Next::request;
  }

  /// The result is meaningless if the connection has been closed.
  [[nodiscard]] asio::awaitable<Response> wait_for_response(const Request& request) {
    if (!output_.empty()) co_await write({});
    if (!open_) co_return Response{};
    deadline_ = Clock::time_point::max();  // the handler has its own time-outs
    waiting_ = true;
    watch_waits_.notify();
    Response response = co_await respond(request);
    waiting_ = false;
    now_ = service_.clock.now();
    deadline_ = now_ + service_.response_timeout;
    co_return response;
  }

  [[nodiscard]] asio::awaitable<void> hand_over() {
    co_await write({});
    if (!open_) co_return;
    open_ = false;
    watch_waits_.notify();
    take_over_(std::move(stream_), std::span{input_}.subspan(read_, filled_ - read_));
  }

  [[nodiscard]] std::optional<Response> respond_now(const Request& request) {
    try {
      return handler_->respond_now(request, now_);
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

  void begin_reading() {
    reads_next_ = answered_ && !parser_.mid_request();
    if (reads_next_) deadline_ = last_active_ + service_.idle_timeout;
    read_ = 0;
  }
  void end_reading(std::size_t bytes) {
    filled_ = bytes;
    last_active_ = now_ = service_.clock.now();
    if (reads_next_) deadline_ = last_active_ + service_.request_timeout;
  }

  /// Appends a response to the next write. Returns false if its body is too long; its head is still appended.
  [[nodiscard]] bool add(const Response& response, bool head_only, bool keep_alive) {
    append_head(output_, response, keep_alive, service_.clock.wall());
    answered_ = true;
    if (head_only) return true;
    if (response.source != nullptr || output_.size() + response.content().size() > kBatchBytes) return false;
    output_ += response.content();
    return true;
  }

  /// Returns true if the stream took all the output.
  [[nodiscard]] bool write_now() {
    if constexpr (kWritesNow) {
      output_.erase(0, stream_.write_now(asio::buffer(output_)));
      if (!output_.empty()) return false;
      last_active_ = now_;
      deadline_ = last_active_ + service_.request_timeout;
      handler_->sent();
      return true;
    }
    return false;
  }

  /// Waits until the client's flow may go on with a piece of this cost.
  [[nodiscard]] asio::awaitable<void> wait_for_turn(std::uint64_t cost) {
    if (turns_.go_on(flow_, cost)) co_return;
    turns_.wait(flow_, this->shared_from_this(), stream_.get_executor());
    for (write_waits_ = cost; write_waits_ > 0;) {
      co_await turn_comes_.wait_until(Clock::time_point::max());
    }
  }

  /// Writes the output and then `body`.
  [[nodiscard]] asio::awaitable<void> write(std::string_view body) {
    asio::const_buffer head = asio::buffer(output_);
    asio::const_buffer rest = asio::buffer(body);
    std::error_code failed;
    deadline_ = service_.clock.now() + service_.response_timeout;
    while (!failed && head.size() + rest.size() > 0) {
      const asio::const_buffer part = asio::buffer(rest, kBodyPiece);
      co_await wait_for_turn(1 + part.size() / IoTurns::kAnswerBytes);
      if (!open_) co_return;
      auto token = asio::redirect_error(asio::use_awaitable, failed);
      std::size_t sent = 0;
      if (rest.size() == 0 || head.size() == 0) {  // a cheaper system call
        sent = co_await stream_.async_write_some(head.size() == 0 ? part : head, token);
      } else {
        sent = co_await stream_.async_write_some(std::array{head, part}, token);
      }
      const std::size_t of_head = std::min(sent, head.size());
      head += of_head;
      rest += sent - of_head;
      turns_.give_back(flow_, part.size() / IoTurns::kAnswerBytes - (sent - of_head) / IoTurns::kAnswerBytes);
      last_active_ = now_ = service_.clock.now();
      deadline_ = last_active_ + service_.response_timeout;
      handler_->wrote(sent);
    }
    output_.clear();
    if (output_.capacity() > kBatchBytes) output_.shrink_to_fit();
    if (failed) co_return close();
    handler_->sent();
    deadline_ = last_active_ + service_.request_timeout;
  }

  [[nodiscard]] asio::awaitable<void> write_body(const Response& response) {
    if (response.source == nullptr) co_return co_await write(response.content());
    while (open_) {
      deadline_ = Clock::time_point::max();  // the source has its own time-outs
      waiting_ = true;
      watch_waits_.notify();
      const std::string_view piece = co_await next_piece(*response.source);
      waiting_ = false;
      if (piece.empty() || !open_) co_return;
      co_await write(piece);
    }
  }

  /// If the source fails, the reader receives a truncated body.
  [[nodiscard]] asio::awaitable<std::string_view> next_piece(BodySource& source) {
    std::string_view piece;
    try {
      piece = co_await source.next();
    } catch (const std::exception& error) {
      service_.log->warn("a response was cut: {}", error.what());
      close();
    }
    co_return piece;
  }

  /// Reads until the client's end: closing with unread bytes would reset the connection and could lose the
  /// response.
  [[nodiscard]] asio::awaitable<void> end() {
    deadline_ = service_.clock.now() + service_.response_timeout;
    co_await stream_.say_end();
    if (!open_) co_return;
    stream_.shutdown();
    answered_ = false;  // input from here on is ignored
    while (open_ && !read_error_) {
      begin_reading();
      end_reading(co_await stream_.async_read_some(asio::buffer(input_),
                                                   asio::redirect_error(asio::use_awaitable, read_error_)));
    }
  }

  /// Wakes at least once per shortest time-out, so that code that moves the deadline forward need not wake
  /// it. Nothing is read while the handler works, so it polls for a hang-up.
  [[nodiscard]] asio::awaitable<void> watch() {
    const auto nap = std::min({service_.idle_timeout, service_.request_timeout, service_.response_timeout});
    for (auto now = service_.clock.now(); open_ && now < deadline_; now = service_.clock.now()) {
      if (waiting_ && stream_.peer_hung_up()) break;
      const auto longest = waiting_ ? std::min(nap, kHangUpCheck) : nap;
      co_await watch_waits_.wait_until(std::min(deadline_, now + longest));
    }
    close();
  }

  S stream_;
  const Service& service_;
  const std::shared_ptr<Handler> handler_;
  const TakeOver take_over_;
  RequestParser parser_;
  Rounds<Connection>& rounds_;  // one for each io_context
  IoTurns& turns_;
  TimedEvent watch_waits_;
  TimedEvent turn_comes_;
  Clock::time_point now_;  // time of the last wait
  Clock::time_point last_active_;
  Clock::time_point deadline_;
  bool open_ = true;
  bool finishing_ = false;
  bool waiting_ = false;              // for the handler
  bool between_requests_ = false;     // and reading
  bool answered_ = false;             // at least one request
  std::optional<Response> response_;  // to the parser's request
  bool more_ = true;                  // further requests are answered
  bool upgraded_ = false;
  FlowId flow_{};                  // of the last request
  std::uint64_t write_waits_ = 0;  // cost of the write that waits for a turn
  bool reads_next_ = false;        // waits for the next request
  std::error_code read_error_;
  std::size_t read_ = 0;  // offset in input_
  std::size_t filled_ = 0;
  std::string output_;  // responses for the next write, or the unwritten rest
  std::array<std::byte, 4096> input_;
};

}  // namespace talus::server::http
