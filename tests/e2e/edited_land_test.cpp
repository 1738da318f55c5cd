// What players build as those see it who have no session: by HTTP, and by talus-gen once the server is gone.
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <talus/voxel/codec.h>

#include "http_client.h"
#include "messages.h"
#include "player.h"
#include "raw_client.h"
#include "scratch_directory.h"
#include "seed_of_run.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

namespace {

Settings editable(const std::filesystem::path& data) {
  return {kClassicWorld, {"TALUS_DATA", data.string()}, {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"}};
}

std::uint64_t number_at(std::string_view body, std::size_t at, std::size_t bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(body.at(at + i))} << (8 * i);
  }
  return value;
}

/// The paths of a server's world with the edits of its store.
struct Land {
  HttpClient http;
  std::string base;   // "/v1/FINGERPRINT"
  std::string store;  // "/v1/FINGERPRINT/STORE"

  explicit Land(std::uint16_t port) : http{port} {
    const auto world = nlohmann::json::parse(http.get("/v1/world").body);
    base = "/v1/" + world["fingerprint"].get<std::string>();
    store = base + "/" + world["store_id"].get<std::string>();
  }
  /// Revisions of the edited columns of the key's region, by place.
  std::map<std::uint64_t, std::uint64_t> edited(ChunkKey key) {
    const Answer answer = http.get(store + "/edits/" + std::to_string(key.lod.value()) + "/" +
                                   std::to_string(key.coord.x >> 5) + "/" + std::to_string(key.coord.z >> 5));
    REQUIRE(answer.status == 200);
    std::map<std::uint64_t, std::uint64_t> columns;
    for (std::size_t at = 4; at < answer.body.size(); at += 10) {
      columns[number_at(answer.body, at, 2)] = number_at(answer.body, at + 2, 8);
    }
    CHECK(columns.size() == number_at(answer.body, 2, 2));
    return columns;
  }
  std::uint64_t revision(ChunkKey key) {
    const auto columns = edited(key);
    const auto found = columns.find(static_cast<std::uint64_t>((key.coord.z & 31) * 32 + (key.coord.x & 31)));
    return found == columns.end() ? 0 : found->second;
  }
  std::string column_path(ChunkKey key, std::uint64_t revision) const {
    return store + "/4/" + std::to_string(key.lod.value()) + "/" + std::to_string(key.coord.x) + "/" +
           std::to_string(key.coord.z) + "@" + std::to_string(revision);
  }
};

/// The chunk of that row in a column's body.
Chunk chunk_in(std::string_view column, std::int32_t row) {
  std::size_t at = 4;
  for (std::uint64_t runs = number_at(column, 2, 2); runs > 0; --runs) {
    const auto first = static_cast<std::int32_t>(number_at(column, at, 4));
    const auto count = static_cast<std::int64_t>(number_at(column, at + 4, 4));
    const auto bytes = static_cast<std::size_t>(number_at(column, at + 8, 4));
    if (row >= first && row < first + count) {
      const auto chunk = decode(std::as_bytes(std::span{column.substr(at + 12, bytes)}));
      REQUIRE(chunk);
      return *chunk;
    }
    at += 12 + bytes;
  }
  FAIL("a column without row " << row);
  return Chunk::uniform(kAir);
}

MaterialId solid(const client::WorldInfo& world) {
  for (const client::Material& material : world.materials) {
    if (material.phase == client::Phase::solid) return material.id;
  }
  FAIL("no solid material");
  return kAir;
}

}  // namespace

