#include "web/player_handler.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include <talus/voxel/codec.h>

#include "chunks/chunk_source.h"
#include "log/escape.h"
#include "log/log_with_fields.h"
#include "session/heights_check.h"
#include "session/reply_frames.h"
#include "session/retry_after.h"
#include "web/columns_body.h"
#include "web/documents.h"
#include "web/entity_tag.h"
#include "web/forwarded_for.h"
#include "web/site_answer.h"
#include "websocket/handshake.h"

namespace talus::server::web {
namespace {

using wire::ErrorCode;

// What has to be generated comes within so long, or the client is told to ask again.
constexpr std::chrono::seconds kMaxWait{20};
// A rate makes a request wait so long at most.
constexpr std::chrono::seconds kMaxThrottle{5};
constexpr std::string_view kImmutable = "public, max-age=31536000, immutable";
constexpr std::string_view kPrivate = "private, no-store";
// Chunks' clients are numbered from here, apart from connections.
constexpr std::uint64_t kFirstFetch = std::uint64_t{1} << 63;

std::string_view bearer_token(const http::Request& request) {
  constexpr std::string_view kScheme = "Bearer ";
  const std::string* const field = request.field("Authorization");
  if (field == nullptr || !field->starts_with(kScheme)) return {};
  return std::string_view{*field}.substr(kScheme.size());
}

std::int64_t first_row(Lod lod) {
  return -chunk_limit(lod);
}

}  // namespace

std::vector<std::byte> refusal_response(ErrorCode code, const std::string& text,
                                        std::chrono::milliseconds retry_after) {
  const int status = code == ErrorCode::unauthorized ? 403 : 503;
  const http::Response response = error_response(status, code, text, retry_after);
  std::string whole;
  http::append_head(whole, response, false,
                    std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()));
  whole += response.body;
  const auto bytes = std::as_bytes(std::span{whole});
  return {bytes.begin(), bytes.end()};
}

PlayerHandler::Caller::Caller(Admission::Slot of, const WebContext& context)
    : slot{std::move(of)},
      rates{context.runner->session.rates.get(), slot.rates(),
            context.runner->session.limits.requests_in_flight},
      flow{flow_of(slot.counted(), context.runner->session.flows)} {}

PlayerHandler::PlayerHandler(WebContextPtr context, const ConnectionInfo& connection, Admission::Slot slot,
                             asio::any_io_executor executor)
    : context_{std::move(context)},
      shared_{context_->runner->session},
      connection_{connection},
      executor_{std::move(executor)},
      memory_{shared_.memory, MemoryUse::sessions} {
  memory_.hold(kIdleBytes);
  if (connection_.through_proxy) {
    proxy_slot_.emplace(std::move(slot));
  } else {
    caller_.emplace(std::move(slot), *context_);
  }
}

PlayerHandler::~PlayerHandler() = default;

void PlayerHandler::sent() {
  memory_.hold(kIdleBytes);
}

http::Response PlayerHandler::refuse(const http::RequestError& error) {
  http::Response response = error_response(error.status, ErrorCode::malformed, error.text);
  shared_.metrics.http_responses_of(response.status).add();
  return response;
}

void PlayerHandler::closed() {
  closed_ = true;
  if (fetch_ != nullptr) fetch_->abandon();
  // Who sees the end finds the slot free.
  leave();
  proxy_slot_.reset();
  if (told_) std::exchange(told_, nullptr)();
}

bool PlayerHandler::blocked() const {
  return caller_ && shared_.access.blocks(caller_->slot.address());
}

void PlayerHandler::rates_changed() {
  if (caller_) caller_->rates.change(shared_.rates.get(), caller_->slot.rates(), shared_.clock.now());
}

Admission::Slot PlayerHandler::take_slot() {
  Admission::Slot slot = std::move(caller_->slot);
  caller_.reset();
  return slot;
}

