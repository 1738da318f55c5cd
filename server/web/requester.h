// Who asks on one connection, what it may have, and how fast: the connection's client, or whom a proxy names.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include <asio/any_io_executor.hpp>
#include <asio/awaitable.hpp>

#include "limits/flows/flow_use.h"
#include "limits/rates/rates.h"
#include "net/accepted_connection.h"
#include "net/admission.h"
#include "net/http/request.h"
#include "net/http/response.h"
#include "runtime/clock.h"
#include "web/cache_fields.h"
#include "web/error_answers.h"
#include "web/web_context.h"

namespace talus::server::web {

class Requester {
 public:
  /// `context` outlives it. `slot`: the connection's.
  Requester(const WebContext& context, const ConnectionInfo& connection, Admission::Slot slot);

  // ---- before a request is answered; an answer where it is refused
  /// Whose it is, where a proxy names that.
  [[nodiscard]] Answer find(const http::Request& request);
  [[nodiscard]] Answer check_rates(Clock::time_point now);
  /// `for_caches`: of an answer that is the same for all. `audience`: who gets it, or the refusal.
  [[nodiscard]] Answer check_token(const http::Request& request, bool for_caches, Audience& audience) const;

  // ---- while it is answered
  [[nodiscard]] bool is_here() const { return caller_.has_value(); }
  /// Only while is_here(), as flow() and next_chunk().
  [[nodiscard]] RateLimits limits() const { return caller_->rates.limits(); }
  [[nodiscard]] const FlowUsePtr& flow() const { return caller_->flow; }
  /// When the rates let a chunk go; `now`: at once.
  [[nodiscard]] Clock::time_point next_chunk(Clock::time_point now);
  /// Waits for that; an answer where it is too long. Before the work: who has no rate left costs the
  /// generators nothing.
  [[nodiscard]] asio::awaitable<Answer> wait_for_rates(asio::any_io_executor executor);
  /// Counts in the rates.
  void charge(std::size_t chunks, std::size_t bytes) { charge(shared_.clock.now(), chunks, bytes); }
  void charge(Clock::time_point now, std::size_t chunks, std::size_t bytes);
  /// Counts in the flow.
  void sent(std::size_t bytes);

  // ---- between requests
  void answered(int status);
  /// Nobody asks any more.
  void end();
  /// The connection's address is on the list of the blocked now.
  [[nodiscard]] bool blocked() const;
  void rates_changed();
  /// As the log names it.
  [[nodiscard]] std::string address() const;
  /// For the session that takes the connection over: of the client that asked for it.
  [[nodiscard]] Admission::Slot take_slot();
  [[nodiscard]] ConnectionInfo session_info() const;

 private:
  struct Caller {
    Caller(Admission::Slot of, const WebContext& context);
    Admission::Slot slot;
    SessionRates rates;
    FlowUsePtr flow;
  };

  [[nodiscard]] http::Response refuse(const SessionRates::Refusal& refusal) const;
  [[nodiscard]] http::Response over_rate(std::chrono::nanoseconds wait) const;
  void leave();

  const WebContext& context_;
  const SessionContext& shared_;
  const ConnectionInfo connection_;
  std::optional<Caller> caller_;
  std::optional<Admission::Slot> proxy_slot_;  // of a connection whose requests name their clients
};

}  // namespace talus::server::web
