// Backups: whole or refused; and a restore that is interrupted anywhere.
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include <talus/store/id_check.h>
#include <talus/store/store_swap.h>
#include <talus/store/whole_store.h>

#include "commands/store/backup.h"
#include "commands/store/copied_file.h"
#include "commands/store/store_figures.h"
#include "edits_of_tests.h"
#include "scratch_directory.h"

namespace talus::server {
namespace {

using namespace testing;
namespace fs = std::filesystem;

/// A data directory with a store of some edits.
struct Data {
  explicit Data(std::uint64_t seed = 7, int edits = 300) {
    const auto directory = store::DataDirectory::open(path, {1, 2});
    REQUIRE(directory.has_value());
    EditStore store{path};
    store.database_settings.store_id = directory->store_id();
    store.database_settings.memory.write_buffer_bytes = 64 << 10;
    store.log_settings.flush_interval = std::chrono::milliseconds{1};
    REQUIRE(store.open() == "");
    TestEditor editor;
    editor.attach(store);
    std::mt19937_64 random{seed};
    for (int i = 0; i < edits; ++i) REQUIRE(editor.edit(store, random_edit(random)).has_value());
    head = store.log().status().head;
  }

  store::BackupManifest back_up(const fs::path& target) const {
    const auto manifest = write_backup(path, target);
    INFO((manifest ? "" : manifest.error()));
    REQUIRE(manifest.has_value());
    return *manifest;
  }

  ScratchDirectory scratch{ScratchDirectory::memory()};
  fs::path path = scratch / "data";
  edits::Head head;
};

/// The store's state, where it is sound in every respect.
edits::Head sound_head(const fs::path& path) {
  const auto store = store::ReadOnlyStore::open(path);
  INFO((store ? "" : store.error()));
  REQUIRE(store.has_value());
  ProgressBar progress{"", ""};
  const auto figures = read_figures(**store, progress);
  REQUIRE(figures.has_value());
  const auto verified = verify(**store, *figures);
  INFO((verified ? "" : verified.error()));
  REQUIRE(verified.has_value());
  return (*store)->meta().head;
}

/// While it lives no file may have more bytes, as on a disk that is full.
class SmallFilesAlone {
 public:
  explicit SmallFilesAlone(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    REQUIRE(::getrlimit(RLIMIT_FSIZE, &before_) == 0);
    const rlimit now{bytes, before_.rlim_max};
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &now) == 0);
  }
  ~SmallFilesAlone() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  SmallFilesAlone(const SmallFilesAlone&) = delete;
  SmallFilesAlone& operator=(const SmallFilesAlone&) = delete;

 private:
  rlimit before_{};
};

std::string restore_error(const fs::path& backup, const fs::path& data, bool replace = false) {
  const auto directory = store::DataDirectory::open_any(data);
  REQUIRE(directory.has_value());
  const auto restored = restore_backup(backup, *directory, replace);
  return restored ? std::string{} : restored.error();
}

}  // namespace

TEST_CASE("a backup is restored as it was, as another store") {
  const Data data;
  const store::BackupManifest manifest = data.back_up(data.scratch / "backup");
  CHECK(manifest.head == data.head);
  CHECK(read_manifest(data.scratch / "backup") == manifest);
  fs::create_directory(data.scratch / "new");
  data.scratch.write("new/rejoin", "the store that was here was found to be wrong");
  CHECK(restore_error(data.scratch / "backup", data.scratch / "new") == "");
  CHECK_FALSE(fs::exists(data.scratch / "new/rejoin"));
  CHECK(sound_head(data.scratch / "new") == data.head);
  const auto restored = store::DataDirectory::open_store(data.scratch / "new");
  REQUIRE(restored.has_value());
  CHECK(restored->identity()->fingerprint == ContentHash{1, 2});
  CHECK(restored->store_id() != manifest.identity.store_id);
  // The server opens it as its own.
  EditStore store{data.scratch / "new"};
  store.database_settings.store_id = restored->store_id();
  CHECK(store.open() == "");
}