ConnectionInfo PlayerHandler::session_info() const {
  ConnectionInfo info = connection_;
  if (info.through_proxy && caller_) info.address = caller_->slot.address().to_string();
  return info;
}

std::optional<http::Response> PlayerHandler::respond_now(const http::Request& request) {
  request_ = &request;
  began_ = shared_.clock.now();
  if (fetch_ != nullptr) std::exchange(fetch_, nullptr)->abandon();  // of a request that threw
  route_.reset();
  kept_.reset();
  public_ = false;
  open_ = false;
  counted_ = false;
  made_ = 0;
  Answer answer = decide(request);
  if (answer) finish(request, *answer);
  return answer;
}

asio::awaitable<http::Response> PlayerHandler::respond(const http::Request& request) {
  http::Response response = co_await std::visit(
      [this](const auto& route) -> asio::awaitable<http::Response> {
        using R = std::decay_t<decltype(route)>;
        if constexpr (std::is_same_v<R, WorldRoute> || std::is_same_v<R, StreamRoute>) {
          throw std::logic_error{"this route is answered at once"};
        } else {
          return fetch(route);
        }
      },
      *route_);
  if (!closed_) finish(request, response);  // nobody is answered otherwise
  co_return response;
}

PlayerHandler::Answer PlayerHandler::decide(const http::Request& request) {
  if (auto wrong = find_caller(request)) return wrong;
  if (auto wrong = check_rates()) return wrong;
  if (request.method == http::Method::options) {
    return http::Response{204,
                          "",
                          "",
                          {{"Allow", "GET, HEAD, OPTIONS"},
                           {"Access-Control-Allow-Methods", "GET, HEAD"},
                           {"Access-Control-Allow-Headers", "Authorization"},
                           {"Access-Control-Max-Age", "86400"}}};
  }
  if (request.method == http::Method::other) {
    http::Response wrong = error_response(405, ErrorCode::malformed, "only GET and HEAD are answered here");
    wrong.last = true;  // a proxy may pass on whatever follows a method that it does not know
    wrong.fields.push_back({"Allow", "GET, HEAD, OPTIONS"});
    return wrong;
  }
  if (!is_for_players(request.path())) return site_answer(context_->site.get(), request);
  auto route = find_route(request.path(), request.query(), shared_.limits.heights_per_request);
  if (!route) return error_response(route.error().status, ErrorCode::malformed, route.error().text);
  route_.emplace(*std::move(route));
  const bool chunks = std::holds_alternative<ChunkRoute>(*route_) ||
                      std::holds_alternative<ColumnsRoute>(*route_) ||
                      std::holds_alternative<MapRoute>(*route_);
  // A stream's token comes in its Hello.
  if (!std::holds_alternative<StreamRoute>(*route_)) {
    if (auto wrong = check_token(request, chunks)) return wrong;
  }
  return std::visit([this](const auto& of) { return answer(of); }, *route_);
}

PlayerHandler::Answer PlayerHandler::find_caller(const http::Request& request) {
  if (!connection_.through_proxy) return std::nullopt;
  const auto address = forwarded_for(request.list("X-Forwarded-For"), context_->settings.proxies);
  if (!address) {
    return error_response(400, ErrorCode::malformed,
                          "the proxy in front of this server names no client; it must set X-Forwarded-For");
  }
  if (shared_.access.meet(*address)) {
    shared_.metrics.denied(AuthFailure::blocked).add();
    http::Response blocked = error_response(403, ErrorCode::unauthorized, describe(AuthFailure::blocked));
    blocked.last = true;
    return blocked;
  }
  auto slot = context_->admission.enter(*address);
  if (!slot) return error_response(503, ErrorCode::overloaded, slot.error(), retry_after::kServerFull);
  caller_.emplace(*std::move(slot), *context_);
  return std::nullopt;
}

