// What those see of edits who serve chunks.
#include <array>
#include <atomic>
#include <map>
#include <optional>
#include <set>
#include <thread>

#include <catch2/catch.hpp>

#include "edits/chunk_index.h"
#include "edits/recent_changes.h"
#include "edits_of_tests.h"
#include "scratch_directory.h"

namespace talus::server {
namespace {

using namespace testing;

constexpr ChunkKey kChunk{{0, 0, 0}, Lod{}};

edits::Edit write(VoxelPos at, std::uint16_t material) {
  edits::Edit edit;
  edit.writes.push_back({at, MaterialId{material}});
  return edit;
}

}  // namespace

TEST_CASE("the index knows revisions and rows of edited chunks, and nothing of others") {
  ChunkIndex index;
  const ChunkKey key{{5, -3, 7}, Lod::of(2)};
  CHECK(index.revision(key) == 0);
  CHECK(index.rows(key).size() == 0);
  CHECK(index.raise(key, {4}) == 0);
  CHECK(index.raise(key, {9}) == 4);
  CHECK(index.raise(key, {6}) == 9);
  CHECK(index.revision(key) == 9);
  CHECK(index.raise({{5, 11, 7}, Lod::of(2)}, {10}) == 0);
  CHECK(index.rows(key) == ChunkRange{-3, 11});
  CHECK(index.revision({{5, 0, 7}, Lod::of(2)}) == 0);
  CHECK(index.revision({{5, -3, 7}, Lod::of(1)}) == 0);
  CHECK(index.rows({{6, -3, 7}, Lod::of(2)}).size() == 0);
  CHECK(index.chunks() == 2);
  CHECK(index.bytes() == ChunkIndex::kColumnBytes + 2 * ChunkIndex::kChunkBytes);
}

TEST_CASE(
    "a chunk far from all others takes the most of the index that is said, where its voxels are samples of "
    "all levels") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  const auto edit = [&](std::int64_t far) {
    edits::Edit all;
    all.fills.push_back({{far, 0, far}, {far + 31, 31, far + 31}, MaterialId{3}, std::nullopt});
    REQUIRE(editor.edit(store, all).has_value());
  };
  edit(0);
  const std::size_t first = store.state().index().bytes();
  edit(std::int64_t{1} << 24U);
  CHECK(store.state().index().bytes() - first <= ChunkIndex::kMaxBytesEach);
  CHECK(first >= ChunkIndex::kMaxBytesEach / 7 * 5);  // nearly all levels
}

TEST_CASE("the cache of edited chunks gives way, a little at a time, and what it lost is read again") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  for (std::int64_t chunk = 0; chunk < 50; ++chunk) {
    edits::Edit fill;
    fill.fills.push_back({{chunk * 32, 0, 0}, {chunk * 32 + 7, 7, 7}, MaterialId{9}, std::nullopt});
    REQUIRE(editor.edit(store, fill).has_value());
  }
  store.close();  // then all is in the database
  REQUIRE(store.open() == "");
  for (std::int32_t chunk = 0; chunk < 50; ++chunk) {
    CHECK(store.state().load({{chunk, 0, 0}, Lod{}})->overrides->size() == 512);
  }
  CHECK(store.state().cache_bytes() > 50 * 512);
  store.state().set_cache_capacity(0);
  while (!store.state().fit_cache()) {
  }
  CHECK(store.state().cache_bytes() == 0);
  CHECK(store.state().load({{7, 0, 0}, Lod{}})->overrides->size() == 512);
  store.state().set_cache_capacity(SIZE_MAX);  // never more than the settings say
  CHECK(store.state().fit_cache());
}

TEST_CASE("the index tells which columns of a region were edited") {
  ChunkIndex index;
  const auto edit = [&](std::int32_t x, std::int32_t z, std::uint64_t revision) {
    const ChunkKey key{{x, 4, z}, Lod::of(1)};
    (void)index.raise(key, {revision});
    index.raise_column(key, revision);
  };
  edit(-1, -32, 3);
  edit(-32, -1, 5);
  edit(-1, -32, 4);
  edit(0, -32, 6);  // of the next region
  CHECK(index.edited_columns({{-7, 99, -9}, Lod::of(1)}) == std::vector<EditedColumn>{{31, 4}, {31 * 32, 5}});
  CHECK(index.edited_columns({{31, 0, -1}, Lod::of(1)}) == std::vector<EditedColumn>{{0, 6}});
  CHECK(index.edited_columns({{-7, 0, -9}, Lod{}}).empty());
  CHECK(index.column_revision({{-1, -5, -32}, Lod::of(1)}) == 4);
  CHECK(index.column_revision({{-2, 4, -32}, Lod::of(1)}) == 0);
  // A column is raised by itself: after the chunks of its edit.
  CHECK(index.raise({{-1, 4, -32}, Lod::of(1)}, {7}) == 4);
  CHECK(index.column_revision({{-1, 4, -32}, Lod::of(1)}) == 4);
}

