// The operators' HTTP pages: /metrics, /flows, /flows.json, /-/healthy, /-/ready, /store/checkpoint.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include <asio/awaitable.hpp>

#include "admin/flows_page.h"
#include "net/http/request.h"
#include "net/http/response.h"

namespace talus::server {

/// True if players may be sent here, with the reason in one line.
struct Readiness {
  bool ready = true;
  std::string text = "ready";
};

/// Called for each request, on the thread that serves it.
struct OperatorAnswers {
  std::function<std::string()> metrics;
  std::function<bool()> healthy;  // true if the main thread responded recently
  std::function<Readiness()> ready;
  std::function<FlowsReport()> flows;
  /// Answers kCheckpointPath; takes the client's address, and a function that closes its connection soon.
  /// Empty if there is not a store to copy.
  std::function<asio::awaitable<http::Response>(const http::Request&, const std::string& address,
                                                std::function<void()> close)>
      checkpoint{};
  /// Receives the state that a balancer's check sends, and the check's query (net/balancer_state.h).
  std::function<void(const std::string& state, const std::string& query)> balancer_says = {};
};

inline constexpr std::string_view kCheckpointPath = "/store/checkpoint";

/// Answers every page except a checkpoint.
[[nodiscard]] http::Response answer_operator(const http::Request& request, const OperatorAnswers& answers);

}  // namespace talus::server
