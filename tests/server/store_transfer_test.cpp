// Edits to a file and back.
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <random>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <talus/store/edit_database.h>
#include <talus/store/store_builder.h>

#include "commands/store/portable_file.h"
#include "commands/store/store_figures.h"
#include "commands/store/transfer.h"
#include "scratch_directory.h"
#include "seed_of_run.h"
#include "whole_stores.h"

namespace talus::server {
namespace {

namespace fs = std::filesystem;

/// Lets the store know somebody who edits.
void add_editor(const fs::path& path) {
  store::EditDatabaseSettings settings;
  settings.path = path;
  settings.fingerprint = kWorld;
  settings.store_id = {3, 4};
  const auto database = store::EditDatabase::open(settings);
  REQUIRE(database.has_value());
  store::EditDatabase::Slice slice;
  slice.put({7, 8}, 3, {.epoch = 2, .last_sequence = 0, .used_ms = 5, .subject = "alice", .results = {}});
  REQUIRE((*database)->put(slice).has_value());
}

Voxels random_voxels(std::mt19937_64& random, int count) {
  const std::array materials{MaterialId{0}, MaterialId{2}, MaterialId{256}, MaterialId{257}};
  Voxels voxels;
  for (int i = 0; i < count; ++i) {
    const auto at = [&] { return static_cast<std::int32_t>(random() % 5) - 2; };
    // Many on the samples of coarse levels.
    const auto index =
        static_cast<std::uint16_t>(random() % 2 == 0 ? random() % 32'768 : (random() % 8) * 4 + 2'048);
    voxels[{{at(), at(), at()}, index}] = materials[random() % 4];
  }
  return voxels;
}

std::string export_to(const fs::path& data, const fs::path& file) {
  const auto store = store::ReadOnlyStore::open(data);
  REQUIRE(store.has_value());
  const auto exported = export_edits(**store, file);
  return exported ? std::string{} : exported.error();
}

tl::expected<Rebuilt, std::string> import_from(const fs::path& file, const fs::path& data, Winner winner) {
  const auto directory = store::DataDirectory::open_any(data);
  REQUIRE(directory.has_value());
  return import_edits(file, *directory, winner, 1'800'000'000'000);
}

PortableReader::Source from(const std::string& bytes) {
  return [&bytes, at = std::size_t{0}](std::span<std::byte> into) mutable {
    const std::size_t count = std::min(into.size(), bytes.size() - at);
    std::copy_n(reinterpret_cast<const std::byte*>(bytes.data()) + at, count, into.begin());
    at += count;
    return tl::expected<std::size_t, std::string>{count};
  };
}

/// The error, or nothing.
std::string read_all(const std::string& bytes) {
  auto reader = PortableReader::open(from(bytes));
  if (!reader) return reader.error();
  for (;;) {
    const auto chunk = reader->next();
    if (!chunk) return chunk.error();
    if (!*chunk) return {};
  }
}

std::string hex(const std::string& bytes) {
  std::string text;
  for (const char byte : bytes) text += fmt::format("{:02x}", static_cast<unsigned char>(byte));
  return text;
}

}  // namespace

TEST_CASE("exported and imported edits are the same, whichever wins if both have a voxel") {
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  std::mt19937_64 random{seed};
  for (int round = 0; round < 6; ++round) {
    const ScratchDirectory scratch{ScratchDirectory::memory()};
    const Voxels ours = random_voxels(random, 2'000);
    const Voxels theirs = random_voxels(random, 2'000);
    make_store(scratch / "a", ours);
    make_store(scratch / "b", theirs);
    add_editor(scratch / "b");
    REQUIRE(export_to(scratch / "a", scratch / "file") == "");
    // Into an empty directory.
    REQUIRE(import_from(scratch / "file", scratch / "new", Winner::file).has_value());
    CHECK(voxels_of(scratch / "new") == ours);
    // Over another store.
    const Winner winner = round % 2 == 0 ? Winner::file : Winner::store;
    Voxels expected = winner == Winner::file ? ours : theirs;
    expected.insert((winner == Winner::file ? theirs : ours).begin(),
                    (winner == Winner::file ? theirs : ours).end());
    const auto imported = import_from(scratch / "file", scratch / "b", winner);
    REQUIRE(imported.has_value());
    CHECK(imported->both == ours.size() + theirs.size() - expected.size());
    CHECK(imported->voxels == expected.size());
    CHECK(voxels_of(scratch / "b") == expected);
    CHECK(voxels_of(imported->replaced) == theirs);
    const auto store = store::ReadOnlyStore::open(scratch / "b");
    CHECK((*store)->meta().store_id == imported->store_id);
    CHECK((*store)->meta().head.position == 10);
    CHECK((*store)->meta().head.revision == 7);
    std::size_t editors = 0;
    REQUIRE((*store)->reader().for_each_editor([&](auto, auto&&) { ++editors; }).has_value());
    CHECK(editors == 0);  // it is another store, of which they know nothing
  }
}

// TALUS_STORE_CHUNKS=1000000 test_server_commands "[large]"
TEST_CASE("memory does not grow with the chunks of an export, an import, a verify", "[.][large]") {
  const char* const given = std::getenv("TALUS_STORE_CHUNKS");
  const std::int32_t chunks = given == nullptr ? 50'000 : std::atoi(given);
  const ScratchDirectory scratch;
  auto measured = [last = std::chrono::steady_clock::now()](const char* what) mutable {
    const auto now = std::chrono::steady_clock::now();
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    std::cout << what << ": " << std::chrono::duration<double>(now - std::exchange(last, now)).count()
              << " s, at most " << usage.ru_maxrss / 1'024 << " MiB so far\n";
    return usage.ru_maxrss / 1'024;
  };
  {
    fs::create_directories(scratch / "a");
    const auto builder = store::StoreBuilder::create(scratch / "a", {{3, 4}, kWorld}, 10, 11);
    std::mt19937_64 random{1};
    for (std::int32_t i = 0; i < chunks; ++i) {
      std::vector<Override> voxels;
      for (std::uint16_t at = 0; at < 20; ++at) {
        voxels.push_back({static_cast<std::uint16_t>(at * 1'600 + random() % 1'600), MaterialId{256}});
      }
      REQUIRE((*builder)->add({i % 1'000, 0, i / 1'000}, 5, voxels).has_value());
    }
    for (const auto& [name, id] : kMaterials) REQUIRE((*builder)->add(name, id).has_value());
    REQUIRE((*builder)->finish(6, 1'700'000'000'000).has_value());
  }
  measured("made");
  REQUIRE(export_to(scratch / "a", scratch / "file") == "");
  measured("exported");
  REQUIRE(import_from(scratch / "file", scratch / "b", Winner::file).has_value());
  measured("imported");
  REQUIRE(import_from(scratch / "file", scratch / "b", Winner::store).has_value());
  measured("imported over it");
  const auto store = store::ReadOnlyStore::open(scratch / "b");
  ProgressBar progress{"", ""};
  const auto figures = read_figures(**store, progress);
  REQUIRE(verify(**store, *figures).has_value());
  CHECK(figures->levels[0].chunks == static_cast<std::uint64_t>(chunks));
  CHECK(measured("verified") < 1'024);
  std::cout << "file: " << fs::file_size(scratch / "file") << " bytes\n";
}

TEST_CASE("an imported file's materials match by name") {
  const ScratchDirectory scratch;
  make_store(scratch / "a", {{{{0, 0, 0}, 1}, MaterialId{256}}, {{{0, 0, 0}, 2}, MaterialId{257}}});
  REQUIRE(export_to(scratch / "a", scratch / "file") == "");
  // There glass has the id that planks have here, and planks are not known.
  make_store(scratch / "b", {}, kWorld, {{"glass", MaterialId{256}}, {"rock", MaterialId{2}}});
  REQUIRE(import_from(scratch / "file", scratch / "b", Winner::file).has_value());
  CHECK(voxels_of(scratch / "b") ==
        Voxels{{{{0, 0, 0}, 1}, MaterialId{257}}, {{{0, 0, 0}, 2}, MaterialId{256}}});
  const auto store = store::ReadOnlyStore::open(scratch / "b");
  CHECK((*store)->materials() == std::map<std::string, MaterialId>{{"air", MaterialId{0}},
                                                                   {"glass", MaterialId{256}},
                                                                   {"planks", MaterialId{257}},
                                                                   {"rock", MaterialId{2}}});
}

TEST_CASE("a file of what is placed there and generated here is refused, unless nothing is built of it") {
  const ScratchDirectory scratch;
  const std::map<std::string, MaterialId> renamed{{"planks", MaterialId{2}}, {"glass", MaterialId{256}}};
  make_store(scratch / "a", {{{{0, 0, 0}, 1}, MaterialId{256}}, {{{0, 0, 0}, 2}, MaterialId{257}}});
  REQUIRE(export_to(scratch / "a", scratch / "file") == "");
  make_store(scratch / "b", {{{{0, 0, 0}, 5}, MaterialId{256}}}, kWorld, renamed);
  const auto refused = import_from(scratch / "file", scratch / "b", Winner::file);
  REQUIRE_FALSE(refused.has_value());
  CHECK_THAT(refused.error(), Catch::Contains("\"planks\" is placed in it") && Catch::Contains("rebase"));
  CHECK(voxels_of(scratch / "b") == Voxels{{{{0, 0, 0}, 5}, MaterialId{256}}});

  make_store(scratch / "c", {{{{0, 0, 0}, 2}, MaterialId{257}}});
  REQUIRE(export_to(scratch / "c", scratch / "of glass") == "");
  REQUIRE(import_from(scratch / "of glass", scratch / "b", Winner::file).has_value());
  CHECK(voxels_of(scratch / "b") ==
        Voxels{{{{0, 0, 0}, 2}, MaterialId{256}}, {{{0, 0, 0}, 5}, MaterialId{256}}});
  CHECK((*store::ReadOnlyStore::open(scratch / "b"))->materials() ==
        std::map<std::string, MaterialId>{
            {"air", MaterialId{0}}, {"glass", MaterialId{256}}, {"planks", MaterialId{2}}});
}

TEST_CASE("a file of another world is refused, and so is a material without a name") {
  const ScratchDirectory scratch;
  make_store(scratch / "a", {{{{0, 0, 0}, 1}, MaterialId{2}}}, {5, 6});
  REQUIRE(export_to(scratch / "a", scratch / "file") == "");
  make_store(scratch / "b", {});
  const auto refused = import_from(scratch / "file", scratch / "b", Winner::file);
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().find("rebase that") != std::string::npos);
  make_store(scratch / "c", {{{{0, 0, 0}, 1}, MaterialId{300}}});
  CHECK(export_to(scratch / "c", scratch / "none").find("material 300 has no name") != std::string::npos);
  CHECK_FALSE(fs::exists(scratch / "none"));
}

TEST_CASE("an import into a store that gave all ids is refused") {
  const ScratchDirectory scratch;
  make_store(scratch / "a", {{{{0, 0, 0}, 1}, MaterialId{256}}});
  REQUIRE(export_to(scratch / "a", scratch / "file") == "");
  std::map<std::string, MaterialId> all;
  for (std::uint32_t id = edits::kFirstBound; id <= UINT16_MAX; ++id) {
    all.emplace(fmt::format("m{}", id), MaterialId{static_cast<std::uint16_t>(id)});
  }
  make_store(scratch / "b", {}, kWorld, all);
  const auto refused = import_from(scratch / "file", scratch / "b", Winner::file);
  REQUIRE_FALSE(refused.has_value());
  CHECK_THAT(refused.error(), Catch::Contains("256 to 65535, are taken"));
  all.erase("m65535");
  make_store(scratch / "c", {}, kWorld, all);
  CHECK_THAT(import_from(scratch / "file", scratch / "c", Winner::file).error(),
             Catch::Contains("are taken"));  // for glass and planks one is left
}

TEST_CASE("an export whose names no import would read is refused") {
  const ScratchDirectory scratch;
  std::map<std::string, MaterialId> many = kMaterials;
  for (std::uint16_t id = 0; id < 5'000; ++id) {
    many.emplace(fmt::format("{:0>256}", id), MaterialId{static_cast<std::uint16_t>(300 + id)});
  }
  make_store(scratch / "many", {}, kWorld, many);
  CHECK_THAT(export_to(scratch / "many", scratch / "file"), Catch::Contains("names of its 5004 materials"));
  make_store(scratch / "long", {}, kWorld, {{std::string(257, 'x'), MaterialId{300}}});
  CHECK_THAT(export_to(scratch / "long", scratch / "file"),
             Catch::Contains("material 300 has a name of 257 bytes"));
  CHECK_FALSE(fs::exists(scratch / "file"));
}

TEST_CASE("the portable file's bytes are as in FORMAT.md") {
  std::string bytes;
  PortableWriter writer{[&](std::span<const std::byte> piece) -> PortableWriter::Status {
    bytes.append(reinterpret_cast<const char*>(piece.data()), piece.size());
    return {};
  }};
  edits::StateHash hash;
  hash.add({-1, 2, 300}, Override{5, MaterialId{256}});
  hash.add({-1, 2, 300}, Override{6, MaterialId{256}});
  REQUIRE(writer.begin({kWorld, {3, 4}, {10, 6, 1'700'000'000'000, hash}, {{"planks", MaterialId{256}}}})
              .has_value());
  REQUIRE(writer.add({-1, 2, 300}, std::vector<Override>{{5, MaterialId{256}}, {6, MaterialId{256}}})
              .has_value());
  REQUIRE(writer.end().has_value());
  CHECK(read_all(bytes) == "");
  CHECK(hex(bytes) ==
        "74616c757365647401000000430000000101000000000000000200000000000000030000000000000004000000000000"
        "000a0680d095ffbc31e908cc9f1043f910cd82f4fd503632d70106706c616e6b738002710446f46a967e3d0c00000002"
        "01d8040406018002010501b04b6a60b276ee1e13000000030102e908cc9f1043f910cd82f4fd503632d7e1a9969cbd4a"
        "f737");
}

TEST_CASE("a portable file that is cut, or changed anywhere, is refused, and nothing is made of it") {
  const ScratchDirectory scratch;
  std::mt19937_64 random{3};
  make_store(scratch / "a", random_voxels(random, 30));
  REQUIRE(export_to(scratch / "a", scratch / "file") == "");
  const std::string whole = read_whole(scratch / "file");
  REQUIRE(read_all(whole) == "");
  for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    if (read_all(damaged).empty()) FAIL("bit " << bit << " makes no difference");
  }
  for (std::size_t size = 0; size < whole.size(); ++size) {
    if (read_all(whole.substr(0, size)).empty()) FAIL(size << " bytes are enough");
  }
  CHECK(read_all(whole + "x").find("bytes follow its end") != std::string::npos);
  std::ofstream{scratch / "cut", std::ios::binary} << whole.substr(0, whole.size() - 20);
  make_store(scratch / "b", {{{{0, 0, 0}, 1}, MaterialId{2}}});
  CHECK_FALSE(import_from(scratch / "cut", scratch / "b", Winner::file).has_value());
  CHECK(voxels_of(scratch / "b").size() == 1);
  CHECK_FALSE(import_from(scratch / "cut", scratch / "new", Winner::file).has_value());
  CHECK_FALSE(fs::exists(scratch / "new" / "db"));
}

}  // namespace talus::server
