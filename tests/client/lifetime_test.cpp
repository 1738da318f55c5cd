// A client may be closed or destroyed at any moment, also in its own callbacks, and be used again.
#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include "peer.h"

namespace talus::client {
namespace {

using namespace testing;

// A client whose only Ping is open when the server hangs up; its handler calls `then`.
struct PingBench {
  asio::io_context io;
  Peer peer{io};
  int disconnects = 0;
  std::optional<Client> client;

  explicit PingBench(int reconnects) {
    Options options;
    options.reconnect.max_attempts = reconnects;
    options.reconnect.first_delay = std::chrono::milliseconds{1};
    Events events;
    events.on_disconnect = [this](const ClientError&, bool) { ++disconnects; };
    client.emplace(io.get_executor(), options, events);
  }

  asio::awaitable<void> visit(std::function<void()> then) {
    co_await join(*client, peer);
    client->ping([then = std::move(then)](const Result<std::chrono::nanoseconds>& time) {
      CHECK_FALSE(time.has_value());
      then();
    });
  }

  asio::awaitable<void> serve() {
    co_await peer.welcome();
    (void)co_await peer.receive();
    peer.hang_up();
  }

  // What is left to do when both ends have finished their parts.
  void settle() {
    io.restart();
    io.run_for(std::chrono::seconds{10});
  }
};

void check_closed(const std::optional<Result<WorldInfo>>& answer) {
  REQUIRE(answer.has_value());
  REQUIRE_FALSE(answer->has_value());
  CHECK(answer->error().kind == ErrorKind::not_connected);
}

}  // namespace

TEST_CASE("a client destroyed before the loop ran answers its connect()") {
  asio::io_context io;
  const Peer peer{io};
  std::optional<Result<WorldInfo>> answer;
  {
    Client client{io.get_executor()};
    client.connect("127.0.0.1", peer.port(), [&](auto world) { answer = std::move(world); });
  }
  io.run_for(std::chrono::seconds{10});
  check_closed(answer);
}

TEST_CASE("a client closed before the loop ran does not connect") {
  asio::io_context io;
  const Peer peer{io};
  std::optional<Result<WorldInfo>> answer;
  Client client{io.get_executor()};
  client.connect("127.0.0.1", peer.port(), [&](auto world) { answer = std::move(world); });
  client.close();
  io.run_for(std::chrono::seconds{10});
  check_closed(answer);
  CHECK_FALSE(client.connected());
}

TEST_CASE("a client closed while its last answers fail receives no event") {
  const int reconnects = GENERATE(0, 3);
  PingBench m{reconnects};
  run(m.io, {[&] { return m.visit([&] { m.client->close(); }); }, [&] { return m.serve(); }});
  m.settle();
  CHECK(m.disconnects == 0);
}

TEST_CASE("a client destroyed while its last answers fail receives no event") {
  const int reconnects = GENERATE(0, 3);
  PingBench m{reconnects};
  run(m.io, {[&] { return m.visit([&] { m.client.reset(); }); }, [&] { return m.serve(); }});
  m.settle();
  CHECK(m.disconnects == 0);
}

TEST_CASE("a client destroyed by the answer to its request receives no event afterwards") {
  asio::io_context io;
  Peer peer{io};
  std::optional<Client> client;
  Events events;
  events.on_disconnect = [&](const ClientError&, bool) { CHECK(client.has_value()); };
  client.emplace(io.get_executor(), Options{}, events);
  bool answered = false;
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(*client, peer);
    client->get(key_at(0, 0, 0), std::nullopt, [&](const Result<ReceivedChunk>& chunk) {
      CHECK_FALSE(chunk.has_value());
      answered = true;
      client.reset();
    });
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    (void)co_await peer.receive();
    peer.hang_up();
  };
  run(io, {visit, serve});
  io.restart();
  io.run_for(std::chrono::seconds{10});
  CHECK(answered);
}

TEST_CASE("a client closed and connected anew while its last answers fail stays connected") {
  const int reconnects = GENERATE(0, 3);
  PingBench m{reconnects};
  std::optional<Result<WorldInfo>> again;
  const auto anew = [&] {
    m.client->close();
    m.client->connect("127.0.0.1", m.peer.port(), [&](auto world) { again = std::move(world); });
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await m.serve();
    co_await m.peer.welcome(2);
    const auto* ping = co_await m.peer.receive();
    CHECK(ping->body_type() == wire::Body::Ping);
    m.peer.hang_up();
  };
  const auto ask = [&]() -> asio::awaitable<void> {
    co_await m.visit(anew);
    while (!again) co_await asio::post(m.io, asio::use_awaitable);
    REQUIRE(again->has_value());
    CHECK((*again)->fingerprint == ContentHash{2, 0});
    CHECK(m.client->connected());
    m.client->ping([](const auto&) {});
  };
  run(m.io, {ask, serve});
  CHECK(m.disconnects == 0);
}

TEST_CASE("a client that connects anew has no View, and reports nothing of the one before") {
  asio::io_context io;
  Peer peer{io};
  std::vector<ChunkKey> came;
  std::vector<ChunkKey> left;
  Events events;
  events.on_chunk = [&](const ReceivedChunk& chunk) { came.push_back(chunk.key); };
  events.on_left_view = [&](ChunkKey key) { left.push_back(key); };
  Client client{io.get_executor(), Options{}, events};
  const bool closed = GENERATE(true, false);  // else the server ends the connection
  View far_away;
  far_away.centre.x = 1'000'000;
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(client, peer);
    REQUIRE(client.set_view(View{}).has_value());
    (void)co_await client.get(key_at(0, 0, 0));
    if (closed) {
      client.close();
    } else {
      (void)co_await client.get(key_at(0, 0, 0));
    }
    CHECK_FALSE(client.set_view(View{}).has_value());
    co_await join(client, peer);
    (void)co_await client.get(key_at(0, 0, 0));
    REQUIRE(client.set_view(far_away).has_value());
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome(1);
    std::optional<std::uint32_t> id;
    while (!id) {
      if (const auto* get = (co_await peer.receive())->body_as_GetChunks())
        id = get->requests()->Get(0)->id();
    }
    co_await peer.send(chunk_frame(0, key_at(1, 1, 1), some_chunk(key_at(1, 1, 1))));
    co_await peer.send(error_frame(wire::ErrorCode::internal, "no", *id));
    if (closed) {
      co_await peer.until_closed();
    } else {
      (void)co_await peer.receive();
      peer.hang_up();
    }
    co_await peer.welcome(2);
    const auto* get = (co_await peer.receive())->body_as_GetChunks();
    REQUIRE(get != nullptr);
    co_await peer.send(error_frame(wire::ErrorCode::internal, "no", get->requests()->Get(0)->id()));
  };
  run(io, {visit, serve});
  CHECK(came == std::vector{key_at(1, 1, 1)});
  CHECK(left.empty());
}

}  // namespace talus::client