PlayerHandler::Answer PlayerHandler::check_token(const http::Request& request, bool may_be_public) {
  if (may_be_public && context_->settings.public_chunks) {
    public_ = true;
    return std::nullopt;
  }
  const auto open = shared_.access.admit({}, shared_.clock.wall());
  open_ = open && open->rights.has(Right::read);
  public_ = may_be_public && open_;
  const std::string_view token = bearer_token(request);
  if (public_ && token.empty()) return std::nullopt;
  const auto grant = shared_.access.admit(token, shared_.clock.wall());
  if (!grant) {
    shared_.metrics.denied(grant.error().failure).add();
    return error_response(401, ErrorCode::unauthorized, describe(grant.error().failure));
  }
  if (!grant->rights.has(Right::read)) {
    return error_response(403, ErrorCode::forbidden, "this token does not permit to read");
  }
  return std::nullopt;
}

PlayerHandler::Answer PlayerHandler::check_rates() {
  if (const auto refusal = caller_->rates.refuse_request(began_)) return refuse(*refusal);
  // What is no chunk takes bytes too: a client that owes that many waits.
  const SessionRates::Due due = caller_->rates.chunks_due(began_);
  if (due.at <= began_ + kMaxThrottle) return std::nullopt;
  return over_rate(due.at - began_);
}

http::Response PlayerHandler::refuse(const SessionRates::Refusal& refusal) const {
  shared_.metrics.throttled(refusal.kind).add();
  caller_->flow->add(FlowMeasure::refusals, 1);
  http::Response response = error_response(
      429, ErrorCode::overloaded, "too many requests; Retry-After says when there is room",
      std::max(std::chrono::milliseconds{1}, std::chrono::ceil<std::chrono::milliseconds>(refusal.wait)));
  response.last = refusal.abusive && !connection_.through_proxy;
  return response;
}

PlayerHandler::Answer PlayerHandler::answer(const WorldRoute&) {
  const auto text = context_->world->get(caller_->rates.limits());
  kept_ = text;
  http::Response response{200, kJson};
  response.kept = text->body;
  response.cache_control = open_ ? http::kNoCache : kPrivate;
  return tagged(std::move(response), text->tag);
}

PlayerHandler::Answer PlayerHandler::answer(const StreamRoute&) {
  const std::string* const origin = request_->field("Origin");
  const std::string* const host = request_->field("Host");
  if (origin != nullptr &&
      !context_->settings.origins.allow(*origin, host == nullptr ? std::string_view{} : *host)) {
    return error_response(403, ErrorCode::forbidden,
                          "pages of this origin may not stream; http.origins lists those that may");
  }
  http::Response response = websocket::answer_handshake(*request_);
  if (response.status == 101) return response;
  // As all errors here.
  http::Response wrong = error_response(response.status, ErrorCode::malformed,
                                        std::string_view{response.body}.substr(0, response.body.size() - 1));
  wrong.fields.insert(wrong.fields.end(), response.fields.begin(), response.fields.end());
  return wrong;
}

PlayerHandler::Answer PlayerHandler::check_world(std::string_view fingerprint, std::string_view codec) const {
  if (auto wrong = check_world(fingerprint)) return wrong;
  static const std::string kCodec = std::to_string(kCodecVersion);
  if (codec != kCodec) {
    return error_response(404, ErrorCode::version,
                          fmt::format("this server sends chunk codec {}", kCodecVersion));
  }
  return std::nullopt;
}

PlayerHandler::Answer PlayerHandler::check_world(std::string_view fingerprint) const {
  if (fingerprint != context_->fingerprint) {
    return error_response(
        404, ErrorCode::out_of_range,
        fmt::format("this server's world is {}; /v1/world describes it", context_->fingerprint));
  }
  return std::nullopt;
}

PlayerHandler::Answer PlayerHandler::answer(const ChunkRoute& route) {
  if (auto wrong = check_world(route.fingerprint, route.codec)) return wrong;
  const EncodedChunkPtr chunk = shared_.chunks.find(route.key);
  if (chunk == nullptr) return std::nullopt;
  if (caller_->rates.chunks_due(began_).at > began_) return std::nullopt;
  shared_.metrics.hot_latency.add(shared_.clock.now() - began_);
  return charged(1, chunk_response(*chunk));
}

