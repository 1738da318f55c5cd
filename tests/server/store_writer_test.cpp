// A writer whose log is elsewhere, and so is synced by another thread: what becomes of syncs that fail, and
// of flushes that wait for them.
#include "edits/store_writer.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include <rocksdb/env.h>
#include <catch2/catch.hpp>

#include <talus/store/acknowledged_file.h>

#include "edits/log_syncer.h"
#include "edits/model.h"
#include "runtime/manual_clock.h"
#include "scratch_directory.h"
#include "unsafe_disk.h"

namespace talus::server {
namespace {

using namespace testing;
using namespace std::chrono_literals;

constexpr edits::EditorId kEditor{7, 9};

edits::EditEntry write_of(std::uint64_t sequence) {
  edits::EditEntry entry{kEditor, 1, sequence, {}, {}};
  entry.edit.writes.push_back({{static_cast<std::int64_t>(sequence), 1, 1}, MaterialId{9}});
  entry.base = edits::testing::base_of(entry.edit);
  return entry;
}

/// A store on a disk of the test's, with its writer; the test is the log's thread. One editor is attached.
struct WriterBench {
  explicit WriterBench(const StoreWriterSettings& how) : settings{how} {
    settings.free_bytes = 0;
    open();
    REQUIRE(store(edits::AttachEntry{kEditor, 1, "somebody"}));
  }
  ~WriterBench() { disk->hold_syncs(false); }

  void open() {
    store::EditDatabaseSettings of_database;
    of_database.path = scratch / "edits";
    of_database.env = environment.get();
    of_database.log_elsewhere = true;
    auto opened = store::EditDatabase::open(of_database);
    REQUIRE(opened.has_value());
    database = *std::move(opened);
    auto read = EditState::open(*database, {});
    REQUIRE(read.has_value());
    state = *std::move(read);
    writer.emplace(*database, *state, clock, settings, nullptr, [this] { woken = true; });
  }
  void cut_power() {
    disk->cut_after(0);
    writer.reset();
    state.reset();
    database.reset();
    disk->restart();
    open();
  }
  bool store(const LogEntry& entry) {
    edits::Batch& batch = writer->begin(1);
    std::visit([&](const auto& each) { batch.apply(each); }, entry);
    return writer->store({}, database->meta().stream);
  }
  void poll_until(const std::function<bool()>& holds) {
    const auto give_up = std::chrono::steady_clock::now() + 30s;
    for (;;) {
      writer->poll();
      if (holds()) return;
      if (std::chrono::steady_clock::now() > give_up) {
        FAIL("what is waited for does not come: " << writer->read_only().value_or("it writes"));
      }
      std::this_thread::yield();
    }
  }
  void await_end_of_sync() {
    const auto give_up = std::chrono::steady_clock::now() + 30s;
    while (!woken.exchange(false)) {
      REQUIRE(std::chrono::steady_clock::now() < give_up);
      std::this_thread::yield();
    }
  }
  [[nodiscard]] std::uint64_t head() const { return state->head().position; }
  [[nodiscard]] std::uint64_t acknowledged() const {
    const auto file = store::AcknowledgedFile::read(*environment, (scratch / "edits/acknowledged").string());
    return file && *file ? (*file)->position : 0;
  }
  [[nodiscard]] bool all_acknowledged() const { return acknowledged() == head(); }