TEST_CASE("the index finds the edited chunks of a box, in the columns that are wanted") {
  ChunkIndex index;
  std::uint64_t revision = 0;
  const auto edit = [&](ChunkKey key) {
    index.raise(key, {++revision});
    index.raise_column(key, revision);
    return key;
  };
  const Lod lod = Lod::of(2);
  const ChunkKey low = edit({{-33, -5, 40}, lod});  // corners of the box, in two regions
  const ChunkKey high = edit({{3, 5, 70}, lod});
  const ChunkKey above = edit({{-33, 5, 40}, lod});
  edit({{-33, 6, 40}, lod});
  edit({{-34, 0, 40}, lod});
  edit({{3, 0, 71}, lod});
  edit({{-10, 0, 50}, lod});  // in the hole
  edit({{0, 0, 50}, Lod{}});  // of another level
  const LevelBox box{lod, {-33, 3}, {-5, 5}, {40, 70}, {-10, -10}, {50, 50}};
  const auto found = [&](const ColumnFilter& wanted) {
    std::vector<ChunkKey> chunks;
    index.edited_chunks(box, wanted, chunks);
    return std::set<ChunkKey>(chunks.begin(), chunks.end());
  };
  CHECK(found([](ChunkKey) { return true; }) == std::set{low, above, high});
  CHECK(found([](ChunkKey column) { return column.coord.x == 3; }) == std::set{high});
  const ChunkKey not_yet = {{0, 0, 60}, lod};
  index.raise(not_yet, {++revision});  // its edit has not raised its column
  CHECK_FALSE(found([](ChunkKey) { return true; }).contains(not_yet));
}

TEST_CASE("after a column's revision is visible, all chunks of that edit are, with their voxels") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  constexpr std::int32_t kRows = 64;
  std::atomic<bool> done = false;
  std::size_t torn = 0;
  std::thread reader{[&] {
    while (!done) {
      const std::uint64_t revision = store.state().index().column_revision(kChunk);
      for (std::int32_t y = 0; y < kRows; ++y) torn += store.state().revision({{0, y, 0}, Lod{}}) < revision;
      const auto chunk = store.state().load(kChunk);
      torn += !chunk || chunk->revision < revision;
    }
  }};
  for (std::uint16_t i = 0; i < 300; ++i) {
    edits::Edit edit;
    for (std::int32_t y = 0; y < kRows; ++y) {
      edit.writes.push_back(
          {{1, std::int64_t{y} * 32 + 1, 1}, MaterialId{static_cast<std::uint16_t>(7 + i)}});
    }
    (void)editor.edit(store, edit);
  }
  done = true;
  reader.join();
  CHECK(torn == 0);
  CHECK(store.state().index().column_revision(kChunk) == 300);
}

namespace {

/// Recent changes, and what the index says of their chunks.
class ChangesBench {
 public:
  explicit ChangesBench(std::size_t bytes) : recent_{bytes} {}
  void add(ChunkKey key, std::uint64_t revision, const std::vector<Override>& voxels) {
    ChunkIndex::ChunkEntry& edited = edited_[key];
    const auto number = recent_.next();
    const auto count = static_cast<std::uint32_t>(voxels.size());
    if (count > 0) {
      recent_.add(std::array{RecentChanges::Change{key, edited.revision, revision, edited.change, count}},
                  voxels);
    }
    edited = {revision, count > 0 ? number : edited.change};
  }
  [[nodiscard]] std::optional<AppliedEdits::Changes> since(ChunkKey key, std::uint64_t since,
                                                           std::size_t most = 10) {
    return recent_.since(key, edited_[key], since, most);
  }

 private:
  RecentChanges recent_;
  std::map<ChunkKey, ChunkIndex::ChunkEntry> edited_;
};

}  // namespace