PlayerHandler::Answer PlayerHandler::answer(const ColumnsRoute& route) {
  return check_world(route.fingerprint, route.codec);
}

PlayerHandler::Answer PlayerHandler::answer(const HeightsRoute& route) {
  HeightsQuery query{route.columns, route.looks, {}};
  for (const std::string_view name : route.fields) {
    const auto& fields = shared_.world.fields;
    const auto found = std::find(fields.begin(), fields.end(), name);
    if (found == fields.end()) {
      return error_response(400, ErrorCode::out_of_range,
                            fmt::format("fields: this world has no '{}'; /v1/world lists them",
                                        escaped(std::string{name}, 40)));
    }
    query.fields.push_back(static_cast<std::uint8_t>(found - fields.begin()));
  }
  if (route.columns.size() > shared_.limits.heights_per_request) {
    return error_response(400, ErrorCode::too_large,
                          fmt::format("columns: at most {} at once", shared_.limits.heights_per_request));
  }
  if (const auto checked = check_query(query, shared_.limits, shared_.world.fields.size()); !checked) {
    return error_response(400, checked.error().code, checked.error().text);
  }
  return std::nullopt;
}

PlayerHandler::Answer PlayerHandler::answer(const MapRoute& route) {
  if (auto wrong = check_world(route.fingerprint)) return wrong;
  PicturePtr picture = shared_.chunks.find_map(route.tile);
  if (picture == nullptr) return std::nullopt;
  if (caller_->rates.chunks_due(began_).at > began_) return std::nullopt;
  charge(1, 0);
  return picture_response(picture);
}

asio::awaitable<http::Response> PlayerHandler::fetch(const ChunkRoute& route) {
  if (auto wrong = co_await wait_for_rates()) co_return *std::move(wrong);
  const std::vector<ChunkKey> keys(1, route.key);
  fetch_ = std::make_shared<Fetch>(executor_, shared_.chunks, shared_.clock,
                                   ClientId{kFirstFetch + ++context_->fetches}, caller_->flow);
  auto chunks = co_await fetch_->get(keys, began_ + kMaxWait);
  if (!chunks) co_return failure(chunks.error());
  shared_.metrics.cold_latency.add(shared_.clock.now() - began_);
  const EncodedChunkPtr chunk = chunks->front();
  co_return charged(1, chunk_response(*chunk));
}

asio::awaitable<http::Response> PlayerHandler::fetch(const ColumnsRoute& route) {
  if (!shared_.memory.takes_work()) {
    co_return error_response(503, ErrorCode::overloaded, kNoMemory, retry_after::kBusy);
  }
  if (auto wrong = co_await wait_for_rates()) co_return *std::move(wrong);
  fetch_ = std::make_shared<Fetch>(executor_, shared_.chunks, shared_.clock,
                                   ClientId{kFirstFetch + ++context_->fetches}, caller_->flow);
  std::string body;
  if (route.square) append_square_head(body, route.edge);
  for (std::int32_t i = 0; i < route.edge * route.edge; ++i) {
    ChunkKey column = route.corner;
    column.coord.x += i % route.edge;
    column.coord.z += i / route.edge;
    std::string one;
    if (auto wrong = co_await append(column, one, 2 * body.size())) {
      charge(made_, 0);
      co_return *std::move(wrong);
    }
    if (route.square) append_length(body, static_cast<std::uint32_t>(one.size()));
    body += one;
    memory_.hold(kIdleBytes + 2 * body.size());
    if (body.size() > kMaxBodyBytes) {
      charge(made_, 0);
      co_return error_response(400, ErrorCode::too_large,
                               "this is over 4 MiB; ask for its chunks one by one");
    }
  }
  co_return charged(made_, body_response(std::move(body)));
}

