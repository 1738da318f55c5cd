// Disks that are full, or fail for a while: edits wait, nothing is lost, nothing happens twice.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include <rocksdb/env.h>
#include <rocksdb/file_system.h>
#include <catch2/catch.hpp>

#include "edits_of_tests.h"
#include "runtime/manual_clock.h"
#include "scratch_directory.h"
#include "seed_of_run.h"
#include "unsafe_disk.h"

namespace talus::server {
namespace {

using namespace testing;
using edits::testing::Model;
using Kind = edits::EntryResult::Kind;

/// A store on a disk of the test's, and one editor.
struct Trouble {
  explicit Trouble(std::uint64_t seed)
      : random{seed},
        disk{std::make_shared<UnsafeDisk>(seed)},
        environment{environment_of(disk)},
        store{scratch / "edits"} {
    store.database_settings.env = environment.get();
    store.database_settings.memory.write_buffer_bytes = 64 << 10;
    store.log_settings.flush_interval = std::chrono::milliseconds{2};
    store.log_settings.retry_interval = std::chrono::milliseconds{5};
  }

  /// One edit, sent until it is decided.
  void edit(const std::function<void()>& on_failure) {
    const edits::Edit edit = random_edit(random);
    ++editor.sequence;
    std::optional<edits::EntryResult> applied;
    while (!(applied = store.apply(editor.entry(edit)))) {
      on_failure();
      std::this_thread::yield();  // until the log takes entries again
    }
    REQUIRE((applied->kind == Kind::done || applied->kind == Kind::repeat));
    REQUIRE(applied->result.changed == model.apply(edit).changed);
  }

  void check() {
    CHECK(overrides_of(store.state()) == model.overrides());
    CHECK(store.state().editor(editor.id)->last_sequence == editor.sequence);
  }

