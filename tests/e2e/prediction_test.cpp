// Own edits seen at once, with a real talusd behind: before it answers, after it refuses, and when another
// was first.
#include <algorithm>
#include <cstdlib>
#include <random>
#include <string_view>

#include <catch2/catch.hpp>

#include <talus/client/prediction.h>

#include "player.h"
#include "scratch_directory.h"
#include "seed_of_run.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

namespace {

constexpr std::size_t kMaxUnansweredEdits = 256;

/// A player whose store shows own edits at once.
struct Builder {
  asio::io_context io;
  client::ChunkStore store{std::size_t{64} << 20};
  client::Prediction own{store, {}};
  bool complete = false;
  std::size_t unanswered = 0;
  client::Client client{io.get_executor(), {}, events()};

  client::Events events() {
    client::Events events;
    events.on_chunk = [this](const client::ReceivedChunk& chunk) { own.put(chunk); };
    events.on_left_view = [this](ChunkKey key) { own.erase(key); };
    events.on_view_complete = [this](const client::View&) { complete = true; };
    return events;
  }
  void until(const std::function<bool()>& done) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes{2};
    while (!done()) {
      if (std::chrono::steady_clock::now() > give_up) FAIL("what a builder waits for did not come");
      io.run_one_for(std::chrono::milliseconds{100});
      if (io.stopped()) io.restart();
    }
  }
  client::WorldInfo join(std::uint16_t port) {
    std::optional<client::Result<client::WorldInfo>> world;
    client.connect("127.0.0.1", std::to_string(port), [&](auto result) { world = std::move(result); });
    until([&] { return world.has_value(); });
    REQUIRE(world->has_value());
    return **world;
  }
  void move_view(VoxelPos at) {
    client::View view;
    view.centre = at;
    view.horizontal_radius = view.vertical_radius = 1;
    REQUIRE(client.set_view(view).has_value());
    until([&] { return complete; });
  }
  void edit(const client::Edit& edit, std::function<void(client::Result<client::EditDone>)> handler = {}) {
    ++unanswered;
    own.edit(client, edit, [this, handler = std::move(handler)](client::Result<client::EditDone> result) {
      --unanswered;
      if (handler) handler(std::move(result));
    });
  }
  [[nodiscard]] MaterialId sees(VoxelPos at) {
    return store.find(*chunk_holding(at, Lod{}))->at(local_pos(at));
  }
};

client::Edit write_of(VoxelPos at, MaterialId material, std::optional<MaterialId> guard = std::nullopt) {
  client::Edit edit;
  edit.writes.push_back({at, material});
  if (guard) edit.guards.push_back({at, *guard});
  return edit;
}

const MaterialId kStone{2};
constexpr std::string_view kLoose = "gravel";  // of the classic world

}  // namespace

