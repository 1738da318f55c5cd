// How a connection begins, waits and ends.
#include <signal.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <string>

#include <asio/io_context.hpp>

#include <talus/client/client.h>

#include "scratch_directory.h"
#include "server_process.h"
#include "test_client.h"

namespace talus::c_api {
namespace {

using namespace testing;
using e2e::ServerProcess;

void check_over(const TestClient& client) {
  auto event = sized<talus_event>();
  CHECK(talus_poll(client.get(), &event, -1) == TALUS_NOT_CONNECTED);
  CHECK(talus_ping(client.get(), nullptr) == TALUS_NOT_CONNECTED);
}

// A port that nobody listens on.
constexpr std::uint16_t kNobody = 1;

}  // namespace

TEST_CASE("a server that is away closes a talus_client, which may try again") {
  TestClient client;
  for (int attempt = 0; attempt < 2; ++attempt) {
    client.connect(kNobody);
    const talus_event closed = client.await(TALUS_EVENT_CLOSED);
    CHECK(closed.status == TALUS_UNREACHABLE);
    CHECK(std::string{closed.message} == "127.0.0.1:1: no server answers there: Connection refused");
    check_over(client);
  }
}

TEST_CASE("an unknown host name is unreachable to a talus_client") {
  TestClient client;
  auto options = sized<talus_connect_options>();
  options.host = "nobody.invalid";
  client.connect(kNobody, options);
  const talus_event closed = client.await(TALUS_EVENT_CLOSED);
  CHECK(closed.status == TALUS_UNREACHABLE);
  CHECK_THAT(closed.message, Catch::StartsWith("nobody.invalid:1: no such host"));
}

TEST_CASE("a wrong token closes a talus_client, the right one lets it in") {
  const ScratchDirectory scratch;
  const ServerProcess server{{{"TALUS_ACCESS_SECRET_FILE", scratch.write("secret", "0123456789abcdef\n")}}};
  TestClient client;
  auto options = sized<talus_connect_options>();
  client.connect(server.port(), options);
  talus_event closed = client.await(TALUS_EVENT_CLOSED);
  CHECK(closed.status == TALUS_REFUSED);
  CHECK_THAT(closed.message, Catch::Contains("asks for a token"));
  options.token = "guess";
  client.connect(server.port(), options);
  closed = client.await(TALUS_EVENT_CLOSED);
  CHECK(closed.status == TALUS_REFUSED);
  CHECK_THAT(closed.message, Catch::Contains("the token is not accepted"));
  options.token = "0123456789abcdef";
  client.join(server.port(), options);
}

TEST_CASE("a talus_client reports that its server was killed") {
  ServerProcess server;
  TestClient client;
  client.join(server.port());
  server.signal(SIGKILL);
  (void)server.wait();
  const talus_event closed = client.await(TALUS_EVENT_CLOSED);
  CHECK(closed.status == TALUS_DISCONNECTED);
  CHECK_THAT(closed.message, Catch::StartsWith("the connection ended"));
  CHECK(client.world().material_count > 0);  // still known
  check_over(client);
}

TEST_CASE("a talus_client that shall reconnect tries, and gives up") {
  ServerProcess server;
  TestClient client;
  auto options = sized<talus_connect_options>();
  options.reconnect_attempts = 2;
  options.reconnect_first_delay_ms = 1;
  client.join(server.port(), options);
  server.signal(SIGKILL);
  (void)server.wait();
  CHECK(client.await(TALUS_EVENT_RECONNECTING).status == TALUS_DISCONNECTED);
  CHECK(client.await(TALUS_EVENT_CLOSED).status == TALUS_UNREACHABLE);
}

TEST_CASE("open requests of a talus_client fail before it is closed") {
  ServerProcess server;
  TestClient client;
  client.join(server.port());
  server.freeze();
  std::uint32_t chunk = 0;
  std::uint32_t ping = 0;
  REQUIRE(talus_get_chunk(client.get(), 0, 0, 0, 0, nullptr, &chunk) == TALUS_OK);
  REQUIRE(talus_ping(client.get(), &ping) == TALUS_OK);
  server.signal(SIGKILL);
  (void)server.wait();
  std::map<std::uint32_t, talus_status> answers;
  (void)client.await(TALUS_EVENT_CLOSED, [&](const talus_event& event) {
    CHECK(event.chunk == nullptr);
    answers[event.request] = event.status;
  });
  CHECK(answers ==
        std::map<std::uint32_t, talus_status>{{chunk, TALUS_DISCONNECTED}, {ping, TALUS_DISCONNECTED}});
}

TEST_CASE("talus_poll waits for its timeout") {
  const ServerProcess server;
  TestClient client;
  client.join(server.port());
  auto event = sized<talus_event>();
  using Clock = std::chrono::steady_clock;
  auto began = Clock::now();
  CHECK(talus_poll(client.get(), &event, 80) == TALUS_NO_EVENT);
  CHECK(Clock::now() - began >= std::chrono::milliseconds{80});
  for (int poll = 0; poll < 100; ++poll) CHECK(talus_poll(client.get(), &event, 0) == TALUS_NO_EVENT);
  // Without limit: until something comes.
  std::uint32_t ping = 0;
  REQUIRE(talus_ping(client.get(), &ping) == TALUS_OK);
  CHECK(talus_poll(client.get(), &event, -1) == TALUS_OK);
  CHECK(event.type == TALUS_EVENT_PONG);
  CHECK(event.request == ping);
}

TEST_CASE("polls that never wait get everything too") {
  const ServerProcess server;
  TestClient client;
  client.connect(server.port());
  auto event = sized<talus_event>();
  talus_status status = TALUS_NO_EVENT;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{30};
  while (status == TALUS_NO_EVENT && std::chrono::steady_clock::now() < end) {
    status = talus_poll(client.get(), &event, 0);
  }
  CHECK(status == TALUS_OK);
  CHECK(event.type == TALUS_EVENT_JOINED);
}

TEST_CASE("after talus_disconnect nothing comes, and talus_connect works again") {
  const ServerProcess server;
  TestClient client;
  for (int visit = 0; visit < 3; ++visit) {
    client.join(server.port());
    client.set_view(client.view(2, 1));
    (void)client.await(TALUS_EVENT_CHUNK);
    REQUIRE(talus_disconnect(client.get()) == TALUS_OK);
    check_over(client);
    auto world = sized<talus_world>();
    CHECK(talus_get_world(client.get(), &world) == TALUS_NOT_CONNECTED);
  }
}

TEST_CASE("a talus_client may be destroyed while it connects") {
  const ServerProcess server;
  for (int polls = 0; polls < 6; ++polls) {
    TestClient client;
    client.connect(server.port());
    auto event = sized<talus_event>();
    for (int poll = 0; poll < polls; ++poll) (void)talus_poll(client.get(), &event, 0);
  }
}

TEST_CASE("talus_get_world returns what the C++ client receives") {
  const ServerProcess server;
  asio::io_context io;
  client::Client by_cpp{io.get_executor()};
  by_cpp.connect("127.0.0.1", std::to_string(server.port()), [&](const auto&) { io.stop(); });
  io.run_for(std::chrono::seconds{30});
  REQUIRE(by_cpp.world() != nullptr);
  const client::WorldInfo& expected = *by_cpp.world();

  TestClient client;
  client.join(server.port());
  const talus_world world = client.world();
  CHECK(ContentHash{world.fingerprint_low, world.fingerprint_high} == expected.fingerprint);
  CHECK(ContentHash{world.store_low, world.store_high} == expected.store_id);
  CHECK(world.server == expected.server);
  CHECK(world.min_y == expected.min_y);
  CHECK(world.max_y == expected.max_y);
  CHECK(VoxelPos{world.spawn_x, world.spawn_y, world.spawn_z} == expected.spawn);
  CHECK(world.max_horizontal_radius == expected.limits.view_horizontal_radius);
  CHECK(world.max_vertical_radius == expected.limits.view_vertical_radius);
  CHECK(world.max_view_chunks == expected.limits.view_chunks);
  CHECK(world.max_columns == expected.limits.heights_per_request);
  CHECK(world.has_horizon == 1);
  REQUIRE(world.material_count == expected.materials.size());
  for (std::uint32_t index = 0; index < world.material_count; ++index) {
    auto material = sized<talus_material>();
    REQUIRE(talus_get_material(client.get(), index, &material) == TALUS_OK);
    CHECK(material.id == to_integer(expected.materials[index].id));
    CHECK(material.name == expected.materials[index].name);
    CHECK(material.colour == expected.materials[index].colour);
    CHECK(material.phase == static_cast<std::uint32_t>(expected.materials[index].phase));
  }
  REQUIRE(world.look_count == expected.looks.size());
  for (std::uint32_t index = 0; index < world.look_count; ++index) {
    CHECK(talus_look_name(client.get(), index) == expected.looks[index]);
  }
  REQUIRE(world.field_count == expected.fields.size());
  for (std::uint32_t index = 0; index < world.field_count; ++index) {
    CHECK(talus_field_name(client.get(), index) == expected.fields[index]);
  }
}

TEST_CASE("talus_get_stats counts") {
  const ServerProcess server;
  TestClient client;
  client.join(server.port());
  client.set_view(client.view(1, 1));
  (void)client.until_complete();
  auto stats = sized<talus_stats>();
  REQUIRE(talus_get_stats(client.get(), &stats) == TALUS_OK);
  CHECK(stats.connections == 1);
  CHECK(stats.received_bytes > stats.chunk_bytes);
  CHECK(stats.chunk_frames + stats.uniform_chunks == 27);
  CHECK(stats.bad_chunks == 0);
}

}  // namespace talus::c_api
