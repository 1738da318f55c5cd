// The client library and its programs by WebSocket, against the real talusd.
#include <sys/socket.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <map>
#include <string>

#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>
#include <asio/io_context.hpp>

#include <talus/client/client.h>

#include "certificates.h"
#include "messages.h"
#include "scratch_directory.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

namespace {

using HashesByChunk = std::map<ChunkKey, ContentHash>;

const std::vector<std::string> kWithHttp{"--http", "127.0.0.1:0"};

client::Options by_websocket() {
  client::Options options;
  options.websocket.on = true;
  return options;
}

/// A client that fills a View around (0, 0, 0).
struct Visitor {
  explicit Visitor(const client::Options& options) : client{io.get_executor(), options, events()} {}

  client::Events events() {
    client::Events told;
    told.on_chunk = [this](const client::ReceivedChunk& chunk) { seen[chunk.key] = chunk.hash; };
    told.on_view_complete = [this](const client::View&) { ++complete; };
    told.on_reconnect = [this](const client::WorldInfo&) { ++reconnects; };
    return told;
  }
  void connect(std::uint16_t port) {
    client.connect("127.0.0.1", std::to_string(port), [this](const client::Result<client::WorldInfo>& world) {
      if (!world) FAIL(world.error().message);
      client::View view{{0, 0, 0}, {}, 4, 2, {}};
      CHECK(client.set_view(view).has_value());
    });
  }
  template <typename Condition>
  void run_until(Condition condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{120};
    while (!condition() && std::chrono::steady_clock::now() < end) {
      io.restart();
      io.run_one_for(std::chrono::seconds{1});
    }
    REQUIRE(condition());
  }

  asio::io_context io;
  HashesByChunk seen;
  int complete = 0;
  int reconnects = 0;
  client::Client client;
};

HashesByChunk view_of(std::uint16_t port, const client::Options& options) {
  Visitor visitor{options};
  visitor.connect(port);
  visitor.run_until([&] { return visitor.complete > 0; });
  return visitor.seen;
}

ProgramResult get_chunk(std::vector<std::string> flags) {
  flags.insert(flags.end(), {"get", "0", "0", "0"});
  return run_program(TALUS_CLIENT_PATH, flags);
}

void check_refused(const ProgramResult& ended, const std::string& part) {
  INFO(ended.err);
  CHECK(ended.status == 1);
  CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
  CHECK_THAT(ended.err, Catch::Contains(part));
}

}  // namespace

TEST_CASE("a View by WebSocket is that by TCP") {
  ServerProcess server{{kClassicWorld}, kWithHttp};
  const HashesByChunk by_tcp = view_of(server.port(), {});
  CHECK(by_tcp.size() == 9 * 5 * 9);
  CHECK(view_of(server.http_port(), by_websocket()) == by_tcp);
}

TEST_CASE("a View by WebSocket in TLS is that by TCP in TLS") {
  const ScratchDirectory scratch;
  const TestCertificate own = make_certificate(1, "talus.example");
  const std::string certificate = scratch.write("certificate.pem", own.certificate);
  ServerProcess server{{kClassicWorld,
                        {"TALUS_TLS_CERTIFICATE", certificate},
                        {"TALUS_TLS_KEY", scratch.write("key.pem", own.key)},
                        {"TALUS_HTTP_TLS", "true"}},
                       kWithHttp};
  client::Options options;
  options.tls = {true, certificate, "talus.example", true};
  const HashesByChunk by_tcp = view_of(server.port(), options);
  CHECK(by_tcp.size() == 9 * 5 * 9);
  options.websocket.on = true;
  const std::uint16_t port = server.https_port();
  CHECK(view_of(port, options) == by_tcp);
  const std::string url = "wss://127.0.0.1:" + std::to_string(port);
  const ProgramResult ended =
      get_chunk({"--connect", url, "--ca", certificate, "--tls-name", "talus.example"});
  INFO(ended.err);
  CHECK(ended.status == 0);
}

TEST_CASE("a client by WebSocket comes back to its View when the server does") {
  client::Options options = by_websocket();
  options.reconnect = {1000, std::chrono::milliseconds{20}, std::chrono::milliseconds{50}, 1};
  Visitor visitor{options};
  std::string address;
  {
    ServerProcess server{{kClassicWorld}, kWithHttp};
    address = "127.0.0.1:" + std::to_string(server.http_port());
    visitor.connect(server.http_port());
    visitor.run_until([&] { return visitor.complete > 0; });
  }
  const HashesByChunk before = std::exchange(visitor.seen, {});
  const ServerProcess again{{kClassicWorld}, {"--http", address}};
  visitor.run_until([&] { return visitor.complete > 1; });
  CHECK(visitor.reconnects == 1);
  CHECK(visitor.seen == before);
}

TEST_CASE("talus-client by WebSocket says in one line what answers instead") {
  ServerProcess server{{}, kWithHttp};
  const std::string http = "ws://127.0.0.1:" + std::to_string(server.http_port());
  const ProgramResult ended = get_chunk({"--connect", http});
  INFO(ended.err);
  CHECK(ended.status == 0);
  check_refused(get_chunk({"--connect", http + "/v1/elsewhere"}), "the server answered 404");
  check_refused(get_chunk({"--connect", http + "/v1/world"}), "the server answered 200");
  check_refused(get_chunk({"--websocket", "--connect", "127.0.0.1:" + std::to_string(server.port())}),
                "the server answered 400");
  check_refused(get_chunk({"--connect", "ws://127.0.0.1:" + std::to_string(server.http_port()) + "/a b"}),
                "path");
}
