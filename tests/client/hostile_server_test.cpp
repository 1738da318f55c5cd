// What a broken or wicked server sends must become an error, never a crash and never a chunk.
#include <algorithm>
#include <limits>

#include <rapidcheck.h>
#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include <talus/voxel/codec.h>

#include "peer.h"

namespace talus::client {
namespace {

using namespace testing;

const ChunkKey kKey = key_at(4, 1, -2);

// What a get() gives when the server answers with the frame that `answer` makes of its id.
Result<ReceivedChunk> get_answered_by(const std::function<protocol::Frame(std::uint32_t)>& answer) {
  asio::io_context io;
  Peer peer{io};
  std::optional<Result<ReceivedChunk>> received;
  const auto visit = [&]() -> asio::awaitable<void> {
    Client client{io.get_executor()};
    co_await join(client, peer);
    received = co_await client.get(kKey);
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    const auto id = (co_await peer.receive())->body_as_GetChunks()->requests()->Get(0)->id();
    co_await peer.send(answer(id));
    peer.hang_up();
  };
  run(io, {visit, serve});
  return *received;
}

ErrorKind kind_of(const Result<ReceivedChunk>& received) {
  REQUIRE_FALSE(received.has_value());
  return received.error().kind;
}

}  // namespace

TEST_CASE("a payload that does not decode is a bad chunk") {
  const auto received = get_answered_by([](std::uint32_t id) {
    return chunk_frame(id, kKey, ContentHash{}, {std::byte{1}, std::byte{200}, std::byte{3}});
  });
  CHECK(kind_of(received) == ErrorKind::bad_chunk);
  CHECK(received.error().message.find(to_string(kKey)) != std::string::npos);
}

TEST_CASE("content that is not what its hash says is a bad chunk") {
  const auto received = get_answered_by([](std::uint32_t id) {
    std::vector<std::byte> payload;
    encode(some_chunk(kKey), payload);
    return chunk_frame(id, kKey, ContentHash{1, 2}, payload);
  });
  CHECK(kind_of(received) == ErrorKind::bad_chunk);
}

TEST_CASE("another chunk than the one asked for breaks the protocol") {
  const auto received = get_answered_by(
      [](std::uint32_t id) { return chunk_frame(id, key_at(4, 1, -3), some_chunk(key_at(4, 1, -3))); });
  CHECK(kind_of(received) == ErrorKind::broken_protocol);
}

TEST_CASE("an answer to a request never made breaks the protocol") {
  const auto received =
      get_answered_by([](std::uint32_t id) { return chunk_frame(id + 1, kKey, some_chunk(kKey)); });
  CHECK(kind_of(received) == ErrorKind::broken_protocol);
}

TEST_CASE("Unchanged without a known hash breaks the protocol") {
  const auto received = get_answered_by([](std::uint32_t id) {
    return protocol::make_frame([&](auto& b) {
      const wire::ChunkKey key{kKey.coord.x, kKey.coord.y, kKey.coord.z, 0};
      const wire::Hash128 hash{};
      return wire::CreateUnchanged(b, id, &key, 0, &hash);
    });
  });
  CHECK(kind_of(received) == ErrorKind::broken_protocol);
}

TEST_CASE("a message of clients breaks the protocol") {
  const auto received = get_answered_by(
      [](std::uint32_t) { return protocol::make_frame([](auto& b) { return wire::CreatePing(b, 1); }); });
  CHECK(kind_of(received) == ErrorKind::broken_protocol);
}

TEST_CASE("a frame larger than a server's may be breaks the protocol at its prefix") {
  const auto received = get_answered_by([](std::uint32_t) {
    return protocol::Frame{std::byte{0xFF}, std::byte{0xFF}, std::byte{0xFF}, std::byte{0x00}};
  });
  CHECK(kind_of(received) == ErrorKind::broken_protocol);
}

TEST_CASE("a connection that ends inside a frame says so") {
  const auto received = get_answered_by([](std::uint32_t id) {
    auto frame = chunk_frame(id, kKey, some_chunk(kKey));
    frame.resize(frame.size() / 2);
    return frame;
  });
  CHECK(kind_of(received) == ErrorKind::disconnected);
}

TEST_CASE("a Welcome with heights that no world has is refused, and no View gets their rows") {
  const auto welcomed_with = [](std::int64_t max_y) {
    asio::io_context io;
    Peer peer{io};
    std::optional<Result<WorldInfo>> world;
    const auto visit = [&]() -> asio::awaitable<void> {
      Client client{io.get_executor()};
      world = co_await client.connect("127.0.0.1", peer.port());
    };
    run(io, {visit, [&]() -> asio::awaitable<void> {
               co_await peer.welcome(1, 1U << 20, 64, 60'000, std::nullopt, {true, max_y});
             }});
    return *world;
  };
  CHECK(welcomed_with(kMaxWorldRows).has_value());
  for (const std::int64_t max_y : {kMaxWorldRows + 1, std::numeric_limits<std::int64_t>::max(),
                                   std::int64_t{-1}, std::numeric_limits<std::int64_t>::min()}) {
    const auto world = welcomed_with(max_y);
    REQUIRE_FALSE(world.has_value());
    CHECK(world.error().kind == ErrorKind::broken_protocol);
    CHECK(world.error().message.find(std::to_string(max_y)) != std::string::npos);
  }
}

TEST_CASE("an answer with any bytes changed is the chunk or an error") {
  const bool held = rc::check("never another chunk", [] {
    const auto received = get_answered_by([](std::uint32_t id) {
      auto frame = chunk_frame(id, kKey, some_chunk(kKey));
      const auto changes = *rc::gen::inRange(1, 4);
      for (int i = 0; i < changes; ++i) {
        frame[*rc::gen::inRange<std::size_t>(0, frame.size())] =
            static_cast<std::byte>(*rc::gen::arbitrary<std::uint8_t>());
      }
      return frame;
    });
    RC_ASSERT(!received.has_value() || (received->chunk && *received->chunk == some_chunk(kKey)));
  });
  REQUIRE(held);
}

}  // namespace talus::client
