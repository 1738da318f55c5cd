#include "net/door.h"

#include <array>
#include <exception>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <asio/co_spawn.hpp>
#include <asio/read.hpp>
#include <asio/redirect_error.hpp>
#include <asio/steady_timer.hpp>
#include <asio/use_awaitable.hpp>

#include "net/proxy_header.h"
#include "session/reply_frames.h"

namespace talus::server {
namespace {

using asio::ip::tcp;
using std::chrono::milliseconds;

std::uint64_t secret() {
  std::random_device device;
  return std::uint64_t{device()} << 32 | device();
}

std::string to_text(const tcp::endpoint& endpoint) {
  return to_string(Endpoint{endpoint.address().to_string(), endpoint.port()});
}

/// What came after a handshake that failed is read away: closing over it would reset the connection and could
/// take the alert with it.
void drop_input(tcp::socket& socket) {
  std::array<std::byte, 4096> unread{};
  std::error_code failed;
  socket.non_blocking(true, failed);
  for (int reads = 0; reads < 4 && !failed; ++reads) (void)socket.read_some(asio::buffer(unread), failed);
}

}  // namespace

struct Door::Visit {
  Visit(tcp::socket socket, const tcp::endpoint& from, ConnectionId number, TlsContext context)
      : id{number}, wire{std::move(socket)}, peer{from}, client{from}, tls{std::move(context)} {}

