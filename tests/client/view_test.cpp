#include <set>

#include <rapidcheck.h>
#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include "peer.h"

namespace talus::client {
namespace {

using namespace testing;

View view_at(std::int64_t x, std::uint16_t horizontal = 1, std::uint16_t vertical = 1) {
  View view;
  view.centre = {x, 0, 0};
  view.horizontal_radius = horizontal;
  view.vertical_radius = vertical;
  return view;
}

protocol::Frame column_frame(int x, int z, const std::vector<wire::UniformRun>& runs) {
  return protocol::make_frame(
      [&](auto& b) { return wire::CreateUniformColumn(b, x, z, 0, 0, b.CreateVectorOfStructs(runs)); });
}

// What on_chunk and on_left_view tell while `frames` come and the view then moves to `then`.
struct ViewEvents {
  std::multiset<ChunkKey> came;
  std::set<ChunkKey> left;
  std::vector<ClientError> errors;
};
ViewEvents watch(const View& view, const std::vector<protocol::Frame>& frames, const View& then) {
  asio::io_context io;
  Peer peer{io};
  ViewEvents seen;
  Events events;
  events.on_chunk = [&](const ReceivedChunk& chunk) { seen.came.insert(chunk.key); };
  events.on_left_view = [&](ChunkKey key) { seen.left.insert(key); };
  events.on_error = [&](const ClientError& error) { seen.errors.push_back(error); };
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor(), Options{}, events};
    co_await join(client, peer);
    REQUIRE(client.set_view(view).has_value());
    (void)co_await client.get(key_at(1000, 0, 0));
    REQUIRE(client.set_view(then).has_value());
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    std::optional<std::uint32_t> last;
    while (!last) {
      if (const auto* get = (co_await peer.receive())->body_as_GetChunks())
        last = get->requests()->Get(0)->id();
    }
    for (const auto& frame : frames) co_await peer.send(frame);
    co_await peer.send(error_frame(wire::ErrorCode::internal, "the end", *last));
  };
  run(io, {visit, serve});
  return seen;
}

protocol::Frame view_chunk(const ChunkKey& key) {
  return chunk_frame(0, key, some_chunk(key));
}

}  // namespace

TEST_CASE("chunks of the View are delivered, others are not") {
  const auto seen =
      watch(view_at(0), {view_chunk(key_at(1, 1, -1)), view_chunk(key_at(2, 0, 0))}, view_at(0));
  CHECK(seen.came == std::multiset<ChunkKey>{key_at(1, 1, -1)});
}

TEST_CASE("a delivered chunk that is no longer covered leaves the View") {
  const auto seen =
      watch(view_at(0), {view_chunk(key_at(-1, 0, 0)), view_chunk(key_at(1, 0, 0))}, view_at(32));
  CHECK(seen.left == std::set<ChunkKey>{key_at(-1, 0, 0)});
}

