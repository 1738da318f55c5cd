// What operators may ask over HTTP: /metrics, /flows, /flows.json, /-/healthy, /-/ready, /store/checkpoint.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include <asio/awaitable.hpp>

#include "admin/flows_page.h"
#include "net/http/request.h"
#include "net/http/response.h"

namespace talus::server {

/// Whether players are to be sent here, and what is said of it, in one line.
struct Readiness {
  bool ready = true;
  std::string text = "ready";
};

/// Asked for each request, on the thread that serves it.
struct OperatorAnswers {
  std::function<std::string()> metrics;
  std::function<bool()> healthy;  // whether the main thread responded lately
  std::function<Readiness()> ready;
  std::function<FlowsReport()> flows;
  /// Asked for kCheckpointPath, with the client's address; empty: there is no store to take.
  std::function<asio::awaitable<http::Response>(const http::Request&, const std::string& address)>
      checkpoint{};
  /// What a balancer said in its check, and what the check's query is: net/balancer_state.h.
  std::function<void(const std::string& state, const std::string& query)> balancer_says = {};
};

inline constexpr std::string_view kCheckpointPath = "/store/checkpoint";

/// All but a checkpoint.
[[nodiscard]] http::Response answer_operator(const http::Request& request, const OperatorAnswers& answers);

}  // namespace talus::server
