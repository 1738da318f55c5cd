// A horizon, seen through the client library: what stands far above the player comes, and only with it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <set>
#include <string>
#include <vector>

#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>
#include <asio/io_context.hpp>

#include <talus/client/client.h>

#include "messages.h"
#include "raw_client.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

namespace {

struct Place {
  client::Column column;
  std::int32_t height = 0;  // voxels
};

struct Valley {
  Place plain;
  Place summit;
};

/// The highest place of 1,280 x 1,280 voxels, and the lowest that is over 400 voxels away from it.
asio::awaitable<Valley> find_valley(client::Client& client) {
  std::vector<client::Column> columns;
  for (int z = 0; z < 40; ++z) {
    for (int x = 0; x < 40; ++x) columns.push_back({x * 32 + 5, z * 32 + 5});
  }
  const auto heights = co_await client.get_heights(columns);
  REQUIRE(heights.has_value());
  std::vector<Place> places;
  for (std::size_t i = 0; i < columns.size(); ++i)
    places.push_back({columns[i], static_cast<std::int32_t>(floor_div((*heights)[i], 256))});
  const auto lower = [](const Place& a, const Place& b) { return a.height < b.height; };
  const Place summit = *std::max_element(places.begin(), places.end(), lower);
  std::erase_if(places, [&](const Place& place) {
    return std::max(std::abs(place.column.x - summit.column.x), std::abs(place.column.z - summit.column.z)) <
           400;
  });
  co_return Valley{*std::min_element(places.begin(), places.end(), lower), summit};
}

struct ReceivedChunks {
  std::set<ChunkKey> chunks;
  std::set<ChunkKey> mixed;
  std::size_t twice = 0;
};

/// All that a player at the plain is sent.
void fly(asio::io_context& io, const ServerProcess& server, bool horizon, ReceivedChunks& seen,
         Valley& valley, client::View& view, HeightRange& heights) {
  client::Events events;
  events.on_chunk = [&](const client::ReceivedChunk& chunk) {
    if (!seen.chunks.insert(chunk.key).second) ++seen.twice;
    if (!chunk.chunk->is_uniform()) seen.mixed.insert(chunk.key);
  };
  client::Client* who = nullptr;
  bool complete = false;
  events.on_view_complete = [&](const client::View&) {
    complete = true;
    who->close();
  };
  const client::Options options;
  client::Client client{io.get_executor(), options, events};
  who = &client;
  const auto visit = [&]() -> asio::awaitable<void> {
    const auto world = co_await client.connect("127.0.0.1", std::to_string(server.port()));
    REQUIRE(world.has_value());
    heights = world->heights();
    valley = co_await find_valley(client);
    view = {{valley.plain.column.x, valley.plain.height, valley.plain.column.z},
            {},
            2,
            0,
            {{Lod::of(1), 20}, {Lod::of(2), 60}}};
    view.horizon = horizon;
    CHECK(client.set_view(view).has_value());
  };
  asio::co_spawn(io, visit, asio::detached);
  io.restart();
  io.run_for(std::chrono::seconds{120});
  REQUIRE(complete);
}

/// The chunks that the server sends as Chunks for a View of its own accord: the library asks for what is
/// missing.
std::multiset<ChunkKey> sent_for(const ServerProcess& server, const client::View& view, bool horizon) {
  RawClient client = greeted(server.port());
  ViewFields fields{.centre = view.centre,
                    .horizontal_radius = view.horizontal_radius,
                    .vertical_radius = view.vertical_radius,
                    .number = 1,
                    .horizon = horizon};
  for (const client::LodRing& ring : view.rings)
    fields.rings.emplace_back(static_cast<std::uint8_t>(ring.lod.value()), ring.radius);
  REQUIRE(client.send(e2e::view(fields)));
  std::multiset<ChunkKey> sent;
  std::uint64_t bytes = 0;
  while (true) {
    const ReceivedFrame received = client.expect();
    if (received.kind() == wire::Body::ViewComplete) return sent;
    if (received.kind() != wire::Body::Chunk) continue;
    sent.insert(key_of(*received.as<wire::Chunk>().key()));
    bytes += received.bytes();
    REQUIRE(client.send(credit(bytes)));
  }
}

}  // namespace

