// Views with a horizon: which servers are asked for one, and which rows the client takes for its own.
#include <limits>
#include <set>

#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include "peer.h"
#include "view_tracker.h"

namespace talus::client {
namespace {

using namespace testing;

/// Columns -1 and 0 of level 1, along x and along z.
View with_horizon() {
  View view;
  view.horizontal_radius = 0;
  view.vertical_radius = 0;
  view.rings = {{Lod::of(1), 1}};
  view.horizon = true;
  return view;
}

protocol::Frame all_air(int x, int z) {
  return protocol::make_frame([&](auto& b) {
    const std::vector<wire::UniformRun> runs{
        {std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max(), 0}};
    return wire::CreateUniformColumn(b, x, z, 1, 0, b.CreateVectorOfStructs(runs));
  });
}

asio::awaitable<std::uint32_t> read_request(Peer& peer, std::size_t& views, std::size_t& horizons) {
  while (true) {
    const auto* message = co_await peer.receive();
    if (const auto* view = message->body_as_View()) {
      ++views;
      horizons += view->horizon() ? 1 : 0;
    }
    if (const auto* get = message->body_as_GetChunks()) co_return get->requests()->Get(0)->id();
  }
}

}  // namespace

TEST_CASE("a server without horizons is not asked for one") {
  asio::io_context io;
  Peer peer{io};
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor()};
    co_await join(client, peer);
    CHECK_FALSE(client.world()->limits.view_horizon);
    View view = with_horizon();
    const auto refused = client.set_view(view);
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error().kind == ErrorKind::out_of_range);
    view.horizon = false;
    CHECK(client.set_view(view).has_value());
  };
  run(io, {visit, [&]() -> asio::awaitable<void> { co_await peer.welcome(); }});
}

TEST_CASE("the horizon alone makes another View") {
  const View view = with_horizon();
  View plain = view;
  plain.horizon = false;
  CHECK(view == View{view});
  CHECK(view != plain);
}

TEST_CASE("a horizon's rows are the world's, whatever a run names") {
  asio::io_context io;
  Peer peer{io};
  std::multiset<ChunkKey> came;
  Events events;
  events.on_chunk = [&](const ReceivedChunk& chunk) { came.insert(chunk.key); };
  std::size_t views = 0;
  std::size_t horizons = 0;
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor(), Options{}, events};
    co_await join(client, peer);
    REQUIRE(client.set_view(with_horizon()).has_value());
    (void)co_await client.get(key_at(1000, 0, 0));
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome(1, 1U << 20, 64, 60'000, std::nullopt, {true, 320});
    const auto last = co_await read_request(peer, views, horizons);
    for (const int y : {-2, -1, 4, 5}) {
      const ChunkKey key = key_at(0, y, 0, 1);
      co_await peer.send(chunk_frame(0, key, some_chunk(key)));
    }
    co_await peer.send(all_air(-1, -1));
    co_await peer.send(error_frame(wire::ErrorCode::internal, "the end", last));
  };
  run(io, {visit, serve});
  CHECK(views == 1);
  CHECK(horizons == 1);
  std::multiset<ChunkKey> expected{key_at(0, -1, 0, 1), key_at(0, 4, 0, 1)};
  for (int y = -1; y <= 4; ++y) expected.insert(key_at(-1, y, -1, 1));
  CHECK(came == expected);
}