// A column's rows are known once any of its chunks was made.
asio::awaitable<PlayerHandler::Answer> PlayerHandler::append(ChunkKey column, std::string& body,
                                                             std::size_t held) {
  constexpr std::size_t kBatch = 64;
  const Lod lod = column.lod;
  const auto known = [&](const MixedRows& rows) {
    return rows.first != std::numeric_limits<std::int32_t>::min();
  };
  MixedRows rows = shared_.chunks.column(column);
  if (!known(rows)) {
    column.coord.y = static_cast<std::int32_t>(floor_div(shared_.world.spawn.y >> lod.value(), kChunkSize));
    const std::vector<ChunkKey> one(1, column);
    if (const auto made = co_await fetch_->get(one, began_ + kMaxWait); !made)
      co_return failure(made.error());
    rows = shared_.chunks.column(column);
  }
  // Without them all rows between the world's lowest and highest may hold anything.
  if (!known(rows)) {
    const HeightRange& heights = shared_.world.heights;
    rows.first = static_cast<std::int32_t>(floor_div(heights.low >> lod.value(), kChunkSize)) - 1;
    rows.last = static_cast<std::int32_t>(floor_div(heights.high >> lod.value(), kChunkSize)) + 1;
  }
  std::vector<ChunkRun> runs;
  std::size_t fetched = 0;
  const std::int64_t top = chunk_limit(lod) - 1;
  for (std::int64_t y = std::int64_t{rows.first} - 1; y <= std::int64_t{rows.last} + 1;) {
    std::vector<ChunkKey> keys;
    for (; keys.size() < kBatch && y <= std::int64_t{rows.last} + 1; ++y) {
      column.coord.y = static_cast<std::int32_t>(y);
      keys.push_back(column);
    }
    auto made = co_await fetch_->get(keys, began_ + kMaxWait);
    if (!made) co_return failure(made.error());
    for (std::size_t i = 0; i < keys.size(); ++i) add_chunk(runs, keys[i].coord.y, (*made)[i]);
    made_ += keys.size() - (fetched == 0 ? 2 : 0);  // those below and above were known
    fetched += keys.size();
    std::size_t bytes = body.size();
    for (const ChunkRun& run : runs) bytes += run.chunk->payload().size();
    memory_.hold(kIdleBytes + held + bytes);
    if (bytes > kMaxBodyBytes || runs.size() > UINT16_MAX) {
      co_return error_response(400, ErrorCode::too_large,
                               "this is over 4 MiB; ask for its chunks one by one");
    }
  }
  // The first stands for all below it, the last for all above.
  runs.front().count += static_cast<std::uint32_t>(runs.front().first_y - first_row(lod));
  runs.front().first_y = static_cast<std::int32_t>(first_row(lod));
  runs.back().count = static_cast<std::uint32_t>(top - runs.back().first_y + 1);
  append_column(body, runs);
  co_return std::nullopt;
}

asio::awaitable<http::Response> PlayerHandler::fetch(const HeightsRoute& route) {
  if (!shared_.memory.takes_work()) {
    co_return error_response(503, ErrorCode::overloaded, kNoMemory, retry_after::kBusy);
  }
  HeightsQuery query{route.columns, route.looks, {}};
  for (const std::string_view name : route.fields) {
    const auto& fields = shared_.world.fields;
    query.fields.push_back(
        static_cast<std::uint8_t>(std::find(fields.begin(), fields.end(), name) - fields.begin()));
  }
  constexpr std::size_t kColumnBytes = 64;
  memory_.hold(kIdleBytes + route.columns.size() * (kColumnBytes + 2 * sizeof(float) * query.fields.size()));
  fetch_ = std::make_shared<Fetch>(executor_, shared_.chunks, shared_.clock,
                                   ClientId{kFirstFetch + ++context_->fetches}, caller_->flow);
  const auto found = co_await fetch_->heights(std::move(query), began_ + kMaxWait);
  if (!found) co_return failure(found.error());
  if (route.npy) co_return http::Response{200, "application/octet-stream", heights_npy(route, *found)};
  co_return http::Response{200, kJson, heights_document(shared_.world, route, *found)};
}

