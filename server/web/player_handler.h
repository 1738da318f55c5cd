// Answers one connection's HTTP requests: chunks, columns of chunks, heights, maps, the world. Cached answers
// are sent at once; others wait for the generators, in turn with the client's flow.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include <asio/any_io_executor.hpp>
#include <asio/awaitable.hpp>

#include "net/accepted_connection.h"
#include "net/admission.h"
#include "net/http/handler.h"
#include "net/http/request.h"
#include "net/http/response.h"
#include "runtime/clock.h"
#include "web/exchange.h"
#include "web/requester.h"
#include "web/routes.h"
#include "web/web_context.h"

namespace talus::server::web {

class PlayerHandler final : public http::Handler {
 public:
  /// `slot`: the connection's admission slot.
  PlayerHandler(WebContextPtr context, const ConnectionInfo& connection, Admission::Slot slot,
                asio::any_io_executor executor);
  ~PlayerHandler() override = default;

  std::optional<http::Response> respond_now(const http::Request& request, Clock::time_point came) override;
  asio::awaitable<http::Response> respond(const http::Request& request) override;
  [[nodiscard]] FlowId flow_of(const http::Request& request) const override {
    return requester_.flow_of_client(request);
  }
  http::Response refuse(const http::RequestError& error) override;
  void wrote(std::size_t bytes) override;
  void sent() override;
  void closed() override;
  /// Sets the function called once if the connection ends without becoming a session.
  void on_closed(std::function<void()> told) { told_ = std::move(told); }

  /// Call once, before the first request. `give_way` closes the connection.
  void share(const FlowShares::GiveWay& give_way) {
    requester_.set_give_way(give_way);
    exchange_.share_memory(give_way);
  }

  [[nodiscard]] Requester& requester() { return requester_; }

 private:
  [[nodiscard]] Answer decide(const http::Request& request);
  void finish(const http::Request& request, http::Response& response);
  [[nodiscard]] AnswerKind kind() const;
  void log_refused_page(const std::string& origin) const;
  void log_answer(const http::Request& request, int status, std::size_t bytes) const;

  const WebContextPtr context_;
  const SessionContext& shared_;
  const ConnectionId id_;
  Requester requester_;
  Exchange exchange_;
  std::optional<Route> route_;  // the current request's
  std::function<void()> told_;
  bool closed_ = false;
};

}  // namespace talus::server::web
