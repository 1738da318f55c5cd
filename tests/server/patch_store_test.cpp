// Without threads: every call returns when its work is done.
#include "chunks/generation/patch_store.h"

#include <array>
#include <catch2/catch.hpp>

#include "failing_allocations.h"
#include "fake_generator.h"
#include "scratch_directory.h"

using namespace talus;
using namespace talus::server;
using namespace std::chrono_literals;

namespace {

constexpr int kTiles = 4;
constexpr int kColumns = kTiles * kTiles;
constexpr std::array kOutside{ChunkKey{{1000, 0, 1000}, Lod{}}};  // of every View here

/// A store on a fake generator, with room for one patch of 600 kB.
struct Bench {
  std::shared_ptr<FakeWork> work = std::make_shared<FakeWork>();
  FakeGenerator generator{work};
  Logger log = make_logger("off", "text");
  Metrics metrics;
  MemoryBudget budget{0};
  ManualClock clock;
  ChunkCache chunks{1 << 20};
  ColumnRows rows{generator, kTiles, 1 << 20};
  ChunkMaker maker{generator, chunks, rows, metrics, log};
  GeneratorMemory memory{budget, 1, log};
  WantedChunks wanted;
  PatchStore store;
  MeasuredWork measured;

  explicit Bench(ColumnCache* columns = nullptr)
      : store{{generator, maker, chunks, rows, wanted, memory, metrics, clock, columns},
              log,
              kTiles,
              1 << 20,
              1} {
    work->patch_columns = 150'000;
    work->first_mixed = 2;
    work->last_mixed = 3;
  }
  PatchStore::Loan obtain(std::int32_t x, std::span<const ChunkKey> asked = kOutside) {
    return store.obtain(
        {x, 0, Lod{}}, asked, nullptr, [] { return AfterStep::go_on; }, measured);
  }
  void finish(const PatchStore::Loan& loan) {
    store.finish(loan, measured, [] { return false; });
  }
  /// All of the patch's chunks in the rows, made by hand.
  void make_chunks(const PatchStore::Loan& loan, std::int32_t first_row, std::int32_t last_row) {
    for_each_column(loan.patch, kTiles, [&](ChunkKey column) {
      for (column.coord.y = first_row; column.coord.y <= last_row; ++column.coord.y) {
        REQUIRE(maker.chunk(loan.stacks.get(), column).has_value());
      }
    });
  }
};

}  // namespace

TEST_CASE("a patch is made once and found from then on") {
  Bench bench;
  const auto first = bench.obtain(0);
  bench.finish(first);
  const auto again = bench.obtain(0);
  CHECK(again.stacks == first.stacks);
  CHECK(again.stacks != nullptr);
  CHECK(bench.work->patches == 1);
  CHECK(bench.measured.patches == 1);
  CHECK(bench.store.holds({0, 0, Lod{}}));
  CHECK_FALSE(bench.store.holds({0, 0, Lod::of(1)}));
}

TEST_CASE("the rows of a patch's columns are known when it is made") {
  Bench bench;
  CHECK_FALSE(bench.rows.exact({{3, 9, 3}, Lod{}}).has_value());
  (void)bench.obtain(0);
  const auto rows = bench.rows.exact({{3, 9, 3}, Lod{}});
  REQUIRE(rows.has_value());
  CHECK(rows->first == 2);
  CHECK(rows->last == 3);
  CHECK_FALSE(bench.rows.exact({{4, 9, 3}, Lod{}}).has_value());
}

TEST_CASE("an evicted patch that was in no View leaves its mixed chunks, each made once") {
  Bench bench;
  const auto first = bench.obtain(0);
  REQUIRE(bench.maker.chunk(first.stacks.get(), {{1, 2, 1}, Lod{}}).has_value());
  bench.finish(first);
  const auto second = bench.obtain(1);
  CHECK_FALSE(bench.store.holds({0, 0, Lod{}}));
  CHECK_FALSE(bench.chunks.holds({{3, 3, 3}, Lod{}}));  // whoever waits for the second patch goes first
  bench.finish(second);
  for (std::int32_t i = 0; i < kColumns; ++i) {
    CHECK(bench.chunks.holds({{i % kTiles, 2, i / kTiles}, Lod{}}));
    CHECK(bench.chunks.holds({{i % kTiles, 3, i / kTiles}, Lod{}}));
  }
  CHECK(bench.work->chunks == 2 * kColumns);
  CHECK(bench.measured.chunks == 2 * kColumns - 1);
}