TEST_CASE("a build comes by HTTP under its revision, at every level, and the base stays") {
  const ScratchDirectory scratch;
  ServerProcess server{editable(scratch / "data"), kWithHttp};
  Player player;
  const auto world = player.connect(server.port());
  REQUIRE(world);
  Land land{server.http_port()};
  const VoxelPos at{world->spawn.x & ~63, (world->spawn.y + 64) & ~63, world->spawn.z & ~63};
  const ChunkKey key = *chunk_holding(at, Lod{});
  const std::string base_path =
      land.base + "/4/0/" + std::to_string(key.coord.x) + "/" + std::to_string(key.coord.z);
  const std::string before = land.http.get(base_path).body;
  CHECK(land.edited(key).empty());
  CHECK(land.http.get(land.column_path(key, 0)).body == before);

  client::Edit block;
  block.fills.push_back({at, {at.x + 15, at.y + 15, at.z + 15}, solid(*world), std::nullopt});
  const auto done = player.edit(std::move(block));
  REQUIRE(done);
  // As soon as it is answered.
  CHECK(land.edited(key) ==
        std::map<std::uint64_t, std::uint64_t>{
            {static_cast<std::uint64_t>((key.coord.z & 31) * 32 + (key.coord.x & 31)), done->revision}});
  CHECK(nlohmann::json::parse(land.http.get("/v1/world").body)["edits"] ==
        nlohmann::json{{"taken", true}, {"revision", std::to_string(done->revision)}});
  const Answer column = land.http.get(land.column_path(key, done->revision));
  REQUIRE(column.status == 200);
  CHECK(column.field("Cache-Control") == "public, max-age=31536000, immutable");
  const Chunk chunk = chunk_in(column.body, key.coord.y);
  CHECK(chunk.at(local_pos(at)) == solid(*world));
  CHECK(chunk.at(local_pos({at.x + 16, at.y, at.z})) == kAir);
  CHECK(land.http.get(base_path).body == before);
  // A chunk of it by itself; a square.
  const std::string chunk_path = land.store + "/4/0/" + std::to_string(key.coord.x) + "/" +
                                 std::to_string(key.coord.y) + "/" + std::to_string(key.coord.z) + "@" +
                                 std::to_string(done->revision);
  const Answer alone = land.http.get(chunk_path);
  REQUIRE(alone.status == 200);
  CHECK(*decode(std::as_bytes(std::span{alone.body})) == chunk);
  const std::string square_path = land.store + "/4/0/" + std::to_string(key.coord.x & ~3) + "/" +
                                  std::to_string(key.coord.z & ~3) + "/4x4@" + std::to_string(done->revision);
  CHECK(land.http.get(square_path).body.find(column.body) != std::string::npos);
  // At coarse levels; rule 1 has samples of levels 1 to 3 in the block.
  for (const int level : {1, 2, 3}) {
    const Lod lod = Lod::of(level);
    const VoxelPos coarse{at.x >> level, at.y >> level, at.z >> level};
    const ChunkKey far = *chunk_holding(coarse, lod);
    CHECK(land.revision(far) == done->revision);
    const Answer there = land.http.get(land.column_path(far, done->revision));
    REQUIRE(there.status == 200);
    CHECK(chunk_in(there.body, far.coord.y).at(local_pos(coarse)) == solid(*world));
  }
  // The next edit moves it on.
  const auto next = player.put({at.x + 20, at.y, at.z}, solid(*world));
  REQUIRE(next);
  const Answer moved = land.http.get(land.column_path(key, done->revision));
  CHECK(moved.status == 307);
  CHECK(moved.field("Location") == std::to_string(key.coord.z) + "@" + std::to_string(next->revision));
  CHECK(chunk_in(land.http.get(land.column_path(key, next->revision)).body, key.coord.y)
            .at(local_pos({at.x + 20, at.y, at.z})) == solid(*world));
}

