// A player's save becomes a store, and a store a save.
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <talus/saves/save.h>

#include "commands/store/save_export.h"
#include "commands/store/store_command.h"
#include "commands/store/transfer.h"
#include "config/parse_flags.h"
#include "scratch_directory.h"
#include "whole_stores.h"

namespace talus::server {
namespace {

namespace fs = std::filesystem;

const std::string kLand = std::string{terrain::classic_world_toml()} +
                          "\n[[placeable]]\nname = \"planks\"\ncolour = \"#8a6b3d\"\n"
                          "[[placeable]]\nname = \"glass\"\ncolour = \"#ddeeff\"\n";

saves::WorldSource land(const std::string& toml = kLand) {
  auto source = saves::read_world(std::as_bytes(std::span{toml}));
  REQUIRE(source);
  return *std::move(source);
}

/// A save with a wall of planks and a pane of glass.
saves::Save save_to(const fs::path& file) {
  auto save = saves::Save::create(file, land());
  REQUIRE(save);
  local::Workspace workspace{save->world()};
  REQUIRE(save->apply(workspace, {{}, {}, {{{-40, 150, -3}, {40, 160, -2}, MaterialId{256}, {}}}, {}}));
  REQUIRE(save->apply(workspace, {{}, {{{0, 150, 0}, MaterialId{257}}}, {}, {}}));
  REQUIRE(save->commit());
  return *std::move(save);
}

tl::expected<Rebuilt, std::string> import_from(const fs::path& file, const fs::path& data) {
  const auto directory = store::DataDirectory::open_any(data);
  REQUIRE(directory.has_value());
  return import_edits(file, *directory, Winner::file, 1'800'000'000'000);
}

tl::expected<ExportResult, std::string> export_from(const fs::path& data, const fs::path& world,
                                                    const fs::path& file) {
  const auto store = store::ReadOnlyStore::open(data);
  REQUIRE(store.has_value());
  return export_save(**store, world, true, file);
}

std::string error_of(const auto& result) {
  return result ? std::string{} : result.error();
}

}  // namespace

TEST_CASE("a save that goes through a store is the same") {
  const ScratchDirectory scratch;
  edits::StateHash hash;
  edits::MaterialIds names;
  {
    const saves::Save save = save_to(scratch / "game.talus");
    hash = save.edits().hash();
    names = save.file().world().materials;
  }
  const auto imported = import_from(scratch / "game.talus", scratch / "data");
  INFO(error_of(imported));
  REQUIRE(imported);
  CHECK(imported->compared);
  CHECK(imported->fingerprint == land().world->fingerprint());
  CHECK(imported->voxels == 81 * 11 * 2 + 1);
  {
    const auto store = store::ReadOnlyStore::open(scratch / "data");
    REQUIRE(store);
    CHECK((*store)->meta().head.hash == hash);
    CHECK((*store)->materials() == names);
    CHECK((*store)->meta().fingerprint == land().world->fingerprint());
  }
  (void)voxels_of(scratch / "data");  // sound, coarse levels too

  const fs::path world = scratch.write("land.toml", kLand);
  const auto exported = export_from(scratch / "data", world, scratch / "again.talus");
  INFO(error_of(exported));
  REQUIRE(exported);
  CHECK(exported->voxels == imported->voxels);
  const auto again = saves::Save::open(scratch / "again.talus");
  REQUIRE(again);
  CHECK(again->edits().hash() == hash);
  CHECK(again->file().world().materials == names);
  CHECK(again->file().world().spec == kLand);
  CHECK(again->edits().settings().settles);
  CHECK(scratch.file_count() >= 3);
}

TEST_CASE("a save's names match the store's, and its voxels win") {
  const ScratchDirectory scratch;
  (void)save_to(scratch / "game.talus");
  edits::MaterialIds stored{{"glass", MaterialId{256}}, {"planks", MaterialId{300}}};
  for (const auto& [name, id] : land().saved.materials) {
    if (to_integer(id) < edits::kFirstBound) stored.emplace(name, id);
  }
  // Voxel (0, 150, 0) is glass in the save.
  const auto index = static_cast<std::uint16_t>((150 % 32) * 32 * 32);
  make_store(scratch / "data", {{{{0, 4, 0}, index}, MaterialId{300}}}, land().world->fingerprint(), stored);
  const auto imported = import_from(scratch / "game.talus", scratch / "data");
  INFO(error_of(imported));
  REQUIRE(imported);
  CHECK(imported->both == 1);
  const Voxels voxels = voxels_of(scratch / "data");
  CHECK(voxels.at({{0, 4, 0}, index}) == MaterialId{256});
  CHECK(voxels.at({{0, 4, -1}, static_cast<std::uint16_t>(index + 30 * 32)}) == MaterialId{300});

  // Ids that the store gave stay in a save.
  REQUIRE(export_from(scratch / "data", scratch.write("land.toml", kLand), scratch / "again.talus"));
  const auto again = saves::Save::open(scratch / "again.talus");
  REQUIRE(again);
  CHECK(again->edits().settings().placeables == std::vector{MaterialId{300}, MaterialId{256}});
}

TEST_CASE("a save of another world or a damaged one leaves the store as it was") {
  const ScratchDirectory scratch;
  (void)save_to(scratch / "game.talus");
  make_store(scratch / "data", {{{{0, 0, 0}, 1}, MaterialId{256}}});
  const Voxels before = voxels_of(scratch / "data");
  CHECK_THAT(error_of(import_from(scratch / "game.talus", scratch / "data")),
             Catch::Contains("game.talus: it is of the world with fingerprint") &&
                 Catch::Contains(to_string(kWorld)));
  CHECK(voxels_of(scratch / "data") == before);

  // Its S is wrong.
  auto file = saves::SaveFile::open(scratch / "game.talus", saves::Access::write);
  REQUIRE(file);
  REQUIRE(file->begin());
  REQUIRE(file->commit({2, {1, 2}}));
  file = tl::unexpected{saves::SaveError{}};  // closes it
  CHECK_THAT(error_of(import_from(scratch / "game.talus", scratch / "new")), Catch::Contains("is damaged"));
  CHECK_FALSE(fs::exists(scratch / "new" / "db"));
}

TEST_CASE("an export as a save names what the world lacks, and leaves the file as it was") {
  const ScratchDirectory scratch;
  (void)save_to(scratch / "game.talus");
  REQUIRE(import_from(scratch / "game.talus", scratch / "data"));
  const fs::path old = scratch.write("old.talus", "old");
  const auto refused = [&](const std::string& world) {
    return error_of(export_from(scratch / "data", scratch.write("world.toml", world), old));
  };
  CHECK_THAT(refused(std::string{terrain::default_world_toml()}),
             Catch::Contains("give the store's world as --world"));
  CHECK_THAT(refused(kLand.substr(0, kLand.rfind("[[placeable]]"))),
             Catch::Contains("material 257, \"glass\", which the world's file does not name"));
  CHECK_THAT(refused("seed = 1\nwrong = 1\n"), Catch::Contains("wrong"));
  CHECK(read_whole(old) == "old");
  CHECK_THAT(error_of(export_from(scratch / "data", scratch.write("world.toml", kLand), scratch.path())),
             Catch::Contains("is not a regular file; give another name"));
}

TEST_CASE("an export replaces no save that is open, and finishes a journal first") {
  const ScratchDirectory scratch;
  (void)save_to(scratch / "game.talus");
  REQUIRE(import_from(scratch / "game.talus", scratch / "data"));
  const fs::path world = scratch.write("land.toml", kLand);
  const auto error = [&](const char* name) {
    return error_of(export_from(scratch / "data", world, scratch / name));
  };
  {
    const auto game = saves::Save::open(scratch / "game.talus");
    REQUIRE(game);
    CHECK_THAT(error("game.talus"), Catch::Contains("is in use; close it where it is open"));
  }
  CHECK(error("game.talus").empty());
  CHECK_FALSE(fs::exists(scratch / "game.talus-journal"));
  CHECK(saves::Save::open(scratch / "game.talus"));
  scratch.write("lost.talus-journal", "pages");
  CHECK_THAT(error("lost.talus"),
             Catch::Contains("lost.talus-journal: is the journal of a save that is gone"));
}

TEST_CASE("the commands take and give saves") {
  const ScratchDirectory scratch;
  (void)save_to(scratch / "game.talus");
  const std::string data = scratch / "data";
  const std::string save = scratch / "game.talus";
  const std::string again = scratch / "again.talus";
  const std::string world = scratch.write("land.toml", kLand);
  const auto run = [](std::vector<const char*> flags, const Environment& environment = {}) {
    flags.insert(flags.begin(), "store");
    const LoadWorld load = [](const fs::path&, const SecretLayers&) {
      return tl::expected<std::shared_ptr<const terrain::World>, std::string>{
          std::make_shared<const terrain::World>(terrain::default_world())};
    };
    return store_command(static_cast<int>(flags.size()), flags.data(), environment, load, {});
  };
  REQUIRE(run({"import", save.c_str(), "--data", data.c_str()}) == 0);
  CHECK(run({"verify", "--data", data.c_str()}) == 0);
  CHECK(run({"export", again.c_str(), "--save", "--data", data.c_str()}) == kFailed);  // the built-in world
  REQUIRE(run({"export", again.c_str(), "--save", "--world", world.c_str(), "--data", data.c_str()},
              {{"TALUS_EDITS_SETTLE", "true"}}) == 0);
  const auto opened = saves::Save::open(again);
  REQUIRE(opened);
  CHECK(opened->edits().settings().settles);
  CHECK(opened->revision() >= 1);
}

}  // namespace talus::server
