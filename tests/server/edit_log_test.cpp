// The log of one machine: what it applies is stored, answered once, and there again after a stop.
#include <atomic>
#include <filesystem>
#include <future>
#include <optional>
#include <set>

#include <catch2/catch.hpp>

#include "edits_of_tests.h"
#include "scratch_directory.h"
#include "seed_of_run.h"

namespace talus::server {
namespace {

using namespace testing;
using edits::testing::Model;
using Kind = edits::EntryResult::Kind;

/// Chunks of all levels, as the database has them.
std::map<ChunkKey, store::StoredChunk> stored_chunks(const store::EditDatabase& database) {
  std::map<ChunkKey, store::StoredChunk> chunks;
  REQUIRE(database.for_each_chunk([&](ChunkKey key, std::uint64_t) { chunks[key] = {}; }));
  for (auto& [key, chunk] : chunks) chunk = database.chunk(key).value().value();
  return chunks;
}

}  // namespace

TEST_CASE("a store that is opened again is as it was, and S is that of its chunks") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  store.log_settings.flush_interval = std::chrono::milliseconds{3};
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  Model model;
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  std::mt19937_64 random{seed};
  for (int i = 0; i < 500; ++i) {
    const edits::Edit edit = random_edit(random);
    const auto applied = editor.edit(store, edit);
    REQUIRE(applied.has_value());
    REQUIRE(applied->result.changed == model.apply(edit).changed);
  }
  store.log().stop();
  CHECK(overrides_of(store.state()) == model.overrides());
  const edits::Head head = store.state().head();
  const edits::Editor known = store.state().editor(editor.id).value();
  store.close();

  REQUIRE(store.open_without_log() == "");
  CHECK(store.database().meta().flushed == head.position);
  CHECK(store.state().head() == head);
  CHECK(store.state().revision() == head.revision);
  CHECK(store.state().editor(editor.id) == known);
  CHECK(known.last_sequence == 500);
  CHECK(overrides_of(store.state()) == model.overrides());
  edits::StateHash hash;
  for (const auto& [key, chunk] : stored_chunks(store.database())) {
    CHECK(store.state().revision(key) == chunk.revision);
    CHECK(store.state().edited_rows(key).contains(key.coord.y));
    if (key.lod == Lod{}) hash.add(key.coord, std::span{chunk.voxels});
  }
  CHECK(hash == head.hash);
}

TEST_CASE("an edit that is sent again is answered by what became of it, also after a stop") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  edits::Edit edit;
  edit.writes.push_back({{1, 2, 3}, MaterialId{77}});
  const auto first = editor.edit(store, edit).value();
  CHECK(first.kind == Kind::done);
  CHECK(first.result.changed == 1);
  store.close();
  REQUIRE(store.open() == "");
  editor.attach(store);
  const auto again = store.apply(editor.entry(edit)).value();
  CHECK(again.kind == Kind::repeat);
  CHECK(again.result == first.result);
  CHECK(store.state().revision() == 1);
  editor.epoch = 1;
  CHECK(store.apply(editor.entry(edit))->kind == Kind::expired);
}

TEST_CASE("the log names an edit's subject: its editor's, or the one that a game server names") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  edits::Edit edit;
  edit.writes.push_back({{1, 2, 3}, MaterialId{77}});
  REQUIRE(editor.edit(store, edit).has_value());
  edit.writes.front().voxel.x = 2;
  edits::EditEntry entry = editor.entry(edit);
  entry.sequence += 1;
  entry.subject = "bob";
  CHECK(store.apply(entry)->kind == Kind::done);
  const std::string own = store.state().editor(editor.id)->subject;
  store.close();
  REQUIRE(store.open_without_log() == "");
  std::vector<std::string> subjects;
  REQUIRE(store.database().for_each_record(0, [&](store::LogRecord record) {
    if (record.kind == Kind::done) subjects.push_back(record.subject);
    return true;
  }));
  CHECK(subjects == std::vector<std::string>{own, "bob"});
}

