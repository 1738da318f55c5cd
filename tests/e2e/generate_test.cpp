// A published world: a client that makes its chunks has the same voxels as one that receives them, and a real
// talusd sends it only edits.
#include <memory>
#include <utility>

#include <catch2/catch.hpp>

#include <talus/local_source/local_source.h>

#include "player.h"
#include "scratch_directory.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;
using namespace std::chrono_literals;

namespace {

Settings published(const std::filesystem::path& data) {
  return {kClassicWorld,
          {"TALUS_PUBLISH", "public"},
          {"TALUS_DATA", data.string()},
          {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"}};
}

client::Options making(std::shared_ptr<client::ChunkMaker> maker = std::make_shared<LocalSource>()) {
  client::Options options;
  options.generate = client::Generate::automatic;
  options.maker = std::move(maker);
  options.reconnect.first_delay = 20ms;
  options.reconnect.max_delay = 200ms;
  options.reconnect.max_attempts = 1'000;
  return options;
}

const std::vector<client::LodRing> kRings{{Lod::of(1), 6}, {Lod::of(2), 12}};

/// Both hold the same chunks.
void check_same(const Player& one, const Player& other) {
  CHECK(one.store.size() == other.store.size());
  std::size_t differing = 0;
  one.store.for_each([&](const client::ReceivedChunk& chunk) {
    const auto* same = other.store.look(chunk.key);
    differing += same == nullptr || same->hash != chunk.hash || same->revision != chunk.revision;
  });
  CHECK(differing == 0);
}

/// A block in the air, and a hole below it.
void build(Player& player, VoxelPos at, MaterialId material) {
  client::Edit edit;
  edit.fills.push_back({at, {at.x + 9, at.y + 9, at.z + 9}, material, std::nullopt});
  edit.fills.push_back({{at.x, at.y - 60, at.z}, {at.x + 5, at.y - 31, at.z + 5}, kAir, std::nullopt});
  REQUIRE(player.edit(std::move(edit)).has_value());
}

/// Another world than the server's, with its fingerprint: the same, one chunk farther east.
class Shifted final : public client::ChunkMaker {
 public:
  void open(std::shared_ptr<const client::WorldFiles> files, std::shared_ptr<const std::atomic<bool>> cancel,
            Opened done) override {
    source_.open(std::move(files), std::move(cancel), [done = std::move(done)](auto world) {
      done(std::move(world).map([](std::shared_ptr<client::LocalWorld> right) {
        return std::static_pointer_cast<client::LocalWorld>(std::make_shared<World>(std::move(right)));
      }));
    });
  }

 private:
  class World final : public client::LocalWorld {
   public:
    explicit World(std::shared_ptr<client::LocalWorld> right) : right_{std::move(right)} {}
    [[nodiscard]] ContentHash fingerprint() const override { return right_->fingerprint(); }
    void make(std::vector<ChunkKey> keys, std::shared_ptr<const std::atomic<bool>> cancel,
              Made done) override {
      for (ChunkKey& key : keys) ++key.coord.x;
      right_->make(std::move(keys), std::move(cancel), [done = std::move(done)](auto made) {
        if (made) {
          for (client::MadeChunk& chunk : *made) --chunk.key.coord.x;
        }
        done(std::move(made));
      });
    }

   private:
    std::shared_ptr<client::LocalWorld> right_;
  };
  LocalSource source_;
};

}  // namespace

TEST_CASE("chunks made by the client are those that the server sends, also where they are edited") {
  const ScratchDirectory scratch;
  const bool websocket = GENERATE(false, true);
  std::vector<std::string> flags;
  if (websocket) flags = {"--http", "127.0.0.1:0"};
  ServerProcess server{published(scratch / "data"), flags};
  Player receiver;
  client::Options options = making();
  options.websocket.on = websocket;
  Player maker{options};
  const auto world = receiver.connect(server.port());
  REQUIRE(world.has_value());
  CHECK(world->limits.view_base);
  const VoxelPos at{world->spawn.x, world->spawn.y + 40, world->spawn.z};
  const MaterialId material = world->materials.back().id;
  build(receiver, at, material);

  REQUIRE(maker.connect(websocket ? server.http_port() : server.port()).has_value());
  maker.until([&] { return maker.client.generates(); });
  maker.move_view(at, 2, kRings);
  receiver.move_view(at, 2, kRings);
  check_same(maker, receiver);
  CHECK(maker.sees(at) == material);

  // Edits of what was made, and of what is new in the next View.
  const VoxelPos next{at.x + 150, at.y, at.z};
  build(receiver, next, material);
  build(receiver, {at.x + 20, at.y, at.z}, material);
  maker.until([&] { return maker.sees({at.x + 20, at.y, at.z}) == material; });
  receiver.until([&] { return receiver.sees({at.x + 20, at.y, at.z}) == material; });
  maker.move_view(next, 2, kRings);
  receiver.move_view(next, 2, kRings);
  maker.until([&] { return maker.client.stats().proofs >= client::kFirstProofs; });
  check_same(maker, receiver);
  CHECK(maker.sees(next) == material);
  CHECK(maker.errors.empty());
  CHECK(maker.client.stats().failed_proofs == 0);
  CHECK(maker.client.stats().uniform_chunks == 0);
  CHECK(maker.client.stats().made_chunks > maker.store.size() / 2);
  CHECK(maker.client.stats().received_bytes < receiver.client.stats().received_bytes / 2);
}

TEST_CASE("a world that differs is found by sixteen chunks, and the server's takes its place") {
  const ScratchDirectory scratch;
  const ServerProcess server{published(scratch / "data")};
  Player receiver;
  Player maker{making(std::make_shared<Shifted>())};
  const auto world = receiver.connect(server.port());
  REQUIRE(world.has_value());
  REQUIRE(maker.connect(server.port()).has_value());
  maker.until([&] { return maker.client.generates(); });
  receiver.move_view(world->spawn, 4);
  maker.move_view(world->spawn, 4);
  maker.until([&] { return !maker.errors.empty(); });
  CHECK_FALSE(maker.client.generates());
  maker.until([&] { return maker.completed >= 1; });
  const auto same = [&] {
    bool all = maker.store.size() == receiver.store.size();
    receiver.store.for_each([&](const client::ReceivedChunk& chunk) {
      const auto* made = maker.store.look(chunk.key);
      all = all && made != nullptr && made->hash == chunk.hash;
    });
    return all;
  };
  maker.until(same);
  CHECK(maker.errors.size() == 1);
  CHECK(maker.errors[0].kind == client::ErrorKind::cannot_generate);
  CHECK(maker.client.stats().proofs <= client::kFirstProofs);
  CHECK(maker.client.stats().failed_proofs >= 1);
}

TEST_CASE("a client that makes chunks returns to a server that was started again") {
  const ScratchDirectory scratch;
  Player maker{making()};
  VoxelPos at;
  Settings settings = published(scratch / "data");
  {
    ServerProcess server{settings};
    settings["TALUS_LISTEN"] = "127.0.0.1:" + std::to_string(server.port());
    const auto world = maker.connect(server.port());
    REQUIRE(world.has_value());
    at = {world->spawn.x, world->spawn.y + 40, world->spawn.z};
    maker.until([&] { return maker.client.generates(); });
    maker.move_view(at, 2, kRings);
    build(maker, at, world->materials.back().id);
    maker.until([&] { return maker.sees(at) == world->materials.back().id; });
  }
  const std::uint64_t made = maker.client.stats().made_chunks;
  const std::uint64_t files = maker.client.stats().file_bytes;
  const ServerProcess again{settings};
  const std::size_t completed = maker.completed;
  maker.until([&] { return maker.completed > completed; });
  CHECK(maker.reconnects == 1);
  CHECK(maker.client.generates());
  CHECK(maker.client.stats().made_chunks == made);
  CHECK(maker.client.stats().file_bytes == files);
  Player receiver;
  REQUIRE(receiver.connect(again.port()).has_value());
  receiver.move_view(at, 2, kRings);
  check_same(maker, receiver);
  maker.move_view({at.x + 300, at.y, at.z}, 2, kRings);
  receiver.move_view({at.x + 300, at.y, at.z}, 2, kRings);
  check_same(maker, receiver);
  CHECK(maker.errors.empty());
}
