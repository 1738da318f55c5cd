#include "admin/operators_page.h"

#include "net/balancer_state.h"

namespace talus::server {

http::Response answer_operator(const http::Request& request, const OperatorAnswers& answers) {
  if (request.method != http::Method::get && request.method != http::Method::head) {
    return {405, http::kPlainText, "only GET and HEAD are answered here\n", {{"Allow", "GET, HEAD"}}};
  }
  const std::string_view path = request.path();
  if (path == "/metrics") return {200, "text/plain; version=0.0.4; charset=utf-8", answers.metrics()};
  if (path == "/-/healthy") {
    if (answers.healthy()) return {200, http::kPlainText, "healthy\n"};
    return {503, http::kPlainText, "the main thread does not respond\n"};
  }
  if (path == "/-/ready") {
    if (request.has(kBalancerStateField) && answers.balancer_says) {
      answers.balancer_says(request.list(kBalancerStateField), std::string{request.query().value_or("")});
    }
    const Readiness readiness = answers.ready();
    return {readiness.ready ? 200 : 503, http::kPlainText, readiness.text + "\n"};
  }
  if (path == "/flows") return {200, http::kPlainText, flows_text(answers.flows())};
  if (path == "/flows.json") return {200, "application/json", flows_json(answers.flows())};
  if (path == kCheckpointPath) return {404, http::kPlainText, "this server keeps no store; see data\n"};
  return {404, http::kPlainText,
          "here are /metrics, /flows, /flows.json, /-/healthy, /-/ready and /store/checkpoint\n"};
}

}  // namespace talus::server
