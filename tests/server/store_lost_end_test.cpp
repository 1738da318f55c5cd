// A stopped store whose log lost its end is refused by all that would make another store of it.
#include <filesystem>
#include <map>
#include <random>

#include <catch2/catch.hpp>

#include <talus/store/acknowledged_file.h>
#include <talus/store/whole_store.h>

#include "commands/store/backup.h"
#include "commands/store/opened_store.h"
#include "commands/store/transfer.h"
#include "edits_of_tests.h"
#include "scratch_directory.h"

namespace talus::server {
namespace {

using namespace testing;
namespace fs = std::filesystem;

/// A data directory as it lies on the disk when talusd is killed: its edits are in RocksDB's log alone.
class KilledDirectory {
 public:
  KilledDirectory() {
    const auto directory = store::DataDirectory::open(scratch_ / "live", {1, 2});
    REQUIRE(directory.has_value());
    EditStore store{scratch_ / "live"};
    store.database_settings.store_id = directory->store_id();
    store.log_settings.flush_interval = std::chrono::hours{1};
    REQUIRE(store.open() == "");
    std::map<std::string, MaterialId> names;
    for (std::uint16_t id = 0; id < 5; ++id) names.emplace("material " + std::to_string(id), MaterialId{id});
    REQUIRE(store.database().name_generated(names).has_value());
    TestEditor editor;
    editor.attach(store);
    std::mt19937_64 random{7};
    for (int i = 0; i < 40; ++i) REQUIRE(editor.edit(store, random_edit(random)).has_value());
    fs::copy(scratch_ / "live", path(), fs::copy_options::recursive);
    head_ = store.log().status().head;
    store.close();
    const auto whole = store::ReadOnlyStore::open(scratch_ / "live");
    REQUIRE(whole.has_value());
    REQUIRE(export_edits(**whole, file()).has_value());
  }

  void lose_end() const {
    for (const auto& entry : fs::directory_iterator{path() / "db"}) {
      if (entry.path().extension() != ".log") continue;
      fs::resize_file(entry.path(), entry.file_size() - 1);
      return;
    }
    FAIL("the log is missing");
  }

  [[nodiscard]] fs::path path() const { return scratch_ / "killed"; }
  /// Of what the store held, exported.
  [[nodiscard]] fs::path file() const { return scratch_ / "file"; }
  [[nodiscard]] edits::Head head() const { return head_; }

  /// What a command says; nothing: it did what it does.
  [[nodiscard]] std::string backup() const {
    const auto opened = OpenedStore::open(path());
    if (!opened) return opened.error();
    const auto done = write_backup(opened->path(), scratch_ / "backup");
    return done ? "" : done.error();
  }
  [[nodiscard]] std::string export_again() const {
    const auto opened = OpenedStore::open(path());
    if (!opened) return opened.error();
    const auto done = export_edits(opened->store(), scratch_ / "again");
    return done ? "" : done.error();
  }
  [[nodiscard]] std::string import() const {
    const auto directory = store::DataDirectory::open_any(path());
    REQUIRE(directory.has_value());
    const auto done = import_edits(file(), *directory, Winner::file, 1'800'000'000'000);
    return done ? "" : done.error();
  }
  [[nodiscard]] std::string rebase() const {
    const auto directory = store::DataDirectory::open_store(path());
    REQUIRE(directory.has_value());
    const auto done = rebase_edits(*directory, terrain::default_world(), true);
    return done ? "" : done.error();
  }

  [[nodiscard]] std::string compact_it() const {
    const auto directory = store::DataDirectory::open_store(path());
    REQUIRE(directory.has_value());
    const auto done = store::compact(path());
    return done ? "" : done.error();
  }

 private:
  ScratchDirectory scratch_{ScratchDirectory::memory()};
  edits::Head head_;
};

constexpr std::array kCommands{&KilledDirectory::backup, &KilledDirectory::export_again,
                               &KilledDirectory::import, &KilledDirectory::rebase,
                               &KilledDirectory::compact_it};

}  // namespace

TEST_CASE("commands refuse a store whose log lost its end") {
  const KilledDirectory store;
  store.lose_end();
  for (const auto command : kCommands) {
    const std::string error = (store.*command)();
    CHECK_THAT(error, Catch::Contains("entries 41 to 41 of its log were acknowledged and are lost"));
  }
  CHECK_FALSE(fs::exists(store.path() / "replaced-1"));
  CHECK(store::AcknowledgedFile::read(*rocksdb::Env::Default(), (store.path() / "acknowledged").string())
            ->value()
            .position == store.head().position);
}

TEST_CASE(
    "a store whose talusd was killed is backed up, exported, imported into, rebased and compacted whole") {
  for (const auto command : kCommands) {
    const KilledDirectory store;
    CHECK((store.*command)() == "");
    const auto now = OpenedStore::open(store.path());
    REQUIRE(now.has_value());
    CHECK(now->store().meta().head.position == store.head().position);
  }
}

}  // namespace talus::server