TEST_CASE("after a reconnect a horizon has the rows of the new Welcome, or is not requested") {
  asio::io_context io;
  Peer peer{io};
  Options options;
  options.reconnect.max_attempts = 5;
  options.reconnect.first_delay = options.reconnect.max_delay = std::chrono::milliseconds{1};
  std::multiset<ChunkKey> left;
  std::vector<ErrorKind> errors;
  Events events;
  events.on_left_view = [&](ChunkKey key) { left.insert(key); };
  events.on_error = [&](const ClientError& error) { errors.push_back(error.kind); };
  events.on_disconnect = [](const ClientError&, bool retrying) { CHECK(retrying); };
  std::size_t views = 0;
  std::size_t horizons = 0;
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor(), options, events};
    co_await join(client, peer);
    REQUIRE(client.set_view(with_horizon()).has_value());
    (void)co_await client.get(key_at(1000, 0, 0));
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome(1, 1U << 20, 64, 60'000, std::nullopt, {true, 320});
    auto last = co_await read_request(peer, views, horizons);
    for (const int y : {3, 4}) {
      const ChunkKey key = key_at(0, y, 0, 1);
      co_await peer.send(chunk_frame(0, key, some_chunk(key)));
    }
    peer.hang_up();
    co_await peer.welcome(1, 1U << 20, 64, 60'000, std::nullopt, {true, 200});
    last = co_await read_request(peer, views, horizons);
    CHECK(horizons == 2);
    CHECK(errors.empty());
    peer.hang_up();
    co_await peer.welcome();
    last = co_await read_request(peer, views, horizons);
    co_await peer.send(error_frame(wire::ErrorCode::internal, "the end", last));
  };
  run(io, {visit, serve});
  CHECK(left == std::multiset<ChunkKey>{key_at(0, 4, 0, 1)});
  CHECK(views == 2);
  CHECK(errors == std::vector{ErrorKind::out_of_range});
}

TEST_CASE("after a reconnect a View beyond the new limits is kept, and not sent") {
  asio::io_context io;
  Peer peer{io};
  Options options;
  options.reconnect.max_attempts = 5;
  options.reconnect.first_delay = options.reconnect.max_delay = std::chrono::milliseconds{1};
  std::vector<std::string> errors;
  Events events;
  events.on_error = [&](const ClientError& error) { errors.push_back(error.message); };
  std::size_t views = 0;
  std::size_t horizons = 0;
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor(), options, events};
    co_await join(client, peer);
    View view = with_horizon();
    view.rings[0].radius = 16;
    REQUIRE(client.set_view(view).has_value());
    (void)co_await client.get(key_at(1000, 0, 0));
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    const auto meet = [&](std::int64_t max_y) -> asio::awaitable<void> {
      co_await peer.welcome(1, 1U << 20, 64, 60'000, std::nullopt, {true, max_y});
    };
    co_await meet(320);
    auto last = co_await read_request(peer, views, horizons);
    CHECK(views == 1);
    peer.hang_up();
    co_await meet(kMaxWorldRows);  // in which it has more chunks than the server allows
    last = co_await read_request(peer, views, horizons);
    CHECK(views == 1);
    CHECK(errors.size() == 1);
    peer.hang_up();
    co_await meet(200);
    last = co_await read_request(peer, views, horizons);
    CHECK(views == 2);
    co_await peer.send(error_frame(wire::ErrorCode::internal, "the end", last));
  };
  run(io, {visit, serve});
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].find("a View whose chunks number") == 0);
}

TEST_CASE("rings grow by one ratio, from level 1 to the farthest radius") {
  const std::vector<LodRing> rings = rings_between(8, 256);
  REQUIRE(rings.size() == 6);
  std::vector<int> radii;
  for (const LodRing& ring : rings) radii.push_back(ring.radius);
  CHECK(radii == std::vector{14, 25, 45, 81, 144, 256});
  CHECK(rings_between(8, 8).empty());
  CHECK(rings_between(0, 1).size() == 1);
  for (int farthest = 9; farthest < 600; ++farthest) {
    int level = 0;
    int radius = 8;
    for (const LodRing& ring : rings_between(8, static_cast<std::uint16_t>(farthest))) {
      CHECK(ring.lod.value() > level);
      CHECK(ring.radius > radius);
      level = ring.lod.value();
      radius = ring.radius;
    }
    CHECK(radius == farthest);
  }
}

}  // namespace talus::client
