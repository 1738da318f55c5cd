// Chunks with their edits, before base chunks of a real world and of a fake one.
#include "edits/edited_chunks.h"

#include <catch2/catch.hpp>
#include <map>
#include <memory>
#include <mutex>

#include <talus/terrain/world.h>
#include <talus/voxel/codec.h>

#include "chunks/generation/terrain_generator.h"
#include "fake_generator.h"

using namespace talus;
using namespace talus::server;

namespace {

/// Edits that a test makes.
class FakeEdits final : public AppliedEdits {
 public:
  std::function<void()> in_load{};  // called before overrides are looked up
  bool load_fails = false;

  void edit(ChunkKey key, std::vector<Override> voxels) {
    const std::lock_guard lock{mutex_};
    chunks_[key] = {++last_revision_, std::make_shared<const edits::ChunkOverrides>(std::move(voxels))};
  }
  void undo(ChunkKey key) {
    const std::lock_guard lock{mutex_};
    chunks_[key] = {++last_revision_, nullptr};
  }
  [[nodiscard]] int loads() const { return loads_; }

  [[nodiscard]] std::uint64_t revision(ChunkKey key) const override {
    const std::lock_guard lock{mutex_};
    const auto found = chunks_.find(key);
    return found == chunks_.end() ? 0 : found->second.revision;
  }
  [[nodiscard]] ChunkRange edited_rows(ChunkKey key) const override {
    const std::lock_guard lock{mutex_};
    ChunkRange rows;
    for (const auto& [at, chunk] : chunks_) {
      if (column_of(at) != column_of(key)) continue;
      rows = rows.size() == 0 ? ChunkRange{at.coord.y, at.coord.y}
                              : ChunkRange{std::min<std::int64_t>(rows.first, at.coord.y),
                                           std::max<std::int64_t>(rows.last, at.coord.y)};
    }
    return rows;
  }
  [[nodiscard]] tl::expected<EditedChunk, std::string> load(ChunkKey key) const override {
    if (in_load) in_load();
    if (load_fails) return tl::make_unexpected(std::string{"the disk is gone"});
    const std::lock_guard lock{mutex_};
    ++loads_;
    return chunks_.at(key);
  }
  [[nodiscard]] std::optional<Changes> changes_since(ChunkKey key, std::uint64_t,
                                                     std::size_t) const override {
    return Changes{revision(key), {{7, MaterialId{5}}}};
  }

 private:
  mutable std::mutex mutex_;
  std::map<ChunkKey, EditedChunk> chunks_;
  std::uint64_t last_revision_ = 0;
  mutable int loads_ = 0;
};

struct Edited {
  FakeEdits edits;
  Logger log = std::make_shared<spdlog::logger>("silent");
  Metrics metrics;
  MemoryBudget memory{0};
  ManualClock clock;
  ChangeFeed feed{log};
  MergedChunks merged{edits, log};
  BaseChunks base;
  EditedChunks chunks{base, edits, merged, feed, metrics};
  WaitingClient client;

  explicit Edited(std::unique_ptr<const Generator> generator, std::size_t merged_bytes = 1 << 20,
                  std::size_t queue_chunks = 1000)
      : base{std::move(generator),
             {.threads = 1,
              .patch_tiles = 2,
              .queue_chunks = queue_chunks,
              .chunk_cache_bytes = 8 << 20,
              .patch_cache_bytes = 8 << 20,
              .own_chunks = 0,
              .merged_cache_bytes = merged_bytes},
             log,
             metrics,
             memory,
             clock,
             &merged} {
    base.start();
  }

  ChunkAnswer ask(ChunkSource& source, WaitingClient& who, ChunkKey key) {
    REQUIRE(source.submit(who.mailbox(), {&key, 1}, Urgency::later) == 1);
    who.await(who.answers().size() + 1);
    REQUIRE(who.answers().back().first == key);
    return who.answers().back().second;
  }
  EncodedChunkPtr get(ChunkKey key) { return ask(chunks, client, key).value(); }
};

/// Of a real world.
struct Bench : Edited {
  explicit Bench(std::size_t merged_bytes = 1 << 20)
      : Edited{std::make_unique<TerrainGenerator>(world(), 2), merged_bytes} {}

