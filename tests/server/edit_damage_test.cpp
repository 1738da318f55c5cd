// What a disk can do to the store's files: each is refused in one line, or costs nothing.
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <system_error>

#include <catch2/catch.hpp>

#include <talus/store/read_only_store.h>
#include <talus/store/rocks.h>
#include <talus/store/store_identity.h>

#include "edits_of_tests.h"
#include "scratch_directory.h"
#include "seed_of_run.h"

namespace talus::server {
namespace {

using namespace testing;
namespace fs = std::filesystem;

constexpr int kEdits = 400;

/// A store as it lies on the disk when the process is killed: some of it in tables, the end in RocksDB's log.
class KilledStore {
 public:
  KilledStore() {
    EditStore store{scratch_ / "live"};
    store.database_settings.memory.write_buffer_bytes = 64 << 10;
    std::mt19937_64 random{7};
    REQUIRE(store.open() == "");
    TestEditor editor;
    editor.attach(store);
    for (int i = 0; i < kEdits; ++i) REQUIRE(editor.edit(store, random_edit(random)).has_value());
    store.close();
    store.log_settings.flush_interval = std::chrono::hours{1};
    REQUIRE(store.open() == "");
    editor.attach(store);
    for (int i = 0; i < kEdits; ++i) REQUIRE(editor.edit(store, random_edit(random)).has_value());
    // Of one moment: RocksDB writes its files anew meanwhile. Of one log, so that its end is the store's:
    // while RocksDB writes a table there are two.
    do {
      fs::remove_all(path());
      fs::create_directory(path());
      REQUIRE(store.database().checkpoint(path() / "db").has_value());
    } while (std::ranges::count_if(fs::directory_iterator{path() / "db"}, [](const auto& entry) {
               return entry.path().extension() == ".log";
             }) != 1);
    fs::copy(scratch_ / "live" / "acknowledged", scratch_ / "killed" / "acknowledged");
    voxels_ = overrides_of(store.state());
  }

  [[nodiscard]] fs::path path() const { return scratch_ / "killed"; }
  /// The largest file of the database with that ending.
  [[nodiscard]] fs::path file(const std::string& ending) const {
    fs::path largest;
    for (const auto& entry : fs::directory_iterator{path() / "db"}) {
      const std::string name = entry.path().filename();
      const bool has = name.ends_with(ending) || name.starts_with(ending);
      if (has && (largest.empty() || entry.file_size() > fs::file_size(largest))) largest = entry.path();
    }
    REQUIRE_FALSE(largest.empty());
    return largest;
  }

  /// The error, or nothing where all is there.
  std::string open() {
    EditStore store{path()};
    const std::string error = store.open_without_log();
    if (error.empty()) CHECK(overrides_of(store.state()) == voxels_);
    CHECK(error.find('\n') == std::string::npos);
    return error;
  }

