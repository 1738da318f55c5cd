// The View: what comes, in which order, and how credit holds it back.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "messages.h"
#include "raw_client.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

namespace {

/// What comes for a View, in its order.
struct Arrivals {
  std::vector<ChunkKey> all;
  std::vector<ChunkKey> by_chunk;  // those that did not come in a UniformColumn
};

Arrivals receive(RawClient& client, std::size_t count) {
  Arrivals came;
  while (came.all.size() < count) {
    const ReceivedFrame received = client.expect();
    if (received.kind() == wire::Body::UniformColumn) {
      const auto& column = received.as<wire::UniformColumn>();
      for (const wire::UniformRun* run : *column.runs()) {
        for (std::int32_t y = run->first_y(); y <= run->last_y(); ++y) {
          came.all.push_back({{column.x(), y, column.z()}, Lod::of(column.lod())});
        }
      }
      continue;
    }
    REQUIRE(received.as<wire::Chunk>().id() == 0);
    came.all.push_back(key_of(*received.as<wire::Chunk>().key()));
    came.by_chunk.push_back(came.all.back());
  }
  REQUIRE(came.all.size() == count);
  return came;
}

std::vector<ChunkKey> receive_chunks(RawClient& client, std::size_t count) {
  return receive(client, count).all;
}

/// The chunks of level 0 around a chunk.
std::set<ChunkKey> box(ChunkKey centre, int horizontal, int vertical) {
  std::set<ChunkKey> keys;
  for (int y = -vertical; y <= vertical; ++y) {
    for (int z = -horizontal; z <= horizontal; ++z) {
      for (int x = -horizontal; x <= horizontal; ++x) {
        keys.insert(at(centre.coord.x + x, centre.coord.y + y, centre.coord.z + z));
      }
    }
  }
  return keys;
}

std::set<ChunkKey> as_set(const std::vector<ChunkKey>& keys) {
  return {keys.begin(), keys.end()};
}

int ring_of(ChunkKey key) {
  const glm::i64vec3 offset = to_vec(key.coord);
  return static_cast<int>(
      std::sqrt(static_cast<double>(offset.x * offset.x + offset.y * offset.y + offset.z * offset.z)));
}

/// Nothing else comes: a Pong is the next frame.
void check_silent(RawClient& client) {
  REQUIRE(client.send(ping(1)));
  (void)client.expect_kind<wire::Pong>();
}

}  // namespace

TEST_CASE("a View brings each of its chunks once") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  REQUIRE(client.send(view({.centre = {10, 10, 10}, .horizontal_radius = 3, .vertical_radius = 2})));
  const std::set<ChunkKey> wanted = box(at(0, 0, 0), 3, 2);
  CHECK(as_set(receive_chunks(client, wanted.size())) == wanted);
  check_silent(client);
}

TEST_CASE("cached chunks come nearest ring first") {
  const ServerProcess server;
  const auto wanted = view({.centre = {10, 10, 10}, .horizontal_radius = 5, .vertical_radius = 2});
  const std::size_t count = box(at(0, 0, 0), 5, 2).size();
  RawClient first = greeted(server.port());
  REQUIRE(first.send(wanted));
  (void)receive_chunks(first, count);

  RawClient second = greeted(server.port());
  REQUIRE(second.send(wanted));
  const std::vector<ChunkKey> keys = receive(second, count).by_chunk;
  CHECK(keys.size() > 100);
  CHECK(std::is_sorted(keys.begin(), keys.end(),
                       [](ChunkKey a, ChunkKey b) { return ring_of(a) < ring_of(b); }));
}

TEST_CASE("a moved View brings only what is new, and again what comes back") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  const auto around = [](std::int64_t x) {
    return view({.centre = {x * kChunkSize, 0, 0}, .horizontal_radius = 2, .vertical_radius = 1});
  };
  constexpr std::size_t kAll = 5 * 5 * 3;
  constexpr std::size_t kSlice = 5 * 3;
  REQUIRE(client.send(around(0)));
  (void)receive_chunks(client, kAll);
  REQUIRE(client.send(around(1)));
  const auto came = receive_chunks(client, kSlice);
  CHECK(std::all_of(came.begin(), came.end(), [](ChunkKey key) { return key.coord.x == 3; }));
  REQUIRE(client.send(around(0)));
  const auto back = receive_chunks(client, kSlice);
  CHECK(std::all_of(back.begin(), back.end(), [](ChunkKey key) { return key.coord.x == -2; }));
  check_silent(client);
}

