// Rollback against the plainest model: each voxel's own list of changes.
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <vector>

#include <fmt/format.h>
#include <rocksdb/db.h>
#include <catch2/catch.hpp>

#include <talus/store/read_only_store.h>
#include <talus/store/rocks.h>

#include "commands/store/history.h"
#include "commands/store/local_writer.h"
#include "commands/store/rollback.h"
#include "commands/store/transfer.h"
#include "edits_of_tests.h"
#include "scratch_directory.h"
#include "seed_of_run.h"

namespace talus::server {
namespace {

using namespace testing;
namespace fs = std::filesystem;
using edits::testing::base_at;
using edits::testing::Model;

struct Change {
  std::string subject;
  bool counts = false;  // it was since the time that is asked for
  MaterialId before{};
  MaterialId after{};
};
using Changes = std::map<VoxelPos, std::vector<Change>>;

/// What the voxel shall be: what it was before the subject's last changes in a row.
MaterialId rolled_back(const std::vector<Change>& changes, const std::string& subject) {
  MaterialId material = changes.back().after;
  for (auto change = changes.rbegin(); change != changes.rend(); ++change) {
    if (change->subject != subject || !change->counts) break;
    material = change->before;
  }
  return material;
}

VoxelPos at_index(ChunkCoord chunk, std::uint16_t index) {
  const VoxelPos at = chunk_origin(chunk);
  return {at.x + index % 32, at.y + index / 1024, at.z + index / 32 % 32};
}

/// A store under edits of several people.
struct GriefedStore {
  explicit GriefedStore(std::uint64_t seed) : random{seed}, store{scratch / "edits"} {
    REQUIRE(store.open() == "");
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      editors[i].id = {i + 1, 77};
      const auto attached = store.apply(edits::AttachEntry{editors[i].id, 1, subjects[i]});
      REQUIRE(attached->kind == edits::EntryResult::Kind::attached);
      editors[i].epoch = 1;
    }
  }

  void edit(int count, bool counts) {
    for (int i = 0; i < count; ++i) {
      const std::size_t who = random() % subjects.size();
      edits::Edit edit = random_edit(random);
      if (random() % 8 == 0) {
        const VoxelPos first{static_cast<std::int64_t>(random() % 40) - 20, -3, -3};
        edit.fills.push_back({first, {first.x + 5, 2, 2}, MaterialId{3}, std::nullopt});
      }
      const auto applied = editors[who].edit(store, edit);
      REQUIRE(applied.has_value());
      for (const edits::ChunkChanges& chunk : applied->changes) {
        for (const edits::VoxelChange& voxel : chunk.voxels) {
          changes[at_index(chunk.chunk, voxel.index)].push_back(
              {subjects[who], counts, voxel.before, voxel.after});
        }
      }
    }
  }
  /// The log's time from now on is later than all before.
  std::int64_t next_moment() {
    const std::int64_t last = store.log().status().head.time_ms;
    const SystemClock clock;
    const auto now = [&] {
      return std::chrono::duration_cast<std::chrono::milliseconds>(clock.wall().time_since_epoch()).count();
    };
    std::int64_t moment = now();
    while (moment <= last) moment = now();
    return moment;
  }
  [[nodiscard]] std::map<VoxelPos, MaterialId> expected(const RollbackRequest& request) const {
    std::map<VoxelPos, MaterialId> voxels;
    for (const auto& [at, list] : changes) {
      const bool inside = at.x >= request.first.x && at.x <= request.last.x && at.y >= request.first.y &&
                          at.y <= request.last.y && at.z >= request.first.z && at.z <= request.last.z;
      const MaterialId material = inside ? rolled_back(list, request.subject) : list.back().after;
      if (material != base_at(at)) voxels.emplace(at, material);
    }
    return voxels;
  }

