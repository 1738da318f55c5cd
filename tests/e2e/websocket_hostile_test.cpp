// What only a WebSocket lets a client do wrong, and a good one beside it that must not notice.
#include <catch2/catch.hpp>
#include <chrono>
#include <list>
#include <string>
#include <vector>

#include "http_client.h"
#include "messages.h"
#include "raw_client.h"
#include "server_process.h"
#include "siege.h"

using namespace talus;
using namespace talus::e2e;

namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t kMebibyte = std::size_t{1} << 20;

Bytes bytes_of(std::initializer_list<unsigned> values) {
  Bytes bytes;
  for (const unsigned value : values) bytes.push_back(static_cast<std::byte>(value));
  return bytes;
}

Bytes repeated(const Bytes& one, std::size_t times) {
  Bytes all;
  all.reserve(one.size() * times);
  for (std::size_t i = 0; i < times; ++i) all.insert(all.end(), one.begin(), one.end());
  return all;
}

RawClient socket_of(std::uint16_t port) {
  return RawClient{port, kLoopback, Transport::websocket};
}

/// A server, a good client of it, and the memory that it had when nobody had done it harm.
struct Bench {
  explicit Bench(Settings settings = {}) : server{std::move(settings), {"--http", "127.0.0.1:0"}} {
    port = server.http_port();
    good.emplace(socket_of(port));
    REQUIRE(good->send(hello()));
    (void)good->expect_kind<wire::Welcome>();
  }
  void check_served() {
    REQUIRE(good->send(ping(++nonce)));
    CHECK(good->expect_kind<wire::Pong>().as<wire::Pong>().nonce() == nonce);
  }
  /// Harm of one kind done `rounds` times takes no memory that one time does not.
  template <typename Harm>
  void check_flat(int rounds, Harm harm) {
    harm();
    check_served();
    const std::size_t before = server.resident_bytes();
    for (int round = 0; round < rounds; ++round) {
      harm();
      check_served();
    }
    if (!kSanitized) CHECK(server.resident_bytes() < before + 4 * kMebibyte);
  }

  ServerProcess server;
  std::uint16_t port = 0;
  std::optional<RawClient> good;
  std::uint64_t nonce = 0;
};

}  // namespace

TEST_CASE("a WebSocket frame that cannot be right ends its connection, and no other") {
  Bench bench;
  for (const Bytes& frame : {
           bytes_of({0x82, 0xFF, 0x80, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4}),  // 2^63 bytes
           bytes_of({0x82, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 1, 2, 3, 4}),
           bytes_of({0x82, 0x01, 'x'}),                 // not masked
           bytes_of({0x81, 0x81, 1, 2, 3, 4, 'x'}),     // text
           bytes_of({0xC2, 0x81, 1, 2, 3, 4, 'x'}),     // compressed
           bytes_of({0x80, 0x81, 1, 2, 3, 4, 'x'}),     // continues nothing
           bytes_of({0x89, 0xFE, 0, 126, 1, 2, 3, 4}),  // a Ping of 126 bytes
           bytes_of({0x09, 0x80, 1, 2, 3, 4}),          // a Ping in pieces
           bytes_of({0x82, 0xFE, 0, 1, 1, 2, 3, 4}),    // one byte, said in two
           bytes_of({0x88, 0x81, 1, 2, 3, 4, 3}),       // a Close of one byte
       }) {
    RawClient bad = socket_of(bench.port);
    REQUIRE(bad.send(hello()));
    (void)bad.expect_kind<wire::Welcome>();
    REQUIRE(bad.send_raw(frame));
    CHECK(bad.closed());
  }
  bench.check_served();
}

TEST_CASE("a WebSocket frame of 2^63 - 1 bytes takes no memory, and its bytes count as any others") {
  Bench bench;
  std::list<RawClient> waiting;
  bench.check_flat(50, [&] {
    RawClient& bad = waiting.emplace_back(socket_of(bench.port));
    REQUIRE(bad.send_raw(bytes_of({0x82, 0xFF, 0x7F, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0})));
    REQUIRE(bad.send_raw(hello()));  // so far the frame is right
    (void)bad.expect_kind<wire::Welcome>();
  });
  // And they break the frames' limits as any others.
  REQUIRE(waiting.front().send_raw(bytes_of({0xFF, 0xFF, 0xFF, 0x7F})));
  CHECK(waiting.front().expect().as<wire::Error>().code() == wire::ErrorCode::too_large);
  CHECK(waiting.front().closed());
}