namespace {

protocol::Frame unchanged_frame(const ChunkKey& key, ContentHash hash) {
  return protocol::make_frame([&](auto& b) {
    const wire::ChunkKey wire_key{key.coord.x, key.coord.y, key.coord.z, 0};
    const wire::Hash128 wire_hash{hash.low, hash.high};
    return wire::CreateUnchanged(b, 0, &wire_key, 0, &wire_hash);
  });
}

/// A client gets `key` for its View, walks away and comes back; the peer answers that with `then`.
struct Return {
  std::multiset<ChunkKey> came;
  std::vector<wire::KnownChunk> said_known;  // with the last View
  std::vector<ChunkKey> asked_for;           // by GetChunks, and answered
  Stats stats;
};
struct Habits {
  std::size_t keep_bytes = 1 << 20;
  bool holds = true;  // what it is given, until it has walked away
};
Return walk_and_return(const ChunkKey& key, const protocol::Frame& then, Habits habits) {
  asio::io_context io;
  Peer peer{io};
  Return seen;
  std::vector<std::shared_ptr<const Chunk>> hands;
  Events events;
  events.on_chunk = [&](const ReceivedChunk& chunk) {
    seen.came.insert(chunk.key);
    if (habits.holds) hands.push_back(chunk.chunk);
  };
  Options options;
  options.keep_bytes = habits.keep_bytes;
  // Requests beyond x = 1000 mark how far the client is: what was sent before their answers has arrived.
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor(), options, events};
    co_await join(client, peer);
    std::int64_t x = 0;
    for (int mark = 1000; mark < 1003; ++mark) {
      (void)client.set_view(view_at(x));
      (void)co_await client.get(key_at(mark, 0, 0));
      x = x == 0 ? 100 * kChunkSize : 0;
      if (mark == 1001) hands.clear();
    }
    (void)co_await client.get(key_at(1003, 0, 0));
    seen.stats = client.stats();
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    for (int mark = 0; mark != 1003;) {
      const wire::Message* message = co_await peer.receive();
      if (const auto* view = message->body_as_View()) {
        seen.said_known.clear();
        if (view->known() == nullptr) continue;
        for (const auto* known : *view->known()) seen.said_known.push_back(*known);
      }
      const auto* get = message->body_as_GetChunks();
      if (get == nullptr) continue;
      std::vector<wire::ChunkRequest> requests;
      for (const auto* request : *get->requests()) requests.push_back(*request);
      for (const auto& request : requests) {
        const wire::ChunkKey& at = request.key();
        if (at.x() < 1000) {
          seen.asked_for.push_back(key_at(at.x(), at.y(), at.z()));
          co_await peer.send(chunk_frame(request.id(), key, some_chunk(key)));
          continue;
        }
        mark = at.x();
        if (mark == 1000) co_await peer.send(view_chunk(key));
        if (mark == 1002 && !then.empty()) co_await peer.send(then);
        co_await peer.send(error_frame(wire::ErrorCode::internal, "a mark", request.id()));
      }
    }
  };
  run(io, {visit, serve});
  return seen;
}

const ChunkKey kKey = key_at(0, 1, 0);

}  // namespace

TEST_CASE("a chunk that left is kept: coming back, its hash is said and its confirmation brings it") {
  const ContentHash hash = content_hash(some_chunk(kKey));
  const Return seen = walk_and_return(kKey, unchanged_frame(kKey, hash), {});
  REQUIRE(seen.said_known.size() == 1);
  CHECK(seen.said_known[0].hash().low() == hash.low);
  CHECK(seen.came.count(kKey) == 2);
  CHECK(seen.asked_for.empty());
  CHECK(seen.stats.kept_chunks == 1);
  CHECK(seen.stats.chunk_frames == 1);
}

TEST_CASE("without room to keep it, or without holders, nothing is announced as known") {
  const Habits habits = GENERATE(Habits{0, true}, Habits{1 << 20, false});
  const Return seen = walk_and_return(kKey, view_chunk(kKey), habits);
  CHECK(seen.said_known.empty());
  CHECK(seen.came.count(kKey) == 2);
}

TEST_CASE("a confirmation of what is not held, or not held so, has the chunk fetched") {
  const bool held = GENERATE(true, false);
  const Return seen = walk_and_return(kKey, unchanged_frame(kKey, {1, 2}), {held ? 1U << 20 : 0U, true});
  CHECK(seen.asked_for == std::vector<ChunkKey>{kKey});
  CHECK(seen.came.count(kKey) == 2);
}