  ScratchDirectory scratch{ScratchDirectory::memory()};
  std::mt19937_64 random;
  EditStore store;
  std::array<std::string, 3> subjects{"griefer", "builder", ""};
  std::array<TestEditor, 3> editors;
  Changes changes;
};

RollbackPlan plan_of(const GriefedStore& griefed, const RollbackRequest& request) {
  ProgressBar progress{"", ""};
  const auto opened = store::ReadOnlyStore::open(griefed.scratch / "edits");
  REQUIRE(opened.has_value());
  auto plan = plan_rollback(**opened, request, progress);
  REQUIRE(plan.has_value());
  return *std::move(plan);
}

std::uint64_t roll_back_locally(const GriefedStore& griefed, const RollbackPlan& plan) {
  ProgressBar progress{"", ""};
  auto writer = LocalWriter::open(griefed.scratch / "edits", {{3, 4}, {1, 2}});
  REQUIRE(writer.has_value());
  const auto changed = roll_back(
      plan, [&](const auto& slice) { return (*writer)->restore(slice); }, progress);
  REQUIRE(changed.has_value());
  return *changed;
}

}  // namespace

TEST_CASE("a rollback undoes a subject's last changes, and leaves other subjects' work") {
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  for (std::uint64_t round = 0; round < 8; ++round) {
    GriefedStore griefed{seed + round};
    griefed.edit(150, false);
    const std::int64_t since = griefed.next_moment();
    griefed.edit(250, true);
    const RollbackRequest request{griefed.subjects[round % 3], since, {-60, -8, -8}, {30, 2, 3}};
    griefed.store.close();
    const RollbackPlan plan = plan_of(griefed, request);
    CHECK(plan.voxels > 0);
    CHECK(roll_back_locally(griefed, plan) == plan.voxels);
    REQUIRE(griefed.store.open_without_log() == "");
    CHECK(overrides_of(griefed.store.state()) == griefed.expected(request));
    griefed.store.close();
    // What was put back is not the subject's any more.
    const RollbackPlan again = plan_of(griefed, request);
    CHECK(again.voxels == 0);
    CHECK(again.already_back == plan.voxels);
    CHECK(again.taken_over == plan.taken_over);
  }
}

TEST_CASE(
    "if the subject has no changes since then, a rollback names the subjects that do, the busiest first") {
  GriefedStore griefed{11};
  const auto write = [&](std::size_t who, std::int64_t x) {
    edits::Edit edit;
    edit.writes.push_back({{x, 1, 1}, MaterialId{256}});
    edit.writes.push_back({{x, 1, 2}, MaterialId{256}});
    REQUIRE(griefed.editors[who].edit(griefed.store, edit).has_value());
  };
  write(2, 1);  // before
  const std::int64_t since = griefed.next_moment();
  write(0, 2);
  write(1, 3);
  write(1, 4);
  write(2, 99);  // elsewhere
  griefed.store.close();
  const VoxelPos first{0, 0, 0};
  const VoxelPos last{10, 2, 2};
  const RollbackPlan plan = plan_of(griefed, {"grefer", since, first, last});
  CHECK_FALSE(plan.met_subject);
  REQUIRE(plan.others.size() == 2);
  CHECK(plan.others[0].subject == "builder");
  CHECK(plan.others[0].voxels == 4);
  CHECK(plan.others[1].subject == "griefer");
  CHECK(plan.others[1].voxels == 2);
  CHECK(plan_of(griefed, {"griefer", since, first, last}).met_subject);
  CHECK_FALSE(plan_of(griefed, {"", since, first, last}).met_subject);
  CHECK(plan_of(griefed, {"", 0, first, last}).met_subject);
}

