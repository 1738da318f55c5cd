// A player of the client library in the test's own thread, who waits for what it wants.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <asio/io_context.hpp>
#include <catch2/catch.hpp>

#include <talus/client/chunk_store.h>
#include <talus/client/client.h>

namespace talus::e2e {

struct Player {
  asio::io_context io;
  client::ChunkStore store{std::size_t{256} << 20};
  std::size_t completed = 0;  // Views
  std::size_t reconnects = 0;
  std::vector<client::ClientError> errors;  // that the connection survives
  client::Client client;

  explicit Player(const client::Options& options = {}) : client{io.get_executor(), options, events()} {}

  /// Fails the test where it takes very long.
  void until(const std::function<bool()>& done) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes{2};
    while (!done()) {
      if (std::chrono::steady_clock::now() > give_up) FAIL("what a player waits for did not come");
      io.run_one_for(std::chrono::milliseconds{100});
      if (io.stopped()) io.restart();
    }
  }

  client::Result<client::WorldInfo> connect(std::uint16_t port) {
    std::optional<client::Result<client::WorldInfo>> world;
    client.connect("127.0.0.1", std::to_string(port), [&](auto result) { world = std::move(result); });
    until([&] { return world.has_value(); });
    return *std::move(world);
  }
  client::Result<client::EditDone> edit(client::Edit edit) {
    std::optional<client::Result<client::EditDone>> done;
    client.edit(std::move(edit), [&](auto result) { done = std::move(result); });
    until([&] { return done.has_value(); });
    return *std::move(done);
  }
  /// One voxel.
  client::Result<client::EditDone> put(VoxelPos voxel, MaterialId material) {
    client::Edit one;
    one.writes.push_back({voxel, material});
    return edit(std::move(one));
  }
  void move_view(VoxelPos centre, std::uint16_t radius = 1, std::vector<client::LodRing> rings = {}) {
    client::View view;
    view.centre = centre;
    view.horizontal_radius = radius;
    view.vertical_radius = 1;
    view.rings = std::move(rings);
    const std::size_t before = completed;
    REQUIRE(client.set_view(view).has_value());
    until([&] { return completed > before; });
  }
  /// What the player sees there; none where the chunk has not come.
  [[nodiscard]] std::optional<MaterialId> sees(VoxelPos voxel, Lod lod = {}) {
    const auto key =
        chunk_holding({voxel.x >> lod.value(), voxel.y >> lod.value(), voxel.z >> lod.value()}, lod);
    const auto chunk = store.find(*key);
    if (chunk == nullptr) return std::nullopt;
    return chunk->at(local_pos({voxel.x >> lod.value(), voxel.y >> lod.value(), voxel.z >> lod.value()}));
  }

 private:
  client::Events events() {
    client::Events events;
    events.on_chunk = [this](const client::ReceivedChunk& chunk) { store.put(chunk); };
    events.on_left_view = [this](ChunkKey key) { store.erase(key); };
    events.on_view_complete = [this](const client::View&) { ++completed; };
    events.on_error = [this](const client::ClientError& error) { errors.push_back(error); };
    events.on_reconnect = [this](const client::WorldInfo&) { ++reconnects; };
    return events;
  }
};

}  // namespace talus::e2e
