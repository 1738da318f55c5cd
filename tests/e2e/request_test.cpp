// Requests with ids: each answered once, and rightly.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <set>

#include <talus/terrain/extraction.h>
#include <talus/terrain/heights.h>
#include <talus/terrain/places.h>
#include <talus/voxel/codec.h>

#include "messages.h"
#include "raw_client.h"
#include "seed_of_run.h"
#include "served_world.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

namespace {

/// The id that a frame answers; 0 where it answers none.
std::uint32_t answered_id(const ReceivedFrame& received) {
  switch (received.kind()) {
    case wire::Body::Chunk:
      return received.as<wire::Chunk>().id();
    case wire::Body::Unchanged:
      return received.as<wire::Unchanged>().id();
    case wire::Body::Heights:
      return received.as<wire::Heights>().id();
    case wire::Body::Error:
      return received.as<wire::Error>().request_id();
    default:
      return 0;
  }
}

wire::ErrorCode error_for(RawClient& client, std::uint32_t id) {
  const ReceivedFrame received = client.expect();
  const auto& error = received.as<wire::Error>();
  CHECK(error.request_id() == id);
  return error.code();
}

}  // namespace

TEST_CASE("a client that shuts its sending side gets all that it asked for, and then the end") {
  const ServerProcess server;
  RawClient client = greeted(server.port(), 1000);  // and gives no credit
  std::vector<wire::ChunkRequest> requests;
  for (std::uint32_t id = 1; id <= 100; ++id) {
    requests.push_back(chunk_request(id, at(static_cast<std::int32_t>(id), 1, -700)));
  }
  REQUIRE(client.send(get_chunks(requests)));
  REQUIRE(client.send(get_heights(101, {wire::ColumnPos{5, 5}})));
  REQUIRE(client.send(view({.horizontal_radius = 6, .vertical_radius = 3, .number = 1})));
  client.end_sending();
  std::set<std::uint32_t> answered;
  int complete = 0;
  while (const auto received = client.receive()) {
    REQUIRE(received->kind() != wire::Body::Error);
    complete += received->kind() == wire::Body::ViewComplete ? 1 : 0;
    if (const std::uint32_t id = answered_id(*received); id != 0) CHECK(answered.insert(id).second);
  }
  CHECK(answered.size() == 101);
  CHECK(complete == 1);
}

TEST_CASE("chunks are the generator's, at every level and at the world's ends") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  const std::int32_t end = (std::int64_t{1} << 31) - 1;
  const std::vector<ChunkKey> keys{
      at(0, 0, 0),          at(-3, 1, 7), at(40, 2, -90),           at(0, 500, 0),
      at(end, 1, -end - 1), at(5, -4, 5), {{3, 0, -2}, Lod::of(3)}, {{-1, 0, 0}, Lod::of(6)}};
  std::vector<wire::ChunkRequest> requests;
  for (const ChunkKey key : keys) {
    requests.push_back(chunk_request(static_cast<std::uint32_t>(requests.size() + 1), key));
  }
  REQUIRE(client.send(get_chunks(requests)));
  for (std::size_t answers = 0; answers < keys.size(); ++answers) {
    const ReceivedFrame received = client.expect();
    const auto& chunk = received.as<wire::Chunk>();
    const ChunkKey key = key_of(*chunk.key());
    REQUIRE(key == keys.at(chunk.id() - 1));
    const Chunk expected = terrain::generate_chunk(served_world(), key);
    const auto decoded = decode(std::as_bytes(std::span{chunk.payload()->data(), chunk.payload()->size()}));
    REQUIRE(decoded.has_value());
    CHECK(*decoded == expected);
    CHECK(hash_of(*chunk.hash()) == content_hash(expected));
    CHECK(chunk.revision() == 0);
  }
}

TEST_CASE("every request is answered exactly once, whatever is cancelled") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  std::mt19937 random{seed};
  std::uniform_int_distribution<std::int32_t> near{-6, 6};

  constexpr std::uint32_t kRequests = 600;
  std::map<std::uint32_t, int> answers;
  for (std::uint32_t id = 1; id <= kRequests; ++id) {
    answers[id] = 0;
    if (id % 10 == 0) {
      REQUIRE(client.send(get_heights(id, {{near(random), near(random)}})));
    } else {
      REQUIRE(client.send(get_chunks({chunk_request(id, at(near(random), near(random), near(random)))})));
    }
    if (random() % 2 == 0) REQUIRE(client.send(cancel({1 + static_cast<std::uint32_t>(random() % id)})));
  }
  for (std::uint32_t received = 0; received < kRequests; ++received)
    ++answers.at(answered_id(client.expect()));
  CHECK(std::all_of(answers.begin(), answers.end(), [](const auto& each) { return each.second == 1; }));

  // Nothing more comes: the Pong is the next frame.
  REQUIRE(client.send(ping(1)));
  (void)client.expect_kind<wire::Pong>();
}

