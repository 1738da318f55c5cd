#include <talus/saves/save.h>

#include <new>
#include <span>
#include <string>

#include <sqlite3.h>
#include <catch2/catch.hpp>

#include <talus/terrain/extraction.h>
#include <talus/world_files/world_files.h>

#include "saved_land.h"
#include "scratch_directory.h"

using namespace talus;
using saves::Access;
using saves::Save;
using Kind = saves::SaveError::Kind;

namespace {

Chunk merged(const Save& save, ChunkKey key) {
  return save.edits().merged_over(key, terrain::generate_chunk(*save.world(), key));
}

}  // namespace

TEST_CASE("a save that is opened again has what was committed") {
  const ScratchDirectory directory;
  edits::StateHash hash;
  std::vector<Chunk> chunks;
  const std::vector<ChunkKey> keys{{{0, 3, 0}, {}}, {{0, 1, 0}, Lod::of(1)}, {{0, 0, 0}, Lod::of(3)}};
  {
    Save save = new_save(directory / "game.talus");
    CHECK(save.revision() == 0);
    local::Workspace workspace{save.world()};
    REQUIRE(save.apply(workspace, filled({-8, 80, -8}, {20, 120, 8})));
    REQUIRE(save.apply(workspace, filled({0, 90, 0}, {20, 120, 8}, kAir)));
    REQUIRE(save.commit());
    CHECK_FALSE(save.has_changes());
    hash = save.edits().hash();
    for (const ChunkKey key : keys) chunks.push_back(merged(save, key));
    REQUIRE(save.apply(workspace, written({0, 100, 0})));
    CHECK(save.has_changes());  // and is lost
  }
  CHECK(directory.file_count() == 1);  // no journal: it may be copied
  const auto save = Save::open(directory / "game.talus");
  REQUIRE(save);
  CHECK(save->revision() == 2);
  CHECK(save->edits().hash() == hash);
  for (std::size_t i = 0; i < keys.size(); ++i) CHECK(merged(*save, keys[i]) == chunks[i]);
}

TEST_CASE("a chunk without overrides leaves the save") {
  const ScratchDirectory directory;
  {
    Save save = new_save(directory / "game.talus");
    local::Workspace workspace{save.world()};
    REQUIRE(save.apply(workspace, written({1, 200, 1})));
    REQUIRE(save.commit());
    REQUIRE(save.apply(workspace, written({1, 200, 1}, kAir)));
    REQUIRE(save.commit());
  }
  auto file = saves::SaveFile::open(directory / "game.talus", Access::read);
  REQUIRE(file);
  const auto chunk = file->next_chunk();
  REQUIRE(chunk);
  CHECK_FALSE(*chunk);
  CHECK(file->state().revision == 2);
}

TEST_CASE("edits made before there was a save are in it") {
  const ScratchDirectory directory;
  const saves::WorldSource source = land();
  local::Workspace workspace{source.world};
  local::Edits edits{{true, {}}};
  REQUIRE(edits.apply(workspace, written({1, 200, 1})));
  REQUIRE(Save::create(directory / "game.talus", source, edits, 7));
  const auto save = Save::open(directory / "game.talus", Access::read);
  REQUIRE(save);
  CHECK(save->edits().hash() == edits.hash());
  CHECK(save->revision() == 7);
  CHECK(save->edits().settings().settles);
}

TEST_CASE("a save holds the files that its world names") {
  const ScratchDirectory directory;
  const std::string toml =
      land_toml() +
      "[[object]]\nname = \"watchtower\"\nmodel = \"watchtower.vox\"\nspacing = 60\nchance = 1\n"
      "[object.palette]\n1 = { name = \"masonry\", colour = \"#8d8a84\" }\n"
      "2 = { name = \"shingles\", colour = \"#6e4436\" }\n";
  const auto source = saves::read_world(std::as_bytes(std::span{toml}),
                                        world_files::bytes_beside(TALUS_SOURCE_DIR "/core/worlds/any.toml"));
  INFO((source ? std::string{} : source.error().message));
  REQUIRE(source);
  CHECK(source->saved.files.size() == 1);
  REQUIRE(Save::create(directory / "game.talus", *source));
  const auto save = Save::open(directory / "game.talus");
  REQUIRE(save);
  CHECK(save->world()->fingerprint() == source->world->fingerprint());
}