TEST_CASE("chunks that were rolled back have no place in a store that is made of an export") {
  GriefedStore griefed{7};
  const std::int64_t since = griefed.next_moment();
  const auto write = [&](std::size_t who, std::int64_t x) {
    edits::Edit edit;
    edit.writes.push_back({{x, 1, 1}, MaterialId{256}});
    REQUIRE(griefed.editors[who].edit(griefed.store, edit).has_value());
  };
  write(1, 40);
  for (std::int64_t x = 1'000; x < 1'320; x += 32) write(0, x);
  griefed.store.close();
  REQUIRE(griefed.store.open_without_log() == "");
  REQUIRE(griefed.store.database().bind({{"brick", MaterialId{256}}}));  // an export names what it has
  griefed.store.close();
  const auto chunks_of = [](const fs::path& path) {
    const auto store = store::ReadOnlyStore::open(path);
    REQUIRE(store.has_value());
    std::vector<ChunkKey> keys;
    REQUIRE((*store)->reader().for_each_chunk([&](ChunkKey key, std::uint64_t) { keys.push_back(key); }));
    return keys;
  };
  const fs::path before = griefed.scratch / "edits";
  const auto plan = plan_of(griefed, {"griefer", since, {-2'000, -20, -20}, {2'000, 20, 20}});
  CHECK(roll_back_locally(griefed, plan) == 10);
  // Whoever asks this store is told revisions that never fall.
  CHECK(chunks_of(before).size() >= 11);
  const auto store = store::ReadOnlyStore::open(before);
  REQUIRE(store.has_value());
  REQUIRE(export_edits(**store, griefed.scratch / "file").has_value());
  const auto directory = store::DataDirectory::open_any(griefed.scratch / "new");
  REQUIRE(directory.has_value());
  const auto imported = import_edits(griefed.scratch / "file", *directory, Winner::file, 1'800'000'000'000);
  REQUIRE(imported.has_value());
  CHECK_FALSE(imported->store_id == (*store)->meta().store_id);
  const auto after = chunks_of(griefed.scratch / "new");
  CHECK(std::ranges::count(after, Lod{}, &ChunkKey::lod) == 1);
  CHECK(std::ranges::find(after, ChunkKey{{1, 0, 0}, Lod{}}) != after.end());
}

TEST_CASE("a voxel that changes between a rollback's plan and its edits stays") {
  GriefedStore griefed{5};
  const std::int64_t since = griefed.next_moment();
  griefed.edit(100, true);
  griefed.store.close();
  const RollbackRequest request{"griefer", since, {-200, -20, -20}, {200, 20, 20}};
  const RollbackPlan plan = plan_of(griefed, request);
  REQUIRE(plan.voxels > 1);
  const edits::ChunkChanges& chunk = plan.slices.front().front();
  const VoxelPos at = at_index(chunk.chunk, chunk.voxels.front().index);
  REQUIRE(griefed.store.open() == "");
  edits::Edit edit;
  edit.writes.push_back({at, MaterialId{9}});
  ++griefed.editors[1].sequence;
  REQUIRE(griefed.store.apply(griefed.editors[1].entry(edit))->result.changed == 1);
  griefed.store.close();
  CHECK(roll_back_locally(griefed, plan) == plan.voxels - 1);
  REQUIRE(griefed.store.open_without_log() == "");
  CHECK(overrides_of(griefed.store.state()).at(at) == MaterialId{9});
}