TEST_CASE("a known chunk is confirmed, not sent") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  const ContentHash known = content_hash(terrain::generate_chunk(served_world(), at(1, 0, 1)));
  REQUIRE(client.send(get_chunks({chunk_request(9, at(1, 0, 1), known)})));
  const ReceivedFrame received = client.expect();
  CHECK(received.as<wire::Unchanged>().id() == 9);
  CHECK(hash_of(*received.as<wire::Unchanged>().hash()) == known);
}

TEST_CASE("a chunk that changed is sent in full") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  REQUIRE(client.send(get_chunks({chunk_request(9, at(1, 0, 1), {1, 2})})));
  CHECK(client.expect_kind<wire::Chunk>().as<wire::Chunk>().id() == 9);
}

TEST_CASE("a coordinate outside the world is refused by its id") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  const std::int32_t beyond = 1 << 30;  // level 2 ends at 2^29
  const ChunkKey outside{{beyond, 0, 0}, Lod::of(2)};
  REQUIRE(client.send(get_chunks({chunk_request(3, outside)})));
  CHECK(error_for(client, 3) == wire::ErrorCode::out_of_range);
}

TEST_CASE("a level of detail that there is not is refused by its id") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  REQUIRE(client.send(get_chunks({{4, {0, 0, 0, 7}, false, {}}})));
  CHECK(error_for(client, 4) == wire::ErrorCode::out_of_range);
}

TEST_CASE("request id 0 closes the connection") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  REQUIRE(client.send(get_chunks({chunk_request(0, at(0, 0, 0))})));
  CHECK(error_for(client, 0) == wire::ErrorCode::malformed);
  CHECK(client.closed());
}

TEST_CASE("an id in flight is refused, the request it names goes on") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  REQUIRE(client.send(get_chunks({chunk_request(5, at(90, 0, 0)), chunk_request(5, at(91, 0, 0))})));
  CHECK(error_for(client, 5) == wire::ErrorCode::duplicate_id);
  const ReceivedFrame received = client.expect();
  CHECK(key_of(*received.as<wire::Chunk>().key()) == at(90, 0, 0));
}

TEST_CASE("heights are the surface's") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  const std::vector<terrain::BaseColumn> columns{{0, 0}, {-1000, 77}, {1LL << 35, -(1LL << 36)}};
  std::vector<wire::ColumnPos> wire_columns;
  for (const auto& column : columns) wire_columns.emplace_back(column.x, column.z);
  REQUIRE(client.send(get_heights(8, wire_columns)));
  const ReceivedFrame received = client.expect();
  const auto& heights = *received.as<wire::Heights>().heights_fx();
  CHECK(std::vector<std::int32_t>(heights.begin(), heights.end()) ==
        terrain::surface_heights(served_world(), columns));
}

TEST_CASE("looks and fields come with the heights, numbered as in Welcome") {
  const ServerProcess server;
  RawClient client{server.port()};
  REQUIRE(client.send(hello({})));
  const ReceivedFrame greeting = client.expect();
  const auto& welcome = greeting.as<wire::Welcome>();
  const std::vector<std::string> names = terrain::place_names(served_world());
  REQUIRE(welcome.fields()->size() == names.size());
  REQUIRE(welcome.looks()->size() == served_world().look_names().size());
  const std::vector<terrain::BaseColumn> columns{{0, 0}, {-1000, 77}, {1LL << 35, -(1LL << 36)}};
  std::vector<wire::ColumnPos> wire_columns;
  for (const auto& column : columns) wire_columns.emplace_back(column.x, column.z);
  REQUIRE(client.send(protocol::make_frame([&](auto& b) {
    const auto column_list = b.CreateVectorOfStructs(wire_columns);
    return wire::CreateGetHeights(b, 8, column_list, true, b.CreateVector(std::vector<std::uint8_t>{0}));
  })));
  const ReceivedFrame received = client.expect();
  const auto& heights = received.as<wire::Heights>();
  const auto places = terrain::places_at(served_world(), columns, std::vector{names[0]});
  CHECK(std::vector<std::uint8_t>(heights.looks()->begin(), heights.looks()->end()) == places.looks);
  CHECK(std::vector<float>(heights.values()->begin(), heights.values()->end()) == places.values);
  CHECK(std::vector<std::int32_t>(heights.heights_fx()->begin(), heights.heights_fx()->end()) ==
        terrain::surface_heights(served_world(), columns));
}

TEST_CASE("heights outside the world are refused") {
  const ServerProcess server;
  RawClient client = greeted(server.port());
  REQUIRE(client.send(get_heights(8, {{1LL << 36, 0}})));
  CHECK(error_for(client, 8) == wire::ErrorCode::out_of_range);
}

TEST_CASE("an edit is refused by its id, whether the client may edit or not") {
  const bool may = GENERATE(true, false);
  const ServerProcess server{{{"TALUS_ACCESS_WITHOUT_TOKEN", may ? "read,edit" : "read"}}};
  RawClient client = greeted(server.port());
  REQUIRE(client.send(edit(12)));
  CHECK(error_for(client, 12) == (may ? wire::ErrorCode::unsupported : wire::ErrorCode::forbidden));
}