TEST_CASE(
    "a client's own edit is visible before the server answers, and disappears if the server refuses it") {
  const ScratchDirectory scratch;
  const ServerProcess server{{kClassicWorld,
                              {"TALUS_DATA", (scratch / "data").string()},
                              {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"}}};
  Builder one;
  Builder two;
  const auto world = one.join(server.port());
  (void)two.join(server.port());
  const VoxelPos at{world.spawn.x, world.spawn.y + 40, world.spawn.z};
  one.move_view(at);
  two.move_view(at);
  one.edit(write_of(at, kStone, kAir));
  CHECK(one.sees(at) == kStone);
  one.until([&] { return one.own.open() == 0; });
  CHECK(one.sees(at) == kStone);

  // The second has not heard of it yet: it sees its own until the server says that it was too late.
  const MaterialId own{3};
  if (two.sees(at) == kAir) {
    std::optional<client::ErrorKind> why;
    two.edit(write_of(at, own, kAir), [&](const auto& result) { why = result.error().kind; });
    CHECK(two.sees(at) == own);
    two.until([&] { return why.has_value(); });
    CHECK(*why == client::ErrorKind::conflict);
  }
  two.until([&] { return two.sees(at) == kStone; });
  CHECK(two.own.open() == 0);
}

TEST_CASE("loose material that slides over the borders of chunks is predicted as the server settles it") {
  const ScratchDirectory scratch;
  const ServerProcess server{{kClassicWorld,
                              {"TALUS_DATA", (scratch / "data").string()},
                              {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"},
                              {"TALUS_EDITS_SETTLE", "true"}}};
  Builder builder;
  const auto world = builder.join(server.port());
  const auto loose = std::ranges::find(world.materials, kLoose, &client::Material::name);
  REQUIRE(loose != world.materials.end());
  // High up, on a floor of stone: a heap two voxels high in one chunk, walled in but for the next chunk,
  // where it leans on one voxel. What is dug there comes again out of the heap.
  const auto middle = [](std::int64_t of) { return floor_div(of, kChunkSize) * kChunkSize + kChunkSize / 2; };
  const VoxelPos at{middle(world.spawn.x) + kChunkSize / 2, middle(world.spawn.y + 64),
                    middle(world.spawn.z)};
  builder.move_view(at);
  client::Edit build;
  build.fills.push_back({{at.x - 7, at.y - 1, at.z - 7}, {at.x + 7, at.y - 1, at.z + 7}, kStone, {}});
  build.fills.push_back({{at.x - 2, at.y, at.z - 1}, {at.x - 1, at.y, at.z + 1}, kStone, {}});
  build.fills.push_back({{at.x - 1, at.y, at.z}, {at.x - 1, at.y + 1, at.z}, loose->id, {}});
  build.writes.push_back({at, loose->id});
  builder.edit(build);
  builder.until([&] { return builder.unanswered + builder.own.open() == 0; });
  REQUIRE(builder.sees({at.x - 1, at.y + 1, at.z}) == loose->id);
  builder.edit(write_of(at, kAir));
  CHECK(builder.sees(at) == kAir);
  builder.until([&] { return builder.own.open() == 0; });
  CHECK(builder.sees(at) == loose->id);
  Player late;
  REQUIRE(late.connect(server.port()).has_value());
  late.move_view(at);
  builder.until([&] {
    bool same = true;
    late.store.for_each([&](const client::ReceivedChunk& chunk) {
      const client::ReceivedChunk* const held = builder.store.look(chunk.key);
      same = same && held != nullptr && held->hash == chunk.hash;
    });
    return same;
  });
}

TEST_CASE("when two who build over one another are done, both see what the server has") {
  const ScratchDirectory scratch;
  const ServerProcess server{{kClassicWorld,
                              {"TALUS_DATA", (scratch / "data").string()},
                              {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"}}};
  const char* const given = std::getenv("TALUS_STEPS");
  const int steps = given != nullptr ? std::atoi(given) : 300;
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  std::mt19937_64 random{seed};
  Builder one;
  Builder two;
  const auto world = one.join(server.port());
  (void)two.join(server.port());
  const VoxelPos origin{world.spawn.x, world.spawn.y, world.spawn.z};
  one.move_view(origin);
  two.move_view(origin);
  for (int step = 0; step < steps; ++step) {
    Builder& who = random() % 2 == 0 ? one : two;
    const auto near = [&] { return static_cast<std::int64_t>(random() % 8) - 4; };
    const VoxelPos at{origin.x + near(), origin.y + near(), origin.z + near()};
    who.edit(write_of(at, MaterialId{static_cast<std::uint16_t>(random() % 2 == 0 ? 0 : 2)}, who.sees(at)));
    who.io.poll();
    who.io.restart();
    who.until([&] { return who.unanswered < kMaxUnansweredEdits; });
  }
  const auto quiet = [&] { return one.unanswered + two.unanswered + one.own.open() + two.own.open() == 0; };
  while (!quiet()) {
    one.until([&] { return one.unanswered + one.own.open() == 0; });
    two.until([&] { return two.unanswered + two.own.open() == 0; });
  }
  // A third, who comes now, is told by the server alone.
  Player late;
  REQUIRE(late.connect(server.port()).has_value());
  late.move_view(origin);
  const auto same = [&](Builder& builder) {
    bool all = true;
    late.store.for_each([&](const client::ReceivedChunk& chunk) {
      const client::ReceivedChunk* const held = builder.store.look(chunk.key);
      all = all && held != nullptr && held->hash == chunk.hash;
    });
    return all;
  };
  one.until([&] { return same(one); });
  two.until([&] { return same(two); });
}