namespace {

/// A wall clock that jumps, of a machine that is suspended.
struct JumpingClock final : Clock {
  std::atomic<std::int64_t> jumped_s{0};
  std::atomic<std::int64_t> elapsed_s{0};
  std::atomic<std::int64_t> suspended_s{0};
  [[nodiscard]] time_point now() const override {
    return time_point{} + std::chrono::seconds{elapsed_s.load()};
  }
  [[nodiscard]] time_point uptime() const override {
    return now() + std::chrono::seconds{suspended_s.load()};
  }
  [[nodiscard]] std::chrono::sys_seconds wall() const override {
    return std::chrono::sys_seconds{
        std::chrono::seconds{1'700'000'000 + elapsed_s.load() + suspended_s.load() + jumped_s.load()}};
  }
  [[nodiscard]] std::chrono::nanoseconds thread_cpu() const override { return {}; }
};

}  // namespace

TEST_CASE("a clock that is ahead for a while dates no edits; one that stays there does") {
  constexpr std::int64_t kDay = 86'400;
  JumpingClock clock;
  BatchDates dates{clock};
  const auto date_s = [&] { return dates.now_ms() / 1'000 - 1'700'000'000; };
  clock.elapsed_s = 30;
  CHECK(date_s() == 30);
  clock.jumped_s = 60;  // as NTP may set it
  CHECK(date_s() == 90);
  CHECK(dates.jumps().count == 0);
  clock.jumped_s = kDay;
  CHECK(date_s() == 90);
  clock.elapsed_s += 500;
  CHECK(date_s() == 590);
  CHECK(dates.jumps().count == 1);
  CHECK(dates.jumps().last == std::chrono::seconds{kDay - 60});
  clock.jumped_s = 60;  // set right in time
  CHECK(date_s() == 590);
  clock.jumped_s = kDay;
  CHECK(date_s() == 590);
  clock.elapsed_s += 600;
  CHECK(date_s() == kDay + 1'130);
  CHECK(dates.jumps().count == 2);
}

TEST_CASE("a clock that was behind at a start and is set right in time dates no edits") {
  constexpr std::int64_t kLastS = 1'700'000'000;
  JumpingClock clock;
  clock.jumped_s = -2'580;
  BatchDates dates{clock};
  const auto after_last_s = [&] { return dates.after(kLastS * 1'000) / 1'000 - kLastS; };
  CHECK(after_last_s() == 0);
  CHECK(dates.jumps().count == 1);
  CHECK(dates.jumps().last == std::chrono::seconds{-2'580});
  clock.elapsed_s = 599;
  CHECK(after_last_s() == 0);
  clock.jumped_s = 0;
  for (const std::int64_t elapsed_s : {600, 1'198}) {
    clock.elapsed_s = elapsed_s;
    CHECK(after_last_s() == 0);
  }
  CHECK(dates.jumps().count == 2);
  clock.elapsed_s = 1'200;
  CHECK(after_last_s() == 1'200);
}

TEST_CASE("edits after the machine was suspended are dated by its clock at once") {
  JumpingClock clock;
  BatchDates dates{clock};
  clock.suspended_s = 28'800;
  CHECK(dates.now_ms() == 1'700'028'800'000);
  CHECK(dates.jumps().count == 0);
}

TEST_CASE("edits of a clock that was ahead do not date later edits, across restarts") {
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  EditStore store{scratch / "edits"};
  JumpingClock clock;
  std::optional<LocalLog> log;
  std::uint64_t editors = 0;
  const auto date_s = [&] {  // of an entry
    std::promise<void> done;
    REQUIRE(log->append(edits::AttachEntry{{++editors, 1}, 1, ""}, [&](const auto&) { done.set_value(); })
                .has_value());
    done.get_future().get();
    return log->status().head.time_ms / 1'000 - 1'700'000'000;
  };
  const auto restart = [&] {
    log.reset();
    store.close();
    REQUIRE(store.open_without_log() == "");
    log.emplace(store.database(), store.state(), clock, store.log_settings, nullptr);
  };
  restart();
  CHECK(date_s() == 0);
  clock.jumped_s = 31'536'000;
  CHECK(date_s() == 0);
  restart();
  CHECK(date_s() == 31'536'000);
  clock.jumped_s = 31'536'000 - 60;
  CHECK(date_s() == 31'536'000);  // a small step back is waited for
  restart();
  clock.jumped_s = 100;
  CHECK(date_s() == 31'536'000);  // this clock may be the wrong one
  clock.elapsed_s = 600;
  CHECK(date_s() == 700);
  restart();
  CHECK(date_s() == 700);
  log.reset();
}

TEST_CASE("each chunk that a batch changed is reported once, after the index has its revision") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  std::vector<ChunkChange> told;
  bool index_first = true;
  store.on_changed = [&](std::span<const ChunkChange> changes) {
    for (const ChunkChange& each : changes) {
      index_first = index_first && store.state().revision(each.key) == each.revision &&
                    store.state().load(each.key)->revision == each.revision;
      told.push_back(each);
    }
  };
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  edits::Edit edit;
  edit.fills.push_back({{30, 30, 30}, {33, 33, 33}, MaterialId{9}, {}});
  REQUIRE(editor.edit(store, edit)->result.changed == 64);
  store.close();
  CHECK(index_first);
  std::set<ChunkKey> keys;
  for (const ChunkChange& each : told) {
    CHECK(keys.insert(each.key).second);
    CHECK(each.previous == 0);
    CHECK(each.revision == 1);
  }
  CHECK(std::ranges::count(told, Lod{}, [](const ChunkChange& each) { return each.key.lod; }) == 8);
}

TEST_CASE("the queue is bounded, and accepted entries are answered before the log stops") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  store.log_settings.queue.entries = 4;
  REQUIRE(store.open() == "");
  std::promise<void> holds;
  std::promise<void> let_go;
  const auto attach = [](std::uint64_t id) { return edits::AttachEntry{{id, 1}, 1, ""}; };
  REQUIRE(store.log().append(attach(1), [&](const auto&) {
    holds.set_value();
    let_go.get_future().wait();
  }));
  holds.get_future().wait();
  int answered = 0;
  for (std::uint64_t id = 2; id < 6; ++id) {
    REQUIRE(store.log().append(attach(id),
                               [&](const auto& applied) { answered += applied.has_value() ? 1 : 0; }));
  }
  CHECK(store.log().status().waiting == 4);
  CHECK(store.log().append(attach(6), [](const auto&) {}).error().code == EditErrorCode::busy);
  let_go.set_value();
  store.log().stop();
  CHECK(answered == 4);
  CHECK_FALSE(store.log().append(attach(7), [](const auto&) {}).has_value());
}

TEST_CASE("if the index is full, only chunks that were edited before can be edited") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  store.state_settings.index_bytes = 1;
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  edits::Edit here;
  here.writes.push_back({{1, 1, 1}, MaterialId{9}});
  edits::Edit there;
  there.writes.push_back({{100, 1, 1}, MaterialId{9}});
  CHECK(editor.edit(store, here).has_value());
  CHECK(store.state().is_full());
  ++editor.sequence;
  const auto refused = store.log().append(editor.entry(there), [](const auto&) {});
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().code == EditErrorCode::index_full);
  CHECK(refused.error().message ==
        "the index of edited chunks is full (limit 1 bytes), and chunk (3, 0, 0) was never edited; edit "
        "chunks that were edited before");
  CHECK(editor.edit(store, here).has_value());

  // What only may slide into such a chunk does not hold up an edit, but nothing slides then.
  ++editor.sequence;
  edits::EditEntry settles = editor.entry(here);
  settles.edit.writes[0].material = MaterialId{10};
  settles.settles = std::make_shared<const edits::SettleRules>(edits::SettleRules{{MaterialId{10}, 160}});
  settles.touched = edits::touched_voxels(settles.edit).value();
  for (const auto& touched : edits::with_settling(settles.touched, edits::settle_box(settles.edit))) {
    settles.base[touched.chunk].clear();
    for (const std::uint16_t index : touched.voxels) settles.base[touched.chunk].push_back({index, kAir});
  }
  std::promise<std::uint32_t> changed;
  const auto taken = store.log().append(std::move(settles), [&](const auto& applied) {
    changed.set_value(applied ? (*applied)->result.changed : 0);
  });
  REQUIRE(taken.has_value());
  CHECK(changed.get_future().get() == 1);
  CHECK(store.state().index().chunks() == 1);
}

TEST_CASE("if the index is full, ore in a chunk that was never edited stays hidden") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  store.state_settings.index_bytes = 1;
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  edits::Edit dig;
  dig.writes.push_back({{0, 1, 1}, MaterialId{9}});
  CHECK(editor.edit(store, dig).has_value());
  REQUIRE(store.state().is_full());
  dig.writes[0].material = kAir;
  edits::EditEntry entry = editor.entry(dig);
  entry.sequence = ++editor.sequence;
  const auto index_of = [](LocalPos at) { return static_cast<std::uint16_t>(voxel_index(at)); };
  const std::uint16_t own = index_of({1, 1, 1});
  const std::uint16_t across = index_of({31, 1, 1});
  entry.secrets = {{kAir},
                   {{{0, 0, 0}, {{own, MaterialId{7}}}}, {{-1, 0, 0}, {{across, MaterialId{7}}}}},
                   {{{0, 0, 0}, {{own, MaterialId{2}}}}, {{-1, 0, 0}, {{across, MaterialId{2}}}}}};
  std::promise<std::uint32_t> changed;
  REQUIRE(store.log().append(std::move(entry), [&](const auto& applied) {
    changed.set_value(applied ? (*applied)->result.changed : 0);
  }));
  CHECK(changed.get_future().get() == 2);  // its own voxel, and the ore in the same chunk
  CHECK(store.state().index().chunks() == 1);
}

TEST_CASE("unflushed edits count as memory of edits, and are bounded if all are small") {
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  EditStore store{scratch / "edits"};
  store.log_settings.flush_interval = std::chrono::hours{1};
  store.log_settings.flush_bytes = 4'096;
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  std::size_t most = 0;
  for (std::int64_t x = 0; x < 300; ++x) {
    edits::Edit edit;
    edit.writes.push_back({{x * 32, 1, 1}, MaterialId{9}});
    REQUIRE(editor.edit(store, edit).has_value());
    most = std::max(most, store.state().dirty_bytes());
    if (x > 0) continue;
    // Nothing is flushed yet.
    CHECK(store.state().bytes() == store.state().index().bytes() + store.state_settings.recent_bytes +
                                       store.state().dirty_bytes() + store.state().editor_bytes());
  }
  CHECK(most > 0);
  CHECK(most <= 4 * 4'096 + 2'048);  // and one edit
}

TEST_CASE("history is kept up to its bytes, and what is kept follows entry by entry") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  store.database_settings.history.bytes = 3 << 20;
  store.log_settings.flush_interval = std::chrono::milliseconds{1};
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  // About 190 kB an entry: each voxel unlike its neighbours.
  edits::Edit edit;
  for (std::int64_t i = 0; i < 30'000; ++i) {
    edit.writes.push_back({{i % 32, i / 1024, i / 32 % 32}, MaterialId{}});
  }
  for (int i = 0; i < 40; ++i) {
    for (std::size_t at = 0; at < edit.writes.size(); ++at) {
      edit.writes[at].material =
          MaterialId{static_cast<std::uint16_t>(10 + (at + static_cast<std::size_t>(i)) % 7)};
    }
    REQUIRE(editor.edit(store, edit)->kind == Kind::done);
  }
  store.close();
  REQUIRE(store.open_without_log() == "");
  CHECK(store.database().history().bytes > 1 << 20);
  CHECK(store.database().history().bytes <= 3 << 20);
  CHECK(store.database().history().since_ms > 0);
  std::vector<std::uint64_t> positions;
  const auto collect = [&](store::LogRecord&& record) {
    positions.push_back(record.position);
    return true;
  };
  REQUIRE(store.database().for_each_record(1, collect));
  REQUIRE_FALSE(positions.empty());
  CHECK(positions.front() > 1);
  CHECK(positions.back() == 41);
  CHECK(positions.size() == positions.back() - positions.front() + 1);
}

TEST_CASE("edits of a chunk that cannot be read fail by its name, and the log goes on") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  store.state_settings.cache_bytes = 0;
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  const auto write = [](VoxelPos at, std::uint16_t material) {
    edits::Edit edit;
    edit.writes.push_back({at, MaterialId{material}});
    return edit;
  };
  const ChunkKey bad{{1, 0, 0}, Lod{}};
  const ChunkKey coarse{{4, 0, 0}, Lod::of(2)};
  REQUIRE(editor.edit(store, write({33, 1, 1}, 9)).has_value());
  REQUIRE(editor.edit(store, write({33, 1, 1}, 8)).has_value());
  REQUIRE(editor.edit(store, write({512, 2, 0}, 9)).has_value());  // a sample of level 2
  REQUIRE(editor.edit(store, write({512, 2, 0}, 8)).has_value());
  store.close();
  REQUIRE(store.open_without_log() == "");
  store::EditDatabase::Slice older;
  older.put(bad, 1, {});
  older.put(coarse, 1, {});
  REQUIRE(store.database().put(older));
  const auto unreadable = store.state().load(bad);
  REQUIRE_FALSE(unreadable.has_value());
  CHECK(unreadable.error() ==
        "chunk (1, 0, 0) at level of detail 0: the store has its edits up to revision 1, and 2 was "
        "acknowledged; "
        "restore a "
        "backup");
  store.open_log();

