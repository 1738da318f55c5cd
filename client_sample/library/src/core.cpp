// Maintains a connection: connecting, joining, reading, writing, reconnecting.
#include "core.h"

#include <algorithm>
#include <exception>

#include <asio/co_spawn.hpp>
#include <asio/post.hpp>
#include <asio/use_awaitable.hpp>

#include <talus/client/backoff.h>
#include <talus/protocol/limits.h>

#include "incoming.h"
#include "outgoing.h"
#include "servers.h"
#include "wait_until.h"

namespace talus::client {
namespace {

const ClientError kClosed{ErrorKind::not_connected, "the client was closed", {}};

// Completion handler of coroutines. Exceptions, which only failed allocations cause, leave through the
// executor's run(): a client whose coroutine ended unnoticed would wait for ever.
void rethrow(const std::exception_ptr& thrown) {
  if (thrown) std::rethrow_exception(thrown);
}

bool worth_retrying(const ClientError& error) {
  return error.kind != ErrorKind::refused && error.kind != ErrorKind::untrusted &&
         error.kind != ErrorKind::world_changed && error.kind != ErrorKind::cannot_generate;
}

std::uint32_t in_flight_limit(const ServerLimits& limits) {
  return std::max(1U, limits.requests_in_flight);
}

void append(std::vector<std::byte>& out, const protocol::Frame& frame) {
  out.insert(out.end(), frame.begin(), frame.end());
}

// A third of the server's time-out: if one Ping is late, the next is still in time.
std::chrono::milliseconds ping_interval(const Options& options, const ServerLimits& limits) {
  constexpr std::chrono::milliseconds kShortest{5};  // prevents a flood, whatever the server asks for
  if (limits.idle_timeout.count() == 0) return options.ping_interval;
  return std::min(options.ping_interval, std::max(limits.idle_timeout / 3, kShortest));
}

}  // namespace

Core::Core(asio::any_io_executor executor, Options options, Events events)
    : executor_{std::move(executor)},
      options_{std::move(options)},
      events_{std::move(events)},
      tracker_{options_.keep_bytes} {}

void Core::connect(std::string host, std::string port, ConnectHandler handler) {
  if (running_) {
    ClientError error{
        ErrorKind::not_connected, "connect() was called while the client is connected or connecting", {}};
    asio::post(executor_, [handler = std::move(handler), error] { handler(tl::unexpected{error}); });
    return;
  }
  running_ = true;
  // Nothing known from the previous server applies to this one.
  world_.reset();
  tracker_ = ViewTracker{options_.keep_bytes};
  uniform_chunks_.clear();
  left_to_tell_.clear();
  stop_generation();
  no_generation_.reset();
  (void)edits_.forget_editor();  // no edits are open
  // The lambda's frame keeps self alive until run() ends.
  asio::co_spawn(
      executor_,
      [self = shared_from_this(), mine = generation_, host = std::move(host), port = std::move(port),
       handler = std::move(handler)]() mutable {
        return self->run(mine, std::move(host), std::move(port), std::move(handler));
      },
      rethrow);
}

asio::awaitable<void> Core::run(Generation mine, std::string host, std::string port, ConnectHandler handler) {
  Backoff backoff{options_.reconnect};
  const auto servers = std::make_shared<Servers>(ServerAddress{std::move(host), std::move(port)},
                                                 options_.more_servers, options_.reconnect.seed);
  bool was_joined = false;
  std::size_t not_tried = servers->count();  // before the first Welcome
  while (mine == generation_) {
    auto connection = std::make_shared<Connection>(executor_, *options_.clock, protocol::kServerFrameBytes);
    connection_ = connection;
    Result<WorldInfo> world = co_await join(connection, servers);
    if (mine != generation_) break;
    if (world && was_joined) {
      if (const auto accepted = accept_world(*world); !accepted) world = tl::unexpected{accepted.error()};
    }
    if (world) {
      if (const auto checked = check_generation(*world); !checked) world = tl::unexpected{checked.error()};
    }
    std::optional<ClientError> why;
    bool broke = false;
    if (world) {
      world_ = *world;
      start_session(connection);
      if (!was_joined) {
        std::exchange(handler, nullptr)(*world);
      } else if (events_.on_reconnect) {
        events_.on_reconnect(*world);
      }
      was_joined = true;
      if (mine == generation_) keep_view(mine);
      if (mine != generation_) break;
      why = co_await read_until_broken(connection);
      if (mine != generation_) break;
      broke = true;
      end_session();
      if (mine != generation_) break;
      if (useful_) backoff.reset();
    } else {
      why = world.error();
    }
    connection->close(*why);
    if (!was_joined && (--not_tried == 0 || !worth_retrying(*why))) {
      running_ = false;
      std::exchange(handler, nullptr)(tl::unexpected{*why});
      co_return;
    }
    const auto asked_wait = servers->leave(options_.clock->now(), why->retry_after);
    if (!was_joined) continue;
    const bool elsewhere = why->kind == ErrorKind::world_changed && servers->count() > 1;
    const auto delay = worth_retrying(*why) || elsewhere ? backoff.next(asked_wait) : std::nullopt;
    if (!delay) {
      end_run(*why);
      co_return;
    }
    if (broke && events_.on_disconnect) events_.on_disconnect(*why, true);
    if (mine != generation_) break;
    retry_timer_ = options_.clock->make_timer(executor_);
    const auto timer = retry_timer_;
    co_await wait_until(*timer, options_.clock->now() + *delay);
  }
  if (handler) handler(tl::unexpected{kClosed});
}

asio::awaitable<Result<WorldInfo>> Core::join(ConnectionPtr connection, std::shared_ptr<Servers> servers) {
  const ServerAddress server = servers->current();
  const std::string where = server.host + ":" + server.port;
  connection->set_deadline(connection, options_.connect_timeout,
                           {ErrorKind::timed_out, where + ": no connection in time", {}});
  const auto opened =
      co_await connection->open(server.host, server.port, options_.tls, options_.websocket, *servers);
  if (!opened) co_return tl::unexpected{opened.error()};

  connection->set_deadline(connection, options_.handshake_timeout,
                           {ErrorKind::timed_out, where + ": connected, but no Welcome came in time", {}});
  const auto hello = hello_frame(options_);
  const auto written = co_await connection->write(hello);
  if (!written) co_return tl::unexpected{written.error()};
  stats_.sent_bytes += hello.size();

  const auto frame = co_await connection->next_frame(stats_);
  connection->lift_deadline();
  if (!frame) co_return tl::unexpected{frame.error()};
  const auto message = protocol::read_message(*frame);
  if (!message) co_return tl::unexpected{broken_protocol(std::string{protocol::describe(message.error())})};
  if (const auto* error = (*message)->body_as_Error()) {
    ClientError refusal = read_error(*error);
    refusal.message = where + ": " + refusal.message;
    co_return tl::unexpected{std::move(refusal)};
  }
  if (const auto* away = (*message)->body_as_GoAway()) {
    co_return tl::unexpected{ClientError{ErrorKind::overloaded,
                                         where + ": the server goes away: " + read_text(away->reason()),
                                         std::chrono::milliseconds{away->retry_after_ms()}}};
  }
  const auto* welcome = (*message)->body_as_Welcome();
  if (welcome == nullptr) {
    co_return tl::unexpected{broken_protocol("the first message is not a Welcome")};
  }
  if (welcome->protocol() < protocol::kOldestProtocol || welcome->protocol() > protocol::kProtocolVersion) {
    co_return tl::unexpected{broken_protocol(
        "Welcome picks protocol version " + std::to_string(welcome->protocol()) + ", which was not offered")};
  }
  co_return read_welcome(*welcome);
}

Result<void> Core::accept_world(const WorldInfo& world) {
  if (world.fingerprint != world_->fingerprint) {
    return tl::unexpected{ClientError{ErrorKind::world_changed,
                                      "the server now has world " + to_string(world.fingerprint) +
                                          "; this client was in world " + to_string(world_->fingerprint),
                                      {}}};
  }
  if (world.store_id != world_->store_id) {
    if (options_.generate != Generate::never) {
      tracker_.outdate_edited();  // this server may publish its world where the last one did not
    } else {
      tracker_.forget_revisions();
    }
    fail_edits(edits_.forget_editor(), kOutcomeUnknown);
  }
  if (world.store_id == ContentHash{}) {
    fail_all_edits({ErrorKind::refused, "this server stores no edits", {}});
  }
  // A server of another release may report other heights.
  if (tracker_.view() && check_view(*tracker_.view(), world)) {
    const auto left = tracker_.replace(View{*tracker_.view()}, world.heights());
    if (events_.on_left_view) left_to_tell_.insert(left.begin(), left.end());
  }
  return {};
}

Result<void> Core::check_kept_view() const {
  return tracker_.view() ? check_view(*tracker_.view(), *world_) : Result<void>{};
}

// A server met again may run another release, or have other limits.
void Core::keep_view(Generation mine) {
  tell_left(mine);
  if (mine != generation_) return;
  if (const auto kept = check_kept_view(); !kept) report(kept.error());
  if (mine == generation_) require_maker();
}

void Core::start_session(const ConnectionPtr& connection) {
  ++stats_.connections;
  joined_ = true;
  useful_ = false;
  taken_bytes_ = 0;
  credited_bytes_ = 0;
  view_to_send_ = tracker_.view().has_value() && check_kept_view().has_value();
  view_sent_ = false;
  sent_base_ = false;
  says_delivered_ = true;
  sent_shape_ = {};
  complete_to_tell_ = false;
  leaving_ = false;
  pace_ = RequestPace{world_->limits, options_.clock->now()};
  pace_timer_ = options_.clock->make_timer(executor_);
  left_since_view_sent_.clear();
  close_reason_.reset();
  begin_generation();
  const auto self = shared_from_this();
  // The lambdas' frames keep self alive; the coroutines end when the connection is closed.
  asio::co_spawn(
      executor_, [self, connection] { return self->write_loop(connection); }, rethrow);
  asio::co_spawn(
      executor_,
      [self, connection, interval = ping_interval(options_, world_->limits)] {
        return self->ping_loop(connection, interval);
      },
      rethrow);
}

// Drops the state that belongs to the connection rather than to the client.
void Core::end_session() {
  joined_ = false;
  if (local_ != nullptr) local_->end_session();
  pace_timer_.reset();
  cancels_to_send_.clear();
  pings_to_send_.clear();
  edits_.connection_ended();
  const ClientError lost{ErrorKind::disconnected, "the connection ended before the server answered", {}};
  for (const auto& [nonce, ping] : std::exchange(open_pings_, {})) {
    if (ping.handler) ping.handler(tl::unexpected{lost});
  }
  const ClientError cancelled{ErrorKind::cancelled, "cancelled", {}};
  for (const auto& request : requests_.send_again()) fail(request, cancelled);
}

void Core::end_run(const ClientError& why) {
  ++generation_;
  running_ = false;
  joined_ = false;
  stop_generation();
  // Event first: handlers of unanswered requests may close the client, and no event may follow that.
  const auto unanswered = requests_.take_all();
  const auto edits = edits_.take_all();
  if (events_.on_disconnect) events_.on_disconnect(why, false);
  for (const auto& request : unanswered) fail(request, why);
  for (const auto& edit : edits.sent) edit.handler(tl::unexpected{unknown_outcome(why)});
  for (const auto& edit : edits.unsent) edit.handler(tl::unexpected{why});
}

void Core::close() {
  if (!running_) return;
  ++generation_;
  running_ = false;
  joined_ = false;
  stop_generation();
  cancels_to_send_.clear();
  pings_to_send_.clear();
  pace_timer_.reset();
  if (retry_timer_) retry_timer_->cancel();
  if (connection_) connection_->close(kClosed);
  // Not inside close(): its caller may not expect callbacks.
  asio::post(executor_, [requests = requests_.take_all(), pings = std::exchange(open_pings_, {})] {
    for (const auto& request : requests) fail(request, kClosed);
    for (const auto& [nonce, ping] : pings) {
      if (ping.handler) ping.handler(tl::unexpected{kClosed});
    }
  });
  ClientError closed = kClosed;
  closed.waited_for = edits_wait_for_;
  fail_all_edits(closed);
}

asio::awaitable<ClientError> Core::read_until_broken(ConnectionPtr connection) {
  while (true) {
    const auto frame = co_await connection->next_frame(stats_);
    if (!frame) {
      // A server that closes the connection sends its reason just before.
      const bool silent_end = frame.error().kind == ErrorKind::disconnected;
      co_return silent_end&& close_reason_ ? *close_reason_ : frame.error();
    }
    const auto handled = handle(*frame);
    if (!handled) co_return handled.error();
  }
}

asio::awaitable<void> Core::write_loop(ConnectionPtr connection) {
  const auto self = shared_from_this();
  while (!connection->is_closed()) {
    const auto bytes = compose();
    if (bytes.empty() && !connection->must_write()) {
      co_await connection->wait_for_work();
      continue;
    }
    const auto written = co_await connection->write(bytes);
    // The reader notices the end too, after the server's last messages.
    if (!written) co_return;
    stats_.sent_bytes += bytes.size();
  }
}

asio::awaitable<void> Core::ping_loop(ConnectionPtr connection, std::chrono::milliseconds interval) {
  const auto self = shared_from_this();
  while (true) {
    co_await connection->pause(interval);
    if (connection->is_closed()) co_return;
    if (options_.clock->now() - connection->last_received() > options_.silence_timeout) {
      connection->close({ErrorKind::timed_out, "the server has sent nothing for too long", {}});
      co_return;
    }
    // A Pong may be delayed behind much other data. A server that never answers gets no more Pings.
    constexpr std::ptrdiff_t kMaxUnansweredPings = 8;
    const auto keeps_alive = [](const auto& ping) { return ping.second.handler == nullptr; };
    if (std::ranges::count_if(open_pings_, keeps_alive) < kMaxUnansweredPings) ping(nullptr);
  }
}

void Core::wake() {
  if (connection_) connection_->wake();
}

void Core::report(const ClientError& error) {
  if (events_.on_error) events_.on_error(error);
}

void Core::wake_at(Clock::Time when) {
  pace_timer_->async_wait_until(when, [weak = weak_from_this()](std::error_code error) {
    if (const auto self = weak.lock(); self && !error) self->wake();
  });
}

std::vector<std::byte> Core::compose() {
  std::vector<std::byte> out;
  if (!leaving_) compose_view(out);
  compose_pings(out);
  if (!leaving_) compose_edits(out);
  if (!leaving_) compose_requests(out);
  // Split into pieces that fit the smallest frame that a server may allow.
  constexpr std::size_t kIdsAFrame = 512;
  const auto ids = std::exchange(cancels_to_send_, {});
  for (std::size_t first = 0; first < ids.size(); first += kIdsAFrame) {
    append(out, cancel_frame(std::span{ids}.subspan(first, std::min(kIdsAFrame, ids.size() - first))));
  }
  // One credit per half window: the server never stalls, and credits stay few.
  if ((taken_bytes_ - credited_bytes_) * 2 >= world_->limits.window_bytes && taken_bytes_ > credited_bytes_) {
    credited_bytes_ = taken_bytes_;
    append(out, credit_frame(credited_bytes_));
  }
  if (waits_for_pace()) {
    constexpr std::chrono::milliseconds kBetweenBatches{10};  // instead of one wake-up per request
    const auto now = options_.clock->now();
    wake_at(std::max(pace_.next(now), now + kBetweenBatches));
  }
  return out;
}

bool Core::waits_for_pace() const {
  if (leaving_) return false;
  return view_to_send_ || !pings_to_send_.empty() || edits_.must_attach() || edits_.has_next() ||
         requests_.has_next(in_flight_limit(world_->limits));
}

void Core::compose_view(std::vector<std::byte>& out) {
  if (!view_to_send_ || !pace_.take(options_.clock->now())) return;
  view_to_send_ = false;
  view_sent_ = true;
  if (++view_number_ == 0) ++view_number_;  // 0 is not a valid number
  sent_base_ = generates();
  auto known = tracker_.known(known_per_frame(world_->limits.frame_bytes), says_delivered_);
  if (sent_base_) {
    std::erase_if(known, [](const ReceivedChunk& chunk) { return chunk.revision == 0; });
    local_->announced(known);
  }
  says_delivered_ = false;
  append(out, view_frame(*tracker_.view(), view_number_, known, sent_base_));
  sent_shape_ = tracker_.shape();
  complete_to_tell_ = false;
  left_since_view_sent_.clear();
}

void Core::compose_pings(std::vector<std::byte>& out) {
  const auto now = options_.clock->now();
  std::vector<std::uint64_t> later;
  for (const auto nonce : std::exchange(pings_to_send_, {})) {
    const auto open = open_pings_.find(nonce);
    if (open == open_pings_.end()) continue;  // a hostile server answered before the Ping was sent
    const bool keeps_alive = open->second.handler == nullptr;  // and must not be delayed
    if (keeps_alive) {
      pace_.spend(now);
    } else if (!pace_.take(now)) {
      later.push_back(nonce);
      continue;
    }
    open->second.sent = now;
    open->second.is_sent = true;
    append(out, ping_frame(nonce));
  }
  pings_to_send_ = std::move(later);
}

void Core::compose_requests(std::vector<std::byte>& out) {
  const ServerLimits& limits = world_->limits;
  const auto now = options_.clock->now();
  const std::size_t most = std::max<std::size_t>(1, chunk_requests_per_frame(limits.frame_bytes));
  std::vector<wire::ChunkRequest> chunks;
  while (requests_.has_next(in_flight_limit(limits)) && pace_.take(now)) {
    const std::uint32_t id = *requests_.send_next(in_flight_limit(limits));
    const Request& request = requests_.at(id);
    if (const auto* heights = std::get_if<HeightsRequest>(&request)) {
      append(out, heights_frame(id, *heights, *world_));
      continue;
    }
    if (const auto* file = std::get_if<FileRequest>(&request)) {
      append(out, file_frame(id, *file));
      continue;
    }
    chunks.push_back(wire_request(id, std::get<ChunkRequest>(request)));
    if (chunks.size() == most) append(out, get_chunks_frame(std::exchange(chunks, {})));
  }
  if (!chunks.empty()) append(out, get_chunks_frame(chunks));
}

}  // namespace talus::client
