// A real talusd over HTTP and WebSocket: the same chunks as over TCP, whatever way they come.
#include <signal.h>

#include <asio/buffer.hpp>
#include <asio/write.hpp>
#include <catch2/catch.hpp>
#include <list>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include <talus/voxel/codec.h>

#include "http_client.h"
#include "messages.h"
#include "raw_client.h"
#include "scratch_directory.h"
#include "server_process.h"
#include "worked_for.h"

using namespace talus;
using namespace talus::e2e;

namespace {

std::string path_of(ChunkKey key) {
  return "/" + std::to_string(key.lod.value()) + "/" + std::to_string(key.coord.x) + "/" +
         std::to_string(key.coord.y) + "/" + std::to_string(key.coord.z);
}

std::string payload_of(const wire::Chunk& chunk) {
  return {reinterpret_cast<const char*>(chunk.payload()->data()), chunk.payload()->size()};
}

}  // namespace

TEST_CASE("chunks by HTTP and by WebSocket equal chunks by TCP") {
  ServerProcess server{{kClassicWorld}, kWithHttp};
  RawClient by_tcp = greeted(server.port());
  RawClient by_socket{server.http_port(), kLoopback, Transport::websocket};
  by_socket.send(hello());
  (void)by_socket.expect_kind<wire::Welcome>();
  HttpClient by_http{server.http_port()};
  const std::string root = root_of(by_http);
  std::uint32_t id = 0;
  for (const ChunkKey key : {at(0, 0, 0), at(-3, 1, 2), at(1000, 0, -70'000), at(5, 100, 5), at(5, -7, 5),
                             ChunkKey{{2, 0, -1}, Lod::of(3)}, ChunkKey{{0, 0, 0}, Lod::of(6)}}) {
    const protocol::Frame ask = get_chunks({chunk_request(++id, key)});
    by_tcp.send(ask);
    by_socket.send(ask);
    const ReceivedFrame tcp_answer = by_tcp.expect_kind<wire::Chunk>();
    const ReceivedFrame socket_answer = by_socket.expect_kind<wire::Chunk>();
    const Answer answer = by_http.get(root + path_of(key));
    CHECK(answer.status == 200);
    CHECK_THAT(answer.head, Catch::Contains("Cache-Control: public, max-age=31536000, immutable\r\n"));
    CHECK(answer.body == payload_of(tcp_answer.as<wire::Chunk>()));
    CHECK(answer.body == payload_of(socket_answer.as<wire::Chunk>()));
  }
}

TEST_CASE("a column and a square by HTTP are the chunks of it") {
  ServerProcess server{{kClassicWorld}, kWithHttp};
  HttpClient client{server.http_port()};
  const std::string root = root_of(client);
  const auto check_column = [&](std::string_view body, std::int32_t x, std::int32_t z) {
    const auto number = [&](std::size_t bytes) {
      std::uint32_t value = 0;
      for (std::size_t i = 0; i < bytes; ++i)
        value |= std::uint32_t{static_cast<unsigned char>(body[i])} << (8 * i);
      body.remove_prefix(bytes);
      return value;
    };
    CHECK(number(2) == 1);
    std::int64_t next = -(std::int64_t{1} << 31);
    for (std::uint32_t runs = number(2); runs > 0; --runs) {
      const auto first = static_cast<std::int32_t>(number(4));
      const std::uint32_t count = number(4);
      const std::uint32_t bytes = number(4);
      CHECK(first == next);
      next += count;
      for (const std::int64_t y : {std::int64_t{first}, first + std::int64_t{count} - 1}) {
        const Answer chunk = client.get(root + path_of(at(x, static_cast<std::int32_t>(y), z)));
        CHECK(chunk.body == body.substr(0, bytes));
      }
      body.remove_prefix(bytes);
    }
    CHECK(next == std::int64_t{1} << 31);
    CHECK(body.empty());
  };
  const Answer column = client.get(root + "/0/7/-3");
  REQUIRE(column.status == 200);
  check_column(column.body, 7, -3);
  Answer square = client.get(root + "/0/4/-4/2x2");
  REQUIRE(square.status == 200);
  std::string_view body{square.body};
  body.remove_prefix(4);
  for (int i = 0; i < 4; ++i) {
    const auto byte = [&](std::size_t at) { return std::uint32_t{static_cast<unsigned char>(body[at])}; };
    const std::uint32_t bytes = byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
    check_column(body.substr(4, bytes), 4 + i % 2, -4 + i / 2);
    body.remove_prefix(4 + bytes);
  }
  CHECK(body.empty());
}

TEST_CASE("pipelined requests are answered in order, cold and hot") {
  ServerProcess server{{kClassicWorld}, kWithHttp};
  HttpClient client{server.http_port()};
  const std::string root = root_of(client);
  std::vector<std::string> first;
  for (int round = 0; round < 2; ++round) {
    std::string all;
    for (int x = 0; x < 16; ++x) all += HttpClient::request(root + path_of(at(x * 40, 0, 0)));
    client.send(all);
    for (std::size_t x = 0; x < 16; ++x) {
      const Answer answer = client.read();
      CHECK(answer.status == 200);
      if (round == 0) first.push_back(answer.body);
      CHECK(answer.body == first[x]);
    }
  }
}

TEST_CASE("heights by HTTP equal heights by TCP") {
  ServerProcess server{{kClassicWorld}, kWithHttp};
  RawClient by_tcp = greeted(server.port());
  by_tcp.send(get_heights(1, {{10, -20}, {74, -20}, {10, 44}, {74, 44}}));
  const ReceivedFrame heights = by_tcp.expect_kind<wire::Heights>();
  HttpClient client{server.http_port()};
  const Answer answer = client.get("/v1/heights?x=10&z=-20&w=2&h=2&step=64");
  REQUIRE(answer.status == 200);
  const auto found = nlohmann::json::parse(answer.body)["heights"].get<std::vector<std::int32_t>>();
  const auto* const expected = heights.as<wire::Heights>().heights_fx();
  CHECK(found == std::vector<std::int32_t>(expected->begin(), expected->end()));
  CHECK(client.get("/v1/heights?columns=10,-20;74,-20;10,44;74,44&format=npy").body.size() == 128 + 4 * 4);
  CHECK(client.get("/v1/heights?columns=10,-20&fields=warmth").status == 400);
}

TEST_CASE("work for a client that is gone while its answer is made is given up") {
  if (kSanitized) return;  // a column takes too long; session_gone_test has the same cases
  ServerProcess server{kDearColumns, {"--http", "127.0.0.1:0", "--admin", "127.0.0.1:0"}};
  const std::uint16_t http = server.http_port();
  const std::uint16_t admin = server.admin_port();
  for (const bool reset : {false, true}) {
    const double before = metric(admin, "talus_heights_generated_total");
    std::list<HttpClient> clients;
    for (std::uint32_t client = 1; client <= kDearClients; ++client) {
      clients.emplace_back(http).send(
          HttpClient::request("/v1/heights?x=" + std::to_string(client * 100'000'000) +
                              "&z=" + std::to_string(reset) + "&w=64&h=32&step=100000"));
    }
    await_work(admin, before);
    for (HttpClient& each : clients) {
      if (reset) each.socket().set_option(asio::socket_base::linger{true, 0});
      each.socket().close();
    }
    check_given_up(admin, before);
  }
}

TEST_CASE("a server that ends answers what was asked and closes kept connections") {
  ServerProcess server{{kClassicWorld}, kWithHttp};
  HttpClient idle{server.http_port()};
  const std::string root = root_of(idle);
  RawClient stream{server.http_port(), kLoopback, Transport::websocket};
  stream.send(hello());
  (void)stream.expect_kind<wire::Welcome>();
  server.signal(SIGTERM);
  CHECK(idle.closed());
  (void)stream.expect_kind<wire::GoAway>();
  CHECK(server.wait().status == 0);
}

TEST_CASE("hostile bytes on the HTTP port end their own connection alone") {
  ServerProcess server{{kClassicWorld, {"TALUS_LIMITS_HANDSHAKE_TIMEOUT_MS", "300"}}, kWithHttp};
  HttpClient friendly{server.http_port()};
  const std::string root = root_of(friendly);
  for (const std::string& text :
       {std::string{"\x16\x03\x01\x02\x00"}, std::string(100'000, 'A'),
        std::string{"GET / HTTP/1.1\r\nHost: a\r\nX: "},
        std::string{"POST /v1/world HTTP/1.1\r\nHost: a\r\nContent-Length: 99999999999999\r\n\r\n"},
        std::string{"GET " + std::string(4000, '/') + " HTTP/1.1\r\nHost: a\r\n\r\n"}}) {
    HttpClient hostile{server.http_port()};
    std::error_code ignored;
    asio::write(hostile.socket(), asio::buffer(text), ignored);
    CHECK(hostile.closed());
  }
  {
    // A frame of 2^62 bytes, and ten thousand frames of nothing: a Hello that never comes.
    HttpClient socket{server.http_port()};
    socket.send(
        HttpClient::request("/v1/stream",
                            "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                            "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"));
    REQUIRE(socket.read().status == 101);
    std::string nothing{"\x02\x80\0\0\0\0", 6};
    for (int i = 0; i < 10'000; ++i) nothing += std::string{"\x00\x80\0\0\0\0", 6};
    std::error_code ignored;
    asio::write(socket.socket(), asio::buffer(nothing), ignored);
    asio::write(socket.socket(), asio::buffer(std::string{"\x00\xFF\x40\0\0\0\0\0\0\0\0\0\0\0", 14}),
                ignored);
    CHECK(socket.closed());
  }
  CHECK(friendly.get(root + path_of(at(0, 0, 0))).status == 200);
}

TEST_CASE("behind a proxy that sends X-Forwarded-For, rates count whom it names") {
  ServerProcess server{{kClassicWorld,
                        {"TALUS_PROXIES", "127.0.0.1"},
                        {"TALUS_RATES_ADDRESS_REQUESTS", "1"},
                        {"TALUS_RATES_BURST_MS", "5000"}},
                       kWithHttp};
  HttpClient proxy{server.http_port()};
  CHECK(proxy.get("/v1/world").status == 400);
  std::map<int, int> statuses;
  for (int i = 0; i < 20; ++i) ++statuses[proxy.get("/v1/world", "X-Forwarded-For: 192.0.2.7\r\n").status];
  CHECK(statuses[200] >= 5);
  CHECK(statuses[429] >= 10);
  CHECK(proxy.get("/v1/world", "X-Forwarded-For: 192.0.2.8\r\n").status == 200);
}