TEST_CASE("only the requested chunks of a patch in a View are made, and it is released") {
  Bench bench;
  const ChunkRange any{-100, 100};
  // The eastern half of the patch, and of its mixed rows 2 and 3 the higher one.
  bench.wanted.set(ClientId{1}, std::array{LevelBox{Lod{}, {2, 3}, {3, 9}, any, {}, {}}});
  const std::array asked{ChunkKey{{2, 3, 0}, Lod{}}};
  bench.finish(bench.obtain(0, asked));
  for (std::int32_t i = 0; i < kColumns; ++i) {
    CHECK_FALSE(bench.chunks.holds({{i % kTiles, 2, i / kTiles}, Lod{}}));
    CHECK(bench.chunks.holds({{i % kTiles, 3, i / kTiles}, Lod{}}) == (i % kTiles >= 2));
  }
  CHECK(bench.work->chunks == kColumns / 2);
  CHECK(bench.store.bytes() == 0);
}

TEST_CASE("extraction for Views ends with the server, and the patch stays") {
  Bench bench;
  const ChunkRange any{-100, 100};
  bench.wanted.set(ClientId{1}, std::array{LevelBox{Lod{}, any, any, any, {}, {}}});
  const auto loan = bench.obtain(0, std::array{ChunkKey{{0, 2, 0}, Lod{}}});
  bench.store.finish(loan, bench.measured, [&] { return bench.work->chunks == 3; });
  CHECK(bench.work->chunks == 3);
  CHECK(bench.store.holds({0, 0, Lod{}}));
}

TEST_CASE("a patch stays if a request wants chunks outside every View") {
  Bench bench;
  const ChunkRange any{-100, 100};
  bench.wanted.set(ClientId{1}, std::array{LevelBox{Lod{}, any, {3, 9}, any, {}, {}}});
  const std::array asked{ChunkKey{{0, 3, 0}, Lod{}}, ChunkKey{{0, 2, 0}, Lod{}}};
  bench.finish(bench.obtain(0, asked));
  CHECK(bench.store.holds({0, 0, Lod{}}));
  // What is wanted of it when it is evicted is left.
  CHECK(bench.work->chunks == 0);
  bench.finish(bench.obtain(1, asked));
  CHECK(bench.work->chunks == kColumns);
}

TEST_CASE("a patch stays of which a View has more rows than are extracted") {
  Bench bench;
  bench.work->last_mixed = 2 + PatchStore::kMaxExtractedRows;
  const ChunkRange any{-100, 100};
  bench.wanted.set(ClientId{1}, std::array{LevelBox{Lod{}, any, any, any, {}, {}}});
  bench.finish(bench.obtain(0, std::array{ChunkKey{{0, 2, 0}, Lod{}}}));
  CHECK(bench.store.holds({0, 0, Lod{}}));
}

TEST_CASE("a patch that was dear to make stays, and leaves what is wanted when it is evicted") {
  Bench bench;
  const ChunkRange any{-100, 100};
  bench.wanted.set(ClientId{1}, std::array{LevelBox{Lod{}, {0, 3}, any, any, {}, {}}});
  const std::array asked{ChunkKey{{0, 2, 0}, Lod{}}};
  bench.work->in_patch = [&] { bench.clock.spend_cpu(PatchStore::kDearPatch + 1ns); };
  bench.finish(bench.obtain(0, asked));
  CHECK(bench.store.holds({0, 0, Lod{}}));
  CHECK(bench.work->chunks == 0);
  bench.finish(bench.obtain(1));
  CHECK(bench.work->chunks == 2 * kColumns);
  CHECK(bench.store.holds({1, 0, Lod{}}));
}