TEST_CASE("while edits come, every body under a revision is always the same") {
  const ScratchDirectory scratch;
  ServerProcess server{editable(scratch / "data"), kWithHttp};
  Player player;
  const auto world = player.connect(server.port());
  REQUIRE(world);
  Land land{server.http_port()};
  const VoxelPos at{world->spawn.x & ~31, (world->spawn.y + 64) & ~31, world->spawn.z & ~31};
  const ChunkKey key = *chunk_holding(at, Lod{});
  const MaterialId stone = solid(*world);
  // Each edit writes one voxel more into two chunks of the column: a body of revision r has r in each, or is
  // torn.
  constexpr std::uint64_t kEdits = 300;
  constexpr std::uint64_t kAtOnce = 100;  // then the land rests, until its body at that revision was seen
  std::uint64_t answered = 0;
  std::uint64_t sent = 0;
  const auto send_some = [&] {
    for (const std::uint64_t until = sent + kAtOnce; sent < until; ++sent) {
      const auto i = static_cast<std::int32_t>(sent);
      client::Edit edit;
      for (const int up : {0, 32}) edit.writes.push_back({{at.x + i % 32, at.y + up, at.z + i / 32}, stone});
      player.client.edit(std::move(edit), [&](const client::Result<client::EditDone>& result) {
        REQUIRE(result);
        ++answered;
      });
    }
  };
  std::map<std::uint64_t, std::string> seen;
  while (answered < kEdits || !seen.contains(kEdits)) {
    if (sent == 0 || (sent < kEdits && answered == sent && seen.contains(sent))) send_some();
    player.io.run_one_for(std::chrono::milliseconds{1});
    player.io.poll();
    if (player.io.stopped()) player.io.restart();
    const std::uint64_t revision = land.revision(key);
    if (revision == 0) continue;
    const Answer column = land.http.get(land.column_path(key, revision));
    if (column.status == 307) continue;
    REQUIRE(column.status == 200);
    const std::string told = column.field("Talus-Revision");
    if (told.empty()) {
      CHECK(column.field("Cache-Control") == "public, max-age=31536000, immutable");
      const auto [known, is_new] = seen.emplace(revision, column.body);
      CHECK(known->second == column.body);
      if (!is_new) continue;
    } else {
      CHECK(column.field("Cache-Control") == "no-store");
      CHECK(std::stoull(told) >= revision);
    }
    for (const int up : {0, 1}) {
      const Chunk chunk = chunk_in(column.body, key.coord.y + up);
      std::uint64_t stones = 0;
      for (int x = 0; x < 32; ++x) {
        for (int z = 0; z < 32; ++z) stones += chunk.at(local_pos({at.x + x, at.y, at.z + z})) == stone;
      }
      if (told.empty()) CHECK(stones == revision);
      if (!told.empty()) CHECK(stones >= std::stoull(told));  // it has all edits up to that, and perhaps more
    }
  }
}

