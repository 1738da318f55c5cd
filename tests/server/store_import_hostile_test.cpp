// Files of edits that are sound to the last byte, and that no talusd wrote.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <catch2/catch.hpp>

#include <talus/store/edit_database.h>
#include <talus/store/read_only_store.h>
#include <talus/store/store_builder.h>
#include <talus/terrain/world.h>

#include "commands/store/portable_file.h"
#include "commands/store/store_commands.h"
#include "commands/store/transfer.h"
#include "scratch_directory.h"

namespace talus::server {
namespace {

namespace fs = std::filesystem;
using Materials = std::map<std::string, MaterialId>;

constexpr ContentHash kLand{1, 2};
constexpr std::int64_t kNow = 1'800'000'000'000;
constexpr std::int64_t kYear = std::int64_t{365} * 86'400'000;

/// With one voxel, of `material`.
fs::path write_edits(const fs::path& file, const Materials& materials, MaterialId material,
                     std::int64_t time_ms = kNow, ContentHash land = kLand) {
  std::ofstream out{file, std::ios::binary};
  PortableWriter writer{[&](std::span<const std::byte> bytes) -> PortableWriter::Status {
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return {};
  }};
  const Override voxel{5, material};
  edits::StateHash hash;
  hash.add({0, 12, 0}, voxel);
  REQUIRE(writer.begin({land, {3, 4}, {10, 6, time_ms, hash}, materials}).has_value());
  REQUIRE(writer.add({0, 12, 0}, std::span{&voxel, 1}).has_value());
  REQUIRE(writer.end().has_value());
  return file;
}

/// A store without edits.
void make_empty_store(const fs::path& path, const Materials& materials, std::int64_t time_ms = kNow) {
  fs::create_directories(path);
  const auto builder = store::StoreBuilder::create(path, {{3, 4}, kLand}, 10, 11);
  REQUIRE(builder.has_value());
  for (const auto& [name, id] : materials) REQUIRE((*builder)->add(name, id).has_value());
  REQUIRE((*builder)->finish(6, time_ms).has_value());
}

/// The error, or nothing.
std::string import_into(const fs::path& data, const fs::path& file, const terrain::World* world = nullptr) {
  fs::create_directories(data);
  const auto directory = store::DataDirectory::open_any(data);
  REQUIRE(directory.has_value());
  const auto imported = import_edits(file, *directory, Winner::file, kNow, world);
  return imported ? std::string{} : imported.error();
}

}  // namespace

TEST_CASE("a file with a name that no world may give is refused, by that name made harmless") {
  const ScratchDirectory scratch;
  const std::map<std::string, std::string> faults{
      {std::string(65, 'z'), R"(": a name has 1 to 64 bytes, this has 65)"},
      {std::string(256, 'z'), R"(": a name has 1 to 64 bytes, this has 256)"},
      {"a\x1b[31mEVIL\n", R"("a\x1B[31mEVIL\x0A": a name is printed as it is)"},
      {std::string("a\0b", 3), R"("a\x00b": a name is printed as it is)"},
      {"\xff\xfe", R"("\xFF\xFE": a name is text in UTF-8)"},
      {"air", R"(material 300 is called "air": 'air' is the world's own)"},
  };
  for (const auto& [name, fault] : faults) {
    // Whether anything is built of it or not.
    for (const MaterialId built : {MaterialId{300}, MaterialId{256}}) {
      const auto file =
          write_edits(scratch / "file", {{"planks", MaterialId{256}}, {name, MaterialId{300}}}, built);
      const std::string error = import_into(scratch / "data", file);
      CHECK_THAT(error, Catch::StartsWith(file.string() + ": its material 300 is called") &&
                            Catch::Contains(fault, Catch::CaseSensitive::No));
      CHECK(error.find_first_of(std::string_view{"\0\n\x1b", 3}) == std::string::npos);
    }
  }
  CHECK_FALSE(fs::exists(scratch / "data" / "db"));
  const Materials largest{{"air", kAir},
                          {"water", kWater},
                          {std::string(64, 'z'), MaterialId{256}},
                          {"dalle à é", MaterialId{257}}};
  CHECK(import_into(scratch / "data", write_edits(scratch / "file", largest, MaterialId{256})) == "");
}

TEST_CASE("a file from a time to come leaves the store at the present, or at its own time") {
  const ScratchDirectory scratch;
  const auto time_after = [&](std::int64_t of_file, std::optional<std::int64_t> of_store) {
    static int number = 0;
    const fs::path data = scratch / ("data" + std::to_string(++number));
    if (of_store) make_empty_store(data, {}, *of_store);
    const auto file = write_edits(scratch / "file", {{"planks", MaterialId{256}}}, MaterialId{256}, of_file);
    REQUIRE(import_into(data, file) == "");
    return (*store::ReadOnlyStore::open(data))->meta().head.time_ms;
  };
  CHECK(time_after(INT64_MAX, {}) == kNow);
  CHECK(time_after(kNow + 10 * kYear, {}) == kNow);
  CHECK(time_after(kNow - kYear, {}) == kNow - kYear);
  CHECK(time_after(INT64_MAX, kNow - kYear) == kNow);
  CHECK(time_after(kNow - 2 * kYear, kNow - kYear) == kNow - kYear);
  CHECK(time_after(INT64_MAX, kNow + kYear) == kNow + kYear);  // its edits have that time
}

TEST_CASE("a generated material that the store's world lacks is refused if something is built of it") {
  const ScratchDirectory scratch;
  const Materials of_store{{"air", kAir}, {"granite", MaterialId{2}}, {"planks", MaterialId{256}}};
  const Materials of_file{{"ghost", MaterialId{37}}, {"planks", MaterialId{256}}};
  make_empty_store(scratch / "data", of_store);
  const auto ghosts = write_edits(scratch / "ghosts", of_file, MaterialId{37});
  CHECK_THAT(import_into(scratch / "data", ghosts),
             Catch::Contains(R"(material 37, "ghost", which its world does not generate)"));
  CHECK(import_into(scratch / "data", write_edits(scratch / "planks", of_file, MaterialId{256})) == "");
  CHECK((*store::ReadOnlyStore::open(scratch / "data"))->materials() == of_store);
  // By another name of the world's file it is the same.
  const auto rock = write_edits(scratch / "rock", {{"rock", MaterialId{2}}}, MaterialId{2});
  CHECK(import_into(scratch / "data", rock) == "");
}

TEST_CASE(
    "an import into an empty directory takes the generated materials from the file's world, if it is given") {
  const ScratchDirectory scratch;
  const auto world = terrain::World::parse(
      read_whole(fs::path{TALUS_SOURCE_DIR} / "core/worlds/classic.toml"), "classic.toml");
  REQUIRE(world.has_value());
  const terrain::Material& rock = world->materials().back();
  const Materials of_file{
      {"ghost", MaterialId{255}}, {"planks", MaterialId{256}}, {"as it was called", rock.id}};
  const auto file_of = [&](MaterialId material, ContentHash land) {
    return write_edits(scratch / "file", of_file, material, kNow, land);
  };
  const std::string refused =
      import_into(scratch / "data", file_of(MaterialId{255}, world->fingerprint()), &*world);
  CHECK_THAT(refused,
             Catch::StartsWith((scratch / "file").string() + ": chunk ") &&
                 Catch::Contains(R"(has material 255, "ghost", which its world does not generate; )") &&
                 Catch::Contains("rebase --drop-unknown"));
  CHECK_FALSE(fs::exists(scratch / "data" / "db"));
  for (const MaterialId known : {rock.id, MaterialId{256}}) {
    const fs::path data = scratch / ("data of " + std::to_string(to_integer(known)));
    CHECK(import_into(data, file_of(known, world->fingerprint()), &*world) == "");
    CHECK_FALSE((*store::ReadOnlyStore::open(data))->materials().contains("ghost"));
  }
  // Of another world it is not known; it may be rebased to one that is.
  CHECK(import_into(scratch / "data", file_of(MaterialId{255}, kLand), &*world) == "");
}

TEST_CASE("an import that is refused leaves nothing of a directory that it made") {
  const ScratchDirectory scratch;
  const LoadWorld load_world = [](const fs::path&, const SecretLayers&) {
    return tl::expected<std::shared_ptr<const terrain::World>, std::string>{};  // none is known
  };
  const ClusterTools cluster;
  const store_commands::Outside outside{load_world, cluster};
  const fs::path whole = write_edits(scratch / "whole", {{"planks", MaterialId{256}}}, MaterialId{256});
  const fs::path cut = scratch / "cut";
  fs::copy_file(whole, cut);
  fs::resize_file(cut, fs::file_size(cut) - 1);
  store_commands::Flags flags;
  flags.path = cut.string();
  for (const char* const data : {"new/data", "new/data/"}) {
    flags.data = scratch / data;
    CHECK_FALSE(store_commands::import_file(flags, outside).has_value());
    CHECK_FALSE(fs::exists(scratch / "new"));
  }
  fs::create_directory(scratch / "there");
  flags.data = scratch / "there/data";
  CHECK_FALSE(store_commands::import_file(flags, outside).has_value());
  CHECK(fs::is_empty(scratch / "there"));
  flags.data = scratch / "there";
  CHECK_FALSE(store_commands::import_file(flags, outside).has_value());
  CHECK(fs::exists(scratch / "there"));
  // What is made of a sound file stays, and the world is named with which it was not compared.
  flags.path = whole.string();
  for (const std::string world : {"", "land.toml"}) {
    flags.world = world;
    flags.data = scratch / ("new" + world);
    const auto imported = store_commands::import_file(flags, outside);
    REQUIRE(imported.has_value());
    CHECK(fs::exists(fs::path{flags.data} / "db"));
    const std::string named = world.empty() ? "default" : world;
    CHECK_THAT(*imported, Catch::Contains("the world (" + named + ") differs from the file's"));
  }
}

TEST_CASE("a store after a rebase that drops unknown materials can be exported") {
  const ScratchDirectory scratch;
  const auto world = terrain::World::parse(
      read_whole(fs::path{TALUS_SOURCE_DIR} / "core/worlds/classic.toml"), "classic.toml");
  REQUIRE(world.has_value());
  // Taken from a file, where nothing knew the world; talusd, once started, has no name for it.
  const auto ghosts = write_edits(scratch / "ghosts", {{"ghost", MaterialId{255}}}, MaterialId{255}, kNow,
                                  world->fingerprint());
  REQUIRE(import_into(scratch / "data", ghosts) == "");
  {
    const auto directory = store::DataDirectory::open_any(scratch / "data");
    REQUIRE(directory.has_value());
    store::EditDatabaseSettings settings;
    settings.path = scratch / "data";
    settings.fingerprint = world->fingerprint();
    settings.store_id = (*store::ReadOnlyStore::open(scratch / "data"))->meta().store_id;
    const auto database = store::EditDatabase::open(settings);
    REQUIRE(database.has_value());
    REQUIRE((*database)->name_generated({{"air", kAir}}).has_value());
  }
  const auto export_now = [&] {
    const auto exported = export_edits(**store::ReadOnlyStore::open(scratch / "data"), scratch / "file");
    return exported ? std::string{} : exported.error();
  };
  CHECK_THAT(export_now(), Catch::Contains("material 255 has no name") &&
                               Catch::Contains("talusd store rebase --drop-unknown"));
  {
    const auto directory = store::DataDirectory::open_any(scratch / "data");
    const auto rebased = rebase_edits(*directory, *world, true);
    REQUIRE(rebased.has_value());
    CHECK(rebased->unknown == 1);
  }
  CHECK(export_now() == "");
}

}  // namespace talus::server
