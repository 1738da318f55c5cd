#include "web/requester.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "net/address_text.h"
#include "player/session/retry_after.h"
#include "web/documents.h"
#include "web/forwarded_for.h"

namespace talus::server::web {
namespace {

using wire::ErrorCode;

// Maximum time that rates delay a request.
constexpr std::chrono::seconds kMaxThrottle{5};

}  // namespace

Requester::Caller::Caller(Admission::Slot of, const WebContext& context)
    : slot{std::move(of)},
      rates{context.runner->session.rates.get(), slot.rates(),
            context.runner->session.limits.requests_in_flight},
      flow{flow_of(slot.counted(), context.runner->session.flows)} {}

Requester::Requester(const WebContext& context, const ConnectionInfo& connection, Admission::Slot slot)
    : context_{context}, shared_{context.runner->session}, connection_{connection} {
  if (connection_.through_proxy) {
    proxy_slot_.emplace(std::move(slot));
  } else {
    caller_.emplace(std::move(slot), context_);
  }
}

FlowId Requester::flow_of_client(const http::Request& request) const {
  if (!connection_.through_proxy) return caller_->flow->id();
  const auto address = forwarded_for(request.list("X-Forwarded-For"), context_.settings.proxies);
  return address ? flow_id_of(counted_as(*address), shared_.flows.ids()) : FlowId{};
}

Answer Requester::find(const http::Request& request) {
  if (!connection_.through_proxy) return std::nullopt;
  const auto address = forwarded_for(request.list("X-Forwarded-For"), context_.settings.proxies);
  if (!address) {
    return error_response(
        400, ErrorCode::malformed,
        "the proxy in front of this server must name a client outside `proxies` in X-Forwarded-For");
  }
  if (shared_.access.meet(*address)) {
    shared_.metrics.denied(AuthFailure::blocked).add();
    http::Response blocked = blocked_response();
    blocked.last = true;
    return blocked;
  }
  auto slot = context_.admission.enter_request(*address);
  if (!slot) return error_response(503, ErrorCode::overloaded, slot.error(), retry_after::kServerFull);
  caller_.emplace(*std::move(slot), context_);
  return std::nullopt;
}

Answer Requester::check_rates(Clock::time_point now) {
  if (const auto refusal = caller_->rates.refuse_request(now)) return refuse(*refusal);
  // Other answers spend bytes too: a client with a large debt waits.
  const Clock::time_point due = next_chunk(now);
  if (due <= now + kMaxThrottle) return std::nullopt;
  return over_rate(due - now);
}

Answer Requester::check_token(const http::Request& request, bool for_caches, Audience& audience) const {
  if (for_caches && context_.settings.public_chunks) {
    audience.caches = true;
    return std::nullopt;
  }
  audience.anybody = shared_.access.lets_anybody_read();
  audience.caches = for_caches && audience.anybody;
  const std::string token = request.bearer_token();
  if (audience.caches && token.empty()) return std::nullopt;
  const auto grant = shared_.access.admit(token, shared_.clock.wall());
  if (!grant) {
    shared_.metrics.denied(grant.error().failure).add();
    return token_refused(grant.error());
  }
  return grant->rights.has(Right::read) ? std::nullopt : Answer{right_missing()};
}

Clock::time_point Requester::next_chunk(Clock::time_point now) {
  const SessionRates::Due due = caller_->rates.chunks_due(now);
  if (due.throttled) shared_.metrics.throttled(*due.throttled).add();
  return due.at;
}

asio::awaitable<Answer> Requester::wait_for_rates(asio::any_io_executor executor) {
  throttle_.emplace(executor, shared_.clock);
  const auto until = shared_.clock.now() + kMaxThrottle;
  for (;;) {
    if (!caller_) co_return fetch_failed(FetchError::gone, shared_.memory);
    const auto now = shared_.clock.now();
    const Clock::time_point due = next_chunk(now);
    if (due <= now) break;
    if (due > until) co_return over_rate(due - now);
    co_await throttle_->wait_until(due);
  }
  co_return std::nullopt;
}

http::Response Requester::over_rate(std::chrono::nanoseconds wait) const {
  caller_->flow->add(FlowMeasure::refusals, 1);
  return error_response(429, ErrorCode::overloaded,
                        "this request exceeds your rate; Retry-After gives the time to retry",
                        std::chrono::ceil<std::chrono::milliseconds>(wait));
}

void Requester::charge(Clock::time_point now, std::size_t chunks, std::size_t bytes) {
  if (caller_) caller_->rates.sent(now, chunks, bytes);
}

void Requester::sent(std::size_t bytes) {
  if (caller_) caller_->flow->add(FlowMeasure::sent, bytes);
}

void Requester::answered(int status) {
  // The next request may come from another client; until then this one holds no slot.
  if (connection_.through_proxy && status != 101) leave();
}

void Requester::end() {
  leave();
  proxy_slot_.reset();
}

void Requester::leave() {
  if (caller_) caller_->rates.give_back();
  caller_.reset();
  if (throttle_) throttle_->notify();
}

bool Requester::blocked() const {
  return caller_ && shared_.access.blocks(caller_->slot.address());
}

void Requester::rates_changed() {
  if (caller_) caller_->rates.change(shared_.rates.get(), caller_->slot.rates(), shared_.clock.now());
}

Admission::Slot Requester::take_slot() {
  Admission::Slot slot = std::move(caller_->slot);
  if (proxy_slot_) slot.take_place(*proxy_slot_);
  caller_.reset();
  return slot;
}

ConnectionInfo Requester::session_info() const {
  ConnectionInfo info = connection_;
  if (info.through_proxy && caller_) info.address = address_text(caller_->slot.address());
  return info;
}

std::string Requester::address() const {
  return caller_ ? address_text(caller_->slot.address()) : connection_.address;
}

http::Response Requester::refuse(const SessionRates::Refusal& refusal) const {
  shared_.metrics.throttled(refusal.kind).add();
  caller_->flow->add(FlowMeasure::refusals, 1);
  http::Response response = error_response(
      429, ErrorCode::overloaded, "too many requests; Retry-After gives the time to retry",
      std::max(std::chrono::milliseconds{1}, std::chrono::ceil<std::chrono::milliseconds>(refusal.wait)));
  response.last = refusal.abusive && !connection_.through_proxy;
  return response;
}

}  // namespace talus::server::web
