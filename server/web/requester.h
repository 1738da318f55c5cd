// The client of a connection's requests, its rights and its rates: the connection's own client, or one that a
// proxy names.
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
#include "net/timed_event.h"
#include "runtime/clock.h"
#include "web/cache_fields.h"
#include "web/error_answers.h"
#include "web/web_context.h"

namespace talus::server::web {

class Requester {
 public:
  /// `context` outlives it. `slot`: the connection's admission slot.
  Requester(const WebContext& context, const ConnectionInfo& connection, Admission::Slot slot);

  /// The flow of the request's client: the connection's own, or the one that a proxy names.
  [[nodiscard]] FlowId flow_of_client(const http::Request& request) const;

  // ---- before a request is answered; each returns an error if it refuses the request
  /// Finds the client, if a proxy names it.
  [[nodiscard]] Answer find(const http::Request& request);
  [[nodiscard]] Answer check_rates(Clock::time_point now);
  /// `for_caches`: the answer is the same for all clients. Sets `audience` to the receivers of the answer, or
  /// of the refusal.
  [[nodiscard]] Answer check_token(const http::Request& request, bool for_caches, Audience& audience) const;

  // ---- while it is answered
  [[nodiscard]] bool is_here() const { return caller_.has_value(); }
  /// Only if is_here(); also flow() and next_chunk().
  [[nodiscard]] RateLimits limits() const { return caller_->rates.limits(); }
  [[nodiscard]] const FlowUsePtr& flow() const { return caller_->flow; }
  /// Time at which the rates allow a chunk; `now`: at once.
  [[nodiscard]] Clock::time_point next_chunk(Clock::time_point now);
  /// Waits until then; returns an error if the wait is too long. Call it before the work, so that a client
  /// over its rate costs the generators nothing.
  [[nodiscard]] asio::awaitable<Answer> wait_for_rates(asio::any_io_executor executor);
  /// Charges the rates.
  void charge(std::size_t chunks, std::size_t bytes) { charge(shared_.clock.now(), chunks, bytes); }
  void charge(Clock::time_point now, std::size_t chunks, std::size_t bytes);
  /// Adds to the flow.
  void sent(std::size_t bytes);

  /// The client of the connection's own slot sent something.
  void progress(Clock::time_point now) {
    if (!connection_.through_proxy) caller_->slot.progress(now);
  }
  /// The connection may give way to other flows'; a proxy's, which serves many clients, never does.
  void set_give_way(const FlowShares::GiveWay& give_way) {
    if (!connection_.through_proxy) caller_->slot.set_give_way(give_way);
  }

  // ---- between requests
  void answered(int status);
  /// Ends the last request.
  void end();
  /// Returns true if the client's address is on the list of blocked addresses now.
  [[nodiscard]] bool blocked() const;
  void rates_changed();
  /// The client's address for the log.
  [[nodiscard]] std::string address() const;
  /// The slot of the client that requested a session, for that session.
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
  std::optional<TimedEvent> throttle_;         // of the last wait_for_rates()
  std::optional<Admission::Slot> proxy_slot_;  // for a connection whose requests name their clients
};

}  // namespace talus::server::web