TEST_CASE("talus-gen exports the land as players left it, once the server is gone") {
  const ScratchDirectory scratch;
  constexpr int kRadius = 1;  // chunks around the middle
  std::map<ChunkKey, Chunk> view;
  ChunkKey middle;
  VoxelPos at;
  const std::string store = (scratch / "data").string();
  std::vector<std::string> exporting;
  {
    const ServerProcess server{editable(scratch / "data")};
    Player player;
    const auto world = player.connect(server.port());
    REQUIRE(world);
    at = world->spawn;
    middle = *chunk_holding(at, Lod{});
    const std::uint64_t seed = seed_of_run();
    CAPTURE(seed);
    std::mt19937_64 random{seed};
    for (int i = 0; i < 120; ++i) {
      const auto some = [&](std::int64_t around, std::int64_t reach) {
        return around - reach + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * reach));
      };
      const VoxelPos low{some(at.x, 50), some(at.y, 40), some(at.z, 50)};
      client::Edit edit;
      edit.fills.push_back(
          {low,
           {low.x + static_cast<std::int64_t>(random() % 9), low.y + static_cast<std::int64_t>(random() % 9),
            low.z + static_cast<std::int64_t>(random() % 9)},
           random() % 2 == 0 ? kAir : world->materials[random() % world->materials.size()].id,
           std::nullopt});
      REQUIRE(player.edit(std::move(edit)));
    }
    client::View all;
    all.centre = at;
    all.horizontal_radius = kRadius;
    all.vertical_radius = 4;
    const std::size_t before = player.completed;
    REQUIRE(player.client.set_view(all));
    player.until([&] { return player.completed > before; });
    for (std::int32_t x = -kRadius; x <= kRadius; ++x) {
      for (std::int32_t z = -kRadius; z <= kRadius; ++z) {
        for (std::int32_t y = -4; y <= 4; ++y) {
          const ChunkKey key{{middle.coord.x + x, middle.coord.y + y, middle.coord.z + z}, Lod{}};
          view.emplace(key, *player.store.find(key));
        }
      }
    }
    const VoxelPos origin = chunk_origin({middle.coord.x - kRadius, 0, middle.coord.z - kRadius});
    exporting = {"export",
                 "--world",
                 kClassicWorld.second,
                 "--origin",
                 std::to_string(origin.x) + "," + std::to_string(origin.z),
                 "--size",
                 "96,96",
                 "--store",
                 store,
                 "-o",
                 (scratch / "export").string()};
    const ProgramResult refused = run_program(TALUS_GEN_PATH, exporting);
    CHECK(refused.status == 1);
    CHECK_THAT(refused.err, Catch::Contains("talusd store backup"));
    const std::string backup = (scratch / "backup").string();
    REQUIRE(run_program(TALUSD_PATH, {"store", "backup", backup, "--data", store}).status == 0);
    std::vector<std::string> from_backup = exporting;
    std::replace(from_backup.begin(), from_backup.end(), store, backup);
    from_backup.back() = (scratch / "export-of-backup").string();
    REQUIRE(run_program(TALUS_GEN_PATH, from_backup).status == 0);
  }
  const ProgramResult exported = run_program(TALUS_GEN_PATH, exporting);
  INFO(exported.err);
  REQUIRE(exported.status == 0);
  const auto json = nlohmann::json::parse(read_whole(scratch / "export" / "export.json"));
  const std::int64_t y0 = json["y0"];
  const std::string bytes = read_whole(scratch / "export" / "voxels.npy");
  CHECK(read_whole(scratch / "export-of-backup" / "voxels.npy") == bytes);
  const auto rows = json["arrays"]["voxels.npy"]["shape"][0].get<std::int64_t>();
  REQUIRE(json["arrays"]["voxels.npy"]["dtype"] == "uint8");
  const std::size_t head = bytes.size() - static_cast<std::size_t>(rows) * 96 * 96;
  std::size_t wrong = 0;
  for (const auto& [key, chunk] : view) {
    const VoxelPos origin = chunk_origin(key.coord);
    for (std::int64_t y = std::max(origin.y, y0); y < origin.y + 32; ++y) {
      for (std::int64_t z = 0; z < 32; ++z) {
        for (std::int64_t x = 0; x < 32; ++x) {
          const std::int64_t column_x = origin.x + x - chunk_origin(middle.coord).x + 32;
          const std::int64_t column_z = origin.z + z - chunk_origin(middle.coord).z + 32;
          const std::size_t index =
              head + static_cast<std::size_t>(((y - y0) * 96 + column_z) * 96 + column_x);
          const unsigned expected = to_integer(chunk.at(local_pos({x, y, z})));
          wrong += (y - y0 < rows ? static_cast<unsigned char>(bytes[index]) : 0U) != expected;
        }
      }
    }
  }
  CHECK(wrong == 0);
  // The same picture twice, as nothing in the store has changed; another than without the edits.
  std::map<std::string, std::string> pictures;
  for (const std::string name : {"one", "two", "plain"}) {
    std::vector<std::string> drawing{"map",
                                     "--world",
                                     kClassicWorld.second,
                                     "--center",
                                     std::to_string(at.x) + "," + std::to_string(at.z),
                                     "--size",
                                     "96,96",
                                     "-o",
                                     (scratch / name).string()};
    if (name != "plain") drawing.insert(drawing.end(), {"--store", store});
    REQUIRE(run_program(TALUS_GEN_PATH, drawing).status == 0);
    pictures[name] = read_whole(scratch / name);
  }
  CHECK(pictures["one"] == pictures["two"]);
  CHECK(pictures["one"] != pictures["plain"]);
}