  std::promise<void> holds;
  std::promise<void> let_go;
  REQUIRE(store.log().append(edits::AttachEntry{{9, 9}, 1, ""}, [&](const auto&) {
    holds.set_value();
    let_go.get_future().wait();
  }));
  holds.get_future().wait();
  editor.epoch = store.state().editor(editor.id)->epoch;
  std::vector<std::string> answers(4);
  const std::vector edits{write({0, 0, 0}, 7), write({34, 1, 1}, 7), write({508, 2, 4}, 7),
                          write({544, 1, 1}, 7)};
  for (std::size_t i = 0; i < edits.size(); ++i) {
    ++editor.sequence;
    REQUIRE(store.log().append(editor.entry(edits[i]), [&, i](const auto& outcome) {
      answers[i] = outcome ? "done" : outcome.error().message;
      if (!outcome) CHECK(outcome.error().code == EditErrorCode::unreadable);
    }));
  }
  let_go.set_value();
  const auto after = editor.edit(store, write({1, 0, 0}, 7));
  CHECK(answers[0] == "done");
  CHECK(answers[1].starts_with("chunk (1, 0, 0) at level of detail 0: "));
  CHECK(answers[2] == "done");  // another chunk of level 2
  CHECK(answers[3] == "done");
  CHECK(after->kind == Kind::done);
  editor.sequence += 1;
  const auto sample = store.apply(editor.entry(write({516, 2, 0}, 7)));
  CHECK_FALSE(sample.has_value());
  CHECK_FALSE(store.log().status().read_only.has_value());
  CHECK(store.state().head().revision == 4 + 4);
}

TEST_CASE("the oldest editors that never edited make room first, and a reopened store agrees") {
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  EditStore store{scratch / "live"};
  store.log_settings.queue.entries = 100'000;
  store.log_settings.flush_interval = std::chrono::milliseconds{1};
  REQUIRE(store.open() == "");
  std::atomic<int> full{0};
  const auto attach = [&](std::uint64_t id) {
    REQUIRE(store.log().append(edits::AttachEntry{{id, 1}, 1, "s"}, [&](const auto& applied) {
      if ((*applied)->kind == Kind::editors_full) ++full;
    }));
  };
  for (std::uint64_t id = 1; id <= edits::kMaxEditors; ++id) attach(id);
  const auto uses = [&](std::uint64_t id) {
    return store.apply(edits::EditEntry{{id, 1}, 1, 1, {}, {}})->kind;
  };
  CHECK(uses(1) == Kind::done);
  CHECK(uses(3) == Kind::done);
  store.close();
  store.log_settings.flush_interval = std::chrono::hours{1};
  REQUIRE(store.open() == "");
  for (std::uint64_t id = 70'000; id < 70'004; ++id) attach(id);
  CHECK(uses(1) == Kind::repeat);  // it is still there
  CHECK(full == 0);
  CHECK(store.state().editor_count() == edits::kMaxEditors);
  const auto known = store.state().editors().all();
  std::filesystem::copy(scratch / "live", scratch / "killed", std::filesystem::copy_options::recursive);
  EditStore again{scratch / "killed"};
  REQUIRE(again.open_without_log() == "");
  CHECK(again.state().editors().all() == known);
  for (const std::uint64_t id : {1, 3, 70'000, 70'003}) CHECK(again.state().editor({id, 1}).has_value());
}

}  // namespace talus::server
