// When all chunks of a View have come, a client says so.
#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include "peer.h"

namespace talus::client {
namespace {

using namespace testing;

View one_chunk_at(int x) {
  View view;
  view.centre = {std::int64_t{x} * kChunkSize, 0, 0};
  view.horizontal_radius = view.vertical_radius = 0;
  return view;
}

// What was told, in order: coordinates of chunks, "complete X", "error".
using Transcript = std::vector<std::string>;

// A client that wants one chunk after the other, of x = 0, 1, ..., each when the one before is complete.
// `answer` gets each View's number and place, and returns the frames to send; GetChunks are answered by
// `refetched`.
Transcript visit_all(int places,
                     const std::function<std::vector<protocol::Frame>(std::uint32_t, int)>& answer,
                     const std::function<protocol::Frame(std::uint32_t, const ChunkKey&)>& refetched = {}) {
  asio::io_context io;
  Peer peer{io};
  Transcript told;
  int place = 0;
  std::optional<Client> client;
  Events events;
  events.on_chunk = [&](const ReceivedChunk& chunk) { told.push_back(std::to_string(chunk.key.coord.x)); };
  events.on_error = [&](const ClientError&) { told.emplace_back("error"); };
  events.on_view_complete = [&](const View& view) {
    told.push_back("complete " + std::to_string(view.centre.x / kChunkSize));
    if (++place == places) return client->close();
    REQUIRE(client->set_view(one_chunk_at(place)).has_value());
  };
  client.emplace(io.get_executor(), Options{}, events);
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(*client, peer);
    REQUIRE(client->set_view(one_chunk_at(0)).has_value());
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    try {
      while (true) {
        const auto* message = co_await peer.receive();
        std::vector<protocol::Frame> frames;
        if (const auto* view = message->body_as_View()) {
          frames = answer(view->number(), static_cast<int>(view->centre()->x() / kChunkSize));
        } else if (const auto* get = message->body_as_GetChunks()) {
          for (const auto* r : *get->requests()) {
            frames.push_back(refetched(r->id(), key_at(r->key().x(), r->key().y(), r->key().z())));
          }
        }
        for (const auto& frame : frames) co_await peer.send(frame);
      }
    } catch (const std::system_error&) {
      // The client has closed.
    }
  };
  run(io, {visit, serve});
  return told;
}

protocol::Frame chunk_at(int x) {
  return chunk_frame(0, key_at(x, 0, 0), some_chunk(key_at(x, 0, 0)));
}

protocol::Frame lost_chunk_frame(std::uint32_t number, int x) {
  return protocol::make_frame([&](auto& b) {
    const wire::ChunkKey key{x, 0, 0, 0};
    return wire::CreateError(b, wire::ErrorCode::internal, b.CreateString("lost"), 0, 0,
                             wire::ErrorAbout::view_chunk, 0, number, &key);
  });
}

}  // namespace

TEST_CASE("a View is complete when its server says so, once, and under its number alone") {
  std::uint32_t before = 0;
  const Transcript told = visit_all(2, [&](std::uint32_t number, int x) {
    CHECK(number != 0);
    CHECK(number != before);
    const auto stale = complete_frame(std::exchange(before, number));
    return std::vector{stale, chunk_at(x), complete_frame(number), complete_frame(number)};
  });
  CHECK(told == Transcript{"0", "complete 0", "1", "complete 1"});
}

TEST_CASE("chunks that are missing when a View is complete are fetched first") {
  const bool bad = GENERATE(true, false);  // a bad chunk came, or none
  const Transcript told = visit_all(
      1,
      [&](std::uint32_t number, int x) {
        std::vector<protocol::Frame> frames;
        if (bad) frames.push_back(chunk_frame(0, key_at(x, 0, 0), ContentHash{}, {std::byte{9}}));
        frames.push_back(complete_frame(number));
        return frames;
      },
      [](std::uint32_t id, const ChunkKey& key) { return chunk_frame(id, key, some_chunk(key)); });
  CHECK(told == (bad ? Transcript{"error", "0", "complete 0"} : Transcript{"0", "complete 0"}));
}

TEST_CASE("a chunk of the View that the server gave up is asked for once") {
  const bool comes = GENERATE(true, false);
  const Transcript told = visit_all(
      1,
      [](std::uint32_t number, int x) {
        return std::vector{lost_chunk_frame(number, x), complete_frame(number)};
      },
      [&](std::uint32_t id, const ChunkKey& key) {
        return comes ? chunk_frame(id, key, some_chunk(key))
                     : error_frame(wire::ErrorCode::internal, "no", id);
      });
  CHECK(told == (comes ? Transcript{"0", "complete 0"} : Transcript{"error", "complete 0"}));
}

}  // namespace talus::client
