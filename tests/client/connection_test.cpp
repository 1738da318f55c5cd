#include <talus/protocol/limits.h>
#include <asio/post.hpp>
#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include <talus/voxel/codec.h>

#include "manual_clock.h"
#include "peer.h"

namespace talus::client {
namespace {

using namespace testing;

// What connect() gives when the server answers the Hello as `answer` does.
Result<WorldInfo> answered_by(const std::function<asio::awaitable<void>(Peer&)>& answer,
                              Options options = {}) {
  asio::io_context io;
  Peer peer{io};
  std::optional<Result<WorldInfo>> joined;
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor(), options};
    joined = co_await client.connect("127.0.0.1", peer.port());
  };
  run(io, {visit, [&] { return answer(peer); }});
  return *joined;
}

}  // namespace

TEST_CASE("a client says Hello with its versions, codecs, token and window") {
  Options options;
  options.token = "open sesame";
  options.window_bytes = 12345;
  (void)answered_by(
      [](Peer& peer) -> asio::awaitable<void> {
        co_await peer.accept();
        const auto* hello = (co_await peer.receive())->body_as_Hello();
        REQUIRE(hello != nullptr);
        CHECK(hello->protocol_min() == protocol::kOldestProtocol);
        CHECK(hello->protocol_max() == protocol::kProtocolVersion);
        CHECK(hello->codecs()->size() == 1);
        CHECK(hello->codecs()->Get(0) == kCodecVersion);
        CHECK(hello->token()->str() == "open sesame");
        CHECK(hello->window_bytes() == 12345);
        peer.hang_up();
      },
      options);
}

TEST_CASE(
    "an HTTP server that answers is distinguished from one that breaks the protocol, however its bytes "
    "arrive") {
  for (const std::size_t first : {std::size_t{2}, std::size_t{4}, std::size_t{20}}) {
    CAPTURE(first);
    const std::string answer = "HTTP/1.1 400 Bad Request\r\n\r\n";
    const auto world = answered_by([&](Peer& peer) -> asio::awaitable<void> {
      co_await peer.accept();
      (void)co_await peer.receive();
      co_await peer.send_bytes(answer.substr(0, first));
      co_await asio::post(asio::use_awaitable);
      co_await peer.send_bytes(answer.substr(first));
      co_await peer.until_closed();
    });
    REQUIRE_FALSE(world.has_value());
    CHECK(world.error().kind == ErrorKind::broken_protocol);
    CHECK_THAT(world.error().message, Catch::Contains("an HTTP server answers there"));
    CHECK_THAT(world.error().message, Catch::Contains("ws://127.0.0.1:"));
  }
}

TEST_CASE("Welcome becomes WorldInfo") {
  const auto world = answered_by([](Peer& peer) { return peer.welcome(42); });
  REQUIRE(world.has_value());
  CHECK(world->fingerprint == ContentHash{42, 0});
  CHECK(world->materials.size() == 4);
  CHECK(world->materials[2].name == "granite");
  CHECK(world->materials[1].phase == Phase::liquid);
  CHECK(world->spawn == VoxelPos{8, 70, -8});
  CHECK(world->max_y == 320);
  CHECK(world->limits.requests_in_flight == 64);
}

TEST_CASE("a refusal carries the server's words") {
  const auto world = answered_by([](Peer& peer) -> asio::awaitable<void> {
    co_await peer.accept();
    (void)co_await peer.receive();
    co_await peer.send(error_frame(wire::ErrorCode::version, "this server speaks 7\nand you speak 1"));
  });
  REQUIRE_FALSE(world.has_value());
  CHECK(world.error().kind == ErrorKind::refused);
  CHECK(world.error().message.find("this server speaks 7 and you speak 1") != std::string::npos);
}

TEST_CASE("a version that was not offered is refused") {
  const auto world = answered_by([](Peer& peer) -> asio::awaitable<void> {
    co_await peer.accept();
    (void)co_await peer.receive();
    co_await peer.send(
        protocol::make_frame([](auto& b) { return wire::CreateWelcome(b, 9, kCodecVersion); }));
  });
  REQUIRE_FALSE(world.has_value());
  CHECK(world.error().kind == ErrorKind::broken_protocol);
}

TEST_CASE("a Welcome without its tables is refused") {
  const auto world = answered_by([](Peer& peer) -> asio::awaitable<void> {
    co_await peer.accept();
    (void)co_await peer.receive();
    co_await peer.send(protocol::make_frame(
        [](auto& b) { return wire::CreateWelcome(b, 1, kCodecVersion, nullptr, nullptr, 32); }));
  });
  REQUIRE_FALSE(world.has_value());
  CHECK(world.error().kind == ErrorKind::broken_protocol);
}

