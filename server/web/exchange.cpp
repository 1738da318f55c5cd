#include "web/exchange.h"

#include <chrono>
#include <string>
#include <utility>

#include "chunks/client_ids.h"
#include "web/columns_body.h"
#include "web/routes.h"

namespace talus::server::web {
namespace {

constexpr std::chrono::seconds kMaxWait{20};

}  // namespace

Exchange::Exchange(const WebContext& context, Requester& requester, asio::any_io_executor executor)
    : context_{context},
      shared_{context.runner->session},
      requester_{requester},
      executor_{std::move(executor)},
      memory_{shared_.memory, MemoryUse::sessions} {
  hold(0);
}

void Exchange::begin(const http::Request& request, Clock::time_point came) {
  request_ = &request;
  path_ = request.path();
  for_players_ = web::is_for_players(path_);
  began_ = came;
  abandon();  // a request that threw
  fetch_.reset();
  kept_.reset();
  audience = {};
  counted_ = false;
  hot_ = false;
}

void Exchange::abandon() {
  if (fetch_ != nullptr) fetch_->abandon();
}

Clock::time_point Exchange::deadline() const {
  return began_ + kMaxWait;
}

Fetch& Exchange::start_fetch() {
  fetch_ = std::make_shared<Fetch>(executor_, chunks(), shared_.clock,
                                   client_id(ClientKind::fetch, ++context_.fetches), requester_.flow());
  return *fetch_;
}

void Exchange::charge(std::size_t chunks, const http::Response& response) {
  const std::size_t bytes = response.content().size();
  const std::size_t sent = request_->method == http::Method::head ? 0 : bytes;
  // For a chunk in memory the time of the request is accurate enough, and known.
  requester_.charge(hot_ ? began_ : shared_.clock.now(), chunks, sent);
  counted_ = true;
  shared_.metrics.chunks_sent.add(chunks);
  shared_.metrics.chunk_bytes_sent.add(bytes);
}

http::Response Exchange::immutable(std::string body) const {
  http::Response response{200, kBytes, std::move(body)};
  response.cache_control = immutable_for(audience);
  tag(*request_, response);
  return response;
}

http::Response Exchange::immutable(const EncodedChunkPtr& chunk) {
  keep(chunk);
  http::Response response{200, kBytes};
  const auto payload = chunk->payload();
  response.kept = {reinterpret_cast<const char*>(payload.data()), payload.size()};
  response.cache_control = immutable_for(audience);
  tag(*request_, response);
  return response;
}

void Exchange::tell_revision(http::Response& response, std::uint64_t revision) const {
  response.cache_control = passing_for(audience);
  response.fields.push_back({"Talus-Revision", std::to_string(revision)});
  response.fields.push_back({"Access-Control-Expose-Headers", "Talus-Revision"});
}

}  // namespace talus::server::web