TEST_CASE("a save is used by one program at a time") {
  const ScratchDirectory directory;
  const auto kind = [&](Access access) {
    const auto second = Save::open(directory / "game.talus", access);
    return second ? std::nullopt : std::optional{second.error().kind};
  };
  {
    const Save first = new_save(directory / "game.talus");
    CHECK(kind(Access::write) == Kind::in_use);
    CHECK(kind(Access::read) == Kind::in_use);
    CHECK_THAT(Save::open(directory / "game.talus").error().message,
               Catch::Contains("game.talus: is in use"));
  }
  const auto reader = Save::open(directory / "game.talus", Access::read);
  REQUIRE(reader);
  CHECK(kind(Access::read) == std::nullopt);
  CHECK(kind(Access::write) == Kind::in_use);
}

TEST_CASE("a commit for which no memory is left is tried again") {
  const ScratchDirectory directory;
  edits::StateHash hash;
  {
    Save save = new_save(directory / "game.talus");
    local::Workspace workspace{save.world()};
    edits::Edit many;
    for (std::int32_t at = 0; at < 256; ++at) {
      many.writes.push_back({{64 + 2 * (at % 16), 200, 2 * (at / 16)}, MaterialId{256}});
      many.writes.push_back({{65 + 2 * (at % 16), 200, 2 * (at / 16)}, MaterialId{257}});
    }
    REQUIRE(save.apply(workspace, many));
    REQUIRE(save.commit());
    REQUIRE(save.apply(workspace, written({64, 201, 0})));
    const auto before = sqlite3_hard_heap_limit64(sqlite3_memory_used());
    CHECK_THROWS_AS(save.commit(), std::bad_alloc);
    sqlite3_hard_heap_limit64(before);
    // Of a chunk that is put before that one.
    REQUIRE(save.apply(workspace, written({0, 200, 0})));
    const auto kept = save.commit();
    INFO((kept ? std::string{} : kept.error().message));
    REQUIRE(kept);
    hash = save.edits().hash();
  }
  const auto save = Save::open(directory / "game.talus");
  INFO((save ? std::string{} : save.error().message));
  REQUIRE(save);
  CHECK(save->edits().hash() == hash);
}

TEST_CASE("a save opened for reading is not written") {
  const ScratchDirectory directory;
  (void)new_save(directory / "game.talus");
  const std::string before = read_whole(directory / "game.talus");
  {
    auto save = Save::open(directory / "game.talus", Access::read);
    REQUIRE(save);
    local::Workspace workspace{save->world()};
    REQUIRE(save->apply(workspace, written({1, 200, 1})));
    const auto kept = save->commit();
    REQUIRE_FALSE(kept);
    CHECK(kept.error().kind == Kind::read_only);
    const auto writer = Save::open(directory / "game.talus", Access::write);
    REQUIRE_FALSE(writer);
    CHECK(writer.error().kind == Kind::in_use);  // it is still locked
  }
  CHECK(read_whole(directory / "game.talus") == before);
}

TEST_CASE("a save does not replace a file") {
  const ScratchDirectory directory;
  (void)new_save(directory / "game.talus");
  const auto again = Save::create(directory / "game.talus", land());
  REQUIRE_FALSE(again);
  CHECK(again.error().kind == Kind::exists);
  CHECK(Save::open(directory / "game.talus"));
  const auto other = Save::create(directory.write("letter", std::string(5'000, 'a')), land());
  REQUIRE_FALSE(other);
  CHECK(read_whole(directory / "letter") == std::string(5'000, 'a'));
  const auto nowhere = Save::create(directory / "no folder" / "game.talus", land());
  REQUIRE_FALSE(nowhere);
  CHECK(nowhere.error().kind == Kind::missing);
}
