// What a client that wants to see through rock gets from a real talusd with secret veins: the ore that land
// or edits expose, by every channel, and no other.
#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include <talus/terrain/extraction.h>
#include <talus/terrain/secret.h>
#include <talus/terrain/world.h>
#include <talus/voxel/codec.h>

#include "http_client.h"
#include "player.h"
#include "scratch_directory.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

namespace {

const std::string kKey{"0123456789abcdef\n\0knows the gold!", 32};  // any bytes
const std::filesystem::path kWorldFile{TALUS_SOURCE_DIR "/core/worlds/features.toml"};

terrain::SecretKey key_of(const std::string& bytes) {
  terrain::SecretKey key;
  std::memcpy(key.words.data(), bytes.data(), bytes.size());
  return key;
}

// The world as the server has it, as it would be without ore, and what is hidden in it.
struct Land {
  explicit Land(const std::string& key) {
    const std::string text = read_whole(kWorldFile);
    open = terrain::World::parse(text, "features.toml").value();
    plain = terrain::World::parse(
                std::regex_replace(text, std::regex{"abundance = [0-9.]+"}, "abundance = 0"), "plain")
                .value();
    shown = open->with_secret_veins(key_of(key)).value();
    for (const auto& material : open->materials()) {
      for (const char* const ore : {"coal", "silver", "copper ore", "gold"}) {
        if (material.name == ore) ores.push_back(material.id);
      }
    }
    REQUIRE(ores.size() == 4);
  }
  [[nodiscard]] bool is_ore(MaterialId id) const {
    return std::find(ores.begin(), ores.end(), id) != ores.end();
  }

  const Chunk& chunk(ChunkKey key) {
    const auto [at, made] = chunks.try_emplace(key, Chunk::uniform(kAir));
    if (made) at->second = terrain::generate_chunk(*shown, key);
    return at->second;
  }
  const std::vector<Override>& hidden(ChunkCoord coord) {
    const auto [at, made] = hidden_in.try_emplace(coord);
    if (made) at->second = terrain::hidden_ore(*shown, coord, chunk({coord, Lod{}}));
    return at->second;
  }