TEST_CASE("a chunk that left and came back before a View was sent comes without the server") {
  asio::io_context io;
  Peer peer{io};
  std::vector<std::shared_ptr<const Chunk>> came;
  std::vector<ChunkKey> asked_for;
  Events events;
  const bool holds = GENERATE(true, false);
  events.on_chunk = [&](const ReceivedChunk& chunk) { came.push_back(holds ? chunk.chunk : nullptr); };
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor(), Options{}, events};
    co_await join(client, peer);
    (void)client.set_view(view_at(0));
    (void)co_await client.get(key_at(1000, 0, 0));
    (void)client.set_view(view_at(100 * kChunkSize));
    (void)client.set_view(view_at(0));
    (void)co_await client.get(key_at(1001, 0, 0));
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    for (int mark = 0; mark != 1001;) {
      const auto* get = (co_await peer.receive())->body_as_GetChunks();
      if (get == nullptr) continue;
      std::vector<wire::ChunkRequest> requests;
      for (const auto* request : *get->requests()) requests.push_back(*request);
      for (const auto& request : requests) {
        const wire::ChunkKey& at = request.key();
        if (at.x() < 1000) {
          asked_for.push_back(key_at(at.x(), at.y(), at.z()));
          co_await peer.send(chunk_frame(request.id(), kKey, some_chunk(kKey)));
          continue;
        }
        mark = at.x();
        if (mark == 1000) co_await peer.send(view_chunk(kKey));
        co_await peer.send(error_frame(wire::ErrorCode::internal, "a mark", request.id()));
      }
    }
  };
  run(io, {visit, serve});
  CHECK(came.size() == 2);
  CHECK(asked_for.size() == (holds ? 0 : 1));
}

TEST_CASE("a UniformColumn's runs are delivered within the View, however long they claim to be") {
  const wire::UniformRun endless{INT32_MIN, 0, 2};
  const wire::UniformRun air{1, INT32_MAX, 0};
  const auto seen = watch(view_at(0), {column_frame(0, 1, {endless, air})}, view_at(0));
  CHECK(seen.came == std::multiset<ChunkKey>{key_at(0, -1, 1), key_at(0, 0, 1), key_at(0, 1, 1)});
}

TEST_CASE("a bad chunk of the View is an error and is not delivered") {
  const auto seen =
      watch(view_at(0), {chunk_frame(0, key_at(0, 0, 0), ContentHash{}, {std::byte{9}})}, view_at(0));
  CHECK(seen.came.empty());
  REQUIRE(seen.errors.size() == 1);
  CHECK(seen.errors[0].kind == ErrorKind::bad_chunk);
}

TEST_CASE("a View beyond the server's limits is refused at once") {
  asio::io_context io;
  Peer peer{io};
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor()};
    co_await join(client, peer);
    CHECK(client.set_view(view_at(0, 33)).error().kind == ErrorKind::out_of_range);
    CHECK(client.set_view(view_at(0, 1, 17)).error().kind == ErrorKind::out_of_range);
    CHECK(client.set_view(view_at(0, 32, 0)).has_value());
    CHECK(client.set_view(view_at(0, 1, 16)).has_value());
  };
  run(io, {visit, [&]() -> asio::awaitable<void> { co_await peer.welcome(); }});
}

TEST_CASE("a ring of level l reaches 2^l times the server's radius, and no farther") {
  asio::io_context io;
  Peer peer{io};
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor()};
    co_await join(client, peer);
    View view = view_at(0, 1, 0);
    view.rings = {{Lod::of(1), 64}, {Lod::of(2), 128}};
    CHECK(client.set_view(view).has_value());
    view.rings[0].radius = 65;
    CHECK(client.set_view(view).error().kind == ErrorKind::out_of_range);
    view.rings = {{Lod::of(2), 129}};
    CHECK(client.set_view(view).error().kind == ErrorKind::out_of_range);
  };
  run(io, {visit, [&]() -> asio::awaitable<void> { co_await peer.welcome(); }});
}

TEST_CASE("a View of more chunks than the server allows is refused, and the one before stays") {
  asio::io_context io;
  Peer peer{io};
  const ChunkKey kept = key_at(0, 7, 0);
  std::multiset<ChunkKey> came;
  Events events;
  events.on_chunk = [&](const ReceivedChunk& chunk) { came.insert(chunk.key); };
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor(), Options{}, events};
    co_await join(client, peer);
    CHECK(client.set_view(view_at(0, 32, 7)).has_value());  // 65 x 65 x 15 of 65,536 chunks
    CHECK(client.set_view(view_at(3200, 32, 8)).error().kind == ErrorKind::out_of_range);
    (void)co_await client.ping();
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    for (const wire::Message* message = nullptr; message == nullptr || message->body_as_Ping() == nullptr;) {
      message = co_await peer.receive();
      if (const auto* view = message->body_as_View()) CHECK(view->centre()->x() == 0);
      if (const auto* ping = message->body_as_Ping()) {
        const auto nonce = ping->nonce();
        co_await peer.send(view_chunk(kept));
        co_await peer.send(protocol::make_frame([&](auto& b) { return wire::CreatePong(b, nonce); }));
        break;
      }
    }
  };
  run(io, {visit, serve});
  CHECK(came == std::multiset<ChunkKey>{kept});
}