TEST_CASE("a million empty fragments are nothing") {
  Bench bench;
  const Bytes begin = bytes_of({0x02, 0x80, 1, 2, 3, 4});
  const Bytes many = repeated(bytes_of({0x00, 0x80, 1, 2, 3, 4}), 100'000);
  bench.check_flat(2, [&] {
    RawClient bad = socket_of(bench.port);
    REQUIRE(bad.send_raw(begin));
    for (int i = 0; i < 10; ++i) REQUIRE(bad.send_raw(many));
    // The connection is still there, in the middle of a message: what comes now is a Hello.
    const protocol::Frame whole = hello();
    REQUIRE(whole.size() < 126);
    Bytes last = bytes_of({0x80, 0x80U | static_cast<unsigned>(whole.size()), 0, 0, 0, 0});
    last.insert(last.end(), whole.begin(), whole.end());
    REQUIRE(bad.send_raw(last));
    (void)bad.expect_kind<wire::Welcome>();
  });
}

TEST_CASE("empty fragments do not keep a connection alive: a client that sends only these is dropped") {
  Bench bench{{{"TALUS_LIMITS_HANDSHAKE_TIMEOUT_MS", "300"}}};
  RawClient bad = socket_of(bench.port);
  const Bytes some = repeated(bytes_of({0x89, 0x80, 1, 2, 3, 4, 0x82, 0x80, 1, 2, 3, 4}), 10);
  std::optional<ReceivedFrame> said;
  while (!said && bad.send_raw(some)) said = bad.receive_within(std::chrono::milliseconds{10});
  REQUIRE(said);
  CHECK(said->as<wire::Error>().code() == wire::ErrorCode::timeout);
  CHECK(bad.closed());
  bench.check_served();
}

TEST_CASE("a flood of Pings is answered as far as it is read, and takes no memory") {
  Bench bench;
  const Bytes one = [] {
    Bytes ping = bytes_of({0x89, 0xFD, 0, 0, 0, 0});
    ping.resize(ping.size() + 125);
    return ping;
  }();
  const Bytes many = repeated(one, 8000);  // a mebibyte
  bench.check_flat(8, [&] {
    RawClient bad = socket_of(bench.port);
    // Pongs are not read. Of several Pings one is answered, and a Pong that cannot be written waits alone.
    for (int i = 0; i < 8; ++i) REQUIRE(bad.send_raw(many));
  });
}

TEST_CASE("a WebSocket whose client shuts its sending side gets all that it asked for, and then the end") {
  Bench bench;
  bench.check_flat(5, [&] {
    RawClient half = socket_of(bench.port);
    REQUIRE(half.send(hello()));
    REQUIRE(half.send(get_chunks({chunk_request(1, at(0, 0, 0)), chunk_request(2, at(9, 0, 0))})));
    half.end_sending();
    (void)half.expect_kind<wire::Welcome>();
    (void)half.expect_kind<wire::Chunk>();
    (void)half.expect_kind<wire::Chunk>();
    CHECK(half.closed());
  });
}

TEST_CASE("a WebSocket that is shut inside a frame is closed") {
  Bench bench;
  RawClient half = socket_of(bench.port);
  REQUIRE(half.send(hello()));
  (void)half.expect_kind<wire::Welcome>();
  REQUIRE(half.send_raw(bytes_of({0x82, 0xFE})));
  half.end_sending();
  CHECK(half.closed());
  bench.check_served();
}

TEST_CASE("request heads of one byte at a time are dropped, and other clients stay") {
  constexpr std::size_t kSlow = 100;
  Bench bench{
      {{"TALUS_LIMITS_HANDSHAKE_TIMEOUT_MS", "500"}, {"TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_BURST", "1000"}}};
  const std::string head = "GET /v1/stream HTTP/1.1\r\nHost: talus\r\nX: ";
  std::list<HttpClient> slow;
  for (std::size_t i = 0; i < kSlow; ++i) slow.emplace_back(bench.port);
  for (std::size_t open = kSlow, at = 0; open > 0; ++at) {
    open = 0;
    for (HttpClient& each : slow) {
      std::error_code failed;
      const char byte = at < head.size() ? head[at] : 'x';
      asio::write(each.socket(), asio::buffer(&byte, 1), failed);
      if (!failed) ++open;
    }
    bench.check_served();
  }
  for (HttpClient& each : slow) CHECK(each.closed());
  HttpClient next{bench.port};
  CHECK(next.get("/v1/world").status == 200);
}