TEST_CASE("chunks of a dear patch are kept on disk when it goes, and read instead of being made") {
  const ScratchDirectory scratch;
  const ManualClock clock;
  const auto columns = ColumnCache::open(
      {.path = scratch.path() / "columns", .fingerprint = {}, .bytes = 1 << 24, .free_bytes = 0},
      make_logger("off", "text"), clock);
  REQUIRE(columns.has_value());
  const ChunkRange any{-100, 100};
  const std::array asked{ChunkKey{{0, 2, 0}, Lod{}}, ChunkKey{{0, 3, 0}, Lod{}}};
  const auto use = [&](bool dear) {
    auto bench = std::make_unique<Bench>(columns->get());
    bench->wanted.set(ClientId{1}, std::array{LevelBox{Lod{}, any, any, any, {}, {}}});
    bench->work->payload_bytes = 10;
    if (dear) bench->work->in_patch = [clock = &bench->clock] { clock->spend_cpu(2ms); };
    bench->work->in_chunk = [dear, clock = &bench->clock] { clock->spend_cpu(dear ? 20us : 1us); };
    return bench;
  };
  {
    const auto cheap = use(false);
    cheap->finish(cheap->obtain(0, asked));
    CHECK(cheap->work->chunks == 2 * kColumns);
    CHECK((*columns)->status().kept == 0);
    const auto dear = use(true);
    dear->finish(dear->obtain(0, asked));
    CHECK((*columns)->status().kept == kColumns);
  }
  {
    const auto ends = use(true);
    ends->work->in_patch = [clock = &ends->clock] { clock->spend_cpu(3ms); };
    (void)ends->obtain(7, asked);
    ends->make_chunks(ends->obtain(7), 2, 3);
    CHECK((*columns)->status().kept == kColumns);
  }
  CHECK((*columns)->status().kept == 2 * kColumns);
  const auto later = use(true);
  CHECK(later->store.read_columns({0, 0, Lod{}}, asked));
  CHECK(later->work->patches == 0);
  CHECK(later->maker.known(asked[0]) != nullptr);
  CHECK(later->maker.known(asked[1])->hash() == ContentHash{std::hash<ChunkKey>{}(asked[1]), 0});
  CHECK(later->maker.known({{0, 4, 0}, Lod{}})->uniform());
  CHECK(later->maker.known({{1, 2, 0}, Lod{}}) == nullptr);  // nobody asked for it
  const std::array elsewhere{ChunkKey{{100, 2, 0}, Lod{}}};
  CHECK_FALSE(later->store.read_columns({25, 0, Lod{}}, elsewhere));
  (void)later->obtain(0);
  CHECK_FALSE(later->store.read_columns({0, 0, Lod{}}, asked));  // cutting it is cheaper
}

TEST_CASE("if any allocation fails while a patch is obtained, the store is whole and usable") {
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    Bench bench;
    const auto first = bench.obtain(0);
    bench.finish(first);
    const std::size_t one_patch = bench.store.bytes();
    const auto second = [&] {
      const talus::test::FailingAllocations failing{allocations};
      auto loan = bench.obtain(1);
      failed = failing.has_failed();
      return loan;
    }();
    // The first patch is where it was, or was handed out to be extracted.
    const bool handed_out = !second.evicted.empty() && second.evicted.front().first == PatchKey{0, 0, Lod{}};
    REQUIRE(handed_out != bench.store.holds({0, 0, Lod{}}));
    REQUIRE(bench.store.holds({1, 0, Lod{}}) == handed_out);
    REQUIRE(bench.store.bytes() == one_patch);
    if (!failed) CHECK(handed_out);
    bench.finish(second);

    const auto third = bench.obtain(2);
    REQUIRE(third.stacks != nullptr);
    REQUIRE(bench.store.holds({2, 0, Lod{}}));
    REQUIRE(bench.store.bytes() == one_patch);
    for_each_column(third.patch, kTiles,
                    [&](ChunkKey column) { CHECK(bench.rows.exact(column).has_value()); });
    bench.finish(third);
    REQUIRE(bench.store.bytes() == one_patch);
  }
}

TEST_CASE("if any allocation fails while evicted patches are extracted, cached chunks are whole") {
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    Bench bench;
    bench.finish(bench.obtain(0));
    const auto second = bench.obtain(1);
    {
      const talus::test::FailingAllocations failing{allocations};
      bench.finish(second);
      failed = failing.has_failed();
    }
    std::size_t held = 0;
    for_each_column({0, 0, Lod{}}, kTiles, [&](ChunkKey column) {
      for (column.coord.y = 2; column.coord.y <= 3; ++column.coord.y)
        held += bench.chunks.holds(column) ? 1U : 0U;
    });
    REQUIRE(held >= 2 * kColumns - 1);
    if (!failed) CHECK(held == 2 * kColumns);
  }
}

TEST_CASE("if any allocation fails while the rows of a patch are noted, the noted rows are exact") {
  const FakeGenerator generator{[] {
    auto work = std::make_shared<FakeWork>();
    work->first_mixed = 2;
    work->last_mixed = 3;
    return work;
  }()};
  const PatchKey patch{5, -7, Lod::of(1)};
  const std::size_t bytes_of_one = [&] {
    ColumnRows rows{generator, 1, 1 << 20};
    rows.note({0, 0, Lod{}}, {});
    return rows.bytes();
  }();
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    ColumnRows rows{generator, kTiles, 1 << 20};
    const auto noted = [&] {
      std::size_t count = 0;
      for_each_column(patch, kTiles, [&](ChunkKey column) {
        const auto exact = rows.exact(column);
        if (!exact) return;
        REQUIRE(exact->first == 2);
        REQUIRE(exact->last == 3);
        ++count;
      });
      return count;
    };
    {
      const talus::test::FailingAllocations failing{allocations};
      try {
        rows.note(patch, {});
      } catch (const std::bad_alloc&) {
      }
      failed = failing.has_failed();
    }
    const std::size_t first = noted();
    REQUIRE(rows.bytes() == first * bytes_of_one);
    CHECK((first == kColumns) == !failed);
    rows.note(patch, {});
    REQUIRE(noted() == kColumns);
    REQUIRE(rows.bytes() == kColumns * bytes_of_one);
  }
}

