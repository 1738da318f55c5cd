// What answers the requests of HTTP connections.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include <asio/awaitable.hpp>

#include "net/http/request.h"
#include "net/http/response.h"
#include "runtime/clock.h"

namespace talus::server::http {

/// Called on the connection's executor, for one request after the other. What it throws becomes a 500.
class Handler {
 public:
  virtual ~Handler() = default;

  /// The response, where nothing has to be waited for. None: respond() gives it. `came`: when the connection
  /// last waited, which is a moment ago: who asks the clock again for every request pays for that.
  [[nodiscard]] virtual std::optional<Response> respond_now(const Request& request,
                                                            Clock::time_point came) = 0;
  /// `request` stays until the response is there. The connection waits as long as the handler does.
  [[nodiscard]] virtual asio::awaitable<Response> respond(const Request& request) = 0;

  /// The response to what is no request. The connection closes after it.
  [[nodiscard]] virtual Response refuse(const RequestError& error) { return response_to(error); }

  /// All responses so far are with the system, or lost.
  virtual void sent() {}
  /// The connection is closed, and asks nothing more.
  virtual void closed() {}
};

/// Answers at once, whatever connection asks.
class FunctionHandler final : public Handler {
 public:
  using Function = std::function<Response(const Request&)>;

  explicit FunctionHandler(Function function) : function_{std::move(function)} {}

  std::optional<Response> respond_now(const Request& request, Clock::time_point /*came*/) override {
    return function_(request);
  }
  asio::awaitable<Response> respond(const Request& request) override { co_return function_(request); }

 private:
  Function function_;
};

}  // namespace talus::server::http