// A tile counts as the columns of chunks that it shows at its level, where it has to be drawn. They count
// before it is drawn, whether or not anybody takes it.
asio::awaitable<http::Response> PlayerHandler::fetch(const MapRoute& route) {
  constexpr std::size_t kColumnsShown =
      std::size_t{map::kTilePixels / kChunkSize} * (map::kTilePixels / kChunkSize);
  PicturePtr picture = shared_.chunks.find_map(route.tile);
  if (picture == nullptr && !shared_.memory.takes_work()) {
    co_return error_response(503, ErrorCode::overloaded, kNoMemory, retry_after::kBusy);
  }
  if (auto wrong = co_await wait_for_rates()) co_return *std::move(wrong);
  charge(picture == nullptr ? kColumnsShown : 1, 0);
  if (picture == nullptr) {
    fetch_ = std::make_shared<Fetch>(executor_, shared_.chunks, shared_.clock,
                                     ClientId{kFirstFetch + ++context_->fetches}, caller_->flow);
    auto drawn = co_await fetch_->map(route.tile, began_ + kMaxWait);
    if (!drawn) co_return failure(drawn.error());
    picture = *std::move(drawn);
  }
  co_return picture_response(picture);
}

asio::awaitable<PlayerHandler::Answer> PlayerHandler::wait_for_rates() {
  TimedEvent event{executor_, shared_.clock};
  const auto until = shared_.clock.now() + kMaxThrottle;
  for (;;) {
    if (!caller_) co_return failure(FetchError::gone);
    const auto now = shared_.clock.now();
    const SessionRates::Due due = caller_->rates.chunks_due(now);
    if (due.throttled) shared_.metrics.throttled(*due.throttled).add();
    if (due.at <= now) break;
    if (due.at > until) co_return over_rate(due.at - now);
    co_await event.wait_until(due.at);
  }
  co_return std::nullopt;
}

http::Response PlayerHandler::over_rate(std::chrono::nanoseconds wait) const {
  caller_->flow->add(FlowMeasure::refusals, 1);
  return error_response(429, ErrorCode::overloaded,
                        "this comes too fast for your rate; Retry-After says when there is room",
                        std::chrono::ceil<std::chrono::milliseconds>(wait));
}

void PlayerHandler::charge(std::size_t chunks, std::size_t bytes) {
  if (caller_) caller_->rates.sent(shared_.clock.now(), chunks, bytes);
}

http::Response PlayerHandler::charged(std::size_t chunks, http::Response response) {
  charge(chunks, request_->method == http::Method::head ? 0 : response.content().size());
  counted_ = true;
  shared_.metrics.chunks_sent.add(chunks);
  shared_.metrics.chunk_bytes_sent.add(response.content().size());
  return response;
}

http::Response PlayerHandler::chunk_response(const EncodedChunk& chunk) {
  const auto payload = chunk.payload();
  return body_response(std::string{reinterpret_cast<const char*>(payload.data()), payload.size()});
}

http::Response PlayerHandler::body_response(std::string body) {
  http::Response response{200, "application/octet-stream", std::move(body)};
  response.cache_control = public_ ? kImmutable : kPrivate;
  return tagged(std::move(response));
}

http::Response PlayerHandler::picture_response(const PicturePtr& picture) {
  kept_ = picture;
  http::Response response{200, "image/png"};
  response.cache_control = public_ ? kImmutable : kPrivate;
  response.kept = picture->png;
  return tagged(std::move(response));
}

http::Response PlayerHandler::tagged(http::Response response) const {
  std::string tag = entity_tag(response.content());
  return tagged(std::move(response), std::move(tag));
}

http::Response PlayerHandler::tagged(http::Response response, std::string tag) const {
  if (lists_tag(request_->field("If-None-Match"), tag)) {
    response.status = 304;
    response.body.clear();
    response.kept = {};
  }
  response.fields.reserve(3);  // with what finish() adds
  response.fields.push_back({"ETag", std::move(tag)});
  return response;
}