TEST_CASE("changes since a revision are each voxel once, as it is now") {
  ChangesBench recent{1 << 20};
  recent.add(kChunk, 3, {});  // of another start
  recent.add(kChunk, 5, {{7, MaterialId{1}}, {9, MaterialId{1}}});
  recent.add(kChunk, 8, {{8, MaterialId{2}}, {9, MaterialId{2}}});
  const auto all = recent.since(kChunk, 3);
  REQUIRE(all.has_value());
  CHECK(all->revision == 8);
  CHECK(all->voxels == std::vector<Override>{{7, MaterialId{1}}, {8, MaterialId{2}}, {9, MaterialId{2}}});
  CHECK(recent.since(kChunk, 4)->voxels.size() == 3);
  CHECK(recent.since(kChunk, 5)->voxels.size() == 2);
  CHECK(recent.since(kChunk, 8)->voxels.empty());
  CHECK_FALSE(recent.since(kChunk, 2).has_value());
  CHECK_FALSE(recent.since(kChunk, 3, 2).has_value());
  CHECK(recent.since({{1, 0, 0}, Lod{}}, 3)->voxels.empty());  // never edited
  // A change that is not known hides those before it.
  recent.add(kChunk, 9, {});
  CHECK_FALSE(recent.since(kChunk, 5).has_value());
  recent.add(kChunk, 10, {{1, MaterialId{3}}});
  CHECK_FALSE(recent.since(kChunk, 8).has_value());
  CHECK(recent.since(kChunk, 9)->voxels.size() == 1);
}

TEST_CASE("the oldest recent changes are dropped, and the others keep their voxels") {
  ChangesBench recent{1'000};
  const auto chunk = [](std::uint64_t number) {
    return ChunkKey{{static_cast<std::int32_t>(number % 3), 0, 0}, Lod{}};
  };
  for (std::uint64_t revision = 1; revision <= 100; ++revision) {
    const auto now = MaterialId{static_cast<std::uint16_t>(revision)};
    std::vector<Override> voxels{{1, now}};
    if (revision % 2 == 0) voxels.push_back({2, now});
    recent.add(chunk(revision), revision, voxels);
  }
  const auto material = [](std::uint16_t of) { return MaterialId{of}; };
  CHECK(recent.since(chunk(100), 97)->voxels ==
        std::vector<Override>{{1, material(100)}, {2, material(100)}});
  CHECK(recent.since(chunk(99), 96)->voxels == std::vector<Override>{{1, material(99)}});
  // Both voxels of 98 are newer than the one of 95.
  CHECK(recent.since(chunk(98), 94)->voxels == std::vector<Override>{{1, material(98)}, {2, material(98)}});
  CHECK_FALSE(recent.since(chunk(100), 70).has_value());
}

TEST_CASE("edits are seen at every level, in changes and chunks, and what is put back leaves the revision") {
  const ScratchDirectory scratch;
  EditStore store{scratch / "edits"};
  store.log_settings.flush_interval = std::chrono::milliseconds{1};
  store.state_settings.cache_bytes = 0;  // the database answers
  REQUIRE(store.open() == "");
  TestEditor editor;
  editor.attach(store);
  const VoxelPos at{0, 1, 0};  // the sample of level 1's voxel (0, 0, 0)
  const ChunkKey coarse{{0, 0, 0}, Lod::of(1)};
  REQUIRE(editor.edit(store, write(at, 9)).has_value());
  for (const ChunkKey key : {kChunk, coarse}) {
    CHECK(store.state().revision(key) == 1);
    CHECK(store.state().load(key)->overrides->size() == 1);
    CHECK(store.state().changes_since(key, 0, 10)->voxels.size() == 1);
    CHECK(store.state().changes_since(key, 1, 10)->voxels.empty());
  }
  CHECK(store.state().edited_rows({{0, 77, 0}, Lod{}}) == ChunkRange{0, 0});
  const auto base = to_integer(edits::testing::base_at(at));
  REQUIRE(editor.edit(store, write(at, base)).has_value());
  CHECK(store.state().load(kChunk)->overrides == nullptr);
  CHECK(store.state().revision(kChunk) == 2);
  CHECK(store.state().changes_since(kChunk, 1, 10)->voxels ==
        std::vector<Override>{{1024, MaterialId{base}}});
  CHECK_FALSE(store.state().changes_since(coarse, 1, 10).has_value());
  store.close();
  REQUIRE(store.open() == "");
  CHECK(store.state().load(kChunk)->revision == 2);
  CHECK(store.state().load(kChunk)->overrides == nullptr);
  CHECK_FALSE(store.state().changes_since(kChunk, 1, 10).has_value());
}

}  // namespace talus::server