TEST_CASE("rings bring coarser chunks") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  REQUIRE(client.send(view({.centre = {0, 0, 0}, .horizontal_radius = 1, .rings = {{1, 4}}})));
  const std::size_t fine = 3 * 3;
  const std::size_t coarse = 5 * 5 - 1;  // -4 to 4 touches coarse -2 to 2; coarse 0 is wholly covered
  const auto keys = receive_chunks(client, fine + coarse);
  CHECK(std::count_if(keys.begin(), keys.end(), [](ChunkKey key) { return key.lod == Lod::of(1); }) ==
        static_cast<std::ptrdiff_t>(coarse));
  check_silent(client);
}

TEST_CASE("a View over the limits is refused and the old one stays") {
  const ServerProcess server{{{"TALUS_LIMITS_VIEW_HORIZONTAL_RADIUS", "2"}}};
  RawClient client = greeted(server.port(), 1);
  REQUIRE(client.send(view({.horizontal_radius = 2})));
  (void)receive_chunks(client, 1);  // the window of one byte is overdrawn by one frame
  REQUIRE(client.send(view({.horizontal_radius = 3})));
  const ReceivedFrame received = client.expect();
  CHECK(received.as<wire::Error>().code() == wire::ErrorCode::too_large);
  CHECK_THAT(received.as<wire::Error>().text()->str(), Catch::Contains("view_horizontal_radius 2"));
}

TEST_CASE("Chunk frames stop at the window and go on with Credit") {
  constexpr std::uint64_t kWindow = 2000;
  const ServerProcess server{{kClassicWorld}};
  RawClient client = greeted(server.port(), kWindow);
  // A chunk that is in memory: what does not come is held back, not still being made.
  REQUIRE(client.send(get_chunks({chunk_request(1, at(0, 0, 0))})));
  std::uint64_t bytes = client.expect_kind<wire::Chunk>().bytes();
  REQUIRE(client.send(credit(bytes)));
  std::vector<wire::ChunkRequest> requests;
  for (std::uint32_t id = 1; id <= 100; ++id) requests.push_back(chunk_request(id, at(0, 0, 0)));
  REQUIRE(client.send(get_chunks(requests)));

  std::size_t chunks = 0;
  while (chunks < requests.size()) {
    // Two Pongs: when the second ping is read, what the first round let out has been written.
    std::uint64_t overdrawn = 0;
    const std::uint64_t before = bytes;
    for (std::uint64_t nonce = 1; nonce <= 2; ++nonce) {
      REQUIRE(client.send(ping(nonce)));
      for (;;) {
        const ReceivedFrame received = client.expect();
        if (received.kind() == wire::Body::Pong) break;
        (void)received.as<wire::Chunk>();
        ++chunks;
        bytes += received.bytes();
        overdrawn = received.bytes();
      }
    }
    CHECK(bytes - before < kWindow + overdrawn);
    if (chunks < requests.size()) CHECK(bytes - before >= kWindow);
    REQUIRE(client.send(credit(bytes)));
  }
}

TEST_CASE("a Credit that goes down closes the connection") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  REQUIRE(client.send(get_chunks({chunk_request(1, at(0, 1'000'000, 0))})));
  const std::size_t bytes = client.expect_kind<wire::Chunk>().bytes();
  REQUIRE(client.send(credit(bytes)));
  REQUIRE(client.send(credit(bytes - 1)));
  CHECK(client.expect().as<wire::Error>().code() == wire::ErrorCode::malformed);
  CHECK(client.closed());
}

TEST_CASE("a Credit for what was not sent closes the connection") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  REQUIRE(client.send(credit(1)));
  CHECK(client.expect().as<wire::Error>().code() == wire::ErrorCode::malformed);
  CHECK(client.closed());
}