TEST_CASE("a client that is closed in on_left_view receives no more of it") {
  asio::io_context io;
  Peer peer{io};
  int left = 0;
  std::optional<Client> client;
  Events events;
  events.on_left_view = [&](ChunkKey) {
    ++left;
    client->close();
  };
  client.emplace(io.get_executor(), Options{}, events);
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(*client, peer);
    REQUIRE(client->set_view(view_at(0)).has_value());
    (void)co_await client->get(key_at(1000, 0, 0));
    REQUIRE(client->set_view(view_at(3200)).has_value());
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    std::optional<std::uint32_t> id;
    while (!id) {
      if (const auto* get = (co_await peer.receive())->body_as_GetChunks())
        id = get->requests()->Get(0)->id();
    }
    for (const int x : {-1, 0, 1}) co_await peer.send(view_chunk(key_at(x, 0, 0)));
    co_await peer.send(error_frame(wire::ErrorCode::internal, "the end", *id));
  };
  run(io, {visit, serve});
  CHECK(left == 1);
}

TEST_CASE("a shape covers exactly as many chunks as it counts") {
  const bool held = rc::check("count is the number covered", [] {
    View view;
    view.centre = {*rc::gen::inRange<std::int64_t>(-3000, 3000), *rc::gen::inRange<std::int64_t>(-300, 300),
                   *rc::gen::inRange<std::int64_t>(-3000, 3000)};
    view.horizontal_radius = *rc::gen::inRange<std::uint16_t>(0, 5);
    view.vertical_radius = *rc::gen::inRange<std::uint16_t>(0, 3);
    view.rings = {{Lod::of(1), static_cast<std::uint16_t>(view.horizontal_radius + 3)},
                  {Lod::of(3), static_cast<std::uint16_t>(view.horizontal_radius + 15)}};
    const ViewShape shape{view};
    std::int64_t covered = 0;
    for (const int level : {0, 1, 2, 3}) {
      const auto scale = std::int64_t{kChunkSize} << level;
      const int reach = (25 >> level) + 2;
      for (int dx = -reach; dx <= reach; ++dx) {
        for (int dz = -reach; dz <= reach; ++dz) {
          for (int dy = -4; dy <= 4; ++dy) {
            covered += shape.covers(key_at(static_cast<int>(floor_div(view.centre.x, scale)) + dx,
                                           static_cast<int>(floor_div(view.centre.y, scale)) + dy,
                                           static_cast<int>(floor_div(view.centre.z, scale)) + dz, level));
          }
        }
      }
    }
    RC_ASSERT(covered == shape.count());
  });
  REQUIRE(held);
}

TEST_CASE("every column within the outermost ring is covered by some level") {
  const bool held = rc::check("no gaps", [] {
    View view;
    view.centre = {*rc::gen::inRange<std::int64_t>(-5000, 5000), 0,
                   *rc::gen::inRange<std::int64_t>(-5000, 5000)};
    view.horizontal_radius = 3;
    view.rings = {{Lod::of(1), 7}, {Lod::of(2), 16}};
    const ViewShape shape{view};
    const auto cx = static_cast<int>(floor_div(view.centre.x, kChunkSize));
    const auto cz = static_cast<int>(floor_div(view.centre.z, kChunkSize));
    for (int x = cx - 16; x <= cx + 16; ++x) {
      for (int z = cz - 16; z <= cz + 16; ++z) {
        bool covered = false;
        for (const int level : {0, 1, 2}) covered |= shape.covers(key_at(x >> level, 0, z >> level, level));
        RC_ASSERT(covered);
      }
    }
  });
  REQUIRE(held);
}

}  // namespace talus::client
