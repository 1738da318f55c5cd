#include "net/handshaker.h"

#include <sys/socket.h>

#include <array>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <asio/co_spawn.hpp>
#include <asio/execution/context.hpp>
#include <asio/post.hpp>
#include <asio/query.hpp>
#include <asio/read.hpp>
#include <asio/redirect_error.hpp>
#include <asio/steady_timer.hpp>
#include <asio/use_awaitable.hpp>

#include <talus/protocol/endpoint.h>
#include "limits/memory/memory_reservation.h"
#include "net/address_text.h"
#include "net/descriptors.h"
#include "net/io_turns.h"
#include "net/proxy_header.h"
#include "player/session/reply_frames.h"
#include "player/session/retry_after.h"
#include "runtime/random_number.h"

namespace talus::server {
namespace {

using asio::ip::tcp;
using std::chrono::milliseconds;

std::string to_text(const tcp::endpoint& endpoint) {
  return to_string(protocol::Endpoint{address_text(endpoint.address()), endpoint.port()});
}

/// Drops input that arrived after a failed handshake: closing with unread bytes would reset the connection
/// and could lose the alert.
void drop_input(tcp::socket& socket) {
  std::array<std::byte, 4096> unread{};
  std::error_code failed;
  socket.non_blocking(true, failed);
  for (int reads = 0; reads < 4 && !failed; ++reads) (void)socket.read_some(asio::buffer(unread), failed);
}

}  // namespace

struct Handshaker::PendingConnection final : IoTurns::Waiter {
  PendingConnection(tcp::socket socket, const tcp::endpoint& from, ConnectionId number, tls::Context context,
                    Clock::time_point now, MemoryBudget& budget)
      : id{number},
        stream{TcpStream{std::move(socket)}},
        peer{from},
        client{from},
        tls{std::move(context)},
        accepted{now},
        memory{budget, MemoryUse::sessions} {}

  void take_turn() override {
    if (turn == nullptr) return;  // it came too late
    turns->charge(flow, IoTurns::kHandshakeStep);
    std::exchange(turn, nullptr)->cancel();
  }
  /// Waits for a turn of the client's flow. Returns false if it came too late.
  static asio::awaitable<bool> wait_for_turn(PendingPtr self) {
    if (self->late) co_return false;
    if (!self->turns->go_on(self->flow, IoTurns::kHandshakeStep)) {
      asio::steady_timer comes{self->socket().get_executor(), asio::steady_timer::time_point::max()};
      struct Forget {
        PendingConnection& of;
        ~Forget() { of.turn = nullptr; }
      } const forget{*self};
      self->turn = &comes;
      self->turns->wait(self->flow, self, comes.get_executor());
      std::error_code cancelled;
      co_await comes.async_wait(asio::redirect_error(asio::use_awaitable, cancelled));
    }
    co_return !self->late;
  }
  /// The waiting coroutine counts it and closes.
  void end(bool gives_way) {
    if (done) return;  // an expired timer cannot be cancelled
    late = true;
    gave_way = gives_way;
    std::error_code ignored;
    socket().cancel(ignored);
    if (turn != nullptr) std::exchange(turn, nullptr)->cancel();
  }
  [[nodiscard]] tcp::socket& socket() { return secured ? secured->transport().socket() : stream->socket(); }