  ScratchDirectory scratch{ScratchDirectory::memory()};
  std::mt19937_64 random;
  std::shared_ptr<UnsafeDisk> disk;
  std::unique_ptr<rocksdb::Env> environment;
  EditStore store;
  TestEditor editor;
  Model model;
};

}  // namespace

TEST_CASE(
    "a disk that fills up, or does not sync, stops edits until it is repaired; no edit is lost or repeated") {
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  for (std::uint64_t round = 0; round < 12; ++round) {
    Trouble trouble{seed + round};
    REQUIRE(trouble.store.open() == "");
    trouble.editor.attach(trouble.store);
    int failures = 0;
    for (int i = 0; i < 300; ++i) {
      // Some are drawn; a round that has drawn none so far gets some at its end.
      if (trouble.random() % 50 == 0 || (failures == 0 && i >= 200 && i % 20 == 0)) {
        if (round % 2 == 0) {
          trouble.disk->fill_after(static_cast<std::int64_t>(trouble.random() % 3'000));
        } else {
          trouble.disk->fail_sync_after(static_cast<std::int64_t>(trouble.random() % 10));
        }
      }
      trouble.edit([&] {
        ++failures;
        trouble.disk->empty();
        trouble.disk->mend();
      });
    }
    CHECK(failures > 0);
    trouble.check();
    trouble.disk->empty();
    trouble.disk->mend();
    trouble.store.close();
    REQUIRE(trouble.store.open_without_log() == "");
    trouble.check();
  }
}

TEST_CASE("after a write that failed nothing reaches the log until the store is opened again") {
  const bool is_full = GENERATE(true, false);  // else it does not sync
  Trouble trouble{11};
  trouble.store.database_settings.log_elsewhere = is_full;
  REQUIRE(trouble.store.open_without_log() == "");
  store::EditDatabase& database = trouble.store.database();
  const auto append = [&] {
    const EditState::Reader reading{trouble.store.state()};
    edits::Batch batch{reading, trouble.store.state().editors(), trouble.store.state().head(), 1};
    batch.apply(edits::AttachEntry{trouble.editor.id, 1, ""});
    return database.append(batch);
  };
  is_full ? trouble.disk->fill_after(10) : trouble.disk->fail_sync_after(0);
  REQUIRE_FALSE(append());
  trouble.disk->empty();
  trouble.disk->mend();
  // RocksDB resumes by itself once there is space, on a thread of its own.
  for (int i = 0; i < 200; ++i) {
    const auto synced = database.sync_log();
    REQUIRE_FALSE(synced);
    CHECK_THAT(synced.error(), Catch::Contains("until the store is opened again"));
    REQUIRE_FALSE(append());
    REQUIRE_FALSE(database.settle());
    std::this_thread::yield();
  }
  REQUIRE(database.recover());
  REQUIRE(append());
  CHECK(database.sync_log());
}

TEST_CASE("a disk that fills up while another thread syncs the log ends neither the process nor the store") {
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  for (std::uint64_t round = 0; round < 40; ++round) {
    Trouble trouble{seed + round};
    trouble.store.database_settings.log_elsewhere = true;
    REQUIRE(trouble.store.open_without_log() == "");
    store::EditDatabase& database = trouble.store.database();
    EditState& state = trouble.store.state();
    std::atomic<bool> ends{false};
    std::thread syncer{[&] {
      while (!ends) (void)database.sync_log();
    }};
    const bool fills = round % 2 == 0;
    const auto after = static_cast<std::int64_t>(trouble.random() % (fills ? 100'000 : 60));
    fills ? trouble.disk->fill_after(after) : trouble.disk->fail_sync_after(after);
    const EditState::Reader reading{state};
    std::uint64_t appended = 0;
    for (store::EditDatabase::Status stored; stored; appended += stored ? 1 : 0) {
      edits::Batch batch{reading, state.editors(), state.head(), 1};
      batch.apply(edits::AttachEntry{{appended + 1, 1}, 1, std::string(200, 'x')});
      stored = database.append(batch);
      if (stored) (void)state.commit(std::move(batch));
    }
    ends = true;
    syncer.join();
    trouble.disk->empty();
    trouble.disk->mend();
    REQUIRE(database.recover());
    CHECK(database.meta().head.position == appended);
    CHECK(database.sync());
  }
}

TEST_CASE("a chunk is read from the disk only once it is there for sure") {
  Trouble trouble{5};
  trouble.store.state_settings.cache_bytes = 0;
  REQUIRE(trouble.store.open_without_log() == "");
  EditState& state = trouble.store.state();
  const auto stage = [&](edits::Batch& batch) {
    REQUIRE(trouble.store.database().append(batch));
    (void)state.commit(std::move(batch));
  };
  const EditState::Reader reading{state};
  edits::Batch batch{reading, state.editors(), state.head(), 1};
  batch.apply(edits::AttachEntry{trouble.editor.id, 1, ""});
  trouble.editor.epoch = trouble.editor.sequence = 1;
  edits::Edit edit;
  edit.writes.push_back({{1, 1, 1}, MaterialId{9}});
  batch.apply(trouble.editor.entry(edit));
  stage(batch);
  const ChunkKey key{{0, 0, 0}, Lod{}};
  Flusher flusher{state, trouble.store.database()};
  flusher.start();
  trouble.disk->fail_sync_after(0);
  REQUIRE_FALSE(flusher.step());  // it is put, and not synced
  REQUIRE(state.dirty(key) != nullptr);
  CHECK(state.load(key)->revision == 1);
  trouble.disk->mend();
  REQUIRE(trouble.store.database().recover());
  flusher.abandon();
  flusher.start();
  while (flusher.is_running()) REQUIRE(flusher.step());
  CHECK(state.dirty(key) == nullptr);
  CHECK(state.load(key)->revision == 1);
  CHECK(state.take_dirty_editors().empty());
}

TEST_CASE("a disk that stays full, and does not say so, is tried again until it is not") {
  Trouble trouble{3};
  REQUIRE(trouble.store.open() == "");
  trouble.editor.attach(trouble.store);
  for (int i = 0; i < 50; ++i) trouble.edit([] { FAIL("the disk is sound"); });
  trouble.disk->fill_after(10);
  trouble.edit([&] {
    const auto reason = trouble.store.log().status().read_only;
    if (!reason || reason->find("the database does not open") == std::string::npos) return;
    CHECK_THAT(*reason, Catch::Contains("its disk is full") && !Catch::Contains("restore a backup"));
    trouble.disk->empty();
  });
  trouble.check();
}

namespace {

/// A disk on which a directory with a name that ends in `stops_at` is made when resume() was called.
class SlowDisk final : public rocksdb::FileSystemWrapper {
 public:
  explicit SlowDisk(std::string stops_at)
      : FileSystemWrapper{rocksdb::FileSystem::Default()}, stops_at_{std::move(stops_at)} {}
  const char* Name() const override { return "SlowDisk"; }
  rocksdb::IOStatus CreateDir(const std::string& path, const rocksdb::IOOptions& options,
                              rocksdb::IODebugContext* debug) override {
    if (path.ends_with(stops_at_)) {
      std::unique_lock lock{mutex_};
      stopped_ = true;
      changed_.notify_all();
      // Longer only where somebody waits for it who must not.
      changed_.wait_for(lock, std::chrono::seconds{10}, [&] { return resumed_; });
    }
    return FileSystemWrapper::CreateDir(path, options, debug);
  }
  void wait_until_stopped() {
    std::unique_lock lock{mutex_};
    changed_.wait(lock, [&] { return stopped_; });
  }
  void resume() {
    const std::lock_guard lock{mutex_};
    resumed_ = true;
    changed_.notify_all();
  }

 private:
  const std::string stops_at_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool stopped_ = false;
  bool resumed_ = false;
};

}  // namespace

TEST_CASE("an end that the disk lost, and another log has, is read there by the next start, and reported") {
  bool lost = false;
  for (std::uint64_t seed = 1; seed <= 50 && !lost; ++seed) {
    Trouble trouble{seed};
    store::EditDatabaseSettings& settings = trouble.store.database_settings;
    settings.log_elsewhere = true;
    std::string told;
    settings.on_lost_end = [&](const std::string& what) { told = what; };
    REQUIRE(trouble.store.open_without_log() == "");
    store::EditDatabase& database = trouble.store.database();
    EditState& state = trouble.store.state();
    const EditState::Reader reading{state};
    const auto append = [&](std::uint64_t editor) {
      edits::Batch batch{reading, state.editors(), state.head(), 1};
      batch.apply(edits::AttachEntry{{editor, 1}, 1, ""});
      REQUIRE(database.append(batch, {editor, 1}));
      (void)state.commit(std::move(batch));
    };
    append(1);
    REQUIRE(database.sync());
    for (std::uint64_t editor = 2; editor < 20; ++editor) append(editor);
    trouble.disk->cut_after(0);
    REQUIRE_FALSE(database.sync());
    REQUIRE_FALSE(database.recover());
    CHECK(told.empty());
    trouble.disk->restart();
    const auto recovered = database.recover();
    if (recovered) continue;  // the disk had it all
    lost = true;
    CHECK(told == recovered.error());
    CHECK(told.find("a start of the server reads it again") != std::string::npos);
    trouble.store.close();
    REQUIRE(trouble.store.open_without_log() == "");
    CHECK(trouble.store.database().meta().stream.sequence < 19);
    CHECK(trouble.store.database().meta().stream.sequence > 0);
  }
  CHECK(lost);
}

TEST_CASE("reopening the database does not wait for a checkpoint, and chunks are read meanwhile") {
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  const auto disk = std::make_shared<SlowDisk>("copy.tmp");
  const auto environment = rocksdb::NewCompositeEnv(disk);
  EditStore store{scratch / "edits"};
  store.database_settings.env = environment.get();
  REQUIRE(store.open_without_log() == "");
  store::EditDatabase& database = store.database();
  store::EditDatabase::Status made;
  std::thread copier{[&] { made = database.checkpoint(scratch / "copy"); }};
  disk->wait_until_stopped();
  const auto refused = database.recover();
  CHECK_FALSE(refused.has_value());
  CHECK(database.chunk({{0, 0, 0}, Lod{}}).has_value());
  disk->resume();
  copier.join();
  CHECK(made.has_value());
  CHECK(database.recover().has_value());
}

TEST_CASE("a store whose files were deleted or replaced takes no edits until they are back") {
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  const std::filesystem::path data = scratch / "data";
  EditStore store{data};
  store.log_settings.retry_interval = std::chrono::milliseconds{5};
  REQUIRE(store.open_without_log() == "");
  std::ofstream{data / "lock"};
  store.open_log();
  TestEditor editor;
  editor.attach(store);
  std::mt19937_64 random{1};
  REQUIRE(editor.edit(store, random_edit(random)).has_value());
  const auto read_only = [&](bool wanted) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds{30};
    while (store.log().status().read_only.has_value() != wanted) {
      REQUIRE(std::chrono::steady_clock::now() < give_up);
      std::this_thread::yield();
    }
    return store.log().status().read_only.value_or("");
  };
  const std::string name = GENERATE("", "lock", "db", "db/CURRENT");
  const bool replaced = GENERATE(false, true);
  if (replaced && name == "db/CURRENT") return;  // RocksDB replaces it, too
  const std::filesystem::path place = name.empty() ? data : data / name;
  std::filesystem::rename(place, scratch / "away");
  if (replaced) std::filesystem::copy(scratch / "away", place, std::filesystem::copy_options::recursive);
  const std::string reason = read_only(true);
  CHECK_THAT(reason, Catch::Contains(data.string()) && Catch::Contains("was deleted or replaced"));
  CHECK(store.log().status().gone);
  CHECK_FALSE(editor.edit(store, random_edit(random)).has_value());
  std::filesystem::remove_all(place);
  std::filesystem::rename(scratch / "away", place);
  CHECK(read_only(false).empty());
  CHECK_FALSE(store.log().status().gone);
  CHECK(editor.edit(store, random_edit(random)).has_value());
  store.close();
  REQUIRE(store.open_without_log() == "");
  CHECK(store.state().editor(editor.id)->last_sequence == editor.sequence);
}

TEST_CASE("a write that the disk does not end for more than 5 s is named, until it ends") {
  ManualClock clock;
  Trouble trouble{1};
  trouble.store.clock = &clock;
  trouble.store.log_settings.flush_interval = std::chrono::hours{1};
  REQUIRE(trouble.store.open() == "");
  trouble.editor.attach(trouble.store);
  trouble.disk->hold_syncs(true);
  ++trouble.editor.sequence;
  const LogEntry entry = trouble.editor.entry(random_edit(trouble.random));
  std::thread waits{[&] { CHECK(trouble.store.apply(entry).has_value()); }};
  trouble.disk->await_held_sync();
  clock.advance(std::chrono::seconds{5});
  CHECK(trouble.store.log().status().disk_wait == "");
  clock.advance(std::chrono::seconds{1});
  CHECK_THAT(trouble.store.log().status().disk_wait,
             Catch::Contains("edits: a write has waited for the disk for over 5 s"));
  trouble.disk->hold_syncs(false);
  waits.join();
  CHECK(trouble.store.log().status().disk_wait == "");
}

TEST_CASE("with little free space edits are refused with the reason") {
  Trouble trouble{1};
  REQUIRE(trouble.store.open() == "");
  trouble.editor.attach(trouble.store);
  trouble.disk->say_free(200 << 20);
  while (!trouble.store.log().status().read_only) std::this_thread::yield();
  CHECK(trouble.store.log().status().read_only->find("209715200 bytes free") != std::string::npos);
  CHECK_FALSE(trouble.editor.edit(trouble.store, random_edit(trouble.random)).has_value());
  trouble.disk->say_free({});
  while (trouble.store.log().status().read_only) std::this_thread::yield();
  CHECK(trouble.editor.edit(trouble.store, random_edit(trouble.random)).has_value());
  trouble.store.close();
  trouble.disk->say_free(1 << 20);
  CHECK(trouble.store.open().find("1048576 bytes free; opening the store needs 67108864") !=
        std::string::npos);
}

TEST_CASE(
    "a disk that reads nothing is named, other chunks are edited, and once it reads again all is there") {
  Trouble trouble{7};
  REQUIRE(trouble.store.open() == "");
  trouble.editor.attach(trouble.store);
  for (int i = 0; i < 300; ++i) trouble.edit([] { FAIL("the disk is sound"); });
  trouble.store.close();
  trouble.store.state_settings.cache_bytes = 0;
  REQUIRE(trouble.store.open() == "");
  trouble.editor.attach(trouble.store);
  trouble.disk->fail_reads(true);
  const auto loaded = trouble.store.state().load({{0, 0, 0}, Lod{}});
  REQUIRE_FALSE(loaded.has_value());
  CHECK_THAT(loaded.error(), Catch::Contains("chunk (0, 0, 0)") && Catch::Contains(".sst") &&
                                 Catch::Contains("Input/output error; its disk fails: check it"));
  edits::Edit far;
  far.writes.push_back({{32'000, 0, 0}, MaterialId{1}});
  CHECK(trouble.editor.edit(trouble.store, far)->kind == Kind::done);
  CHECK_FALSE(trouble.store.log().status().read_only.has_value());
  trouble.disk->fail_reads(false);
  trouble.check();
}

TEST_CASE("a disk that reads nothing while tables are merged stops edits until it reads, and loses nothing") {
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  int failures = 0;
  for (std::uint64_t round = 0; round < 4 || failures == 0; ++round) {
    REQUIRE(round < 40);
    Trouble trouble{seed + round};
    REQUIRE(trouble.store.open() == "");
    trouble.editor.attach(trouble.store);
    for (int i = 0; i < 300; ++i) {
      if (trouble.random() % 20 == 0) trouble.disk->fail_reads(true);
      trouble.edit([&] {
        ++failures;
        if (const auto reason = trouble.store.log().status().read_only) {
          INFO(*reason);
          CHECK(reason->find("is lost") == std::string::npos);
        }
        trouble.disk->fail_reads(trouble.random() % 4 != 0);
      });
    }
    trouble.disk->fail_reads(false);
    trouble.check();
    trouble.store.close();
    REQUIRE(trouble.store.open_without_log() == "");
    trouble.check();
  }
}

}  // namespace talus::server
