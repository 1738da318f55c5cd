// Clients do not know each other, and chunks belong to no thread.
#include <catch2/catch.hpp>
#include <thread>
#include <vector>

#include "server_process.h"
#include "test_client.h"

namespace talus::c_api {
namespace {

using namespace testing;
using e2e::ServerProcess;

// Without Catch, whose macros are for one thread: the voxels of a View, in the order of their keys; empty
// where anything failed.
std::map<Key, Voxels> visit(std::uint16_t port) {
  std::map<Key, Voxels> chunks;
  talus_client* client = nullptr;
  if (talus_create(&client) != TALUS_OK) return {};
  auto options = sized<talus_connect_options>();
  options.host = "127.0.0.1";
  options.port = port;
  talus_status status = talus_connect(client, &options);
  auto event = sized<talus_event>();
  while (status >= 0) {
    status = talus_poll(client, &event, 10'000);
    if (status != TALUS_OK) break;
    if (event.type == TALUS_EVENT_JOINED) {
      auto world = sized<talus_world>();
      auto view = sized<talus_view>();
      status = talus_get_world(client, &world);
      view.centre_x = world.spawn_x;
      view.centre_y = world.spawn_y;
      view.centre_z = world.spawn_z;
      view.horizontal_radius = 3;
      view.vertical_radius = 1;
      if (status == TALUS_OK) status = talus_set_view(client, &view);
    } else if (event.type == TALUS_EVENT_CHUNK) {
      Voxels& voxels = chunks[key_of(event)];
      voxels.resize(TALUS_CHUNK_VOLUME);
      status = talus_decode(event.chunk, voxels.data(), voxels.size());
    } else if (event.type == TALUS_EVENT_VIEW_COMPLETE) {
      talus_destroy(client);
      return chunks;
    }
  }
  talus_destroy(client);
  return {};
}

}  // namespace

TEST_CASE("two talus_clients in two threads see the same world") {
  const ServerProcess server;
  std::map<Key, Voxels> there;
  std::thread thread{[&] { there = visit(server.port()); }};
  const auto here = visit(server.port());
  thread.join();
  CHECK(here.size() == 147);
  CHECK(here == there);
}

TEST_CASE("retained chunks are decoded and released by other threads") {
  const ServerProcess server;
  TestClient client;
  client.join(server.port());
  client.set_view(client.view(1, 1));
  std::vector<const talus_chunk*> chunks;
  std::vector<Voxels> expected;
  (void)client.await(TALUS_EVENT_VIEW_COMPLETE, [&](const talus_event& event) {
    for (int holder = 0; holder < 2; ++holder) talus_chunk_retain(event.chunk);
    chunks.push_back(event.chunk);
    expected.push_back(decode(event.chunk));
  });
  const auto mesh = [&](std::vector<Voxels>& out) {
    for (const talus_chunk* chunk : chunks) {
      Voxels& voxels = out.emplace_back(TALUS_CHUNK_VOLUME);
      (void)talus_decode(chunk, voxels.data(), voxels.size());
      talus_chunk_release(chunk);
    }
  };
  std::vector<Voxels> first;
  std::vector<Voxels> second;
  std::thread one{[&] { mesh(first); }};
  std::thread other{[&] { mesh(second); }};
  REQUIRE(talus_disconnect(client.get()) == TALUS_OK);
  one.join();
  other.join();
  CHECK(first == expected);
  CHECK(second == expected);
}

TEST_CASE("the last error without a client is of its own thread") {
  CHECK(talus_decode(nullptr, nullptr, 0) == TALUS_INVALID_ARGUMENT);
  std::string there;
  std::thread{[&] { there = talus_last_error(nullptr); }}.join();
  CHECK(there.empty());
  CHECK(std::string{talus_last_error(nullptr)}.starts_with("talus_decode: "));
}

}  // namespace talus::c_api
