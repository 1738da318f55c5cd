// Own edits seen at once: against a server in a map, with answers and chunks that come late and in any order,
// edits of others, refusals, and chunks that leave and come back.
#include <talus/client/prediction.h>

#include <deque>
#include <map>
#include <random>
#include <set>

#include <asio/post.hpp>
#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include <talus/edits/evaluate.h>

#include "failing_allocations.h"
#include "peer.h"
#include "seed_of_run.h"

namespace talus::client {
namespace {

constexpr MaterialId kStone{1};
constexpr MaterialId kBrick{2};

/// Four chunks around the origin, of air below and stone above: enough for edits to reach over their borders.
const std::vector<ChunkCoord> kChunks{{-1, 0, 0}, {0, 0, 0}, {-1, 0, -1}, {0, 0, -1}};

struct NoOverrides final : edits::OverrideSource {
  [[nodiscard]] const edits::ChunkOverrides* find(ChunkKey) const override { return nullptr; }
};

/// What a server has, and how it decides.
struct Server {
  struct ServerChunk {
    std::shared_ptr<const Chunk> chunk = std::make_shared<const Chunk>(Chunk::uniform(kAir));
    std::uint64_t revision = 0;
  };
  std::map<ChunkCoord, ServerChunk> chunks;
  std::uint64_t revision = 0;

  Server() {
    for (const ChunkCoord chunk : kChunks) chunks[chunk] = {};
  }
  [[nodiscard]] ReceivedChunk sent(ChunkCoord chunk) const {
    const ServerChunk& kept = chunks.at(chunk);
    return {{chunk, Lod{}}, kept.revision, content_hash(*kept.chunk), kept.chunk};
  }
  /// What settling may do: what `from` had slides into all that the edit dug in `into`, which is as before.
  struct Slide {
    ChunkCoord into;
    VoxelPos from;
  };
  Result<EditDone> apply(const Edit& edit, std::set<ChunkCoord>& changed,
                         const std::optional<Slide>& slide = std::nullopt) {
    edits::BaseVoxels base;
    const auto touched = edits::touched_voxels(edit).value();
    for (const auto& [chunk, voxels] : touched) {
      for (const std::uint16_t index : voxels) {
        const LocalPos at{static_cast<std::uint8_t>(index % 32), static_cast<std::uint8_t>(index / 1024),
                          static_cast<std::uint8_t>(index / 32 % 32)};
        base[chunk].push_back({index, chunks[chunk].chunk->at(at)});
      }
    }
    auto outcome = edits::evaluate(edit, base, NoOverrides{}).value();
    if (slide &&
        std::erase_if(outcome.chunks, [&](const auto& each) { return each.chunk == slide->into; }) > 0) {
      const ChunkCoord from = chunk_holding(slide->from, Lod{})->coord;
      const auto index = static_cast<std::uint16_t>(voxel_index(local_pos(slide->from)));
      const MaterialId before = chunks[from].chunk->at(local_pos(slide->from));
      const edits::VoxelChange slid{index, before, before == kAir ? kStone : kAir, before};
      const auto other = std::ranges::find(outcome.chunks, from, &edits::ChunkChanges::chunk);
      if (other == outcome.chunks.end()) {
        outcome.chunks.push_back({from, {slid}});
      } else if (std::ranges::find(other->voxels, index, &edits::VoxelChange::index) == other->voxels.end()) {
        other->voxels.push_back(slid);
        std::ranges::sort(other->voxels, {}, &edits::VoxelChange::index);
      }
    }
    if (outcome.conflict) return tl::unexpected{ClientError{ErrorKind::conflict, "a guard", {}}};
    if (outcome.changed > 0) ++revision;
    for (const edits::ChunkChanges& each : outcome.chunks) {
      std::vector<Override> voxels;
      for (const edits::VoxelChange& voxel : each.voxels) voxels.push_back({voxel.index, voxel.after});
      ServerChunk& kept = chunks[each.chunk];
      kept = {std::make_shared<const Chunk>(kept.chunk->with_overrides(voxels)), revision};
      changed.insert(each.chunk);
    }
    return EditDone{revision, static_cast<std::uint32_t>(outcome.changed)};
  }
};

Edit write_of(VoxelPos at, MaterialId material, std::optional<MaterialId> guard = std::nullopt) {
  Edit edit;
  edit.writes.push_back({at, material});
  if (guard) edit.guards.push_back({at, *guard});
  return edit;
}

/// A player's side.
struct Player {
  ChunkStore store{std::size_t{64} << 20};
  std::vector<ChunkKey> changed;
  Prediction own{store, [this](ChunkKey key) { changed.push_back(key); }};