TEST_CASE("a store that is there is refused, or moved aside whole") {
  const Data old{1};
  const Data data{2};
  (void)data.back_up(data.scratch / "backup");
  CHECK(restore_error(data.scratch / "backup", old.path).find("it holds a store; give --replace") !=
        std::string::npos);
  CHECK(sound_head(old.path) == old.head);
  CHECK(restore_error(data.scratch / "backup", old.path, true) == "");
  CHECK(sound_head(old.path) == data.head);
  CHECK(sound_head(old.path / "replaced-1") == old.head);
  // A damaged identity is no reason not to restore.
  std::ofstream{old.path / "store.toml"} << "?";
  CHECK(restore_error(data.scratch / "backup", old.path, true) == "");
  CHECK(sound_head(old.path) == data.head);
}

TEST_CASE("a backup goes into an empty directory alone") {
  const Data data;
  fs::create_directory(data.scratch / "full");
  std::ofstream{data.scratch / "full" / "letter"} << "dear";
  const auto refused = write_backup(data.path, data.scratch / "full");
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().find("the directory is not empty") != std::string::npos);
}

TEST_CASE("a backup makes no directory but its own") {
  const Data data;
  const auto refused = write_backup(data.path, data.scratch / "disk" / "today/");
  REQUIRE_FALSE(refused.has_value());
  CHECK_THAT(refused.error(), Catch::Contains("disk is not a directory; make it, or mount its disk"));
  CHECK_FALSE(fs::exists(data.scratch / "disk"));
}

TEST_CASE("a backup that finds no room leaves nothing behind") {
  const Data data;
  const fs::path target = data.scratch / "disk" / "today";
  fs::create_directory(data.scratch / "disk");
  {
    const SmallFilesAlone full{64};
    const auto refused = write_backup(data.path, target);
    REQUIRE_FALSE(refused.has_value());
    CHECK_THAT(refused.error(), Catch::Contains("File too large") && !Catch::Contains("is left"));
    CHECK_FALSE(fs::exists(target));
    CHECK_FALSE(write_backup(data.path, target.string() + "/").has_value());
    CHECK_FALSE(fs::exists(target));
    fs::create_directory(target);  // one that was there stays, as it was
    CHECK_FALSE(write_backup(data.path, target).has_value());
    CHECK(fs::is_empty(target));
  }
  data.back_up(target);
  CHECK(sound_head(target) == data.head);
}

TEST_CASE("a backup that was not finished, or is damaged anywhere, is refused and changes nothing") {
  const Data data;
  const fs::path backup = data.scratch / "backup";
  const store::BackupManifest manifest = data.back_up(backup);
  const fs::path target = data.scratch / "target";
  SECTION("without a manifest") {
    fs::remove(backup / "manifest");
    CHECK(restore_error(backup, target).find("was not finished") != std::string::npos);
  }
  SECTION("no directory") {
    CHECK(restore_error(data.scratch / "none", target).find("the directory does not exist") !=
          std::string::npos);
  }
  SECTION("a file that changed, is short, or is gone") {
    for (const store::BackupManifest::File& file : manifest.files) {
      const fs::path path = backup / file.name;
      const std::string whole = read_whole(path);
      INFO(file.name);
      if (whole.empty()) continue;
      std::string changed = whole;
      changed[changed.size() / 2] = static_cast<char>(changed[changed.size() / 2] ^ 1);
      std::ofstream{path, std::ios::binary} << changed;
      CHECK(restore_error(backup, target).find(file.name + " is damaged") != std::string::npos);
      std::ofstream{path, std::ios::binary} << whole.substr(1);
      CHECK(restore_error(backup, target).find(file.name + " is damaged") != std::string::npos);
      fs::remove(path);
      CHECK(restore_error(backup, target).find(file.name) != std::string::npos);
      std::ofstream{path, std::ios::binary} << whole;
      CHECK_FALSE(fs::exists(target / "db"));
    }
    CHECK(restore_error(backup, target) == "");
  }
  SECTION("a file that is longer than the manifest says is not read to its end") {
    // Who read all of it would take minutes, and the disk.
    const fs::path path = backup / manifest.files.front().name;
    fs::resize_file(path, std::uintmax_t{1} << 43U);
    CHECK(restore_error(backup, target).find(manifest.files.front().name + " is damaged") !=
          std::string::npos);
  }
  SECTION("a file that is not regular") {
    const fs::path path = backup / manifest.files.front().name;
    fs::rename(path, data.scratch / "kept");
    REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
    CHECK(restore_error(backup, target).find(path.string() + ": it is a pipe") != std::string::npos);
    fs::remove(path);
    for (const fs::path& elsewhere : {data.scratch / "kept", fs::path{"/dev/zero"}}) {
      fs::create_symlink(elsewhere, path);
      CHECK(restore_error(backup, target).find(path.string() + ": it is a link") != std::string::npos);
      fs::remove(path);
    }
    fs::rename(data.scratch / "kept", path);
    fs::rename(backup / "db", data.scratch / "kept");
    fs::create_directory_symlink(data.scratch / "kept", backup / "db");
    CHECK(restore_error(backup, target).find("db is a link") != std::string::npos);
  }
}

