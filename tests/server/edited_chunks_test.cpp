// Chunks with their edits, of a real world and of a fake one.

#include <catch2/catch.hpp>
#include <map>
#include <memory>
#include <mutex>

#include <talus/terrain/world.h>
#include <talus/voxel/codec.h>

#include "chunks/chunks.h"
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
  void edited_chunks(const LevelBox&, const ColumnFilter&, std::vector<ChunkKey>& found) const override {
    const std::lock_guard lock{mutex_};
    for (const auto& [key, chunk] : chunks_) found.push_back(key);
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

struct EditedBench {
  FakeEdits edits;
  Logger log = make_logger("off", "text");
  Metrics metrics;
  MemoryBudget memory;
  ManualClock clock;
  ChangeFeed feed{log};
  Chunks chunks;
  WaitingClient client;

  explicit EditedBench(std::unique_ptr<const Generator> generator, std::size_t merged_bytes = 1 << 20,
                       std::size_t queue_chunks = 1000, std::uint64_t memory_bytes = 0)
      : memory{memory_bytes},
        chunks{std::move(generator),
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
               Chunks::Edits{edits, feed}} {
    chunks.start();
  }

  [[nodiscard]] std::size_t submit(WaitingClient& to, ChunkKey key, Version version = Version::edited) {
    return chunks.submit(to.mailbox(), {&key, 1}, Urgency::later, version);
  }
  ChunkAnswer ask(WaitingClient& asker, ChunkKey key, Version version = Version::edited) {
    REQUIRE(submit(asker, key, version) == 1);
    asker.await(asker.answers().size() + 1);
    REQUIRE(asker.answers().back().first == key);
    return asker.answers().back().second;
  }
  EncodedChunkPtr get(ChunkKey key) { return ask(client, key).value(); }
  EncodedChunkPtr find(ChunkKey key) { return chunks.find(key, Version::edited); }
  EncodedChunkPtr find_generated(ChunkKey key) { return chunks.find(key, Version::generated); }
};

/// Of a real world.
struct Bench : EditedBench {
  explicit Bench(std::size_t merged_bytes = 1 << 20, std::uint64_t memory_bytes = 0)
      : EditedBench{std::make_unique<TerrainGenerator>(world(), 2), merged_bytes, 1000, memory_bytes} {}

  static std::shared_ptr<const terrain::World> world() {
    static const auto one = std::make_shared<const terrain::World>(terrain::default_world());
    return one;
  }
  EncodedChunkPtr as_generated(ChunkKey key) {
    if (EncodedChunkPtr chunk = find_generated(key)) return chunk;
    WaitingClient other;
    return ask(other, key, Version::generated).value();
  }
  /// A chunk of the key's column in which the ground lies.
  ChunkKey with_ground(ChunkKey key) {
    (void)as_generated(key);
    const MixedRows rows = chunks.column(key, Version::generated);
    REQUIRE(rows.first <= rows.last);
    key.coord.y = rows.first;
    return key;
  }
};

struct Fake : EditedBench {
  std::shared_ptr<FakeWork> work;
  explicit Fake(std::shared_ptr<FakeWork> of = std::make_shared<FakeWork>())
      : EditedBench{std::make_unique<FakeGenerator>(of), 1 << 20, 1}, work{std::move(of)} {}
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

TEST_CASE("an unedited chunk is the base chunk, found and generated as without edits") {
  Bench bench;
  bench.edits.edit({{9, 9, 9}, Lod{}}, kSome);
  const EncodedChunkPtr chunk = bench.get(kColumn);
  CHECK(chunk == bench.find_generated(kColumn));
  CHECK(bench.find(kColumn) == chunk);
  CHECK(bench.chunks.revision(kColumn) == kBaseRevision);
  CHECK(bench.edits.loads() == 0);
}

TEST_CASE("an edited chunk is the base with its overrides, encoded with its revision") {
  const auto lod = Lod::of(GENERATE(0, 2));
  Bench bench;
  const ChunkKey key = bench.with_ground({kColumn.coord, lod});
  bench.edits.edit(key, {});
  bench.edits.edit(key, kSome);
  CHECK(bench.find(key) == nullptr);  // not merged yet
  const EncodedChunkPtr chunk = bench.get(key);
  const Chunk expected = decoded(bench.as_generated(key)).with_overrides(kSome);
  CHECK(decoded(chunk) == expected);
  CHECK(chunk->hash() == content_hash(expected));
  CHECK(chunk->hash() != bench.as_generated(key)->hash());
  CHECK(revision_in_frame(*chunk) == 2);
  CHECK(bench.find(key) == chunk);
}

TEST_CASE("a chunk is merged once a revision") {
  Bench bench;
  const ChunkKey key = bench.with_ground(kColumn);
  bench.edits.edit(key, kSome);
  const EncodedChunkPtr first = bench.get(key);
  WaitingClient other;
  CHECK(bench.ask(other, key).value() == first);
  CHECK(bench.edits.loads() == 1);
  bench.edits.edit(key, {{1, MaterialId{3}}});
  CHECK(bench.find(key) == nullptr);
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

TEST_CASE("each client has the version that it asked for, also of one chunk at the same time") {
  Fake fake;
  fake.edits.edit(kColumn, {});
  fake.work->close_gate();
  WaitingClient web;
  REQUIRE(fake.submit(web, kColumn, Version::generated) == 1);
  REQUIRE(fake.submit(fake.client, kColumn) == 1);
  fake.edits.undo(kColumn);  // with overrides the fake's chunk would have to decode
  fake.work->open_gate();
  web.await(1);
  fake.client.await(1);
  CHECK(web.answers()[0].second.value()->revision() == kBaseRevision);
  CHECK(fake.client.answers()[0].second.value()->revision() == 2);
  CHECK(fake.work->chunks == 1);
  CHECK(fake.find_generated(kColumn)->revision() == kBaseRevision);
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
    CHECK(decoded(chunk).at({6, 0, 0}) == decoded(bench.find_generated(key)).at({6, 0, 0}));
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
  REQUIRE(fake.submit(fake.client, kColumn) == 1);
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
  CHECK(bench.find(key) == nullptr);
  CHECK(bench.chunks.newer(key, kBaseRevision) == old);  // better than none
  CHECK(bench.chunks.newer(key, old->revision()) == nullptr);
  CHECK(bench.chunks.revision(key) == 2);
}

TEST_CASE("a chunk whose edits cannot be read is a failure that says why") {
  Bench bench;
  const ChunkKey key = bench.with_ground(kColumn);
  bench.edits.edit(key, kSome);
  bench.edits.load_fails = true;
  const ChunkAnswer answer = bench.ask(bench.client, key);
  REQUIRE_FALSE(answer.has_value());
  CHECK(answer.error().reason == "its edits cannot be read");  // the log says why
  bench.edits.load_fails = false;
  CHECK(bench.get(key)->revision() == 1);
}

TEST_CASE("a want of memory while a chunk is merged is a failure too") {
  Bench bench;
  const ChunkKey key = bench.with_ground(kColumn);
  bench.edits.edit(key, kSome);
  bench.edits.in_load = [] { throw std::bad_alloc{}; };
  CHECK_FALSE(bench.ask(bench.client, key).has_value());
}

TEST_CASE("a row with an edited chunk is mixed, whatever the terrain knows") {
  Bench bench;
  (void)bench.as_generated(kColumn);
  const MixedRows rows = bench.chunks.column(kColumn, Version::generated);
  const auto at = [](std::int32_t y) { return ChunkKey{{kColumn.coord.x, y, kColumn.coord.z}, Lod{}}; };
  CHECK(bench.chunks.column(kColumn, Version::edited).uniform_at(rows.last + 3) == kAir);
  bench.edits.edit(at(rows.last + 3), kSome);
  bench.edits.edit(at(rows.first - 2), kSome);
  const MixedRows edited = bench.chunks.column(kColumn, Version::edited);
  CHECK_FALSE(edited.uniform_at(rows.last + 3).has_value());
  CHECK_FALSE(edited.uniform_at(rows.first - 2).has_value());
  CHECK(edited.uniform_at(rows.last + 4) == kAir);
  CHECK(edited.uniform_at(rows.first - 3) == rows.below);
  CHECK(bench.chunks.column(kColumn, Version::generated).uniform_at(rows.last + 3) == kAir);
  const ChunkKey beside{{kColumn.coord.x + 1, 0, kColumn.coord.z}, Lod{}};
  CHECK(bench.chunks.column(beside, Version::edited).last ==
        bench.chunks.column(beside, Version::generated).last);
}

TEST_CASE("the cache of merged chunks has the bytes that its capacity allows") {
  FakeEdits edits;
  MergedChunks merged{edits, make_logger("off", "text"), 1 << 20};
  const EncodedChunkPtr base = encode_shared(Chunk::uniform(MaterialId{2}));
  CHECK(merged.merged(kColumn, base).value() == base);
  for (std::int32_t x = 0; x < 20; ++x) {
    const ChunkKey key{{x, 2, 0}, Lod{}};
    edits.edit(key, kSome);
    const EncodedChunkPtr chunk = merged.merged(key, base).value();
    REQUIRE(merged.newer(key, kBaseRevision) == chunk);
  }
  CHECK(merged.bytes() > 20 * 200);
  merged.set_capacity(0);
  std::size_t probes = 1000;
  CHECK(merged.fit(probes));
  CHECK(merged.bytes() == 0);
}

TEST_CASE("merged chunks are memory of the caches, and shrink with them") {
  std::vector<Override> noise;
  for (std::uint32_t i = 0; i < 16'384; ++i) {
    noise.push_back({static_cast<std::uint16_t>(2 * i),
                     MaterialId{static_cast<std::uint16_t>(1 + ((i * 2'654'435'761U) >> 29U))}});
  }
  Bench bench{1 << 20, std::uint64_t{64} << 20U};
  std::vector<ChunkKey> keys;
  for (std::int32_t x = 0; x < 60; ++x) keys.push_back(bench.with_ground({{x, 2, 0}, Lod{}}));
  const auto used = [&] {
    while (!bench.chunks.fit_caches()) {
    }
    return bench.memory.used(MemoryUse::chunk_cache);
  };
  const auto bytes_found = [&] {
    std::size_t bytes = 0;
    for (const ChunkKey key : keys) {
      if (const EncodedChunkPtr chunk = bench.find(key)) bytes += chunk->bytes();
    }
    return bytes;
  };
  const std::uint64_t without = used();
  std::size_t merged = 0;
  for (const ChunkKey key : keys) {
    bench.edits.edit(key, noise);
    merged += bench.get(key)->bytes();
  }
  constexpr std::size_t kMinBytes = std::size_t{256}
                                    << 10U;  // of the cache of merged chunks: 1/16 of the budget
  CHECK(merged > kMinBytes);
  CHECK(bytes_found() == merged);
  CHECK(used() >= without + merged);
  bench.memory.set(MemoryUse::sessions, UINT64_MAX / 4);
  (void)used();
  CHECK(bytes_found() <= kMinBytes);
}

TEST_CASE("if no merged chunk can be kept, each is made on request") {
  Bench bench{0};
  const ChunkKey key = bench.with_ground(kColumn);
  bench.edits.edit(key, kSome);
  CHECK(bench.get(key)->revision() == 1);
  CHECK(bench.find(key) == nullptr);
  CHECK(bench.get(key)->revision() == 1);
  CHECK(bench.edits.loads() == 2);
}

TEST_CASE("a refused client of edited chunks is notified of room in the queue") {
  WaitingClient late;
  Fake fake;
  fake.work->close_gate();
  REQUIRE(fake.submit(fake.client, kColumn) == 1);
  constexpr ChunkKey kFar{{100, 0, 0}, Lod{}};
  REQUIRE(fake.submit(late, kFar) == 0);
  fake.work->open_gate();
  late.await_room();
}