  ScratchDirectory scratch{ScratchDirectory::memory()};
  std::shared_ptr<UnsafeDisk> disk = std::make_shared<UnsafeDisk>(1);
  std::unique_ptr<rocksdb::Env> environment = environment_of(disk);
  ManualClock clock;
  StoreWriterSettings settings;
  std::atomic<bool> woken{false};
  std::unique_ptr<store::EditDatabase> database;
  std::unique_ptr<EditState> state;
  std::optional<StoreWriter> writer;
};

StoreWriterSettings with_intervals(std::chrono::milliseconds flush, std::chrono::milliseconds retry) {
  StoreWriterSettings settings;
  settings.flush_interval = flush;
  settings.retry_interval = retry;
  return settings;
}

}  // namespace

TEST_CASE("a sync that fails stops the writer until the disk is mended, and what is synced then stays") {
  const bool ends_flush = GENERATE(false, true);  // else it is the periodic one
  const bool flushed_later = GENERATE(false, true);
  CAPTURE(ends_flush, flushed_later);
  WriterBench written{with_intervals(1h, 0ms)};
  REQUIRE(written.store(write_of(1)));
  if (ends_flush) {
    written.poll_until([&] { return written.all_acknowledged(); });
    written.disk->fail_sync_after(0);
    written.writer->flush_all();
    REQUIRE(written.writer->is_broken());
    CHECK(written.database->meta().flushed == 0);
  } else {
    written.disk->fail_sync_after(0);
    written.poll_until([&] { return written.writer->is_broken(); });
    CHECK(written.acknowledged() < written.head());
  }
  CHECK_THAT(written.writer->read_only().value(), Catch::Contains("the test's disk does not sync"));
  written.disk->mend();
  written.poll_until([&] { return !written.writer->is_read_only(); });
  REQUIRE(written.store(write_of(2)));
  if (flushed_later) {
    written.writer->flush_all();
    CHECK(written.database->meta().flushed == written.head());
  }
  REQUIRE(written.store(write_of(3)));
  written.poll_until([&] { return written.all_acknowledged(); });
  const edits::Head before = written.state->head();
  written.cut_power();
  CHECK(written.state->head() == before);
  CHECK(written.state->editor(kEditor)->last_sequence == 3);
}

TEST_CASE("a flush that a fault ended is not taken for synced by what it waited for then") {
  // Long enough that the first poll begins no periodic sync: with one the test shows less.
  WriterBench written{with_intervals(0ms, 300ms)};
  REQUIRE(written.store(write_of(1)));
  written.writer->poll();
  written.await_end_of_sync();
  written.disk->fill_after(0);
  REQUIRE_FALSE(written.store(write_of(2)));
  written.disk->empty();
  written.poll_until([&] { return !written.writer->is_broken(); });
  // All is put again, and nobody has heard of its sync yet.
  CHECK(written.database->meta().flushed == 0);
  written.poll_until([&] { return written.database->meta().flushed == written.head(); });
  const edits::Head before = written.state->head();
  written.cut_power();
  CHECK(written.state->head() == before);
  CHECK(written.state->editor(kEditor)->last_sequence == 2);
}

TEST_CASE("a waiter for a sync is woken when it ends") {
  WriterBench written{with_intervals(0ms, 1h)};
  REQUIRE(written.store(write_of(1)));
  written.writer->poll();
  CHECK(written.writer->next_poll() > std::chrono::steady_clock::now() + 30min);
  written.await_end_of_sync();
  written.writer->poll();
  CHECK(written.database->meta().flushed == written.head());
}

TEST_CASE("a sync that fails after the writer broke does not delay its next attempt") {
  WriterBench written{with_intervals(0ms, 1h)};
  REQUIRE(written.store(write_of(1)));
  written.disk->hold_syncs(true);
  written.writer->poll();
  written.disk->await_held_sync();
  written.disk->fill_after(0);
  REQUIRE_FALSE(written.store(write_of(2)));
  const auto due = written.writer->next_poll();
  const std::string reason = written.writer->read_only().value();
  written.disk->fail_sync_after(0);
  written.disk->hold_syncs(false);
  written.await_end_of_sync();
  written.writer->poll();
  CHECK(written.writer->next_poll() == due);
  CHECK(written.writer->read_only() == reason);
}

TEST_CASE("a sync that the disk does not end for more than 5 s is named, until it ends") {
  WriterBench written{with_intervals(1h, 0ms)};
  REQUIRE(written.store(write_of(1)));
  written.disk->hold_syncs(true);
  written.writer->poll();
  written.disk->await_held_sync();
  written.clock.advance(5s);
  CHECK(written.writer->status().disk_wait == "");
  written.clock.advance(2s);
  CHECK(written.writer->status().disk_wait ==
        "edits " + (written.scratch / "edits").string() +
            ": a write has waited for the disk for over 5 s; check the disk");
  written.disk->hold_syncs(false);
  written.await_end_of_sync();
  CHECK(written.writer->status().disk_wait == "");
}

TEST_CASE("errors of syncs that began before the database was opened again are not reported") {
  WriterBench written{with_intervals(1h, 1h)};
  LogSyncer syncer{*written.database, written.clock};
  written.disk->hold_syncs(true);
  REQUIRE(syncer.begin() == 1);
  written.disk->await_held_sync();
  syncer.forget_errors();
  REQUIRE(syncer.begin() == 2);
  written.disk->fail_sync_after(0);
  written.disk->hold_syncs(false);
  syncer.wait();
  const auto ended = syncer.take_ended();
  REQUIRE(ended.has_value());
  CHECK(ended->number == 2);
  CHECK_FALSE(ended->done.has_value());
  REQUIRE(syncer.begin() == 3);
  syncer.wait();
  syncer.forget_errors();
  CHECK_FALSE(syncer.take_ended().has_value());
}

}  // namespace talus::server