TEST_CASE("a voxel's history names subjects, materials before and after, and its own start") {
  GriefedStore griefed{9};
  griefed.edit(200, false);
  griefed.store.close();
  const auto opened = store::ReadOnlyStore::open(griefed.scratch / "edits");
  REQUIRE(opened.has_value());
  ProgressBar progress{"", ""};
  const auto changes_of = [&](VoxelPos at) {
    std::vector<VoxelHistory> changes;
    REQUIRE(history_of(
        **opened, at, [&](const VoxelHistory& change) { changes.push_back(change); }, progress));
    return changes;
  };
  std::size_t compared = 0;
  for (const auto& [at, list] : griefed.changes) {
    if (++compared > 60) break;
    const auto changes = changes_of(at);
    REQUIRE(changes.size() == list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      CHECK(changes[i].subject == list[i].subject);
      CHECK(changes[i].before == list[i].before);
      CHECK(changes[i].after == list[i].after);
    }
  }
  CHECK(changes_of({5'000, 5, 5}).empty());
  const auto kept = kept_records(**opened);
  REQUIRE(kept.has_value());
  CHECK(kept->first == 1);
  CHECK(kept->last == (*opened)->meta().head.position);
}

TEST_CASE(
    "a subject's history has each of its edits once, page by page, with the box around what it changed") {
  GriefedStore griefed{11};
  griefed.edit(100, true);
  const std::int64_t since = griefed.next_moment();
  griefed.edit(100, true);
  griefed.store.close();
  const auto opened = store::ReadOnlyStore::open(griefed.scratch / "edits");
  REQUIRE(opened.has_value());
  std::map<std::uint64_t, std::vector<VoxelPos>> expected;  // by position
  std::uint64_t before_since = 0;
  REQUIRE((*opened)->reader().for_each_record((*opened)->meta(), 1, [&](store::LogRecord&& record) {
    if (record.time_ms < since) before_since = record.position;
    if (record.subject != "griefer") return true;
    for (const auto& [chunk, voxels] : record.changes) {
      for (const auto& voxel : voxels) expected[record.position].push_back(at_index(chunk, voxel.index));
    }
    return true;
  }));
  REQUIRE(expected.size() > 10);
  REQUIRE(expected.begin()->first <= before_since);
  ProgressBar progress{"", ""};
  const auto read = [&](std::int64_t since_ms, std::size_t most) {
    std::vector<SubjectEdit> all;
    SubjectQuery query{"griefer", since_ms, 0, most};
    for (;;) {
      const std::size_t before = all.size();
      const auto page = subject_history(
          **opened, query, [&](const SubjectEdit& edit) { all.push_back(edit); }, progress);
      REQUIRE(page.has_value());
      CHECK(page->met);
      CHECK(page->others.empty());
      CHECK(page->listed == all.size() - before);
      CHECK(page->listed <= most);
      if (!page->more) return all;
      REQUIRE(page->listed == most);
      REQUIRE(page->last_position == all.back().position);
      query.after = page->last_position;
    }
  };
  for (const std::size_t most : {std::size_t{1}, std::size_t{7}, expected.size(), std::size_t{100'000}}) {
    CAPTURE(most);
    const auto all = read(0, most);
    REQUIRE(all.size() == expected.size());
    auto edit = all.begin();
    for (const auto& [position, voxels] : expected) {
      CHECK(edit->position == position);
      CHECK(edit->voxels == voxels.size());
      VoxelPos first = voxels.front();
      VoxelPos last = first;
      for (const VoxelPos& at : voxels) {
        first = {std::min(first.x, at.x), std::min(first.y, at.y), std::min(first.z, at.z)};
        last = {std::max(last.x, at.x), std::max(last.y, at.y), std::max(last.z, at.z)};
      }
      CHECK(edit->first == first);
      CHECK(edit->last == last);
      ++edit;
    }
  }
  const auto later =
      static_cast<std::size_t>(std::distance(expected.upper_bound(before_since), expected.end()));
  REQUIRE(later > 0);
  CHECK(read(since, 7).size() == later);
  const auto nobody = subject_history(
      **opened, SubjectQuery{"nobody"}, [](const SubjectEdit&) { FAIL(); }, progress);
  REQUIRE(nobody.has_value());
  CHECK(nobody->listed == 0);
  CHECK_FALSE(nobody->more);
  CHECK_FALSE(nobody->met);
  REQUIRE(nobody->others.size() > 1);
  CHECK(std::ranges::is_sorted(nobody->others, std::ranges::greater{},
                               &std::pair<std::string, std::uint64_t>::second));
  CHECK(std::ranges::find(nobody->others, std::pair{std::string{"griefer"},
                                                    std::uint64_t{expected.size()}}) != nobody->others.end());
}

TEST_CASE("a record that is missing in the middle, or at the end, is damage and no shorter history") {
  GriefedStore griefed{9};
  griefed.edit(50, true);
  griefed.store.close();
  const std::uint64_t lost = GENERATE(20, 53);
  const fs::path path = griefed.scratch / "edits";
  {
    rocksdb::DB* opened = nullptr;
    REQUIRE(rocksdb::DB::Open(store::rocks_options({}, false), (path / "db").string(), &opened).ok());
    const std::unique_ptr<rocksdb::DB> db{opened};
    std::string record;
    REQUIRE(db->Get({}, store::log_key(lost), &record).ok());
    REQUIRE(db->Delete({}, store::log_key(lost)).ok());
  }
  const auto store = store::ReadOnlyStore::open(path);
  REQUIRE(store.has_value());
  ProgressBar progress{"", ""};
  const std::string damage = fmt::format("entry {} of its log is damaged or lost", lost);
  const auto history = history_of(
      **store, griefed.changes.begin()->first, [](const VoxelHistory&) {}, progress);
  REQUIRE_FALSE(history.has_value());
  CHECK_THAT(history.error(), Catch::Contains(damage));
  const auto plan = plan_rollback(**store, {"griefer", 0, {-60, -8, -8}, {30, 2, 3}}, progress);
  REQUIRE_FALSE(plan.has_value());
  CHECK_THAT(plan.error(), Catch::Contains(damage));
}

TEST_CASE("history that was dropped is said to be, and the rest is still whole") {
  ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  store.database_settings.history.bytes = 0;
  store.log_settings.flush_interval = std::chrono::milliseconds{1};
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  std::mt19937_64 random{1};
  for (int i = 0; i < 50; ++i) REQUIRE(editor.edit(store, random_edit(random)).has_value());
  store.close();
  const auto opened = store::ReadOnlyStore::open(scratch / "edits");
  REQUIRE(opened.has_value());
  CHECK((*opened)->first_record() > 1);
  const auto kept = kept_records(**opened);
  REQUIRE(kept.has_value());
  CHECK(kept->first == (*opened)->first_record());
}

TEST_CASE("edits before the time stay, even if a clock that was ahead dated them later") {
  Rollback rollback{{"a", 1'000, {0, 0, 0}, {1'000, 31, 31}}};
  store::LogRecord record;
  record.kind = edits::EntryResult::Kind::done;
  record.subject = "a";
  std::int32_t x = 0;
  for (const std::int64_t time_ms : {9'000, 900, 1'100}) {
    record.time_ms = time_ms;
    record.changes = {{{x++, 0, 0}, {{0, MaterialId{1}, MaterialId{2}, MaterialId{1}}}}};
    REQUIRE(rollback.add(record));
  }
  const auto slices = rollback.slices();
  REQUIRE(slices.size() == 1);
  REQUIRE(slices[0].size() == 1);
  CHECK(slices[0][0].chunk == ChunkCoord{2, 0, 0});
  CHECK(rollback.date_fell_to_ms() == 900);
}

TEST_CASE("slices are within the bounds of an edit") {
  Rollback rollback{{"a", 0, {-1'000, -1'000, -1'000}, {100'000, 1'000, 1'000}}};
  store::LogRecord record;
  record.kind = edits::EntryResult::Kind::done;
  record.subject = "a";
  for (std::int32_t x = 0; x < 200; ++x) {
    record.changes = {{{x, 0, 0}, {}}};
    const std::uint16_t many = x % 50 == 0 ? 32'768 : 3;
    for (std::uint16_t i = 0; i < many; ++i) {
      record.changes[0].voxels.push_back({i, MaterialId{1}, MaterialId{2}, MaterialId{1}});
    }
    REQUIRE(rollback.add(record));
  }
  std::size_t voxels = 0;
  for (const auto& slice : rollback.slices()) {
    CHECK(slice.size() <= edits::kMaxChunks);
    std::size_t of_slice = 0;
    for (const edits::ChunkChanges& chunk : slice) of_slice += chunk.voxels.size();
    CHECK(of_slice <= Restorer::kMaxVoxels);
    voxels += of_slice;
  }
  CHECK(voxels == rollback.voxels());
  CHECK(voxels == 4 * 32'768 + 196 * 3);
}

}  // namespace talus::server
