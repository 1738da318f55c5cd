#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include "peer.h"

namespace talus::client {
namespace {

using namespace testing;
using std::chrono::milliseconds;

Options quick_to_return(int attempts = 5) {
  Options options;
  options.reconnect.max_attempts = attempts;
  options.reconnect.first_delay = milliseconds{1};
  options.reconnect.max_delay = milliseconds{2};
  return options;
}

}  // namespace

TEST_CASE("after a reconnect to the same world open requests and the View are sent again") {
  asio::io_context io;
  Peer peer{io};
  int lost = 0;
  int back = 0;
  Events events;
  events.on_disconnect = [&](const ClientError&, bool retrying) {
    CHECK(retrying);
    ++lost;
  };
  events.on_reconnect = [&](const WorldInfo&) { ++back; };
  Client client{io.get_executor(), quick_to_return(), events};
  View view;
  view.centre = {100, 0, 0};

  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(client, peer);
    REQUIRE(client.set_view(view).has_value());
    const auto chunk = co_await client.get(key_at(1, 2, 3));
    REQUIRE(chunk.has_value());
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    for (bool asked = false; !asked;) {
      asked = (co_await peer.receive())->body_type() == wire::Body::GetChunks;
    }
    peer.hang_up();
    co_await peer.welcome();
    std::optional<std::uint32_t> id;
    bool view_seen = false;
    while (!id || !view_seen) {
      const auto* message = co_await peer.receive();
      if (const auto* again = message->body_as_View()) {
        CHECK(again->centre()->x() == 100);
        view_seen = true;
      } else if (const auto* get = message->body_as_GetChunks()) {
        id = get->requests()->Get(0)->id();
      }
    }
    co_await peer.send(chunk_frame(*id, key_at(1, 2, 3), some_chunk(key_at(1, 2, 3))));
  };
  run(io, {visit, serve});
  CHECK(lost == 1);
  CHECK(back == 1);
  CHECK(client.stats().connections == 2);
}

TEST_CASE("another world at the same address fails what is open") {
  asio::io_context io;
  Peer peer{io};
  std::optional<ClientError> last;
  Events events;
  events.on_disconnect = [&](const ClientError& error, bool retrying) {
    if (!retrying) last = error;
  };
  Client client{io.get_executor(), quick_to_return(), events};
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(client, peer);
    const auto chunk = co_await client.get(key_at(1, 2, 3));
    REQUIRE_FALSE(chunk.has_value());
    CHECK(chunk.error().kind == ErrorKind::world_changed);
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome(1);
    (void)co_await peer.receive();
    peer.hang_up();
    co_await peer.welcome(2);
  };
  run(io, {visit, serve});
  REQUIRE(last.has_value());
  CHECK(last->kind == ErrorKind::world_changed);
}

TEST_CASE("when attempts run out what is open fails") {
  asio::io_context io;
  auto peer = std::make_unique<Peer>(io);
  Client client{io.get_executor(), quick_to_return(3)};
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(client, *peer);
    const auto chunk = co_await client.get(key_at(1, 2, 3));
    REQUIRE_FALSE(chunk.has_value());
    CHECK(chunk.error().kind == ErrorKind::unreachable);
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer->welcome();
    (void)co_await peer->receive();
    peer.reset();
  };
  run(io, {visit, serve});
}

TEST_CASE("a server that closes with an Error gives the reason") {
  asio::io_context io;
  Peer peer{io};
  std::optional<ClientError> lost;
  Events events;
  events.on_disconnect = [&](const ClientError& error, bool retrying) {
    CHECK_FALSE(retrying);
    lost = error;
  };
  Client client{io.get_executor(), Options{}, events};
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(client, peer);
    const auto answer = co_await client.get(key_at(0, 0, 0));
    CHECK_FALSE(answer.has_value());
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    (void)co_await peer.receive();
    co_await peer.send(error_frame(wire::ErrorCode::timeout, "you said nothing"));
    peer.hang_up();
  };
  run(io, {visit, serve});
  REQUIRE(lost.has_value());
  CHECK(lost->message == "the server says: you said nothing");
}

}  // namespace talus::client