  static std::shared_ptr<const terrain::World> world() {
    static const auto one = std::make_shared<const terrain::World>(terrain::default_world());
    return one;
  }
  EncodedChunkPtr as_generated(ChunkKey key) {
    if (EncodedChunkPtr chunk = base.find(key)) return chunk;
    WaitingClient other;
    return ask(base, other, key).value();
  }
  /// A chunk of the key's column in which the ground lies.
  ChunkKey with_ground(ChunkKey key) {
    (void)as_generated(key);
    const MixedRows rows = base.column(key);
    REQUIRE(rows.first <= rows.last);
    key.coord.y = rows.first;
    return key;
  }
};

struct Fake : Edited {
  std::shared_ptr<FakeWork> work;
  explicit Fake(std::shared_ptr<FakeWork> of = std::make_shared<FakeWork>())
      : Edited{std::make_unique<FakeGenerator>(of), 1 << 20, 1}, work{std::move(of)} {}
  ~Fake() { work->open_gate(); }
};

Chunk decoded(const EncodedChunkPtr& chunk) {
  return decode(chunk->payload()).value();
}

std::uint64_t revision_in_frame(const EncodedChunk& chunk) {
  std::vector<std::byte> frame;
  chunk.append_frame(frame, 1, {});
  return (*protocol::read_message(frame))->body_as_Chunk()->revision();
}

constexpr ChunkKey kColumn{{3, 2, -5}, Lod{}};
const std::vector<Override> kSome{{0, MaterialId{2}}, {17, kAir}, {30'000, MaterialId{3}}};

}  // namespace

TEST_CASE("what was not edited is the base chunk, found and generated as without edits") {
  Bench bench;
  bench.edits.edit({{9, 9, 9}, Lod{}}, kSome);
  const EncodedChunkPtr chunk = bench.get(kColumn);
  CHECK(chunk == bench.base.find(kColumn));
  CHECK(bench.chunks.find(kColumn) == chunk);
  CHECK(bench.chunks.revision(kColumn) == kBaseRevision);
  CHECK(bench.edits.loads() == 0);
}

TEST_CASE("an edited chunk is the base with its overrides, encoded with its revision") {
  const auto lod = Lod::of(GENERATE(0, 2));
  Bench bench;
  const ChunkKey key = bench.with_ground({kColumn.coord, lod});
  bench.edits.edit(key, {});
  bench.edits.edit(key, kSome);
  CHECK(bench.chunks.find(key) == nullptr);  // not merged yet
  const EncodedChunkPtr chunk = bench.get(key);
  const Chunk expected = decoded(bench.as_generated(key)).with_overrides(kSome);
  CHECK(decoded(chunk) == expected);
  CHECK(chunk->hash() == content_hash(expected));
  CHECK(chunk->hash() != bench.as_generated(key)->hash());
  CHECK(revision_in_frame(*chunk) == 2);
  CHECK(bench.chunks.find(key) == chunk);
}

TEST_CASE("a chunk is merged once a revision") {
  Bench bench;
  const ChunkKey key = bench.with_ground(kColumn);
  bench.edits.edit(key, kSome);
  const EncodedChunkPtr first = bench.get(key);
  WaitingClient other;
  CHECK(bench.ask(bench.chunks, other, key).value() == first);
  CHECK(bench.edits.loads() == 1);
  bench.edits.edit(key, {{1, MaterialId{3}}});
  CHECK(bench.chunks.find(key) == nullptr);
  CHECK(bench.get(key)->revision() == 2);
  CHECK(bench.edits.loads() == 2);
}

TEST_CASE("a chunk whose last override went is as generated, and keeps its revision") {
  Bench bench;
  const ChunkKey key = bench.with_ground(kColumn);
  bench.edits.edit(key, kSome);
  bench.edits.undo(key);
  const EncodedChunkPtr chunk = bench.get(key);
  CHECK(chunk->revision() == 2);
  CHECK(chunk->hash() == bench.as_generated(key)->hash());
  CHECK(chunk->uniform() == bench.as_generated(key)->uniform());
}

TEST_CASE("who asks the base has the chunk as generated, also beside who sees edits") {
  Fake fake;
  fake.edits.edit(kColumn, {});
  fake.work->close_gate();
  WaitingClient web;
  REQUIRE(fake.base.submit(web.mailbox(), {&kColumn, 1}, Urgency::later) == 1);
  REQUIRE(fake.chunks.submit(fake.client.mailbox(), {&kColumn, 1}, Urgency::later) == 1);
  fake.edits.undo(kColumn);  // with overrides the fake's chunk would have to decode
  fake.work->open_gate();
  web.await(1);
  fake.client.await(1);
  CHECK(web.answers()[0].second.value()->revision() == kBaseRevision);
  CHECK(fake.client.answers()[0].second.value()->revision() == 2);
  CHECK(fake.work->chunks == 1);
  CHECK(fake.base.find(kColumn)->revision() == kBaseRevision);
}

TEST_CASE("no patch is made for an edited chunk whose base is known without") {
  Bench bench;
  const ChunkKey sky{{3, 10'000, -5}, Lod{}};
  const ChunkKey deep{{3, -10'000, -5}, Lod{}};
  for (const ChunkKey key : {sky, deep}) {
    bench.edits.edit(key, {{5, MaterialId{3}}});
    const EncodedChunkPtr chunk = bench.get(key);
    CHECK(chunk->revision() > 0);
    CHECK(decoded(chunk).at({5, 0, 0}) == MaterialId{3});
    CHECK(decoded(chunk).at({6, 0, 0}) == decoded(bench.base.find(key)).at({6, 0, 0}));
  }
  CHECK(bench.metrics.patches_made.total() == 0);
  CHECK(bench.metrics.chunks_made.total() == 0);
}

TEST_CASE("nor for one whose base is in memory") {
  Bench bench;
  const ChunkKey key = bench.with_ground(kColumn);
  (void)bench.as_generated(key);
  const std::uint64_t chunks = bench.metrics.chunks_made.total();
  const std::uint64_t patches = bench.metrics.patches_made.total();
  bench.edits.edit(key, kSome);
  (void)bench.get(key);
  CHECK(bench.metrics.patches_made.total() == patches);
  CHECK(bench.metrics.chunks_made.total() == chunks);
}

TEST_CASE("an edit while a chunk is made is in the answer") {
  Fake fake;
  fake.work->close_gate();
  REQUIRE(fake.chunks.submit(fake.client.mailbox(), {&kColumn, 1}, Urgency::later) == 1);
  fake.work->await_somebody_at_gate();
  fake.edits.undo(kColumn);
  fake.work->open_gate();
  fake.client.await(1);
  CHECK(fake.client.answers()[0].second.value()->revision() == 1);
}

TEST_CASE("an edit while a chunk is merged is found by its revision") {
  Bench bench;
  const ChunkKey key = bench.with_ground(kColumn);
  bench.edits.edit(key, kSome);
  const EncodedChunkPtr old = bench.get(key);
  bench.edits.edit(key, {});
  CHECK(bench.chunks.find(key) == nullptr);
  CHECK(bench.chunks.newer(key, kBaseRevision) == old);  // better than none
  CHECK(bench.chunks.newer(key, old->revision()) == nullptr);
  CHECK(bench.chunks.revision(key) == 2);
}

TEST_CASE("a chunk whose edits cannot be read is a failure that says why") {
  Bench bench;
  const ChunkKey key = bench.with_ground(kColumn);
  bench.edits.edit(key, kSome);
  bench.edits.load_fails = true;
  const ChunkAnswer answer = bench.ask(bench.chunks, bench.client, key);
  REQUIRE_FALSE(answer.has_value());
  CHECK(answer.error().reason == "the disk is gone");
  bench.edits.load_fails = false;
  CHECK(bench.get(key)->revision() == 1);
}

TEST_CASE("a want of memory while a chunk is merged is a failure too") {
  Bench bench;
  const ChunkKey key = bench.with_ground(kColumn);
  bench.edits.edit(key, kSome);
  bench.edits.in_load = [] { throw std::bad_alloc{}; };
  CHECK_FALSE(bench.ask(bench.chunks, bench.client, key).has_value());
}

TEST_CASE("a row with an edited chunk is mixed, whatever the terrain knows") {
  Bench bench;
  (void)bench.as_generated(kColumn);
  const MixedRows rows = bench.base.column(kColumn);
  const auto at = [](std::int32_t y) { return ChunkKey{{kColumn.coord.x, y, kColumn.coord.z}, Lod{}}; };
  CHECK(bench.chunks.column(kColumn).uniform_at(rows.last + 3) == kAir);
  bench.edits.edit(at(rows.last + 3), kSome);
  bench.edits.edit(at(rows.first - 2), kSome);
  const MixedRows edited = bench.chunks.column(kColumn);
  CHECK_FALSE(edited.uniform_at(rows.last + 3).has_value());
  CHECK_FALSE(edited.uniform_at(rows.first - 2).has_value());
  CHECK(edited.uniform_at(rows.last + 4) == kAir);
  CHECK(edited.uniform_at(rows.first - 3) == rows.below);
  CHECK(bench.base.column(kColumn).uniform_at(rows.last + 3) == kAir);
  const ChunkKey beside{{kColumn.coord.x + 1, 0, kColumn.coord.z}, Lod{}};
  CHECK(bench.chunks.column(beside).last == bench.base.column(beside).last);
}

TEST_CASE("merged chunks are memory of the caches, and shrink with them") {
  Bench bench;
  for (std::int32_t x = 0; x < 20; ++x) {
    const ChunkKey key = bench.with_ground({{x, 2, 0}, Lod{}});
    bench.edits.edit(key, kSome);
    (void)bench.get(key);
  }
  const std::size_t merged = bench.merged.bytes();
  CHECK(merged > 20 * 200);
  while (!bench.base.fit_caches()) {
  }
  const std::uint64_t with_merged = bench.memory.used(MemoryUse::chunk_cache);
  bench.merged.set_capacity(0);
  std::size_t looks = 1000;
  CHECK(bench.merged.fit(looks));
  CHECK(bench.merged.bytes() == 0);
  while (!bench.base.fit_caches()) {
  }
  CHECK(bench.memory.used(MemoryUse::chunk_cache) == with_merged - merged);
}

TEST_CASE("where no merged chunk can be kept each is made when it is asked for") {
  Bench bench{0};
  const ChunkKey key = bench.with_ground(kColumn);
  bench.edits.edit(key, kSome);
  CHECK(bench.get(key)->revision() == 1);
  CHECK(bench.chunks.find(key) == nullptr);
  CHECK(bench.get(key)->revision() == 1);
  CHECK(bench.edits.loads() == 2);
}

TEST_CASE("room in the generators' queue is told through the edits") {
  WaitingClient late;
  Fake fake;
  fake.work->close_gate();
  REQUIRE(fake.chunks.submit(fake.client.mailbox(), {&kColumn, 1}, Urgency::later) == 1);
  constexpr ChunkKey kFar{{100, 0, 0}, Lod{}};
  REQUIRE(fake.chunks.submit(late.mailbox(), {&kFar, 1}, Urgency::later) == 0);
  fake.work->open_gate();
  late.await_room();
}