  explicit Player(const Server& server) {
    for (const ChunkCoord chunk : kChunks) own.put(server.sent(chunk));
    changed.clear();
  }
  [[nodiscard]] MaterialId sees(VoxelPos at) {
    return store.find({chunk_holding(at, Lod{})->coord, Lod{}})->at(local_pos(at));
  }
};

}  // namespace

TEST_CASE("an edit is seen at once, goes where it is refused, and stays where it happened") {
  Server server;
  Player player{server};
  const Edit edit = write_of({1, 2, 3}, kBrick, kAir);
  const auto first = player.own.begin(edit);
  CHECK(player.sees({1, 2, 3}) == kBrick);
  CHECK(player.changed == std::vector<ChunkKey>{{{0, 0, 0}, Lod{}}});
  player.own.done(first, tl::unexpected{ClientError{ErrorKind::refused, "no", {}}});
  CHECK(player.sees({1, 2, 3}) == kAir);
  CHECK(player.own.open() == 0);
  CHECK(player.store.look({{0, 0, 0}, Lod{}})->hash == server.sent({0, 0, 0}).hash);

  const auto second = player.own.begin(edit);
  std::set<ChunkCoord> changed;
  const auto done = server.apply(edit, changed);
  player.own.done(second, done);  // before its broadcast
  CHECK(player.sees({1, 2, 3}) == kBrick);
  CHECK(player.own.open() == 1);
  player.own.put(server.sent({0, 0, 0}));
  CHECK(player.own.open() == 0);
  CHECK(player.sees({1, 2, 3}) == kBrick);
}

TEST_CASE("if another's edit came first, the guards decide here as they do there") {
  Server server;
  Player player{server};
  const Edit edit = write_of({1, 2, 3}, kBrick, kAir);
  const auto id = player.own.begin(edit);
  std::set<ChunkCoord> changed;
  REQUIRE(server.apply(write_of({1, 2, 3}, kStone), changed));
  player.own.put(server.sent({0, 0, 0}));
  CHECK(player.sees({1, 2, 3}) == kStone);
  player.own.done(id, server.apply(edit, changed));
  CHECK(player.sees({1, 2, 3}) == kStone);
  CHECK(player.own.open() == 0);
}

TEST_CASE("another's edit of other voxels is seen together with one's own that is not answered") {
  Server server;
  Player player{server};
  (void)player.own.begin(write_of({1, 2, 3}, kBrick));
  std::set<ChunkCoord> changed;
  REQUIRE(server.apply(write_of({9, 2, 3}, kStone), changed));
  player.own.put(server.sent({0, 0, 0}));
  CHECK(player.sees({1, 2, 3}) == kBrick);
  CHECK(player.sees({9, 2, 3}) == kStone);
}

TEST_CASE("an edit that changed less than was seen here does not leave a trace") {
  Server server;
  std::set<ChunkCoord> changed;
  REQUIRE(server.apply(write_of({-1, 2, 3}, kStone), changed));
  REQUIRE(server.apply(write_of({1, 2, 3}, kStone), changed));
  Player player{server};
  Edit edit;
  edit.fills.push_back({{-4, 2, 3}, {4, 2, 3}, kBrick, kStone});
  const auto id = player.own.begin(edit);
  CHECK(player.sees({-1, 2, 3}) == kBrick);
  REQUIRE(server.apply(write_of({-1, 2, 3}, kAir), changed));
  player.own.done(id, server.apply(edit, changed));
  player.own.put(server.sent({0, 0, 0}));
  CHECK(player.sees({1, 2, 3}) == kBrick);
  player.own.put(server.sent({-1, 0, 0}));  // of the revision before the edit's
  CHECK(player.sees({-1, 2, 3}) == kAir);
  CHECK(player.own.open() == 0);
}

TEST_CASE("a voxel dug and filled from a neighbour chunk does not stay dug here") {
  Server server;
  std::set<ChunkCoord> changed;
  REQUIRE(server.apply(write_of({0, 2, 3}, kStone), changed));
  REQUIRE(server.apply(write_of({-1, 3, 3}, kStone), changed));
  Player player{server};
  const Edit dig = write_of({0, 2, 3}, kAir);
  const auto id = player.own.begin(dig);
  CHECK(player.sees({0, 2, 3}) == kAir);
  CHECK(player.own.behind(id).empty());  // it is not answered
  const auto done = server.apply(dig, changed, Server::Slide{{0, 0, 0}, {-1, 3, 3}});
  player.own.done(id, done);
  player.own.put(server.sent({-1, 0, 0}));
  REQUIRE(player.own.behind(id) == std::vector<ChunkKey>{{{0, 0, 0}, Lod{}}});
  player.own.put(server.sent({0, 0, 0}));
  CHECK(player.own.open() == 1);  // it may be of before the edit
  player.own.resolve(id, {{0, 0, 0}, Lod{}});
  CHECK(player.sees({0, 2, 3}) == kStone);
  CHECK(player.sees({-1, 3, 3}) == kAir);
  CHECK(player.own.open() == 0);
}

TEST_CASE("a chunk that was away since the answer shows as it comes back, dug and filled again or not") {
  const bool is_away_at_answer = GENERATE(true, false);
  Server server;
  std::set<ChunkCoord> changed;
  REQUIRE(server.apply(write_of({0, 2, 3}, kStone), changed));
  REQUIRE(server.apply(write_of({-1, 3, 3}, kStone), changed));
  Player player{server};
  const ChunkKey dug{{0, 0, 0}, Lod{}};
  Edit two = write_of({0, 2, 3}, kAir);
  two.writes.push_back({{-1, 9, 3}, kBrick});  // keeps the edit open: its chunk has not come
  const auto id = player.own.begin(two);
  const auto done = server.apply(two, changed, Server::Slide{{0, 0, 0}, {-1, 3, 3}});
  if (is_away_at_answer) player.own.erase(dug);
  player.own.done(id, done);
  if (!is_away_at_answer) player.own.erase(dug);
  player.own.put(server.sent({0, 0, 0}));  // of before the edit, which did not change it
  CHECK(player.own.open() == 1);
  CHECK(player.sees({0, 2, 3}) == kStone);
}

TEST_CASE("an answer after the prediction is gone or cleared changes nothing") {
  Server server;
  Player player{server};
  const auto id = player.own.begin(write_of({1, 2, 3}, kBrick));
  player.own.clear();
  CHECK(player.store.size() == 0);
  player.own.done(id, EditDone{1, 1});
  CHECK(player.own.open() == 0);
}

TEST_CASE("a chunk that no open edit touches comes and leaves without a look at the edits") {
  Server server;
  Player player{server};
  Edit fill;
  fill.fills.push_back({{-16, 0, -16}, {15, 31, 15}, kBrick, std::nullopt});  // 8,192 voxels in each chunk
  (void)player.own.begin(fill);
  player.changed.clear();
  const auto chunk = std::make_shared<const Chunk>(Chunk::uniform(kStone));
  const ChunkKey far{{9, 0, 0}, Lod{}};
  const ChunkKey coarse{{0, 0, 0}, Lod::of(3)};
  {
    const test::FailingAllocations none_that_large{0, 16'384};
    for (const ChunkKey& key : {far, coarse}) player.own.put({key, 0, content_hash(*chunk), chunk});
    for (const ChunkKey& key : {far, coarse}) player.own.erase(key);
    CHECK_FALSE(none_that_large.has_failed());
  }
  CHECK(player.changed == std::vector{far, coarse});
  CHECK_FALSE(player.store.contains(far));
  CHECK(player.own.open() == 1);
}

TEST_CASE("an edit that changed less than was seen leaves no trace where the connection breaks after it") {
  using namespace testing;
  asio::io_context io;
  Peer peer{io};
  Server server;
  Player player{server};
  Events events;
  bool is_lost = false;
  events.on_disconnect = [&](const ClientError&, bool) { is_lost = true; };
  Client client{io.get_executor(), Options{}, events};
  const auto visit = [&]() -> asio::awaitable<void> {
    co_await join(client, peer);
    player.own.edit(client, write_of({1, 2, 3}, kBrick), [&](const Result<EditDone>& done) {
      CHECK(done.has_value());
      CHECK(player.sees({1, 2, 3}) == kBrick);
    });
    while (!is_lost) co_await asio::post(io, asio::use_awaitable);
  };
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    const auto* attach = co_await peer.receive();
    CHECK(attach->body_type() == wire::Body::Attach);
    co_await peer.send(protocol::make_frame([](auto& b) {
      const wire::Hash128 editor{5, 5};
      return wire::CreateAttached(b, &editor, 1, 0, false, 0, wire::CreateEditLimits(b, 65'536, 64, 8));
    }));
    const auto id = (co_await peer.receive())->body_as_Edit()->id();
    co_await peer.send(protocol::make_frame([&](auto& b) { return wire::CreateEditResult(b, id, 1, 1); }));
    const auto* ping = co_await peer.receive();  // in front of asking for the chunk
    CHECK(ping->body_type() == wire::Body::Ping);
    peer.hang_up();
  };
  run(io, {visit, serve});
  CHECK(player.own.open() == 0);
  CHECK(player.sees({1, 2, 3}) == kAir);
}

// The server gets edits in order and answers when it likes; updates of each chunk come in order, and merged.
TEST_CASE("when all is answered and sent, the store holds what the server holds") {
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  std::mt19937_64 random{seed};
  const auto below = [&](std::uint64_t end) { return random() % end; };
  const auto some_voxel = [&] {
    const auto near = [&] { return static_cast<std::int64_t>(below(6)) - 3; };
    return VoxelPos{near(), static_cast<std::int64_t>(below(3)), near()};
  };
  const auto some_material = [&] { return MaterialId{static_cast<std::uint16_t>(below(3))}; };
  const auto some_edit = [&] {
    Edit edit;
    for (std::uint64_t left = below(3); left > 0; --left)
      edit.guards.push_back({some_voxel(), some_material()});
    for (std::uint64_t left = below(3); left > 0; --left)
      edit.writes.push_back({some_voxel(), some_material()});
    if (edit.writes.empty() || below(3) == 0) {
      VoxelPos first = some_voxel();
      VoxelPos last = some_voxel();
      for (const auto axis : {&VoxelPos::x, &VoxelPos::y, &VoxelPos::z}) {
        if (first.*axis > last.*axis) std::swap(first.*axis, last.*axis);
      }
      edit.fills.push_back({first, last, some_material(), std::nullopt});
      if (below(2) == 0) edit.fills.back().only = some_material();
    }
    return edit;
  };
  const int rounds = 200;
  for (int round = 0; round < rounds; ++round) {
    Server server;
    Player player{server};
    struct SentEdit {
      Prediction::Id id;
      Edit edit;
    };
    std::deque<SentEdit> to_server;
    std::vector<std::pair<Prediction::Id, Result<EditDone>>> answers;
    std::set<ChunkCoord> updates;  // chunks of which the player has not the newest
    std::set<ChunkCoord> away;     // from the View
    std::vector<std::pair<Prediction::Id, ChunkKey>> asked;
    const auto get = [&] {
      const auto at = asked.begin() + static_cast<std::ptrdiff_t>(below(asked.size()));
      const auto [id, key] = *at;
      asked.erase(at);
      if (!away.contains(key.coord)) player.own.put(server.sent(key.coord));
      player.own.resolve(id, key);
    };
    const auto update = [&](ChunkCoord chunk) {
      updates.erase(chunk);
      if (!away.contains(chunk)) player.own.put(server.sent(chunk));
    };
    const auto server_step = [&] {
      const SentEdit sent = std::move(to_server.front());
      to_server.pop_front();
      if (below(8) == 0) {
        answers.emplace_back(sent.id, tl::unexpected{ClientError{ErrorKind::refused, "no", {}}});
      } else {
        std::optional<Server::Slide> slide;
        if (below(4) == 0) slide = {kChunks[below(kChunks.size())], some_voxel()};
        if (slide && chunk_holding(slide->from, Lod{})->coord == slide->into) slide.reset();
        answers.emplace_back(sent.id, server.apply(sent.edit, updates, slide));
      }
    };
    const auto answer = [&] {
      const auto at = answers.begin() + static_cast<std::ptrdiff_t>(below(answers.size()));
      player.own.done(at->first, at->second);
      for (const ChunkKey& key : player.own.behind(at->first)) asked.emplace_back(at->first, key);
      answers.erase(at);
    };
    for (int step = 0; step < 60; ++step) {
      switch (below(7)) {
        case 0:
        case 1: {
          SentEdit sent{{}, some_edit()};
          sent.id = player.own.begin(sent.edit);
          to_server.push_back(std::move(sent));
          break;
        }
        case 2:
          (void)server.apply(some_edit(), updates);  // another's
          break;
        case 3:
          if (!to_server.empty()) server_step();
          break;
        case 4:
          if (!asked.empty() && below(2) == 0) get();
          if (!answers.empty()) answer();
          break;
        case 5:
          if (!updates.empty())
            update(*std::next(updates.begin(), static_cast<std::ptrdiff_t>(below(updates.size()))));
          break;
        default: {
          const ChunkCoord chunk = kChunks[below(kChunks.size())];
          if (below(4) != 0) break;
          if (away.erase(chunk) > 0) {
            update(chunk);
          } else {
            away.insert(chunk);
            player.own.erase({chunk, Lod{}});
          }
        }
      }
    }
    while (!to_server.empty()) server_step();
    while (!answers.empty() || !updates.empty() || !asked.empty()) {
      if (!asked.empty() && below(2) == 0) {
        get();
      } else if (updates.empty() && answers.empty()) {
        continue;
      } else if (!answers.empty() && (updates.empty() || below(2) == 0)) {
        answer();
      } else {
        update(*updates.begin());
      }
    }
    for (const ChunkCoord chunk : kChunks) {
      INFO("round " << round << ", chunk " << to_string(ChunkKey{chunk, Lod{}}));
      const ReceivedChunk* const held = player.store.look({chunk, Lod{}});
      REQUIRE((held == nullptr) == away.contains(chunk));
      if (held == nullptr) continue;
      REQUIRE(held->hash == server.sent(chunk).hash);
      REQUIRE(held->revision == server.sent(chunk).revision);
      REQUIRE(*held->chunk == *server.chunks.at(chunk).chunk);
    }
    REQUIRE(player.own.open() == 0);
  }
}

}  // namespace talus::client
