// A store that is read without a server.
#include <talus/store/stored_edits.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <random>

#include <catch2/catch.hpp>

#include <talus/store/data_directory.h>

#include "edits_of_tests.h"
#include "scratch_directory.h"

namespace talus::server {
namespace {

using namespace testing;
namespace fs = std::filesystem;

constexpr ContentHash kWorld{1, 2};  // of EditStore

/// Every file below, its bytes and when it was written.
std::map<std::string, std::pair<std::string, fs::file_time_type>> files_below(const fs::path& directory) {
  std::map<std::string, std::pair<std::string, fs::file_time_type>> files;
  for (const auto& entry : fs::recursive_directory_iterator{directory}) {
    if (entry.is_regular_file())
      files[entry.path().string()] = {read_whole(entry.path()), entry.last_write_time()};
  }
  return files;
}

/// A directory with a store.toml, as talusd makes it, whose id `store` is given.
void make_directory(const fs::path& path, EditStore& store) {
  const auto directory = store::DataDirectory::open(path, kWorld);
  REQUIRE(directory);
  store.database_settings.store_id = directory->store_id();
}

/// Level 0's overrides, by the chunks of overrides_of().
std::map<VoxelPos, MaterialId> stored_overrides(const store::StoredEdits& edits) {
  std::map<VoxelPos, MaterialId> voxels;
  for (std::int32_t x = -4; x <= 4; ++x) {
    for (std::int32_t y = -2; y <= 2; ++y) {
      for (std::int32_t z = -2; z <= 2; ++z) {
        const auto chunk = edits.overrides({{x, y, z}, Lod{}});
        REQUIRE(chunk.has_value());
        const VoxelPos at = chunk_origin({x, y, z});
        for (const Override& each : chunk->voxels()) {
          voxels.emplace(
              VoxelPos{at.x + each.index % 32, at.y + each.index / 1024, at.z + each.index / 32 % 32},
              each.material);
        }
      }
    }
  }
  return voxels;
}

}  // namespace

TEST_CASE("a store is read as its server left it, flushed or not, and stays as it was") {
  // 0: nothing is flushed but at the end; 1: as soon as may be.
  for (const int flushed : {0, 1}) {
    const ScratchDirectory scratch;
    EditStore store{scratch.path()};
    make_directory(scratch.path(), store);
    if (flushed == 1) store.log_settings.flush_interval = std::chrono::milliseconds{1};
    std::mt19937_64 random{static_cast<std::uint64_t>(7 + flushed)};
    REQUIRE(store.open() == "");
    REQUIRE(store.database().bind({{"planks", MaterialId{300}}}));
    TestEditor editor;
    editor.attach(store);
    for (int i = 0; i < 300; ++i) REQUIRE(editor.edit(store, random_edit(random)));
    const auto expected = overrides_of(store.state());
    const std::uint64_t revision = store.state().revision();
    // As a kill leaves it: the files while they are in use.
    const ScratchDirectory killed;
    fs::copy(scratch.path(), killed.path(),
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    store.close();
    for (const fs::path& path : {scratch.path(), killed.path()}) {
      const auto before = files_below(path);
      {
        const auto edits = store::StoredEdits::open(path, kWorld);
        INFO((edits ? std::string{} : edits.error()));
        REQUIRE(edits);
        CHECK((*edits)->revision() == revision);
        CHECK((*edits)->materials().at("planks") == MaterialId{300});
        CHECK(stored_overrides(**edits) == expected);
        CHECK((*edits)->edited_rows({{1000, 0, 0}, Lod{}}).size() == 0);
        for (const auto& [at, material] : expected) {
          CHECK((*edits)->edited_rows(*chunk_holding(at, Lod{})).contains(floor_div(at.y, kChunkSize)));
        }
      }
      CHECK(files_below(path) == before);
    }
    // And the server goes on with it.
    REQUIRE(store.open() == "");
    CHECK(overrides_of(store.state()) == expected);
  }
}

TEST_CASE("a store in use by a server is not read, and the error names its backup") {
  const ScratchDirectory scratch;
  EditStore store{scratch.path()};
  make_directory(scratch.path(), store);
  REQUIRE(store.open() == "");
  store.close();
  {
    const auto server = store::DataDirectory::open(scratch.path(), kWorld);
    REQUIRE(server);
    const auto refused = store::StoredEdits::open(scratch.path(), kWorld);
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error(), Catch::Contains("talusd uses it") && Catch::Contains("talusd store backup"));
  }
  const auto reading = store::StoredEdits::open(scratch.path(), kWorld);
  REQUIRE(reading);
  CHECK_FALSE(store::DataDirectory::open(scratch.path(), kWorld));  // while it is read
  CHECK(store::StoredEdits::open(scratch.path(), kWorld));          // but others may read
}

TEST_CASE("an invalid, foreign, damaged or truncated store is refused in one line") {
  const ScratchDirectory scratch;
  const auto refused = [&](const std::string& part, ContentHash world = kWorld) {
    const auto opened = store::StoredEdits::open(scratch.path(), world);
    REQUIRE_FALSE(opened);
    INFO(opened.error());
    CHECK(opened.error().find('\n') == std::string::npos);
    CHECK_THAT(opened.error(), Catch::Contains(part));
  };
  refused("no store.toml");
  CHECK(fs::is_empty(scratch.path()));
  EditStore store{scratch.path()};
  make_directory(scratch.path(), store);
  refused("does not open");
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  std::mt19937_64 random{5};
  for (int i = 0; i < 20; ++i) REQUIRE(editor.edit(store, random_edit(random)));
  store.close();
  refused(to_string(ContentHash{5, 6}), ContentHash{5, 6});
  // A file that says more was acknowledged than is there.
  const std::string acknowledged = read_whole(scratch / "acknowledged");
  store::Bytes more;
  encode(store::AcknowledgedState{1'000'000, 1}, more);
  std::ofstream{scratch / "acknowledged", std::ios::binary}.write(reinterpret_cast<const char*>(more.data()),
                                                                  static_cast<std::streamsize>(more.size()));
  refused("were acknowledged and are lost");
  std::ofstream{scratch / "acknowledged", std::ios::binary} << acknowledged;
  CHECK(store::StoredEdits::open(scratch.path(), kWorld));
  // Nothing is read whole that may have any length.
  const auto with_length = [&](const fs::path& file, std::uintmax_t bytes, const std::string& part) {
    const std::uintmax_t before = fs::file_size(file);
    fs::resize_file(file, bytes);
    refused(part);
    fs::resize_file(file, before);
  };
  constexpr std::uintmax_t kHuge = std::uintmax_t{1} << 40U;
  with_length(scratch / "acknowledged", kHuge, "acknowledged: it is damaged");
  with_length(scratch / "db" / "CURRENT", kHuge, "CURRENT: it has 1099511627776 bytes");
  with_length(scratch / "db" / "IDENTITY", kHuge, "IDENTITY: it has 1099511627776 bytes");
  CHECK(store::StoredEdits::open(scratch.path(), kWorld));
  // A backup has no lock, and a manifest where it is whole.
  fs::remove(scratch / "lock");
  refused("without its manifest");
  std::ofstream{scratch / "manifest"};
  CHECK(store::StoredEdits::open(scratch.path(), kWorld));
  fs::create_directory(scratch / "talus-next");
  refused("being put in its place");
  fs::remove(scratch / "talus-next");
  fs::remove(scratch / "db" / "CURRENT");
  refused("does not open");
}

}  // namespace talus::server