TEST_CASE("a server that never answers the Hello is given up") {
  ManualClock clock;
  Options options;
  options.clock = &clock;
  const auto world = answered_by(
      [&](Peer& peer) -> asio::awaitable<void> {
        co_await peer.accept();
        (void)co_await peer.receive();
        clock.advance(options.handshake_timeout);
        co_await peer.until_closed();
      },
      options);
  REQUIRE_FALSE(world.has_value());
  CHECK(world.error().kind == ErrorKind::timed_out);
}

TEST_CASE("a port without a server is one clear line") {
  asio::io_context io;
  std::string port;
  {
    Peer gone{io};
    port = gone.port();
  }
  run(io, {[&]() -> asio::awaitable<void> {
        Client client{io.get_executor()};
        const auto world = co_await client.connect("127.0.0.1", port);
        REQUIRE_FALSE(world.has_value());
        CHECK(world.error().kind == ErrorKind::unreachable);
        CHECK(world.error().message.find("127.0.0.1:" + port) == 0);
      }});
}

TEST_CASE("ping measures the round trip") {
  asio::io_context io;
  Peer peer{io};
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor()};
    co_await join(client, peer);
    const auto time = co_await client.ping();
    REQUIRE(time.has_value());
    CHECK(time->count() > 0);
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    const auto nonce = (co_await peer.receive())->body_as_Ping()->nonce();
    co_await peer.send(protocol::make_frame([&](auto& b) { return wire::CreatePong(b, nonce); }));
  };
  run(io, {visit, serve});
}

TEST_CASE("an idle client sends Ping, and drops a server that says nothing for too long") {
  asio::io_context io;
  Peer peer{io};
  ManualClock clock;
  std::optional<ClientError> lost;
  Options options;
  options.clock = &clock;
  options.ping_interval = std::chrono::seconds{10};
  options.silence_timeout = std::chrono::seconds{35};
  Events events;
  events.on_disconnect = [&](const ClientError& error, bool) { lost = error; };
  Client client{io.get_executor(), options, events};
  int pings = 0;
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(client, peer);
    // Time goes on when the last Ping has arrived.
    for (int steps = 0; !lost;) {
      co_await asio::post(io, asio::use_awaitable);
      if (pings < steps || !clock.next()) continue;
      clock.advance(*clock.next() - clock.now());
      ++steps;
    }
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    try {
      while (true) {
        const auto* message = co_await peer.receive();
        CHECK(message->body_type() == wire::Body::Ping);
        ++pings;
      }
    } catch (const std::system_error&) {
      // The client has closed.
    }
  };
  run(io, {visit, serve});
  REQUIRE(lost.has_value());
  CHECK(lost->kind == ErrorKind::timed_out);
  CHECK(pings == 3);  // after 10, 20 and 30 seconds; after 40 the silence is too long
}

TEST_CASE("a client says Ping before the server's idle time-out, however seldom it would by itself") {
  asio::io_context io;
  Peer peer{io};
  ManualClock clock;
  Options options;
  options.clock = &clock;
  options.ping_interval = std::chrono::hours{1};
  Client client{io.get_executor(), options};
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(client, peer);
    while (!clock.next()) co_await asio::post(io, asio::use_awaitable);
    CHECK(*clock.next() - clock.now() == std::chrono::seconds{20});
  };
  run(io, {visit, [&]() -> asio::awaitable<void> { co_await peer.welcome(1, 1U << 20, 64, 60'000); }});
}

TEST_CASE("a server that answers no Ping is sent few to keep the connection alive") {
  constexpr int kMaxUnansweredPings = 8;
  asio::io_context io;
  Peer peer{io};
  ManualClock clock;
  Options options;
  options.clock = &clock;
  options.ping_interval = std::chrono::seconds{1};
  options.silence_timeout = std::chrono::hours{1};
  Client client{io.get_executor(), options};
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(client, peer);
    for (int interval = 0; interval < 2 * kMaxUnansweredPings; ++interval) {
      while (!clock.next()) co_await asio::post(io, asio::use_awaitable);
      clock.advance(*clock.next() - clock.now());
    }
    while (!clock.next()) co_await asio::post(io, asio::use_awaitable);
    const auto own = co_await client.ping();
    CHECK(own.has_value());
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    for (int pings = 0; pings < kMaxUnansweredPings; ++pings) (void)co_await peer.receive();
    const auto nonce = (co_await peer.receive())->body_as_Ping()->nonce();
    co_await peer.send(protocol::make_frame([&](auto& b) { return wire::CreatePong(b, nonce); }));
    peer.hang_up();
  };
  run(io, {visit, serve});
}

TEST_CASE("close answers what is open") {
  asio::io_context io;
  Peer peer{io};
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor()};
    co_await join(client, peer);
    client.get(key_at(0, 0, 0), std::nullopt, [&](const auto& chunk) {
      REQUIRE_FALSE(chunk.has_value());
      CHECK(chunk.error().kind == ErrorKind::not_connected);
      io.stop();
    });
    client.close();
    CHECK_FALSE(client.connected());
  };
  run(io, {visit, [&]() -> asio::awaitable<void> { co_await peer.welcome(); }});
}

}  // namespace talus::client
