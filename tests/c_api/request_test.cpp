// Single chunks, heights and pings.
#include <catch2/catch.hpp>

#include "server_process.h"
#include "test_client.h"

namespace talus::c_api {
namespace {

using namespace testing;
using e2e::ServerProcess;

// A row of voxels of the column (x, z) inside its chunk that holds a solid one, or -1.
int highest_solid(const Voxels& voxels, int x, int z) {
  for (int y = TALUS_CHUNK_SIZE - 1; y >= 0; --y) {
    if (voxels[static_cast<std::size_t>(TALUS_VOXEL_INDEX(x, y, z))] > 1) return y;
  }
  return -1;
}

}  // namespace

TEST_CASE("talus_get_heights returns the ground of the voxels") {
  const ServerProcess server{{e2e::kClassicWorld}};
  TestClient client;
  client.join(server.port());
  const std::int64_t columns[] = {5, 7, 6, 7, -100, 2000};
  std::uint32_t asked = 0;
  REQUIRE(talus_get_heights(client.get(), columns, 3, &asked) == TALUS_OK);
  const talus_event event = client.await(TALUS_EVENT_HEIGHTS);
  CHECK(event.request == asked);
  CHECK(event.status == TALUS_OK);
  REQUIRE(event.column_count == 3);
  CHECK(event.looks == nullptr);
  CHECK(event.values == nullptr);
  const int ground = (event.heights_fx[0] + 255) / 256 - 1;  // the voxel whose top is the ground or above it
  REQUIRE(talus_get_chunk(client.get(), 0, ground >> 5, 0, 0, nullptr, nullptr) == TALUS_OK);
  const talus_event chunk = client.await(TALUS_EVENT_CHUNK_ANSWER);
  const int found = (ground >> 5) * 32 + highest_solid(decode(chunk.chunk), 5, 7);
  CHECK(std::abs(found - ground) <= 1);
}

TEST_CASE("talus_get_places returns looks and fields of columns") {
  const ServerProcess server{{{"TALUS_WORLD", TALUS_SOURCE_DIR "/core/worlds/default.toml"}}};
  TestClient client;
  client.join(server.port());
  const talus_world world = client.world();
  REQUIRE(world.field_count > 1);
  const char* const fields[] = {talus_field_name(client.get(), 1), talus_field_name(client.get(), 0)};
  const std::int64_t columns[] = {0, 0, 1000, 1000, -5000, 77};
  REQUIRE(talus_get_places(client.get(), columns, 3, fields, 2, nullptr) == TALUS_OK);
  const talus_event event = client.await(TALUS_EVENT_HEIGHTS);
  CHECK(event.status == TALUS_OK);
  REQUIRE(event.column_count == 3);
  REQUIRE(event.field_count == 2);
  for (std::uint32_t column = 0; column < 3; ++column) {
    CHECK(talus_look_name(client.get(), event.looks[column]) != nullptr);
  }
  const float first = event.values[0];
  // One field of one column, by itself.
  REQUIRE(talus_get_places(client.get(), columns, 1, fields, 1, nullptr) == TALUS_OK);
  CHECK(client.await(TALUS_EVENT_HEIGHTS).values[0] == first);

  const char* const unknown[] = {"no such field"};
  REQUIRE(talus_get_places(client.get(), columns, 1, unknown, 1, nullptr) == TALUS_OK);
  const talus_event refused = client.await(TALUS_EVENT_HEIGHTS);
  CHECK(refused.status == TALUS_OUT_OF_RANGE);
  CHECK_THAT(refused.message, Catch::Contains("no such field"));
  CHECK(refused.column_count == 0);
  CHECK(refused.heights_fx == nullptr);
}

TEST_CASE("talus_get_chunk with the hash of what one holds brings no voxels") {
  const ServerProcess server;
  TestClient client;
  client.join(server.port());
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  REQUIRE(talus_get_chunk(client.get(), 3, 1, -4, 2, nullptr, &first) == TALUS_OK);
  talus_event event = client.await(TALUS_EVENT_CHUNK_ANSWER);
  CHECK(event.request == first);
  CHECK(key_of(event) == Key{2, 3, 1, -4});
  CHECK(event.chunk != nullptr);
  const std::uint64_t known[2] = {event.hash_low, event.hash_high};
  REQUIRE(talus_get_chunk(client.get(), 3, 1, -4, 2, known, &second) == TALUS_OK);
  CHECK(second != first);
  event = client.await(TALUS_EVENT_CHUNK_ANSWER);
  CHECK(event.request == second);
  CHECK(event.status == TALUS_OK);
  CHECK(event.chunk == nullptr);
  CHECK(event.uniform_material == -1);
  CHECK(event.hash_low == known[0]);
}

TEST_CASE("every request of a talus_client is answered once, cancelled or not") {
  const ServerProcess server;
  TestClient client;
  client.join(server.port());
  std::map<std::uint32_t, int> answers;
  for (int i = 0; i < 200; ++i) {
    std::uint32_t request = 0;
    REQUIRE(talus_get_chunk(client.get(), i, 0, 1000, 0, nullptr, &request) == TALUS_OK);
    REQUIRE(answers.emplace(request, 0).second);
    if (i % 2 == 0) REQUIRE(talus_cancel(client.get(), request) == TALUS_OK);
  }
  int cancelled = 0;
  for (int i = 0; i < 200; ++i) {
    const talus_event event = client.await(TALUS_EVENT_CHUNK_ANSWER);
    ++answers.at(event.request);
    const bool is_cancelled = event.status == TALUS_CANCELLED;
    CHECK((is_cancelled || event.chunk != nullptr));
    cancelled += is_cancelled;
  }
  for (const auto& [request, times] : answers) CHECK(times == 1);
  CHECK(cancelled == 100);
}

TEST_CASE("talus_ping returns a round trip") {
  const ServerProcess server;
  TestClient client;
  client.join(server.port());
  std::uint32_t request = 0;
  REQUIRE(talus_ping(client.get(), &request) == TALUS_OK);
  const talus_event event = client.await(TALUS_EVENT_PONG);
  CHECK(event.request == request);
  CHECK(event.status == TALUS_OK);
  CHECK(event.round_trip_ns > 0);
}

}  // namespace talus::c_api