  ConnectionId id;
  Wire wire;
  tcp::endpoint peer;
  tcp::endpoint client;  // `peer`, or for whom it speaks
  TlsContext tls;        // null: plain
  Clock::time_point came = Clock::now();
  std::optional<Admission::Place> place;
  bool late = false;
  bool done = false;  // let in: the wire is another's
};

Door::Door(const Config& config, Admission& admission, Metrics& metrics, Logger log, HasRoom has_room,
           Welcome welcome)
    : config_{config},
      admission_{admission},
      metrics_{metrics},
      log_{std::move(log)},
      has_room_{std::move(has_room)},
      welcome_{std::move(welcome)},
      budget_{config.limits.handshakes_per_address_per_second, config.limits.handshakes_per_address_burst,
              secret()} {}

void Door::knock(tcp::socket socket, ConnectionId id, const TlsContext& tls) {
  std::error_code gone;
  const tcp::endpoint peer = socket.remote_endpoint(gone);
  if (gone) return;
  const auto visit = std::make_shared<Visit>(std::move(socket), peer, id, tls);
  if (tls == nullptr && !config_.proxies.contain(peer.address())) {
    if (admit(*visit)) let_in(*visit);
    return;
  }
  // Who only has its place to wait for needs no coroutine; these do, and there are only so many.
  if (metrics_.handshakes.now() >= static_cast<std::int64_t>(config_.limits.handshakes_under_way)) {
    refuse(*visit, Refusal::handshakes, "this server has as many handshakes under way as it takes",
           retry_after::kServerFull);
    return;
  }
  metrics_.handshakes.rise();
  asio::co_spawn(
      visit->wire.get_executor(), [this, visit] { return receive(visit); },
      [this, id](const std::exception_ptr& thrown) {
        metrics_.handshakes.fall();
        try {
          if (thrown) std::rethrow_exception(thrown);
        } catch (const std::exception& error) {
          log_->error("conn {}: failed: {}", id, error.what());
        }
      });
}

asio::awaitable<void> Door::receive(VisitPtr visit) {
  asio::steady_timer deadline{
      visit->wire.get_executor(),
      visit->came + milliseconds{static_cast<milliseconds::rep>(config_.limits.handshake_timeout_ms)}};
  deadline.async_wait([visit](std::error_code cancelled) {
    if (cancelled || visit->done) return;  // what has expired already can no more be cancelled
    visit->late = true;
    visit->wire.close();
  });
  if (config_.proxies.contain(visit->peer.address()) && !co_await ask_proxy(*visit)) co_return;
  if (!admit(*visit)) co_return;
  if (visit->tls != nullptr && !co_await shake_hands(*visit)) co_return;
  deadline.cancel();
  if (!visit->late) let_in(*visit);
}

asio::awaitable<bool> Door::ask_proxy(Visit& visit) {
  std::error_code failed;
  std::array<std::byte, kProxyPrefixBytes> prefix_bytes{};
  const std::size_t came = co_await asio::async_read(visit.wire.socket(), asio::buffer(prefix_bytes),
                                                     asio::redirect_error(asio::use_awaitable, failed));
  if (failed && came == 0 && !visit.late) co_return false;  // how some proxies ask whether a server is there
  auto prefix = failed ? tl::make_unexpected(std::string_view{"sent no whole PROXY header of version 2"})
                       : read_proxy_prefix(prefix_bytes);
  std::vector<std::byte> body(prefix ? prefix->body_bytes : 0);
  if (!body.empty()) {
    co_await asio::async_read(visit.wire.socket(), asio::buffer(body),
                              asio::redirect_error(asio::use_awaitable, failed));
    if (failed) prefix = tl::make_unexpected(std::string_view{"sent no whole PROXY header of version 2"});
  }
  if (!prefix) {
    refuse(visit, Refusal::proxy, fmt::format("it is one of `proxies` and {}", prefix.error()),
           retry_after::kNever);
    co_return false;
  }
  visit.client = proxied_client(*prefix, body).value_or(visit.peer);
  co_return true;
}

asio::awaitable<bool> Door::shake_hands(Visit& visit) {
  visit.wire.use_tls(visit.tls);
  std::error_code failed;
  co_await visit.wire.async_handshake(asio::redirect_error(asio::use_awaitable, failed));
  if (!failed) {
    metrics_.tls_handshakes.add();
    co_return true;
  }
  (visit.late ? metrics_.tls_late : metrics_.tls_failed).add();
  log_->info("conn {} {}: TLS handshake failed: {}", visit.id, to_text(visit.client),
             visit.late ? "not done in time" : failed.message());
  visit.wire.shutdown();
  drop_input(visit.wire.socket());
  co_return false;
}

bool Door::admit(Visit& visit) {
  if (!has_room_()) {
    refuse(visit, Refusal::memory, std::string{kNoMemory}, retry_after::kServerFull);
    return false;
  }
  auto place = admission_.enter(visit.client.address());
  if (!place) {
    refuse(visit, Refusal::places, place.error(), retry_after::kServerFull);
    return false;
  }
  const auto wait = budget_.take(visit.client.address(), Clock::now());
  if (wait > Clock::duration::zero()) {
    refuse(visit, Refusal::pace,
           fmt::format("your address begins connections faster than {} a second",
                       config_.limits.handshakes_per_address_per_second),
           std::chrono::ceil<milliseconds>(wait));
    return false;
  }
  visit.place.emplace(*std::move(place));
  return true;
}

void Door::let_in(Visit& visit) {
  visit.done = true;
  welcome_(
      Guest{visit.id, std::move(visit.wire), to_text(visit.client), *std::move(visit.place), visit.came});
}

void Door::refuse(Visit& visit, Refusal why, const std::string& text, std::chrono::milliseconds retry_after) {
  metrics_.refused_for(why).add();
  note_refusal(to_text(visit.client), text);
  // To say it by TLS would cost the handshake that is refused, and a proxy that keeps no rule hears nothing.
  if (visit.tls != nullptr || why == Refusal::proxy) return visit.wire.close();
  metrics_.error(wire::ErrorCode::overloaded).add();
  refusals_.refuse(std::move(visit.wire.socket()), text, retry_after);
}

void Door::note_refusal(const std::string& who, const std::string& why) {
  {
    const std::lock_guard lock{refusal_lines_};
    ++refusals_unsaid_;
    last_refused_ = fmt::format("{}: {}", who, why);
  }
  tell_refusals();
}

void Door::tell_refusals(Clock::duration since_the_last) {
  const std::lock_guard lock{refusal_lines_};
  const auto now = Clock::now();
  if (refusals_unsaid_ == 0 || now - last_refusal_line_ < since_the_last) return;
  last_refusal_line_ = now;
  log_->warn("refused {} ({} refused since the last such line)", last_refused_,
             std::exchange(refusals_unsaid_, 0));
}

}  // namespace talus::server
