#include "web/player_handler.h"

#include <chrono>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "net/websocket/handshake.h"
#include "runtime/log/escape.h"
#include "web/chunk_answers.h"
#include "web/columns_body.h"
#include "web/documents.h"
#include "web/heights_answers.h"
#include "web/map_answers.h"
#include "web/site_answer.h"
#include "web/world_files.h"

namespace talus::server::web {
namespace {

using wire::ErrorCode;

http::Response kinds_of_requests() {
  return {204,
          "",
          "",
          {{"Allow", "GET, HEAD, OPTIONS"},
           {"Access-Control-Allow-Methods", "GET, HEAD"},
           {"Access-Control-Allow-Headers", "Authorization"},
           {"Access-Control-Max-Age", "86400"}}};
}

http::Response other_method() {
  http::Response wrong = error_response(405, ErrorCode::malformed, "only GET and HEAD are answered here");
  wrong.last = true;  // a proxy may forward any bytes after a method that it does not know
  wrong.fields.push_back({"Allow", "GET, HEAD, OPTIONS"});
  return wrong;
}

/// Returns the world's description.
Answer answer_now(Exchange& exchange, const WorldRoute&) {
  const auto text = exchange.context().world->get(exchange.requester().limits());
  exchange.keep(text);
  http::Response response{200, kJson};
  response.kept = text->body;
  response.cache_control = fresh_for(exchange.audience);
  tag(exchange.request(), response, text->tag);
  return response;
}

/// Returns the edited columns of a region. Source: PROTOCOL.md, "Edited land".
Answer answer_now(Exchange& exchange, const EditsRoute& route) {
  if (auto wrong = check_world(exchange.context(), route.fingerprint)) return wrong;
  if (auto wrong = check_store(exchange.context(), route.store)) return wrong;
  http::Response response{200, kBytes};
  append_edited_columns(response.body, exchange.context().edits->edited_columns(route.region));
  response.cache_control = revalidated_for(exchange.audience);
  tag(exchange.request(), response);
  return response;
}

Answer answer_now(Exchange& exchange, const StreamRoute&) {
  if (is_strange_page(exchange.request(), exchange.context().settings.origins)) {
    return error_response(403, ErrorCode::forbidden,
                          "pages of this origin may not stream; http.origins lists the origins that may");
  }
  http::Response response = websocket::answer_handshake(exchange.request());
  if (response.status == 101) return response;
  // In the format of all errors here.
  http::Response wrong = error_response(response.status, ErrorCode::malformed,
                                        std::string_view{response.body}.substr(0, response.body.size() - 1));
  wrong.fields.insert(wrong.fields.end(), response.fields.begin(), response.fields.end());
  return wrong;
}

}  // namespace

PlayerHandler::PlayerHandler(WebContextPtr context, const ConnectionInfo& connection, Admission::Slot slot,
                             asio::any_io_executor executor)
    : context_{std::move(context)},
      shared_{context_->runner->session},
      id_{connection.id},
      requester_{*context_, connection, std::move(slot)},
      exchange_{*context_, requester_, std::move(executor)} {}

void PlayerHandler::wrote(std::size_t bytes) {
  exchange_.drains_on(bytes);
}

void PlayerHandler::sent() {
  exchange_.hold(0);
  exchange_.drained();
}

http::Response PlayerHandler::refuse(const http::RequestError& error) {
  http::Response response = error_response(error.status, ErrorCode::malformed, error.text);
  shared_.metrics.http_responses_of(response.status).add();
  return response;
}

void PlayerHandler::closed() {
  closed_ = true;
  exchange_.abandon();
  // Before the client sees the end, so that it finds the slot free.
  requester_.end();
  if (told_) std::exchange(told_, nullptr)();
}

std::optional<http::Response> PlayerHandler::respond_now(const http::Request& request,
                                                         Clock::time_point came) {
  exchange_.begin(request, came);
  requester_.progress(came);
  route_.reset();
  Answer answer = decide(request);
  if (answer) finish(request, *answer);
  return answer;
}

asio::awaitable<http::Response> PlayerHandler::respond(const http::Request& request) {
  http::Response response = co_await std::visit(
      [this](const auto& route) -> asio::awaitable<http::Response> {
        using R = std::decay_t<decltype(route)>;
        if constexpr (std::is_same_v<R, WorldRoute> || std::is_same_v<R, StreamRoute> ||
                      std::is_same_v<R, EditsRoute>) {
          throw std::logic_error{"this route is answered at once"};
        } else {
          return answer_later(exchange_, route);
        }
      },
      *route_);
  if (!closed_) finish(request, response);  // a closed connection gets no answer
  co_return response;
}

Answer PlayerHandler::decide(const http::Request& request) {
  if (auto wrong = requester_.find(request)) return wrong;
  if (auto wrong = requester_.check_rates(exchange_.began())) return wrong;
  if (request.method == http::Method::options) return kinds_of_requests();
  if (request.method == http::Method::other) return other_method();
  if (!exchange_.is_for_players()) return site_answer(context_->site.get(), request);
  auto route = find_route(exchange_.path(), request.query(), shared_.limits.heights_per_request);
  if (!route) return error_response(route.error().status, ErrorCode::malformed, route.error().text);
  route_.emplace(*std::move(route));
  const bool chunks = std::holds_alternative<ChunkRoute>(*route_) ||
                      std::holds_alternative<ColumnsRoute>(*route_) ||
                      std::holds_alternative<EditsRoute>(*route_) ||
                      std::holds_alternative<MapRoute>(*route_) || std::holds_alternative<FileRoute>(*route_);
  // The token of a stream is in its Hello.
  if (!std::holds_alternative<StreamRoute>(*route_)) {
    if (auto wrong = requester_.check_token(request, chunks, exchange_.audience)) return wrong;
  }
  return std::visit([this](const auto& of) { return answer_now(exchange_, of); }, *route_);
}

void PlayerHandler::finish(const http::Request& request, http::Response& response) {
  exchange_.end();
  // Until it is sent. A world's files are in memory anyway.
  exchange_.hold(route_ && std::holds_alternative<FileRoute>(*route_) ? 0 : response.content().size());
  if (exchange_.is_for_players() &&
      !add_origin_fields(request, exchange_.audience, context_->settings.origins, response)) {
    log_refused_page(request.list("Origin"));
  }
  const bool head = request.method == http::Method::head;
  const std::size_t bytes = head ? 0 : response.content().size();
  const auto now = shared_.clock.now();
  exchange_.drains(now);
  const auto took = now - exchange_.began();
  shared_.metrics.http_responses_of(response.status).add();
  if (response.status != 101) shared_.metrics.web_latency_of(kind()).add(took);
  if (exchange_.hot()) shared_.metrics.hot_latency.add(took);
  shared_.metrics.sent_bytes.add(bytes);
  requester_.sent(bytes);
  if (!exchange_.counted()) requester_.charge(0, bytes);
  const std::uint64_t every = context_->settings.log_every;
  if (every != 0 && ++context_->answers % every == 0) log_answer(request, response.status, bytes);
  requester_.answered(response.status);
}

AnswerKind PlayerHandler::kind() const {
  if (!exchange_.is_for_players()) return AnswerKind::file;
  if (!route_) return AnswerKind::other;
  if (std::holds_alternative<ChunkRoute>(*route_)) return AnswerKind::chunk;
  if (std::holds_alternative<ColumnsRoute>(*route_)) return AnswerKind::columns;
  if (std::holds_alternative<EditsRoute>(*route_)) return AnswerKind::edits;
  if (std::holds_alternative<HeightsRoute>(*route_)) return AnswerKind::heights;
  if (std::holds_alternative<FileRoute>(*route_)) return AnswerKind::file;
  return std::holds_alternative<MapRoute>(*route_) ? AnswerKind::map : AnswerKind::other;
}

void PlayerHandler::log_refused_page(const std::string& origin) const {
  if (!context_->refused_origins->add(origin)) return;
  context_->runner->log->warn(
      "conn {} {}: pages of origin \"{}\" may not read or stream; http.origins lists the origins that may "
      "(each origin is logged once, at most {} of them)",
      id_, requester_.address(), escaped(origin, RefusedOrigins::kMaxLength), RefusedOrigins::kMax);
}

void PlayerHandler::log_answer(const http::Request& request, int status, std::size_t bytes) const {
  const char* const method = request.method == http::Method::head ? "HEAD" : "GET";
  const std::string client = requester_.address();
  const std::string target = escaped(request.target, 200);
  const std::uint64_t every = context_->settings.log_every;
  const double ms =
      std::chrono::duration<double, std::milli>(shared_.clock.now() - exchange_.began()).count();
  context_->runner->log->write(
      LogLevel::info,
      fmt::format("conn {} {}: {} {}: {} in {:.1f} ms, {} bytes; one answer in {} is logged", id_, client,
                  method, target, status, ms, bytes, every),
      {"http", access_fields({id_, client, method, target, status, ms, bytes, every})});
}

}  // namespace talus::server::web