TEST_CASE("a damaged table is neither copied nor restored") {
  Data data;
  const fs::path target = data.scratch / "backup";
  store::BackupManifest manifest = data.back_up(target);
  const auto table = std::ranges::find_if(
      manifest.files, [](const store::BackupManifest::File& file) { return file.name.ends_with(".sst"); });
  REQUIRE(table != manifest.files.end());
  for (const fs::path& each : {data.path, target}) {
    std::fstream file{each / table->name, std::ios::in | std::ios::out | std::ios::binary};
    file.seekp(100);
    file << "damage";
  }
  const auto written = write_backup(data.path, data.scratch / "other");
  REQUIRE_FALSE(written.has_value());
  CHECK(written.error().find((data.path / table->name).string()) != std::string::npos);
  CHECK_FALSE(fs::exists(data.scratch / "other"));
  // As an older talusd made one of a damaged store.
  ProgressBar progress{"", ""};
  table->hash = hash_file(target / table->name, progress)->hash;
  std::ofstream{target / store::kManifestName} << encode(manifest);
  const auto directory = store::DataDirectory::open_any(data.scratch / "restored");
  REQUIRE(directory.has_value());
  const auto restored = restore_backup(target, *directory, false);
  REQUIRE_FALSE(restored.has_value());
  CHECK(restored.error().find((target / table->name).string()) != std::string::npos);
}

TEST_CASE("files whose sizes no number holds are not begun with, nor is one file twice") {
  const Data data;
  const fs::path backup = data.scratch / "backup";
  store::BackupManifest manifest = data.back_up(backup);
  const auto error_with = [&](const store::BackupManifest& changed) {
    std::ofstream{backup / "manifest"} << encode(changed);
    return restore_error(backup, data.scratch / "target");
  };
  store::BackupManifest large = manifest;
  for (store::BackupManifest::File& file : large.files) file.bytes = std::uint64_t{1} << 63U;
  CHECK(large.bytes() == UINT64_MAX);
  CHECK_THAT(error_with(large), Catch::Contains("bytes free; 18446744073709551615 are needed"));
  store::BackupManifest twice = manifest;
  twice.files.push_back(twice.files.front());
  CHECK_THAT(error_with(twice), Catch::Contains("its manifest is damaged"));
  CHECK(error_with(manifest) == "");
}

TEST_CASE("a manifest is read back, and any other text is refused") {
  store::BackupManifest manifest{
      {{1, 2}, {3, 4}}, {5, 6, 7, {8, 9}}, {{"db/000012.sst", 10, {11, 12}}, {"acknowledged", 25, {}}}};
  const std::string text = encode(manifest);
  CHECK(store::decode_manifest(text) == manifest);
  for (std::size_t bit = 0; bit < text.size() * 8; ++bit) {
    std::string damaged = text;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    if (store::decode_manifest(damaged)) FAIL("bit " << bit << " makes no difference");
  }
  for (std::size_t size = 0; size < text.size(); ++size) {
    if (store::decode_manifest(text.substr(0, size))) FAIL(size << " bytes are enough");
  }
  CHECK_FALSE(store::decode_manifest(text + "\n").has_value());
  manifest.files[0].name = "db/../../etc/passwd";
  CHECK_FALSE(store::decode_manifest(encode(manifest)).has_value());
  std::string newer = text;
  newer.replace(newer.find("backup 1"), 8, "backup 2");
  CHECK(store::decode_manifest(newer).error().find("use a newer talusd") != std::string::npos);
}