 private:
  ScratchDirectory scratch_{ScratchDirectory::memory()};
  std::map<VoxelPos, MaterialId> voxels_;
};

void overwrite(const fs::path& path, std::uint64_t offset, const std::string& bytes) {
  std::fstream file{path, std::ios::in | std::ios::out | std::ios::binary};
  file.seekp(static_cast<std::streamoff>(offset));
  file << bytes;
}

void flip(const fs::path& path, std::uint64_t offset) {
  const std::string whole = read_whole(path);
  overwrite(path, offset, std::string(1, static_cast<char>(whole.at(offset) ^ 0x10)));
}

/// Reads all records of the log that the store keeps.
bool reads_history(const store::ReadOnlyStore& store) {
  return store.reader().for_each_record(store.meta(), 1, [](const auto&) { return true; }).has_value();
}

}  // namespace

TEST_CASE("a killed process loses nothing") {
  KilledStore store;
  CHECK(store.open() == "");
}

TEST_CASE("a log that lost its end is refused, and the entries that are lost are named") {
  KilledStore store;
  const fs::path log = store.file(".log");
  SECTION("one byte") {
    fs::resize_file(log, fs::file_size(log) - 1);
  }
  SECTION("half of it") {
    fs::resize_file(log, fs::file_size(log) / 2);
  }
  SECTION("all of it") {
    fs::resize_file(log, 0);
  }
  const std::string error = store.open();
  INFO(error);
  CHECK(error.find("to 802 of its log were acknowledged and are lost") != std::string::npos);
  CHECK(error.find("restore a backup, or delete") != std::string::npos);
  CHECK(error.find("as a store of a new id") != std::string::npos);
}

TEST_CASE("after the acknowledged file is deleted, the store opens with the rest, as another store") {
  KilledStore store;
  const fs::path log = store.file(".log");
  const store::EditDatabaseSettings settings = EditStore{store.path()}.database_settings;
  fs::remove(store.path() / "acknowledged");
  SECTION("one byte is lost") {
    fs::resize_file(log, fs::file_size(log) - 1);
  }
  SECTION("all of the log is lost") {
    fs::resize_file(log, 0);
  }
  const auto database = store::EditDatabase::open(settings);
  INFO((database ? std::string{} : database.error()));
  REQUIRE(database.has_value());
  const ContentHash now = (*database)->meta().store_id;
  CHECK(now != settings.store_id);
  CHECK(store::read_store_identity(store.path() / "store.toml") == store::StoreIdentity{now, {1, 2}});
}

TEST_CASE("a store that became another stays that") {
  KilledStore store;
  fs::remove(store.path() / "acknowledged");
  store::EditDatabaseSettings settings = EditStore{store.path()}.database_settings;
  {
    const auto database = store::EditDatabase::open(settings);
    REQUIRE(database.has_value());
    CHECK((*database)->meta().head.position == 802);
    settings.store_id = (*database)->meta().store_id;
  }
  {
    const auto again = store::EditDatabase::open(settings);
    REQUIRE(again.has_value());
    CHECK((*again)->meta().store_id == settings.store_id);
  }
  // The power was cut when store.toml had a new id and nothing else.
  fs::remove(store.path() / "acknowledged");
  settings.store_id = {5, 6};
  const auto interrupted = store::EditDatabase::open(settings);
  REQUIRE(interrupted.has_value());
  CHECK(store::read_store_identity(store.path() / "store.toml")->store_id == (*interrupted)->meta().store_id);
}

TEST_CASE("a torn record at the log's end, which was not acknowledged, is dropped") {
  KilledStore store;
  const fs::path log = store.file(".log");
  const std::uint64_t whole = fs::file_size(log);
  // A full fragment of 496 bytes.
  const std::string header{"\x12\x34\x56\x78\xf0\x01\x01", 7};
  std::string torn;
  SECTION("its end is zeros") {
    torn = header + std::string(100, 'x') + std::string(396, '\0');
  }
  SECTION("its beginning is zeros, and RocksDB passes over the rest of the block") {
    torn = std::string(107, '\0') + std::string(396, 'x');
  }
  SECTION("its file got its new length, and no page") {
    torn = std::string(100'000, '\0');
  }
  std::ofstream{log, std::ios::binary | std::ios::app} << torn;
  const auto dropped = [&] {
    const auto read = store::ReadOnlyStore::open(store.path());
    INFO((read ? "" : read.error()));
    REQUIRE(read.has_value());
    CHECK((*read)->meta().head.position == 802);
    return (*read)->dropped();
  };
  const std::string named = log.string() + " from byte " + std::to_string(whole) + " on was torn";
  CHECK((torn.front() == 0 || dropped().find(named) != std::string::npos));
  CHECK(store.open() == "");
  CHECK(dropped().empty());
}

TEST_CASE("a torn record at the manifest's end is dropped") {
  KilledStore store;
  const fs::path manifest = store.file("MANIFEST-");
  std::ofstream{manifest, std::ios::binary | std::ios::app}
      << std::string{"\x12\x34\x56\x78\x20\x00\x01", 7} + "x" + std::string(31, '\0');
  {
    const auto read = store::ReadOnlyStore::open(store.path());
    REQUIRE(read.has_value());
    CHECK((*read)->dropped().find(manifest.string()) != std::string::npos);
  }
  CHECK(store.open() == "");
}

TEST_CASE("damage in the middle of the log is named and refused, even if nothing is acknowledged") {
  KilledStore store;
  fs::remove(store.path() / "acknowledged");
  const fs::path log = store.file(".log");
  SECTION("a flipped bit") {
    flip(log, fs::file_size(log) / 2);
  }
  SECTION("a page of zeros") {
    overwrite(log, 8192, std::string(4096, '\0'));
  }
  SECTION("zeros from the beginning of a block on") {
    overwrite(log, 32'768, std::string(4096, '\0'));
  }
  for (int tries = 0; tries < 2; ++tries) {
    const std::string error = store.open();
    INFO(error);
    CHECK(error.find(log.string() + " from byte ") != std::string::npos);
    CHECK(error.find("restore a backup") != std::string::npos);
  }
}

TEST_CASE("a flipped bit in any file of a store is named at once, or everything is answered right") {
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  std::mt19937_64 random{seed};
  KilledStore store;
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  const char* const text = std::getenv("TALUS_FLIPS");
  for (int left = text == nullptr ? 20 : std::atoi(text); left > 0; --left) {
    const fs::path whole = scratch / "whole";
    fs::remove_all(whole);
    fs::copy(store.path(), whole, fs::copy_options::recursive);
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator{store.path()}) {
      if (entry.is_regular_file() && entry.file_size() > 0) files.push_back(entry.path());
    }
    std::ranges::sort(files);
    const fs::path& file = files[random() % files.size()];
    flip(file, random() % fs::file_size(file));
    CAPTURE(file);
    const auto names_file = [&](const std::string& error) {
      INFO(error);
      CHECK((error.find(file.filename()) != std::string::npos ||
             error.find("were acknowledged and are lost") != std::string::npos));
    };
    std::string damage;
    if (const auto read = store::ReadOnlyStore::open(store.path()); !read) {
      damage = read.error();
    } else if (const auto sound = (*read)->verify_files(); !sound) {
      damage = sound.error();
    }
    if (!damage.empty()) names_file(damage);
    if (const std::string error = store.open(); !error.empty()) {
      names_file(error);
    } else if (damage.empty()) {
      CHECK(reads_history(**store::ReadOnlyStore::open(store.path())));
    }
    fs::remove_all(store.path());
    fs::rename(whole, store.path());
  }
}

TEST_CASE("damage that the start does not read ends edits once it is met, with one reason, and reads go on") {
  KilledStore store;
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  const fs::path table = store.file(".sst");
  const fs::path whole = scratch / "whole";
  fs::copy(store.path(), whole, fs::copy_options::recursive);
  bool is_hidden = false;
  for (std::uint64_t at = fs::file_size(table) - 512; !is_hidden && at >= 512; at -= 512) {
    fs::remove_all(store.path());
    fs::copy(whole, store.path(), fs::copy_options::recursive);
    flip(table, at);
    const auto read = store::ReadOnlyStore::open(store.path());
    is_hidden =
        read && !reads_history(**read) && (*read)->for_each_chunk([](auto, const auto&) { return true; });
  }
  REQUIRE(is_hidden);
  EditStore running{store.path()};
  running.database_settings.memory.write_buffer_bytes = 64 << 10;
  running.log_settings.flush_interval = std::chrono::milliseconds{2};
  running.log_settings.retry_interval = std::chrono::milliseconds{1};
  REQUIRE(running.open() == "");
  TestEditor editor;
  const auto known = running.state().editor(editor.id);
  editor.epoch = known ? known->epoch + 1 : 1;
  // On a busy machine a compaction may have met the damage before, and this is refused.
  (void)running.apply(edits::AttachEntry{editor.id, editor.epoch, "somebody"});
  std::mt19937_64 random{7};
  const auto reason = [&] { return running.log().status().read_only; };
  for (int edits = 0; edits < 100'000 && !reason(); ++edits) (void)editor.edit(running, random_edit(random));
  REQUIRE(reason());
  const std::string why = *reason();
  INFO(why);
  CHECK(why.find(table.string()) != std::string::npos);
  CHECK(why.find(
            "all chunks and editors in that table can be read, and records of the log's history are lost") !=
        std::string::npos);
  CHECK(why.find("restore a backup") != std::string::npos);
  CHECK_FALSE(editor.edit(running, random_edit(random)).has_value());
  CHECK_FALSE(running.database().recover());
  CHECK(reason() == why);
  CHECK_FALSE(overrides_of(running.state()).empty());
}

TEST_CASE("damage in the log is refused") {
  KilledStore store;
  const fs::path log = store.file(".log");
  SECTION("a flipped bit in the middle") {
    flip(log, fs::file_size(log) / 2);
  }
  SECTION("a page at its end is zero") {
    overwrite(log, fs::file_size(log) - 4096, std::string(4096, '\0'));
  }
  SECTION("a flipped bit at the end") {
    flip(log, fs::file_size(log) - 2);
  }
  SECTION("a page of zeros in the middle") {
    overwrite(log, 8192, std::string(4096, '\0'));
  }
  SECTION("the file is gone") {
    fs::remove(log);
  }
  const std::string error = store.open();
  INFO(error);
  CHECK(error.starts_with("edits "));
  CHECK(error.find("restore a backup") != std::string::npos);
}

TEST_CASE("files of the database that are gone are refused, and no empty store is made in their place") {
  KilledStore store;
  SECTION("CURRENT") {
    fs::remove(store.path() / "db" / "CURRENT");
  }
  SECTION("the manifest") {
    fs::remove(store.file("MANIFEST-"));
  }
  SECTION("a table") {
    fs::remove(store.file(".sst"));
  }
  SECTION("all of it") {
    fs::remove_all(store.path() / "db");
  }
  const std::string error = store.open();
  INFO(error);
  CHECK(error.starts_with("edits "));
  CHECK(error.find("restore a backup") != std::string::npos);
}

TEST_CASE("a flipped bit in a table is refused") {
  KilledStore store;
  flip(store.file(".sst"), 100);
  CHECK(store.open().find("restore a backup") != std::string::npos);
}

TEST_CASE("the file of what was acknowledged may be gone, but not damaged") {
  KilledStore store;
  const fs::path file = store.path() / "acknowledged";
  SECTION("gone") {
    fs::remove(file);
    CHECK(store.open() == "");
  }
  SECTION("damaged") {
    flip(file, 3);
    CHECK(store.open().find("acknowledged: it is damaged") != std::string::npos);
  }
}

TEST_CASE("files of options that a kill left unfinished are deleted by the next start") {
  KilledStore store;
  const fs::path left = store.path() / "db" / "OPTIONS-000099.dbtmp";
  std::ofstream{left} << "[Version]";
  CHECK(store.open() == "");
  CHECK_FALSE(fs::exists(left));
}

TEST_CASE("what is no damage is no reason to restore a backup") {
  const auto advice = [](int error) {
    return std::string{store::remedy_for(rocksdb::Status::IOError("While open a file: /data/db/000008.sst",
                                                                  std::generic_category().message(error)))};
  };
  for (const int error : {EACCES, EPERM, EROFS}) CHECK_THAT(advice(error), Catch::Contains("read and write"));
  CHECK_THAT(advice(EMFILE), Catch::Contains("open files"));
  CHECK_THAT(advice(EDQUOT), Catch::Contains("quota"));
  CHECK_THAT(advice(EFBIG), Catch::Contains("file's size"));
  for (const int error : {EIO, ENXIO, ENODEV, ETIMEDOUT, ESTALE}) {
    CHECK_THAT(advice(error), Catch::StartsWith("its disk fails: check it"));
  }
  CHECK_THAT(advice(EINVAL), Catch::StartsWith("restore a backup"));
}

TEST_CASE("a directory that cannot be written is refused") {
  EditStore store{"/proc/edits"};
  const std::string error = store.open();
  INFO(error);
  CHECK(error.find("give --data a directory that talusd may write") != std::string::npos);
}

}  // namespace talus::server
