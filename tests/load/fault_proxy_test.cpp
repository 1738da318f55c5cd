// talusd and the client library, with a bad network between them.
#include "fault_proxy.h"

#include <csignal>

#include <asio/io_context.hpp>
#include <catch2/catch.hpp>
#include <map>
#include <optional>

#include <talus/client/client.h>

#include "messages.h"
#include "raw_client.h"
#include "server_process.h"

using namespace talus;
using namespace talus::load;
using e2e::RawClient;
using e2e::ServerProcess;
using std::chrono::milliseconds;
using std::chrono::seconds;

namespace {

constexpr std::size_t kViewChunks = 5 * 3 * 5;
constexpr seconds kConnectTimeout{60};

struct Visit {
  std::map<ChunkKey, ContentHash> chunks;
  int disconnects = 0, reconnects = 0;
};

/// A client that comes back when it is cut off stays until its View is whole.
Visit visit(std::uint16_t port) {
  Visit visit;
  asio::io_context io;
  client::Options options;
  options.reconnect = {20, milliseconds{1}, milliseconds{5}, 1};
  client::Events events;
  events.on_chunk = [&](const client::ReceivedChunk& chunk) { visit.chunks[chunk.key] = chunk.hash; };
  events.on_disconnect = [&](const client::ClientError&, bool retrying) {
    ++visit.disconnects;
    CHECK(retrying);
  };
  events.on_reconnect = [&](const client::WorldInfo&) { ++visit.reconnects; };
  client::Client client{io.get_executor(), options, events};
  client.connect("127.0.0.1", std::to_string(port), [&](const client::Result<client::WorldInfo>& world) {
    REQUIRE(world.has_value());
    const auto set = client.set_view({{0, 60, 0}, {}, 2, 1, {}});
    CHECK(set.has_value());
  });
  const auto deadline = std::chrono::steady_clock::now() + kConnectTimeout;
  while (visit.chunks.size() < kViewChunks) {
    const bool something = io.run_one_until(deadline) > 0;
    REQUIRE(something);
  }
  client.close();
  return visit;
}

/// It answers a client that comes without a proxy, and ends well.
void check_well(ServerProcess& server) {
  CHECK(visit(server.port()).chunks.size() == kViewChunks);
  server.signal(SIGTERM);
  CHECK(server.wait().status == 0);
}

}  // namespace

TEST_CASE("a proxy without faults passes everything on") {
  ServerProcess server;
  FaultProxy proxy{server.port(), {}, {}};
  CHECK(visit(proxy.port()).chunks == visit(server.port()).chunks);
  CHECK(proxy.connections() == 1);
  check_well(server);
}

TEST_CASE("a client that is cut off inside a frame comes back for its whole View") {
  ServerProcess server;
  Faults cut;
  cut.cut_after = 8001;
  FaultProxy proxy{server.port(), {}, cut, 2};
  const Visit visited = visit(proxy.port());
  CHECK(visited.chunks == visit(server.port()).chunks);
  CHECK(visited.disconnects == 2);
  CHECK(visited.reconnects == 2);
  check_well(server);
}

TEST_CASE("a server whose client is cut off inside a frame serves the others") {
  ServerProcess server;
  Faults cut;
  cut.cut_after = 30;  // in its Hello
  FaultProxy proxy{server.port(), cut, {}};
  RawClient client{proxy.port()};
  REQUIRE(client.send(e2e::hello()));
  CHECK(client.closed());
  check_well(server);
}

TEST_CASE("a slow link brings a whole View, and a Pong") {
  ServerProcess server;
  Faults throttle;
  throttle.bytes_per_second = 40'000;
  FaultProxy proxy{server.port(), throttle, throttle};
  const Visit visited = visit(proxy.port());
  CHECK(visited.chunks == visit(server.port()).chunks);
  CHECK(visited.disconnects == 0);
  RawClient client = e2e::greeted(proxy.port());
  REQUIRE(client.send(e2e::ping(7)));
  CHECK(client.expect_kind<wire::Pong>().as<wire::Pong>().nonce() == 7);
  check_well(server);
}

TEST_CASE("a link that is late, and unevenly so, brings a whole View") {
  ServerProcess server;
  Faults late;
  late.delay = milliseconds{30};
  late.jitter = milliseconds{40};
  FaultProxy proxy{server.port(), late, late};
  const Visit visited = visit(proxy.port());
  CHECK(visited.chunks == visit(server.port()).chunks);
  CHECK(visited.disconnects == 0);
  check_well(server);
}

TEST_CASE("a client that receives the server's end returns") {
  ServerProcess server;
  Faults half;
  half.half_close_after = 8001;
  FaultProxy proxy{server.port(), {}, half, 1};
  const Visit visited = visit(proxy.port());
  CHECK(visited.chunks == visit(server.port()).chunks);
  CHECK(visited.reconnects == 1);
  check_well(server);
}

TEST_CASE("a server that receives its client's end releases it and serves the others") {
  ServerProcess server;
  const auto hello = e2e::hello();
  Faults half;
  half.half_close_after = hello.size();
  FaultProxy proxy{server.port(), half, {}};
  RawClient client{proxy.port()};
  REQUIRE(client.send(hello));
  while (client.receive()) {
  }
  check_well(server);
}

TEST_CASE("a flipped bit is never taken for a chunk") {
  ServerProcess server{{e2e::kClassicWorld}};
  const ChunkKey key = e2e::at(0, 1, 0);
  RawClient raw{server.port()};
  REQUIRE(raw.send(e2e::hello()));
  const std::size_t welcome_bytes = raw.expect_kind<wire::Welcome>().bytes();
  REQUIRE(raw.send(e2e::get_chunks({e2e::chunk_request(1, key)})));
  const std::size_t chunk_bytes = raw.expect_kind<wire::Chunk>().bytes();

  Faults flip;
  flip.flip_every = welcome_bytes + chunk_bytes - 8;  // the payload ends the frame, but for its padding
  FaultProxy proxy{server.port(), {}, flip};
  asio::io_context io;
  client::Client client{io.get_executor()};
  std::optional<client::Result<client::ReceivedChunk>> answer;
  client.connect("127.0.0.1", std::to_string(proxy.port()),
                 [&](const client::Result<client::WorldInfo>& world) {
                   REQUIRE(world.has_value());
                   client.get(key, std::nullopt, [&](const client::Result<client::ReceivedChunk>& chunk) {
                     answer = chunk;
                     client.close();
                   });
                 });
  io.run();
  REQUIRE(answer.has_value());
  REQUIRE_FALSE(answer->has_value());
  CHECK(answer->error().kind == client::ErrorKind::bad_chunk);
  check_well(server);
}
