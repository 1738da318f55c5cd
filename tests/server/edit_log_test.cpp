// The log of one machine: what it applies is stored, answered once, and there again after a stop.
#include <future>
#include <set>

#include <catch2/catch.hpp>

#include "edits_of_tests.h"
#include "scratch_directory.h"

namespace talus::server {
namespace {

using namespace testing;
using edits::testing::Model;
using Kind = edits::Applied::Kind;

/// Chunks of all levels, as the database has them.
std::map<ChunkKey, StoredChunk> stored_chunks(const EditDatabase& database) {
  std::map<ChunkKey, StoredChunk> chunks;
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
  std::mt19937_64 random{std::random_device{}()};
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

TEST_CASE("the log says whose an edit is: its editor's, or whom a game server names") {
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
  REQUIRE(store.database().for_each_record(0, [&](LogRecord record) {
    if (record.kind == Kind::done) subjects.push_back(record.subject);
    return true;
  }));
  CHECK(subjects == std::vector<std::string>{own, "bob"});
}

TEST_CASE("each chunk that a batch changed is told once, after the index has its revision") {
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

TEST_CASE("the queue is bounded, and whoever was taken is answered before the log stops") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  store.log_settings.queue_entries = 4;
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
  CHECK_FALSE(store.log().append(attach(6), [](const auto&) {}));
  let_go.set_value();
  store.log().stop();
  CHECK(answered == 4);
  CHECK_FALSE(store.log().append(attach(7), [](const auto&) {}));
}

TEST_CASE("where the index is full, chunks that were edited can be edited, and no others") {
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
  CHECK_FALSE(editor.edit(store, there).has_value());
  CHECK(editor.edit(store, here).has_value());
}

TEST_CASE("history is kept up to its bytes, and what is kept follows entry by entry") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  store.database_settings.history_bytes = 3 << 20;
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
  std::vector<std::uint64_t> positions;
  const auto collect = [&](LogRecord&& record) {
    positions.push_back(record.position);
    return true;
  };
  REQUIRE(store.database().for_each_record(1, collect));
  REQUIRE_FALSE(positions.empty());
  CHECK(positions.front() > 1);
  CHECK(positions.back() == 41);
  CHECK(positions.size() == positions.back() - positions.front() + 1);
}

}  // namespace talus::server
