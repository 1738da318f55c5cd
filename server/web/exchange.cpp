#include "web/exchange.h"

#include <chrono>
#include <utility>

#include "chunks/client_ids.h"
#include "web/columns_body.h"

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

void Exchange::begin(const http::Request& request) {
  request_ = &request;
  began_ = shared_.clock.now();
  abandon();  // of a request that threw
  fetch_.reset();
  kept_.reset();
  audience = {};
  counted_ = false;
}

void Exchange::abandon() {
  if (fetch_ != nullptr) fetch_->abandon();
}

Clock::time_point Exchange::deadline() const {
  return began_ + kMaxWait;
}

Fetch& Exchange::start_fetch(bool edited) {
  fetch_ = std::make_shared<Fetch>(executor_, chunks(edited), shared_.clock,
                                   client_id(ClientKind::fetch, ++context_.fetches), requester_.flow());
  return *fetch_;
}

http::Response Exchange::charged(std::size_t chunks, http::Response response) {
  requester_.charge(chunks, request_->method == http::Method::head ? 0 : response.content().size());
  counted_ = true;
  shared_.metrics.chunks_sent.add(chunks);
  shared_.metrics.chunk_bytes_sent.add(response.content().size());
  return response;
}

http::Response Exchange::immutable(std::string body) const {
  http::Response response{200, kBytes, std::move(body)};
  response.cache_control = immutable_for(audience);
  return tagged(*request_, std::move(response));
}

}  // namespace talus::server::web
