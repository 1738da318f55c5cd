// What a server must do on purpose, by a peer that the test scripts.
#include <catch2/catch.hpp>

#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>

#include "peer.h"
#include "test_client.h"

namespace talus::c_api {
namespace {

using namespace testing;

std::uint16_t port_of(const client::testing::Peer& peer) {
  return static_cast<std::uint16_t>(std::stoi(peer.port()));
}

talus_connect_options quick_to_return() {
  auto options = sized<talus_connect_options>();
  options.reconnect_attempts = 5;
  options.reconnect_first_delay_ms = 1;
  return options;
}

}  // namespace

TEST_CASE("a talus_client comes back to the same world, and its View comes again") {
  asio::io_context io;
  client::testing::Peer peer{io};
  const ChunkKey key{};
  const Chunk chunk = client::testing::some_chunk(key);
  const auto serve = [&]() -> asio::awaitable<void> {
    for (int visit = 0; visit < 2; ++visit) {
      co_await peer.welcome();
      const wire::Message* message = co_await peer.receive();
      while (message->body_type() != wire::Body::View) message = co_await peer.receive();
      co_await peer.send(client::testing::chunk_frame(0, key, chunk));
      if (visit == 0) peer.hang_up();
    }
    co_await peer.until_closed();
  };
  asio::co_spawn(io, serve, asio::detached);
  const auto meanwhile = [&] { (void)io.poll(); };
  TestClient client;
  client.connect(port_of(peer), quick_to_return());
  (void)client.await(TALUS_EVENT_JOINED, {}, meanwhile);
  auto view = sized<talus_view>();
  client.set_view(view);
  const auto expected = [&] {
    DenseVoxels dense;
    chunk.copy_to(dense);
    Voxels voxels;
    for (const MaterialId id : dense) voxels.push_back(to_integer(id));
    return voxels;
  }();
  CHECK(decode(client.await(TALUS_EVENT_CHUNK, {}, meanwhile).chunk) == expected);
  const talus_event lost = client.await(TALUS_EVENT_RECONNECTING, {}, meanwhile);
  CHECK(lost.status == TALUS_DISCONNECTED);
  CHECK(talus_set_view(client.get(), &view) == TALUS_OK);  // it is kept
  (void)client.await(TALUS_EVENT_RECONNECTED, {}, meanwhile);
  CHECK(decode(client.await(TALUS_EVENT_CHUNK, {}, meanwhile).chunk) == expected);
}

TEST_CASE("a talus_client does not come back to another world") {
  asio::io_context io;
  client::testing::Peer peer{io};
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome(1);
    peer.hang_up();
    co_await peer.welcome(2);
    co_await peer.until_closed();
  };
  asio::co_spawn(io, serve, asio::detached);
  TestClient client;
  client.connect(port_of(peer), quick_to_return());
  const auto meanwhile = [&] { (void)io.poll(); };
  CHECK(client.await(TALUS_EVENT_CLOSED, {}, meanwhile).status == TALUS_WORLD_CHANGED);
}

TEST_CASE("a talus_client reports a bad chunk, and stays connected") {
  asio::io_context io;
  client::testing::Peer peer{io};
  const std::vector<std::byte> no_payload(1);
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    const wire::Message* message = co_await peer.receive();
    while (message->body_type() != wire::Body::View) message = co_await peer.receive();
    co_await peer.send(client::testing::chunk_frame(0, ChunkKey{}, ContentHash{1, 2}, no_payload));
    co_await peer.until_closed();
  };
  asio::co_spawn(io, serve, asio::detached);
  const auto meanwhile = [&] { (void)io.poll(); };
  TestClient client;
  client.connect(port_of(peer));
  (void)client.await(TALUS_EVENT_JOINED, {}, meanwhile);
  client.set_view(sized<talus_view>());
  const talus_event bad = client.await(TALUS_EVENT_ERROR, {}, meanwhile);
  CHECK(bad.status == TALUS_BAD_CHUNK);
  CHECK(std::string{bad.message} != "");
  CHECK(talus_ping(client.get(), nullptr) == TALUS_OK);
}

TEST_CASE("VIEW_COMPLETE that waits when another View is set never comes") {
  asio::io_context io;
  client::testing::Peer peer{io};
  const ChunkKey key{};
  const Chunk chunk = client::testing::some_chunk(key);
  bool sent = false;
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    const wire::Message* message = co_await peer.receive();
    while (message->body_type() != wire::Body::View) message = co_await peer.receive();
    const std::uint32_t number = message->body_as_View()->number();
    co_await peer.send(client::testing::chunk_frame(0, key, chunk));
    co_await peer.send(client::testing::complete_frame(number));
    sent = true;
    co_await peer.until_closed();
  };
  asio::co_spawn(io, serve, asio::detached);
  const auto meanwhile = [&] { (void)io.poll(); };
  TestClient client;
  client.connect(port_of(peer));
  (void)client.await(TALUS_EVENT_JOINED, {}, meanwhile);
  auto view = sized<talus_view>();
  client.set_view(view);
  auto event = sized<talus_event>();
  while (!sent) {  // both messages lie in the socket before the client reads either
    REQUIRE(talus_poll(client.get(), &event, 0) == TALUS_NO_EVENT);
    (void)io.poll();
  }
  REQUIRE(talus_poll(client.get(), &event, 10'000) == TALUS_OK);
  REQUIRE(event.type == TALUS_EVENT_CHUNK);
  SECTION("where it is another one") {
    view.centre_x = 32;
    client.set_view(view);
    REQUIRE(talus_poll(client.get(), &event, 100) == TALUS_OK);
    CHECK(event.type == TALUS_EVENT_CHUNK_LEFT);
    CHECK(talus_poll(client.get(), &event, 100) == TALUS_NO_EVENT);
  }
  SECTION("but does where it is the same") {
    client.set_view(view);
    REQUIRE(talus_poll(client.get(), &event, 0) == TALUS_OK);
    CHECK(event.type == TALUS_EVENT_VIEW_COMPLETE);
  }
}

}  // namespace talus::c_api
