// A map of a server that allows few columns a request.
#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include "commands.h"
#include "peer.h"
#include "scratch_directory.h"

namespace talus::cli {
namespace {

using namespace client::testing;

protocol::Frame no_heights(std::uint32_t id, std::size_t columns) {
  return protocol::make_frame([&](auto& b) {
    return wire::CreateHeights(b, id, b.CreateVector(std::vector<std::int32_t>(columns, 0)));
  });
}

}  // namespace

TEST_CASE("a map asks for no more heights at once than the server allows") {
  asio::io_context io;
  Peer peer{io};
  const ScratchDirectory scratch;
  std::vector<std::size_t> requests;
  const auto visit = [&]() -> asio::awaitable<void> {
    ConnectTarget target{{"127.0.0.1", static_cast<std::uint16_t>(std::stoi(peer.port()))}, {}};
    MapOptions options;
    options.center = client::Column{16, 16};
    options.width = options.depth = 2;
    options.output = scratch / "map.png";
    const auto drawn = co_await map(std::move(target), std::move(options));
    CHECK((drawn ? "" : drawn.error()) == std::string{});
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome(1, 1U << 20, 64, 60'000, std::nullopt, {.heights_per_request = 512});
    try {
      while (true) {
        const auto* message = co_await peer.receive();
        if (const auto* heights = message->body_as_GetHeights()) {
          requests.push_back(heights->columns()->size());
          co_await peer.send(no_heights(heights->id(), requests.back()));
        } else if (const auto* get = message->body_as_GetChunks()) {
          std::vector<std::pair<std::uint32_t, ChunkKey>> asked;
          for (const auto* chunk : *get->requests()) {
            asked.emplace_back(chunk->id(), key_at(chunk->key().x(), chunk->key().y(), chunk->key().z()));
          }
          for (const auto& [id, key] : asked) {
            co_await peer.send(chunk_frame(id, key, Chunk::uniform(key.coord.y < 0 ? MaterialId{2} : kAir)));
          }
        }
      }
    } catch (const std::system_error&) {
      // The map is drawn.
    }
  };
  run(io, {visit, serve});
  CHECK(requests == std::vector<std::size_t>{512, 512});
}

}  // namespace talus::cli