TEST_CASE("the summit above the plain comes with a horizon, and not without") {
  const bool horizon = GENERATE(false, true);
  CAPTURE(horizon);
  const ServerProcess server{{kClassicWorld}};
  asio::io_context io;
  ReceivedChunks seen;
  Valley valley;
  client::View view;
  HeightRange heights;
  fly(io, server, horizon, seen, valley, view, heights);
  CAPTURE(valley.plain.height, valley.summit.height);

  // The chunk that holds the summit's topmost voxel, of the level that the View has there.
  std::vector<ChunkKey> at_summit;
  view.horizon = true;
  const client::ViewShape shape{view, heights};
  for (const int level : {1, 2}) {
    const auto key = chunk_holding({valley.summit.column.x >> level, (valley.summit.height - 1) >> level,
                                    valley.summit.column.z >> level},
                                   Lod::of(level));
    REQUIRE(key.has_value());
    if (shape.covers(*key)) at_summit.push_back(*key);
  }
  REQUIRE_FALSE(at_summit.empty());
  for (const ChunkKey key : at_summit) {
    CAPTURE(to_string(key));
    CHECK(seen.chunks.contains(key) == horizon);
  }
  if (horizon) {
    CHECK(std::any_of(at_summit.begin(), at_summit.end(),
                      [&](ChunkKey key) { return seen.mixed.contains(key); }));
    CHECK(static_cast<std::int64_t>(seen.chunks.size()) == shape.count());
  }
  CHECK(seen.twice == 0);

  const std::multiset<ChunkKey> sent = sent_for(server, view, horizon);
  CHECK(std::any_of(at_summit.begin(), at_summit.end(), [&](ChunkKey key) { return sent.contains(key); }) ==
        horizon);
  const std::set<ChunkKey> once(sent.begin(), sent.end());
  CHECK(once.size() == sent.size());
  // Chunks among the rows that may hold anything may turn out uniform: those come as Chunks, too.
  const bool all = std::includes(once.begin(), once.end(), seen.mixed.begin(), seen.mixed.end());
  if (horizon) CHECK(all);
}

TEST_CASE("a horizon has every chunk of its rings that is not uniform, and as many as the client counts") {
  const ServerProcess server{{{"TALUS_WORLD", TALUS_SOURCE_DIR "/core/worlds/features.toml"}}};
  asio::io_context io;
  ReceivedChunks seen;
  Valley valley;
  client::View view;
  HeightRange heights;
  fly(io, server, true, seen, valley, view, heights);
  const client::ViewShape shape{view, heights};
  CHECK(static_cast<std::int64_t>(seen.chunks.size()) == shape.count());
  CHECK(seen.mixed.size() > 300);
  // One row more on each side, as single chunks: nothing but rock and air lies beyond.
  std::vector<ChunkKey> beyond;
  for (const ChunkKey key : seen.chunks) {
    if (key.lod == Lod{} || beyond.size() >= 200) continue;
    const ChunkRange rows = shape.rows(key.coord.x, key.coord.z, key.lod);
    for (const std::int64_t y : {rows.first - 1, rows.last + 1})
      beyond.push_back({{key.coord.x, static_cast<std::int32_t>(y), key.coord.z}, key.lod});
  }
  const client::Options options;
  client::Client client{io.get_executor(), options};
  std::size_t uniform = 0;
  const auto visit = [&]() -> asio::awaitable<void> {
    const auto world = co_await client.connect("127.0.0.1", std::to_string(server.port()));
    REQUIRE(world.has_value());
    for (const ChunkKey key : beyond) {
      const auto chunk = co_await client.get(key);
      if (chunk && chunk->chunk->is_uniform()) ++uniform;
    }
    client.close();
  };
  asio::co_spawn(io, visit, asio::detached);
  io.restart();
  io.run_for(std::chrono::seconds{120});
  CHECK(beyond.size() >= 200);
  CHECK(uniform == beyond.size());
}
