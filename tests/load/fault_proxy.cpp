#include "fault_proxy.h"

#include <algorithm>
#include <array>
#include <deque>
#include <memory>
#include <vector>

#include <asio/buffer.hpp>
#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>
#include <asio/redirect_error.hpp>
#include <asio/steady_timer.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>

#include "random.h"

namespace talus::load {
namespace {

using asio::ip::tcp;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kReadBytes = 4096;

}  // namespace

struct FaultProxy::Pair {
  Pair(tcp::socket client_socket, asio::io_context& io) : client{std::move(client_socket)}, server{io} {}

  void reset() {
    for (tcp::socket* socket : {&client, &server}) {
      std::error_code ignored;
      socket->set_option(asio::socket_base::linger{true, 0}, ignored);
      socket->close(ignored);
    }
  }

  tcp::socket client, server;
};

/// One direction: bytes are read when they come, and written when they are due.
struct FaultProxy::Lane {
  Lane(std::shared_ptr<Pair> both, tcp::socket& source, tcp::socket& target, Faults what, Random jitter)
      : pair{std::move(both)},
        from{source},
        to{target},
        faults{what},
        random{jitter},
        news{from.get_executor()} {}

  struct Piece {
    Clock::time_point due;
    std::vector<std::byte> bytes;
  };

  asio::awaitable<void> read() {
    std::array<std::byte, kReadBytes> buffer{};
    for (std::error_code failed; !failed;) {
      while (held > faults.queue_bytes && to.is_open()) co_await wait();
      const std::size_t bytes = co_await from.async_read_some(
          asio::buffer(buffer), asio::redirect_error(asio::use_awaitable, failed));
      if (bytes == 0) continue;
      const auto more = std::chrono::duration_cast<Clock::duration>(faults.jitter * random.part());
      last_due = std::max(last_due, Clock::now() + faults.delay + more);
      pieces.push_back({last_due, {buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(bytes)}});
      held += bytes;
      news.cancel();
    }
    ended = true;
    news.cancel();
  }

  asio::awaitable<void> write() {
    while (to.is_open()) {
      if (pieces.empty()) {
        if (ended) break;
        co_await wait();
        continue;
      }
      Piece piece = std::move(pieces.front());
      pieces.pop_front();
      co_await wait_until(piece.due);
      if (!co_await pass(piece.bytes)) co_return;
      held -= piece.bytes.size();
      news.cancel();
    }
    std::error_code ignored;
    to.shutdown(tcp::socket::shutdown_send, ignored);
  }

  /// False where the direction has ended.
  asio::awaitable<bool> pass(std::vector<std::byte>& bytes) {
    const std::uint64_t end =
        std::min(faults.cut_after.value_or(kAll), faults.half_close_after.value_or(kAll));
    const bool last = passed + bytes.size() >= end;
    if (last) bytes.resize(static_cast<std::size_t>(end - passed));
    for (std::size_t i = 0; faults.flip_every != 0 && i < bytes.size(); ++i) {
      if ((passed + i + 1) % faults.flip_every == 0) bytes[i] ^= std::byte{0x10};
    }
    std::error_code failed;
    if (!half_closed) {
      co_await asio::async_write(to, asio::buffer(bytes), asio::redirect_error(asio::use_awaitable, failed));
    }
    passed += bytes.size();
    if (faults.bytes_per_second != 0) {
      free_at = std::max(free_at, Clock::now()) +
                std::chrono::nanoseconds{1'000'000'000 * bytes.size() / faults.bytes_per_second};
      co_await wait_until(free_at);
    }
    if (last && faults.cut_after) {
      pair->reset();
      co_return false;
    }
    if (last) {
      half_closed = true;
      std::error_code ignored;
      to.shutdown(tcp::socket::shutdown_send, ignored);
    }
    co_return !failed && !last;
  }

  asio::awaitable<void> wait() { co_await wait_until(Clock::time_point::max(), news); }
  asio::awaitable<void> wait_until(Clock::time_point when) {
    asio::steady_timer timer{from.get_executor()};
    co_await wait_until(when, timer);
  }
  static asio::awaitable<void> wait_until(Clock::time_point when, asio::steady_timer& timer) {
    std::error_code cancelled;
    timer.expires_at(when);
    co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, cancelled));
  }

  std::shared_ptr<Pair> pair;
  tcp::socket& from;
  tcp::socket& to;
  Faults faults;
  Random random;
  asio::steady_timer news;  // cancelled when something has changed
  std::deque<Piece> pieces;
  std::size_t held = 0;
  std::uint64_t passed = 0;
  bool ended = false;
  bool half_closed = false;
  Clock::time_point last_due{};
  Clock::time_point free_at{};
};

FaultProxy::FaultProxy(std::uint16_t server_port, Faults to_server, Faults to_client, std::uint64_t faulty,
                       std::uint64_t seed)
    : acceptor_{io_, {asio::ip::address_v4::loopback(), 0}},
      server_{asio::ip::address_v4::loopback(), server_port},
      to_server_{to_server},
      to_client_{to_client},
      faulty_{faulty},
      seed_{seed},
      port_{acceptor_.local_endpoint().port()} {
  asio::co_spawn(io_, accept(), asio::detached);
  thread_ = std::thread{[this] { io_.run(); }};
}

FaultProxy::~FaultProxy() {
  io_.stop();
  thread_.join();
}

asio::awaitable<void> FaultProxy::accept() {
  for (;;) {
    std::error_code failed;
    tcp::socket client = co_await acceptor_.async_accept(asio::redirect_error(asio::use_awaitable, failed));
    if (failed) co_return;
    asio::co_spawn(io_, serve(std::move(client), connections_++), asio::detached);
  }
}

asio::awaitable<void> FaultProxy::serve(tcp::socket client, std::uint64_t number) {
  const auto pair = std::make_shared<Pair>(std::move(client), io_);
  std::error_code failed;
  // A short queue must not be made long by the system's own.
  if (to_client_.queue_bytes < Faults{}.queue_bytes) {
    pair->server.open(server_.protocol(), failed);
    pair->server.set_option(asio::socket_base::receive_buffer_size{static_cast<int>(to_client_.queue_bytes)},
                            failed);
  }
  co_await pair->server.async_connect(server_, asio::redirect_error(asio::use_awaitable, failed));
  if (failed) co_return pair->reset();
  for (tcp::socket* socket : {&pair->client, &pair->server}) socket->set_option(tcp::no_delay{true}, failed);
  const bool suffers = number < faulty_;
  const auto start = [&](tcp::socket& from, tcp::socket& to, const Faults& faults, std::uint64_t stream) {
    const auto lane = std::make_shared<Lane>(pair, from, to, suffers ? faults : Faults{},
                                             Random{seed_, 2 * number + stream});
    asio::co_spawn(
        io_, [lane] { return lane->read(); }, asio::detached);
    asio::co_spawn(
        io_, [lane] { return lane->write(); }, asio::detached);
  };
  start(pair->client, pair->server, to_server_, 0);
  start(pair->server, pair->client, to_client_, 1);
}

}  // namespace talus::load
