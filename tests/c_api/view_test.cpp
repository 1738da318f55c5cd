// Chunks around a player.
#include <catch2/catch.hpp>

#include <asio/io_context.hpp>

#include <talus/client/client.h>

#include "server_process.h"
#include "test_client.h"

namespace talus::c_api {
namespace {

using namespace testing;
using e2e::ServerProcess;

// The same View by the C++ library.
std::map<Key, Voxels> by_cpp(std::uint16_t port, const talus_view& view) {
  std::map<Key, Voxels> chunks;
  asio::io_context io;
  client::Events events;
  bool complete = false;
  events.on_chunk = [&](const client::ReceivedChunk& chunk) {
    DenseVoxels dense;
    chunk.chunk->copy_to(dense);
    const auto& [x, y, z] = chunk.key.coord;
    Voxels& voxels = chunks[{static_cast<std::uint32_t>(chunk.key.lod.value()), x, y, z}];
    for (const MaterialId id : dense) voxels.push_back(to_integer(id));
  };
  events.on_view_complete = [&](const client::View&) {
    complete = true;
    io.stop();
  };
  client::Client client{io.get_executor(), {}, events};
  client.connect("127.0.0.1", std::to_string(port), [&](const auto& world) {
    REQUIRE(world.has_value());
    client::View own;
    own.centre = {view.centre_x, view.centre_y, view.centre_z};
    own.horizontal_radius = view.horizontal_radius;
    own.vertical_radius = view.vertical_radius;
    own.rings = {{Lod::of(2), view.ring_radius[1]}};
    REQUIRE(client.set_view(own).has_value());
  });
  io.run_for(std::chrono::seconds{30});
  REQUIRE(complete);
  return chunks;
}

}  // namespace

TEST_CASE("a talus_client's voxels equal the C++ client's") {
  const ServerProcess server;
  TestClient client;
  client.join(server.port());
  auto view = client.view(2, 2);
  view.ring_radius[1] = 8;
  client.set_view(view);
  const auto chunks = client.until_complete();
  std::uint64_t expected = 0;
  REQUIRE(talus_count_view(client.get(), &view, &expected) == TALUS_OK);
  CHECK(chunks.size() == expected);
  CHECK(chunks == by_cpp(server.port(), view));
}

TEST_CASE("a talus_client that makes chunks sees those that another receives") {
  const ServerProcess server{{{"TALUS_PUBLISH", "public"}}};
  TestClient receiver;
  receiver.join(server.port());
  receiver.set_view(receiver.view(2, 1));
  auto options = sized<talus_connect_options>();
  options.generate = TALUS_GENERATE_ALWAYS;
  options.generate_threads = 1;
  TestClient maker;
  maker.join(server.port(), options);
  maker.set_view(maker.view(2, 1));
  CHECK(maker.until_complete() == receiver.until_complete());
  auto stats = sized<talus_stats>();
  REQUIRE(talus_get_stats(maker.get(), &stats) == TALUS_OK);
  CHECK(stats.file_bytes > 0);
  CHECK(stats.failed_proofs == 0);

  const ServerProcess unpublished;
  TestClient alone;
  alone.connect(unpublished.port(), options);
  CHECK(alone.await(TALUS_EVENT_CLOSED).status == TALUS_CANNOT_GENERATE);
}

TEST_CASE("a talus_client by WebSocket sees what it sees by TCP") {
  e2e::ServerProcess server{{}, {"--http", "127.0.0.1:0"}};
  auto options = sized<talus_connect_options>();
  TestClient by_tcp;
  by_tcp.join(server.port(), options);
  by_tcp.set_view(by_tcp.view(2, 1));
  options.flags = TALUS_WEBSOCKET;
  TestClient by_websocket;
  by_websocket.join(server.http_port(), options);
  by_websocket.set_view(by_websocket.view(2, 1));
  const auto seen = by_tcp.until_complete();
  CHECK(seen.size() == 75);
  const bool same = by_websocket.until_complete() == seen;
  CHECK(same);
}

TEST_CASE("an event of a chunk says which material is all of it") {
  const ServerProcess server;
  TestClient client;
  client.join(server.port());
  client.set_view(client.view(1, 4));
  int uniform = 0;
  int mixed = 0;
  (void)client.await(TALUS_EVENT_VIEW_COMPLETE, [&](const talus_event& event) {
    REQUIRE(event.type == TALUS_EVENT_CHUNK);
    CHECK(event.status == TALUS_OK);
    CHECK(std::string{event.message} == "");
    const Voxels voxels = decode(event.chunk);
    const bool all = std::count(voxels.begin(), voxels.end(), voxels[0]) == TALUS_CHUNK_VOLUME;
    CHECK(event.uniform_material == (all ? voxels[0] : -1));
    ++(all ? uniform : mixed);
  });
  CHECK(uniform > 0);
  CHECK(mixed > 0);
}

TEST_CASE("a View that moves loses chunks and gains others") {
  const ServerProcess server;
  TestClient client;
  client.join(server.port());
  auto view = client.view(2, 1);
  client.set_view(view);
  auto held = client.until_complete();
  CHECK(held.size() == 75);

  view.centre_x += 32;
  client.set_view(view);
  client.set_view(view);  // once more changes nothing
  int left = 0;
  int came = 0;
  (void)client.await(TALUS_EVENT_VIEW_COMPLETE, [&](const talus_event& event) {
    if (event.type == TALUS_EVENT_CHUNK_LEFT) {
      ++left;
      CHECK(event.chunk == nullptr);
      CHECK(held.erase(key_of(event)) == 1);
    } else {
      REQUIRE(event.type == TALUS_EVENT_CHUNK);
      ++came;
      CHECK(held.emplace(key_of(event), decode(event.chunk)).second);
    }
  });
  CHECK(left == 15);
  CHECK(came == 15);
  CHECK(held.size() == 75);
}

TEST_CASE("a retained chunk outlives its event, its connection and its client") {
  const ServerProcess server;
  const talus_chunk* kept = nullptr;
  Voxels before;
  {
    TestClient client;
    client.join(server.port());
    client.set_view(client.view(0, 0));
    const talus_event event = client.await(TALUS_EVENT_CHUNK);
    kept = event.chunk;
    talus_chunk_retain(kept);
    before = decode(kept);
    (void)client.await(TALUS_EVENT_VIEW_COMPLETE);
    CHECK(decode(kept) == before);
  }
  CHECK(decode(kept) == before);
  talus_chunk_release(kept);
}

TEST_CASE("chunks that the game retained come back without being sent again") {
  const ServerProcess server;
  TestClient client;
  client.join(server.port());
  const auto view = client.view(1, 1);
  auto away = view;
  away.centre_x += 32 * 20;
  client.set_view(view);
  std::vector<const talus_chunk*> retained;
  (void)client.await(TALUS_EVENT_VIEW_COMPLETE, [&](const talus_event& event) {
    talus_chunk_retain(event.chunk);
    retained.push_back(event.chunk);
  });
  client.set_view(away);
  (void)client.until_complete();
  client.set_view(view);
  CHECK(client.until_complete().size() == 27);
  auto stats = sized<talus_stats>();
  REQUIRE(talus_get_stats(client.get(), &stats) == TALUS_OK);
  CHECK(stats.kept_chunks > 0);
  for (const talus_chunk* chunk : retained) talus_chunk_release(chunk);
}

TEST_CASE("a View with a horizon has as many chunks as talus_count_view says") {
  const ServerProcess server;
  TestClient client;
  client.join(server.port());
  auto view = client.view(1, 1);
  REQUIRE(talus_fill_rings(&view, 16) == TALUS_OK);
  view.flags = TALUS_VIEW_HORIZON;
  view.direction_x = -3;
  client.set_view(view);
  std::uint64_t expected = 0;
  REQUIRE(talus_count_view(client.get(), &view, &expected) == TALUS_OK);
  CHECK(client.until_complete().size() == expected);
}

TEST_CASE("Views without polls do not pile up events without end") {
  const ServerProcess server;
  TestClient client;
  client.join(server.port());
  const auto view = client.view(6, 4);
  auto away = view;
  away.centre_x += 32 * 100;
  client.set_view(view);
  std::vector<const talus_chunk*> retained;
  (void)client.await(TALUS_EVENT_VIEW_COMPLETE, [&](const talus_event& event) {
    talus_chunk_retain(event.chunk);
    retained.push_back(event.chunk);
  });
  talus_status status = TALUS_OK;
  for (int turn = 0; turn < 4000 && status == TALUS_OK; ++turn) {
    status = talus_set_view(client.get(), turn % 2 == 0 ? &away : &view);
  }
  CHECK(status == TALUS_TOO_MANY_EVENTS);
  CHECK_THAT(client.error(), Catch::Contains("poll until TALUS_NO_EVENT"));
  auto event = sized<talus_event>();
  while (talus_poll(client.get(), &event, 0) == TALUS_OK) continue;
  client.set_view(view);
  for (const talus_chunk* chunk : retained) talus_chunk_release(chunk);
}

}  // namespace talus::c_api