TEST_CASE("an interrupted swap is finished at the next opening of the directory, after any step") {
  for (int steps = 0; steps <= 8; ++steps) {
    CAPTURE(steps);
    const ScratchDirectory scratch;
    const fs::path data = scratch / "data";
    const fs::path next = data / "talus-next";
    fs::create_directories(next);
    for (const char* const name : {"acknowledged", "db", "store.toml"}) {
      std::ofstream{data / name} << "old";
      std::ofstream{next / name} << "new";
    }
    int left = steps;
    const auto rename = [&](const fs::path& from, const fs::path& to) {
      if (left-- > 0) fs::rename(from, to);
    };
    if (left > 0) fs::create_directory(next / "old");
    for (const char* const name : {"acknowledged", "db", "store.toml"}) {
      rename(data / name, next / "old" / name);
      rename(next / name, data / name);
    }
    rename(next / "old", data / "replaced-1");
    if (left > 0) fs::remove_all(next);
    REQUIRE(store::DataDirectory::open_any(data).has_value());
    for (const char* const name : {"acknowledged", "db", "store.toml"}) {
      CHECK(read_whole(data / name) == "new");
      CHECK(read_whole(data / "replaced-1" / name) == "old");
    }
    CHECK_FALSE(fs::exists(next));
  }
}

TEST_CASE("unfinished files are removed at the next opening of the directory, and nothing else is") {
  const ScratchDirectory scratch;
  for (const char* const name : {"talus-staging/db", "talus-checkpoint-3/db", "staging", "checkpoint-1"}) {
    fs::create_directories(scratch.path() / name);
  }
  REQUIRE(store::DataDirectory::open_any(scratch.path()).has_value());
  CHECK_FALSE(fs::exists(scratch / "talus-staging"));
  CHECK_FALSE(fs::exists(scratch / "talus-checkpoint-3"));
  CHECK(fs::exists(scratch / "staging"));
  CHECK(fs::exists(scratch / "checkpoint-1"));
}

TEST_CASE("verify finds a chunk that differs from the hash, and coarse levels that differ from level 0") {
  const Data data;
  const auto store = store::ReadOnlyStore::open(data.path);
  ProgressBar progress{"", ""};
  auto figures = read_figures(**store, progress);
  REQUIRE(figures.has_value());
  CHECK(verify(**store, *figures).has_value());
  CHECK(figures->levels[1].voxels > 0);
  figures->levels[1].hash.add({1, 1, 1}, Override{3, MaterialId{2}});
  CHECK(verify(**store, *figures).error().find("level 1 does not match level 0") != std::string::npos);
  figures->levels[0].hash.add({1, 1, 1}, Override{3, MaterialId{2}});
  CHECK(verify(**store, *figures).error().find("its overrides hash to") != std::string::npos);
}

TEST_CASE("verify finds a store.toml of another world, and levels of another rule, as talusd's start does") {
  const Data data;
  store::StoreMeta meta = (*store::ReadOnlyStore::open(data.path))->meta();
  CHECK(store::check_opens(data.path, meta).has_value());
  meta.level_rule += 1;
  CHECK_THAT(store::check_opens(data.path, meta).error(), Catch::Contains("coarse levels were made by rule"));
  meta.level_rule -= 1;
  meta.fingerprint = {8, 9};
  CHECK_THAT(store::check_opens(data.path, meta).error(),
             Catch::Contains("the world with fingerprint 00000000000000090000000000000008"));
}

TEST_CASE("a compacted store is the same store") {
  const Data data;
  const auto before = store::ReadOnlyStore::open(data.path).value()->meta();
  REQUIRE(store::compact(data.path).has_value());
  CHECK(sound_head(data.path) == data.head);
  CHECK(store::ReadOnlyStore::open(data.path).value()->meta() == before);
}

TEST_CASE("a backup that does not fit on the disk is not begun") {
  const ScratchDirectory scratch;
  CHECK(store::check_space(scratch.path(), 1'000).has_value());
  const auto refused = store::check_space(scratch.path(), std::uint64_t{1} << 60U);
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().find("bytes free; 1152921504673955840 are needed") != std::string::npos);
}

}  // namespace talus::server