  std::optional<terrain::World> open;
  std::optional<terrain::World> plain;
  std::optional<terrain::World> shown;
  std::vector<MaterialId> ores;
  std::map<ChunkKey, Chunk> chunks;
  std::map<ChunkCoord, std::vector<Override>> hidden_in;
};

std::string key_file(const ScratchDirectory& scratch, const std::string& name, const std::string& bytes) {
  const std::string file = scratch.write(name, bytes);
  std::filesystem::permissions(file, std::filesystem::perms{0600});
  return file;
}

Settings with_secrets(const ScratchDirectory& scratch) {
  return {{"TALUS_WORLD", kWorldFile.string()},
          {"TALUS_DATA", (scratch / "data").string()},
          {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"},
          {"TALUS_HTTP_PUBLIC_CHUNKS", "true"},
          {"TALUS_SECRET_KEY_FILE", key_file(scratch, "key", kKey)},
          {"TALUS_SECRET_LAYERS", "veins"}};
}

ContentHash hash_with(const Chunk& shown, const std::vector<Override>& hidden) {
  return content_hash(shown.with_overrides(hidden));
}

}  // namespace

TEST_CASE("an x-ray client sees the ore that the land exposes, by every channel, and no other") {
  const ScratchDirectory scratch;
  Land land{kKey};
  ServerProcess server{with_secrets(scratch), kWithHttp};
  Player player;
  std::size_t coarse_ore = 0;
  const auto world = player.connect(server.port());
  REQUIRE(world.has_value());

  SECTION("identity") {
    // Not what anybody can compute who tries seeds.
    CHECK(world->fingerprint == land.shown->fingerprint());
    CHECK(world->fingerprint != land.open->fingerprint());
    CHECK(world->fingerprint != land.plain->fingerprint());
    HttpClient http{server.http_port()};
    const std::string body = http.get("/v1/world").body;
    CHECK(body.find("seed") == std::string::npos);
    CHECK(http.get("/v1/" + to_string(land.open->fingerprint()) + "/4/0/0/0/0").status == 404);
  }

  SECTION("a View of all levels") {
    const VoxelPos centre{world->spawn.x, 48, world->spawn.z};
    constexpr std::int32_t kRadius = 8;
    player.move_view(centre, kRadius, {{Lod::of(1), 10}, {Lod::of(2), 12}});
    const ChunkCoord middle = chunk_holding(centre, Lod{})->coord;
    std::size_t hidden = 0;
    std::size_t exposed = 0;
    for (std::int32_t x = -kRadius; x <= kRadius; ++x) {
      for (std::int32_t z = -kRadius; z <= kRadius; ++z) {
        for (std::int32_t y = -1; y <= 1; ++y) {
          const ChunkCoord coord{middle.x + x, middle.y + y, middle.z + z};
          const auto seen = player.store.find({coord, Lod{}});
          if (seen == nullptr) continue;  // outside of a round View
          // All voxels, so all bytes and hashes too: nothing of a chunk follows from anything else.
          REQUIRE(*seen == land.chunk({coord, Lod{}}));
          hidden += land.hidden(coord).size();
          for (std::size_t i = 0; i < kChunkVolume; ++i)
            exposed += land.is_ore(seen->at(local_of(i))) ? 1 : 0;
        }
      }
    }
    CHECK(hidden > 10'000);
    CHECK(exposed > 100);
    for (int level = 1; level <= 2; ++level) {
      for (std::int32_t x = -16; x <= 16; ++x) {
        for (std::int32_t z = -16; z <= 16; ++z) {
          for (std::int32_t y = -4; y <= 4; ++y) {
            const ChunkKey key{{(middle.x >> level) + x, (middle.y >> level) + y, (middle.z >> level) + z},
                               Lod::of(level)};
            const auto seen = player.store.find(key);
            if (seen == nullptr) continue;
            for (std::size_t i = 0; i < kChunkVolume; ++i)
              coarse_ore += land.is_ore(seen->at(local_of(i))) ? 1 : 0;
          }
        }
      }
    }
    CHECK(coarse_ore == 0);
  }

  SECTION("HTTP, and hashes of what a client guesses") {
    HttpClient http{server.http_port()};
    const std::string root = root_of(http);
    std::size_t tried = 0;
    for (std::int32_t x = 0; x < 40 && tried < 6; ++x) {
      const ChunkKey key{{x, 1, 3}, Lod{}};
      if (land.hidden(key.coord).size() < 50) continue;
      ++tried;
      const Answer answer = http.get(root + "/0/" + std::to_string(x) + "/1/3");
      REQUIRE(answer.status == 200);
      const Chunk& shown = land.chunk(key);
      std::vector<std::byte> payload;
      encode(shown, payload);
      CHECK(answer.body.size() == payload.size());
      CHECK(std::memcmp(answer.body.data(), payload.data(), payload.size()) == 0);
      // A right guess of what is hidden is no more "unchanged" than a wrong one.
      std::optional<client::Result<client::ReceivedChunk>> got;
      player.client.get(key, hash_with(shown, land.hidden(key.coord)),
                        [&](auto result) { got = std::move(result); });
      player.until([&] { return got.has_value(); });
      REQUIRE(got->has_value());
      CHECK_FALSE((*got)->unchanged());
      CHECK((*got)->hash == content_hash(shown));
    }
    CHECK(tried == 6);
  }

  SECTION("guards, `only`, and what edits answer") {
    std::size_t tried = 0;
    for (std::int32_t x = 0; x < 40 && tried < 60; ++x) {
      const ChunkCoord coord{x, 1, 3};
      for (std::size_t i = 0; i < land.hidden(coord).size() && i < 10; ++i) {
        const Override ore = land.hidden(coord)[i];
        const VoxelPos at = voxel_at(chunk_origin(coord), local_of(ore.index));
        client::Edit guess;
        guess.guards.push_back({at, ore.material});
        const auto refused = player.edit(std::move(guess));
        REQUIRE_FALSE(refused.has_value());
        CHECK(refused.error().kind == client::ErrorKind::conflict);
        client::Edit only;
        only.fills.push_back({at, at, kWater, ore.material});
        CHECK(player.edit(std::move(only))->changed == 0);
        // Writing what is shown is no change.
        CHECK(player.put(at, land.chunk({coord, Lod{}}).at(local_of(ore.index)))->changed == 0);
        ++tried;
      }
    }
    CHECK(tried == 60);
  }
}

TEST_CASE("digging reveals the ore beside the hole at once, to all, and for good") {
  const ScratchDirectory scratch;
  Land land{kKey};
  const ChunkCoord coord = [&] {
    for (std::int32_t x = 0;; ++x) {
      if (land.hidden({x, 1, 3}).size() > 50) return ChunkCoord{x, 1, 3};
    }
  }();
  // A hidden voxel that is not at the chunk's edge, and what is hidden beside it.
  const std::vector<Override>& hidden = land.hidden(coord);
  const auto found = std::find_if(hidden.begin(), hidden.end(), [](const Override& each) {
    const LocalPos at = local_of(each.index);
    return std::min({at.x, at.y, at.z}) > 1 && std::max({at.x, at.y, at.z}) < 30;
  });
  REQUIRE(found != hidden.end());
  const VoxelPos at = voxel_at(chunk_origin(coord), local_of(found->index));
  std::map<VoxelPos, MaterialId> beside;
  for (const Override& each : hidden) {
    const VoxelPos other = voxel_at(chunk_origin(coord), local_of(each.index));
    const auto apart = std::abs(other.x - at.x) + std::abs(other.y - at.y) + std::abs(other.z - at.z);
    if (apart == 1) beside.emplace(other, each.material);
  }
  std::vector<Override> expected{{found->index, kAir}};
  for (const auto& [voxel, ore] : beside) {
    expected.push_back({static_cast<std::uint16_t>(voxel_index(local_pos(voxel))), ore});
  }
  const Chunk after = land.chunk({coord, Lod{}}).with_overrides(expected);
  {
    ServerProcess server{with_secrets(scratch), kWithHttp};
    Player digger;
    Player viewer;
    REQUIRE(digger.connect(server.port()).has_value());
    REQUIRE(viewer.connect(server.port()).has_value());
    viewer.move_view(at);
    digger.move_view(at);
    CHECK(viewer.sees(at) != kAir);
    const auto dug = digger.put(at, kAir);
    REQUIRE(dug.has_value());
    CHECK(dug->changed == 1 + beside.size());
    for (Player* const player : {&digger, &viewer}) {
      player->until([&] { return player->sees(at) == kAir; });
      for (const auto& [voxel, ore] : beside) CHECK(player->sees(voxel) == ore);
      CHECK(*player->store.find({coord, Lod{}}) == after);
    }
    // Undone, all is as generated.
    client::Edit undo;
    undo.fills.push_back(
        {{at.x - 1, at.y - 1, at.z - 1}, {at.x + 1, at.y + 1, at.z + 1}, std::nullopt, std::nullopt});
    CHECK(digger.edit(std::move(undo))->changed == 1 + beside.size());
    CHECK(digger.put(at, kAir)->changed == 1 + beside.size());
  }
  ServerProcess again{with_secrets(scratch), kWithHttp};
  Player late;
  REQUIRE(late.connect(again.port()).has_value());
  late.move_view(at);
  CHECK(*late.store.find({coord, Lod{}}) == after);
}

TEST_CASE("a server without its secret key, or with another, or a wrong one, is refused in one line") {
  const ScratchDirectory scratch;
  Settings settings = with_secrets(scratch);
  { const ServerProcess server{settings}; }
  const auto told = [&](const Settings& changed) {
    const ProgramResult result = run_talusd({"--listen", "127.0.0.1:0"}, changed);
    CHECK(result.status != 0);
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
    return result.err;
  };
  settings["TALUS_PUBLISH"] = "public";
  CHECK_THAT(told(settings), Catch::Contains("publish: clients cannot make a world with [secret]"));
  settings.erase("TALUS_PUBLISH");
  settings["TALUS_SECRET_KEY_FILE"] = key_file(scratch, "other", std::string(31, 'x') + "y");
  CHECK_THAT(told(settings), Catch::Contains("secret.key_file"));
  settings["TALUS_SECRET_KEY_FILE"] = key_file(scratch, "short", "0123456789abcdef");
  CHECK_THAT(told(settings), Catch::Contains("has 16 bytes; it must have 32"));
  settings["TALUS_SECRET_KEY_FILE"] = key_file(scratch, "blank", std::string(32, '\0'));
  CHECK_THAT(told(settings), Catch::Contains("has no secret"));
  settings.erase("TALUS_SECRET_KEY_FILE");
  CHECK_THAT(told(settings), Catch::Contains("secret.layers: is set and key_file is not"));
  settings.erase("TALUS_SECRET_LAYERS");
  CHECK_THAT(told(settings), Catch::Contains("secret.key_file"));
}