  ConnectionId id;
  std::optional<TcpStream> stream;  // until it is secured
  std::optional<TlsStream> secured;
  tcp::endpoint peer;
  tcp::endpoint client;  // `peer`, or the client that it proxies
  tls::Context tls;      // null: plain
  Clock::time_point accepted;
  MemoryReservation memory;
  std::optional<Admission::Slot> slot;
  bool through_proxy = false;               // its peer, a proxy, sent no PROXY header
  std::optional<std::uint16_t> proxy_port;  // the proxy's port
  std::optional<FlowShares::Part> place;    // among the handshakes in flight
  IoTurns* turns = nullptr;                 // of the socket's thread, while TLS begins
  FlowId flow{};
  asio::steady_timer* turn = nullptr;  // cancelled when its turn comes
  bool late = false;
  bool gave_way = false;  // to another flow's handshake; also late
  bool done = false;      // accepted or failed
};

std::vector<std::byte> refusal_frame(wire::ErrorCode code, const std::string& text,
                                     milliseconds retry_after) {
  return error_frame(code, text, {}, retry_after);
}

Handshaker::Handshaker(const HandshakeSettings& settings, Admission& admission, const AccessControl& access,
                       FlowUses& flows, Metrics& metrics, MemoryBudget& memory, const Clock& clock,
                       Logger log, OnAccepted on_accepted, RefusalMessage refusal_message)
    : proxies_{settings.proxies},
      header_optional_{settings.header_optional},
      per_address_per_second_{settings.per_address_per_second},
      max_in_flight_{settings.max_in_flight},
      timeout_{settings.timeout},
      silence_{settings.silence},
      admission_{admission},
      access_{access},
      flows_{flows},
      metrics_{metrics},
      memory_{memory},
      clock_{clock},
      log_{std::move(log)},
      on_accepted_{std::move(on_accepted)},
      refusal_message_{std::move(refusal_message)},
      rate_{settings.per_address_per_second, settings.per_address_burst, random_number()},
      refusal_log_{log_, clock} {}

void Handshaker::change(const HandshakeSettings& settings) {
  per_address_per_second_ = settings.per_address_per_second;
  max_in_flight_ = settings.max_in_flight;
  timeout_ = settings.timeout;
  silence_ = settings.silence;
  rate_.change(settings.per_address_per_second, settings.per_address_burst);
}

void Handshaker::begin(tcp::socket socket, ConnectionId id, const tls::Context& tls) {
  std::error_code gone;
  const tcp::endpoint peer = socket.remote_endpoint(gone);
  if (gone) return;
  const auto pending =
      std::make_shared<PendingConnection>(std::move(socket), peer, id, tls, clock_.now(), memory_);
  if (is_spare(pending->socket().native_handle())) {
    refuse(*pending, Refusal::descriptors, "this server has reached its system's limit of open files",
           retry_after::kServerFull);
    return;
  }
  const bool by_proxy = proxies_.contain(peer.address());
  if (!by_proxy && !admit(*pending)) return;
  // Without PROXY header and TLS there is nothing to wait for. Otherwise a coroutine waits, and the number of
  // coroutines is bounded.
  if (!by_proxy && tls == nullptr) return accept(*pending);
  if (!take_place(pending)) {
    refuse(*pending, Refusal::handshakes, "this server has reached its limit of handshakes in flight",
           retry_after::kServerFull);
    return;
  }
  pending->memory.hold(tls == nullptr ? kProxyBytes : kTlsBytes);
  metrics_.handshakes.rise();
  try {
    spawn(pending, id);
  } catch (...) {  // no memory for the coroutine: its completion will not run
    metrics_.handshakes.fall();
    throw;
  }
}

bool Handshaker::take_place(const PendingPtr& pending) {
  FlowShares& places = admission_.handshakes();
  const FlowId flow = admission_.flow_of(counted_as(pending->peer.address()));
  if (places.size() >= max_in_flight_ && !places.make_room(flow, 1, 0, pending->accepted)) return false;
  pending->place.emplace(places, flow, 1, pending->accepted);
  const std::weak_ptr<PendingConnection> weak = pending;
  pending->place->set_give_way([weak, executor = pending->socket().get_executor()] {
    asio::post(executor, [weak] {
      if (const auto alive = weak.lock()) alive->end(true);
    });
  });
  return true;
}

void Handshaker::spawn(const PendingPtr& pending, ConnectionId id) {
  asio::co_spawn(
      pending->socket().get_executor(), [this, pending] { return shake_hands(pending); },
      [this, id](const std::exception_ptr& thrown) {
        metrics_.handshakes.fall();
        try {
          if (thrown) std::rethrow_exception(thrown);
        } catch (const std::exception& error) {
          log_->error("conn {}: failed: {}", id, error.what());
        }
      });
}

asio::awaitable<void> Handshaker::shake_hands(PendingPtr pending) {
  // Also on an exception: the deadline's handler may be queued already.
  struct MarkDone {
    PendingConnection& connection;
    ~MarkDone() { connection.done = true; }
  };
  asio::steady_timer deadline{pending->socket().get_executor()};
  deadline.expires_after(pending->accepted + timeout_.load() - clock_.now());
  deadline.async_wait([pending](std::error_code cancelled) {
    if (!cancelled) pending->end(false);
  });
  bool accepted = true;
  {
    const MarkDone mark{*pending};
    if (proxies_.contain(pending->peer.address())) {
      pending->proxy_port = 0;  // until a header names another
      pending->through_proxy = header_optional_ && !co_await sends_proxy_header(*pending);
      accepted = pending->through_proxy ? !pending->late : co_await read_proxy_header(*pending);
    }
    if (accepted && !pending->slot) {
      pending->place->move_to(admission_.flow_of(counted_as(pending->client.address())));
      accepted = admit(*pending);
    }
    if (accepted && pending->tls != nullptr) accepted = co_await begin_tls(pending);
  }
  deadline.cancel();
  if (accepted) accept(*pending);
}

// Checks the first byte only: neither HTTP nor TLS begins with a line break.
asio::awaitable<bool> Handshaker::sends_proxy_header(PendingConnection& pending) {
  std::error_code failed;
  co_await pending.socket().async_wait(tcp::socket::wait_read,
                                       asio::redirect_error(asio::use_awaitable, failed));
  char first = 0;
  if (failed || ::recv(pending.socket().native_handle(), &first, 1, MSG_PEEK | MSG_DONTWAIT) != 1) {
    co_return false;
  }
  co_return first == '\r';
}

asio::awaitable<bool> Handshaker::read_proxy_header(PendingConnection& pending) {
  const auto incomplete = tl::make_unexpected(std::string_view{"sent no whole PROXY header of version 2"});
  std::error_code failed;
  std::array<std::byte, kProxyPrefixBytes> prefix_bytes{};
  const std::size_t came = co_await asio::async_read(pending.socket(), asio::buffer(prefix_bytes),
                                                     asio::redirect_error(asio::use_awaitable, failed));
  if (failed && came == 0 && !pending.late) co_return false;  // a health check of some proxies
  tl::expected<ProxyPrefix, std::string_view> prefix = incomplete;
  if (!failed && !pending.late) prefix = read_proxy_prefix(prefix_bytes);
  std::vector<std::byte> body(prefix ? prefix->body_bytes : 0);
  if (!body.empty()) {
    co_await asio::async_read(pending.socket(), asio::buffer(body),
                              asio::redirect_error(asio::use_awaitable, failed));
    if (failed || pending.late) prefix = incomplete;
  }
  if (!prefix) {
    refuse(pending, pending.gave_way ? Refusal::handshakes : Refusal::proxy,
           fmt::format("it is one of `proxies` and {}", prefix.error()), {});
    co_return false;
  }
  pending.client = proxied_client(*prefix, body).value_or(pending.peer);
  pending.proxy_port = proxied_port(*prefix, body);
  co_return true;
}

asio::awaitable<bool> Handshaker::begin_tls(PendingPtr shared) {
  PendingConnection& pending = *shared;
  pending.secured.emplace(*std::exchange(pending.stream, std::nullopt), pending.tls);
  pending.turns =
      &asio::use_service<IoTurns>(asio::query(pending.socket().get_executor(), asio::execution::context));
  pending.flow = flow_id_of(pending.slot->counted(), flows_.ids());
  const std::error_code failed =
      co_await pending.secured->handshake([&] { return PendingConnection::wait_for_turn(shared); });
  if (!failed && !pending.late) {
    metrics_.tls_handshakes.add();
    co_return true;
  }
  if (pending.gave_way) {
    count(pending, Refusal::handshakes);
  } else {
    (pending.late ? metrics_.tls_late : metrics_.tls_failed).add();
  }
  log_->info("conn {} {}: TLS handshake failed: {}", pending.id, to_text(pending.client),
             pending.gave_way ? "it gave way to another address's"
             : pending.late   ? "not done in time"
                              : failed.message());
  pending.slot.reset();  // before the socket closes, so that the client finds the slot free
  pending.secured->shutdown();
  drop_input(pending.socket());
  // It may still be in line for a turn.
  pending.secured.reset();
  pending.place.reset();
  pending.memory.hold(0);
  co_return false;
}

bool Handshaker::admit(PendingConnection& pending) {
  if (const auto blocked = access_.meet(pending.client.address())) {
    refuse_blocked(pending, *blocked);
    return false;
  }
  // Before another connection gives way.
  const auto wait =
      pending.through_proxy ? Clock::duration::zero() : rate_.admit(pending.client.address(), clock_.now());
  if (wait > Clock::duration::zero()) {
    refuse(pending, Refusal::pace,
           fmt::format("your address begins connections faster than {} a second",
                       per_address_per_second_.load()),
           std::chrono::ceil<milliseconds>(wait));
    return false;
  }
  auto slot = pending.through_proxy ? admission_.enter_proxy(pending.client.address())
                                    : admission_.enter(pending.client.address());
  if (!slot) {
    refuse(pending, Refusal::places, slot.error(), retry_after::kServerFull);
    return false;
  }
  const FlowId flow = flow_id_of(slot->counted(), flows_.ids());
  if (!memory_.takes_connection_of(flow, clock_.now())) {
    refuse(pending, Refusal::memory, std::string{kNoMemory}, retry_after::kServerFull);
    return false;
  }
  (void)memory_.takes_work_of(flow, 0, clock_.now());  // it wants chunks next
  pending.slot.emplace(*std::move(slot));
  return true;
}

void Handshaker::accept(PendingConnection& pending) {
  pending.place.reset();
  pending.memory.hold(0);  // charged to the session from here on
  ConnectionInfo info{pending.id, to_text(pending.client), pending.accepted, pending.through_proxy,
                      pending.proxy_port};
  TcpStream& transport = pending.secured ? pending.secured->transport() : *pending.stream;
  transport.prefer_latency();
  if (const milliseconds silence = silence_; silence.count() > 0) transport.give_up_after(silence);
  if (pending.secured) {
    on_accepted_({std::move(info), *std::move(pending.slot), *std::move(pending.secured)});
  } else {
    on_accepted_({std::move(info), *std::move(pending.slot), *std::move(pending.stream)});
  }
}

void Handshaker::refuse(PendingConnection& pending, Refusal why, const std::string& text,
                        milliseconds retry_after) {
  refusal_log_.note(to_text(pending.client), text);
  count_and_close(pending, why, wire::ErrorCode::overloaded, text, retry_after);
}

void Handshaker::refuse_blocked(PendingConnection& pending, const BlockedAddress& blocked) {
  if (!blocked.repeated) {
    log_->warn("refused {}: line {} of access.blocked_file blocks it; from now on this is only counted",
               to_text(pending.client), blocked.line);
  }
  count_and_close(pending, Refusal::blocked, wire::ErrorCode::unauthorized,
                  std::string{describe(AuthFailure::blocked)}, retry_after::kNever);
}

void Handshaker::count(const PendingConnection& pending, Refusal why) {
  metrics_.refused_for(why).add();
  const asio::ip::address client = pending.client.address();
  if (!proxies_.contain(client)) flow_of(counted_as(client), flows_)->add(FlowMeasure::refusals, 1);
}

void Handshaker::count_and_close(PendingConnection& pending, Refusal why, wire::ErrorCode code,
                                 const std::string& text, milliseconds retry_after) {
  count(pending, why);
  // A message over TLS would need the refused handshake; a proxy that breaks the rules gets none.
  if (pending.tls != nullptr || why == Refusal::proxy) return pending.stream->close();
  metrics_.error(code).add();
  refusals_.refuse(std::move(pending.stream->socket()), refusal_message_(code, text, retry_after),
                   admission_.flow_of(counted_as(pending.client.address())), clock_.now());
}

}  // namespace talus::server