TEST_CASE("only the lowest rows of a deep column are extracted") {
  Bench bench;
  bench.work->first_mixed = -100;
  bench.work->last_mixed = 100;
  bench.finish(bench.obtain(0));
  bench.finish(bench.obtain(1));
  CHECK(bench.work->chunks == PatchStore::kMaxExtractedRows * kColumns);
  CHECK(bench.chunks.holds({{0, -93, 0}, Lod{}}));
  CHECK_FALSE(bench.chunks.holds({{0, -92, 0}, Lod{}}));
}

TEST_CASE("a patch whose mixed chunks are all cached is let go, and its memory serves the next") {
  Bench bench;
  {
    const auto loan = bench.obtain(0);
    bench.make_chunks(loan, 2, 3);
    bench.finish(loan);
  }
  CHECK_FALSE(bench.store.holds({0, 0, Lod{}}));
  CHECK(bench.store.bytes() == 0);
  (void)bench.obtain(1);
  CHECK(bench.work->reused == 1);
}

TEST_CASE("a patch with a mixed chunk that is not cached stays") {
  Bench bench;
  const auto loan = bench.obtain(0);
  bench.make_chunks(loan, 2, 2);
  bench.finish(loan);
  CHECK(bench.store.holds({0, 0, Lod{}}));
}

TEST_CASE("a patch deeper than what would be extracted stays, whatever is cached of it") {
  Bench bench;
  bench.work->last_mixed = 2 + PatchStore::kMaxExtractedRows;
  const auto loan = bench.obtain(0);
  bench.make_chunks(loan, 2, 2 + PatchStore::kMaxExtractedRows);
  bench.finish(loan);
  CHECK(bench.store.holds({0, 0, Lod{}}));
}

TEST_CASE("a patch that could not be made is absent, and may be made the next time") {
  Bench bench;
  bench.work->out_of_memory = true;
  const auto failed = bench.obtain(0);
  CHECK(failed.stacks == nullptr);
  CHECK_FALSE(bench.maker.chunk(failed.stacks.get(), {{0, 2, 0}, Lod{}}).has_value());
  bench.finish(failed);
  bench.work->out_of_memory = false;
  CHECK(bench.obtain(0).stacks != nullptr);
  CHECK(bench.measured.patches == 1);
}

TEST_CASE("a smaller capacity evicts as many patches a call as it may, and what is in use stays usable") {
  Bench bench;
  const auto loan = bench.obtain(0);
  CHECK(bench.store.bytes() >= 600'000);
  bench.store.set_capacity(0);
  std::size_t probes = 0;
  CHECK_FALSE(bench.store.fit(probes));
  CHECK(bench.store.bytes() >= 600'000);
  probes = 2;
  CHECK(bench.store.fit(probes));
  CHECK(probes == 1);
  CHECK(bench.store.bytes() == 0);
  CHECK(loan.stacks->tops.size() == 1);
}

TEST_CASE("making a patch takes the thread time that its clock counts") {
  struct Slow final : Clock {
    mutable int calls = 0;
    time_point now() const override { return {}; }
    std::chrono::sys_seconds wall() const override { return {}; }
    std::chrono::nanoseconds thread_cpu() const override { return ++calls * 7ms; }
  };
  Bench bench;
  const Slow slow;
  PatchStore store{{bench.generator, bench.maker, bench.chunks, bench.rows, bench.wanted, bench.memory,
                    bench.metrics, slow},
                   bench.log,
                   kTiles,
                   1 << 20,
                   1};
  const auto loan = store.obtain(
      {0, 0, Lod{}}, kOutside, nullptr, [] { return AfterStep::go_on; }, bench.measured);
  CHECK(bench.measured.patch_time == 7ms);
  const auto go_on = [] { return false; };
  store.finish(loan, bench.measured, go_on);
  store.finish(store.obtain(
                   {1, 0, Lod{}}, kOutside, nullptr, [] { return AfterStep::go_on; }, bench.measured),
               bench.measured, go_on);
  CHECK(bench.measured.patch_time == 14ms);
  CHECK(bench.measured.chunk_time == 7ms);
}
