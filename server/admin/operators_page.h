// What operators may ask over HTTP: /metrics, /flows, /flows.json, /-/healthy, /-/ready.
#pragma once

#include <functional>
#include <string>

#include "admin/flows_page.h"
#include "http/request.h"
#include "http/response.h"

namespace talus::server {

/// Asked for each request, on the thread that serves it.
struct OperatorAnswers {
  std::function<std::string()> metrics;
  std::function<bool()> healthy;  // whether the main thread responded lately
  std::function<bool()> ready;    // false: players are not to be sent here
  std::function<FlowsReport()> flows;
  /// What a balancer said in its check: net/balancer_state.h.
  std::function<void(const std::string&)> balancer_says = {};
};

[[nodiscard]] http::Response answer_operator(const http::Request& request, const OperatorAnswers& answers);

}  // namespace talus::server