http::Response PlayerHandler::failure(FetchError error) const {
  switch (error) {
    case FetchError::busy:
      return error_response(503, ErrorCode::overloaded,
                            shared_.memory.takes_jobs() ? "too many chunks wait to be generated" : kNoMemory,
                            retry_after::kBusy);
    case FetchError::late:
      return error_response(503, ErrorCode::overloaded, "this takes longer than 20 s now",
                            retry_after::kBusy);
    default:
      return error_response(503, ErrorCode::internal, "this could not be generated", retry_after::kFailed);
  }
}

void PlayerHandler::finish(const http::Request& request, http::Response& response) {
  fetch_.reset();
  memory_.hold(kIdleBytes + response.body.size());  // until it is sent
  if (is_for_players(request.path())) add_origin_fields(request, response);
  const bool head = request.method == http::Method::head;
  const std::size_t bytes = head ? 0 : response.content().size();
  shared_.metrics.http_responses_of(response.status).add();
  if (response.status != 101) shared_.metrics.web_latency_of(kind()).add(shared_.clock.now() - began_);
  shared_.metrics.sent_bytes.add(bytes);
  if (caller_) {
    caller_->flow->add(FlowMeasure::sent, bytes);
    if (!counted_) caller_->rates.sent(shared_.clock.now(), 0, bytes);
  }
  const std::uint64_t every = context_->settings.log_every;
  if (every != 0 && ++context_->answers % every == 0) log_answer(request, response.status, bytes);
  // The next request may be somebody else's; until then nobody has a place here.
  if (connection_.through_proxy && response.status != 101) leave();
}

void PlayerHandler::leave() {
  if (caller_) caller_->rates.give_back();
  caller_.reset();
}

void PlayerHandler::log_answer(const http::Request& request, int status, std::size_t bytes) const {
  const char* const method = request.method == http::Method::head ? "HEAD" : "GET";
  const std::string client = caller_ ? caller_->slot.address().to_string() : connection_.address;
  const std::string target = escaped(request.target, 200);
  const std::uint64_t every = context_->settings.log_every;
  const double ms = std::chrono::duration<double, std::milli>(shared_.clock.now() - began_).count();
  log_with_fields(context_->runner->log,
                  fmt::format("conn {} {}: {} {}: {} in {:.1f} ms, {} bytes; one answer in {} is logged",
                              connection_.id, client, method, target, status, ms, bytes, every),
                  "http", access_fields({connection_.id, client, method, target, status, ms, bytes, every}));
}

AnswerKind PlayerHandler::kind() const {
  if (!is_for_players(request_->path())) return AnswerKind::file;
  if (!route_) return AnswerKind::other;
  if (std::holds_alternative<ChunkRoute>(*route_)) return AnswerKind::chunk;
  if (std::holds_alternative<ColumnsRoute>(*route_)) return AnswerKind::columns;
  if (std::holds_alternative<HeightsRoute>(*route_)) return AnswerKind::heights;
  return std::holds_alternative<MapRoute>(*route_) ? AnswerKind::map : AnswerKind::other;
}

void PlayerHandler::add_origin_fields(const http::Request& request, http::Response& response) const {
  if (response.status == 101) return;
  // What every cache may keep is the same for all: one copy, which any page may read.
  if (public_ || context_->settings.origins.all()) {
    response.fields.push_back({"Access-Control-Allow-Origin", "*"});
    return;
  }
  const std::string* const origin = request.field("Origin");
  const std::string* const host = request.field("Host");
  if (origin != nullptr &&
      context_->settings.origins.allow(*origin, host == nullptr ? std::string_view{} : *host)) {
    response.fields.push_back({"Access-Control-Allow-Origin", *origin});
  }
  response.fields.push_back({"Vary", "Origin"});  // a cache must not show one origin the answer to another
}

}  // namespace talus::server::web
