// Answers the requests of HTTP connections.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include <asio/awaitable.hpp>

#include "limits/flows/flow_ids.h"
#include "net/http/request.h"
#include "net/http/response.h"
#include "runtime/clock.h"

namespace talus::server::http {

/// Called on the connection's executor, one request at a time. An exception becomes a 500.
class Handler {
 public:
  virtual ~Handler() = default;

  /// Returns the response, or nullopt if respond() must wait for it. `came`: time of the connection's last
  /// wait, moments ago, which saves a clock reading for each request.
  [[nodiscard]] virtual std::optional<Response> respond_now(const Request& request,
                                                            Clock::time_point came) = 0;
  /// `request` stays valid until the response is returned. The connection waits without a time-out.
  [[nodiscard]] virtual asio::awaitable<Response> respond(const Request& request) = 0;

  /// The client that sent the request: its connections share turns of the io thread. By default all are one.
  [[nodiscard]] virtual FlowId flow_of(const Request& /*request*/) const { return {}; }

  /// Returns the response to a malformed request. The connection closes after it.
  [[nodiscard]] virtual Response refuse(const RequestError& error) { return response_to(error); }

  /// The system took `bytes` of a response that it did not take at once.
  virtual void wrote(std::size_t /*bytes*/) {}
  /// All responses so far were written to the system, or lost.
  virtual void sent() {}
  /// The connection is closed; no calls follow.
  virtual void closed() {}
};

/// Answers at once, the same for every connection.
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
