#include "chunks/column_cache/column_cache.h"

#include <array>
#include <catch2/catch.hpp>
#include <fstream>
#include <random>
#include <span>

#include "logged_lines.h"
#include "runtime/manual_clock.h"
#include "scratch_directory.h"

using namespace talus;
using namespace talus::server;
using namespace std::chrono_literals;

namespace {

constexpr ContentHash kWorld{1, 2};

ChunkKey column(std::int32_t x, std::int32_t z = 0, int level = 0) {
  return {{x, 0, z}, Lod::of(level)};
}

std::vector<std::byte> payload_of(std::size_t size, std::uint32_t seed) {
  std::mt19937 random{seed};
  std::vector<std::byte> payload(size);
  for (std::byte& byte : payload) byte = static_cast<std::byte>(random());
  return payload;
}

EncodedChunkPtr chunk_of(std::size_t size, std::uint32_t seed, bool uniform = false) {
  return std::make_shared<const EncodedChunk>(ContentHash{seed, ~std::uint64_t{seed}}, payload_of(size, seed),
                                              kBaseRevision, uniform);
}

ColumnRecord record_of(std::int32_t first, std::int32_t last, std::initializer_list<std::int32_t> rows,
                       std::size_t size = 100) {
  ColumnRecord record{{first, last, MaterialId{7}}, {}};
  for (const std::int32_t y : rows) {
    record.chunks.push_back({y, chunk_of(size, static_cast<std::uint32_t>(y), y % 2 == 0)});
  }
  return record;
}

bool same(const ColumnRecord& a, const ColumnRecord& b) {
  if (a.rows.first != b.rows.first || a.rows.last != b.rows.last || a.rows.below != b.rows.below)
    return false;
  return std::equal(a.chunks.begin(), a.chunks.end(), b.chunks.begin(), b.chunks.end(),
                    [](const auto& one, const auto& other) {
                      return one.y == other.y && one.chunk->hash() == other.chunk->hash() &&
                             one.chunk->uniform() == other.chunk->uniform() &&
                             one.chunk->revision() == other.chunk->revision() &&
                             std::ranges::equal(one.chunk->payload(), other.chunk->payload());
                    });
}

struct Bench {
  ScratchDirectory scratch;
  ManualClock clock;
  std::shared_ptr<LoggedLines> log = std::make_shared<LoggedLines>();
  ColumnCacheSettings settings{.path = scratch.path() / "columns",
                               .fingerprint = kWorld,
                               .bytes = std::uint64_t{64} << 20,
                               .memory_bytes = std::size_t{3} << 20,
                               .free_bytes = 0};

  [[nodiscard]] std::unique_ptr<ColumnCache> open() {
    auto opened = ColumnCache::open(settings, log, clock);
    INFO((opened ? "" : opened.error()));
    REQUIRE(opened.has_value());
    return *std::move(opened);
  }
};

}  // namespace

TEST_CASE("a column's record: what is encoded is decoded, and whatever byte changes is found") {
  const ColumnRecord record = record_of(-3, 12, {-3, -2, 0, 11, 12});
  std::vector<std::byte> bytes;
  encode(column(-5, 9, 2), record, bytes);
  const auto decoded = decode_column(column(-5, 9, 2), bytes);
  REQUIRE(decoded.has_value());
  CHECK(same(*decoded, record));
  CHECK_FALSE(decode_column(column(-5, 9, 3), bytes).has_value());
  CHECK_FALSE(decode_column(column(-5, 8, 2), bytes).has_value());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    bytes[at] ^= std::byte{1};
    CHECK_FALSE(decode_column(column(-5, 9, 2), bytes).has_value());
    bytes[at] ^= std::byte{1};
    CHECK_FALSE(decode_column(column(-5, 9, 2), std::span{bytes}.first(at)).has_value());
  }
}

TEST_CASE("a column without mixed rows is worth a record, too") {
  const ColumnRecord record{{4, 3, MaterialId{9}}, {}};
  std::vector<std::byte> bytes;
  encode(column(0), record, bytes);
  const auto decoded = decode_column(column(0), bytes);
  REQUIRE(decoded.has_value());
  CHECK(same(*decoded, record));
}

TEST_CASE("keys of columns that lie together stand together, each level by itself") {
  CHECK(column_key(column(0, 0)) < column_key(column(0, 0, 1)));
  CHECK(column_key(column(-1, -1)) < column_key(column(0, 0)));
  // A square of 4 x 4 that is aligned is one range.
  const std::string before = column_key(column(3, 7));
  std::string least = column_key(column(4, 8));
  std::string most = least;
  for (std::int32_t x = 4; x < 8; ++x) {
    for (std::int32_t z = 8; z < 12; ++z) {
      least = std::min(least, column_key(column(x, z)));
      most = std::max(most, column_key(column(x, z)));
    }
  }
  for (std::int32_t x = 0; x < 16; ++x) {
    for (std::int32_t z = 0; z < 16; ++z) {
      const std::string key = column_key(column(x, z));
      const bool inside = x >= 4 && x < 8 && z >= 8 && z < 12;
      CHECK((key >= least && key <= most) == inside);
    }
  }
}

TEST_CASE("columns outlive their cache") {
  Bench bench;
  const ColumnRecord record = record_of(1, 3, {1, 2, 3});
  {
    const auto cache = bench.open();
    CHECK_FALSE(cache->find(column(5)).has_value());
    cache->put(column(5), record_of(1, 3, {1}));
    cache->put(column(5), record);  // replaces it
    cache->put(column(6), record_of(0, 0, {0}));
    const auto found = cache->find(column(5));
    REQUIRE(found.has_value());
    CHECK(same(*found, record));
  }
  const auto cache = bench.open();
  const auto found = cache->find(column(5));
  REQUIRE(found.has_value());
  CHECK(same(*found, record));
  CHECK_FALSE(cache->find(column(5, 1)).has_value());
  const auto status = cache->status();
  CHECK(status.found == 1);
  CHECK(status.missing == 1);
  CHECK(status.lost == 0);
  CHECK(bench.log->text().empty());
}

TEST_CASE("a cache of another world, or a damaged one, begins anew and says so") {
  Bench bench;
  bench.open()->put(column(5), record_of(1, 3, {1, 2, 3}));
  SECTION("another world") {
    bench.settings.fingerprint = {3, 4};
  }
  SECTION("no identity") {
    std::filesystem::remove(bench.settings.path / "identity");
  }
  SECTION("the database lost a file") {
    std::filesystem::remove(bench.settings.path / "db" / "CURRENT");
    for (const auto& file : std::filesystem::directory_iterator{bench.settings.path / "db"}) {
      if (file.path().extension() == ".sst") std::filesystem::resize_file(file.path(), 10);
    }
  }
  const auto cache = bench.open();
  CHECK_FALSE(cache->find(column(5)).has_value());
  cache->put(column(5), record_of(1, 1, {1}));
  CHECK(cache->find(column(5)).has_value());
}

TEST_CASE("a directory of something else is left alone, and named") {
  Bench bench;
  std::filesystem::create_directories(bench.settings.path / "greek");
  const auto opened = ColumnCache::open(bench.settings, bench.log, bench.clock);
  REQUIRE_FALSE(opened.has_value());
  CHECK(opened.error().find("\"greek\"") != std::string::npos);
  CHECK(std::filesystem::is_directory(bench.settings.path / "greek"));
}

TEST_CASE("the same column put again takes no room") {
  Bench bench;
  const auto cache = bench.open();
  const ColumnRecord record = record_of(1, 3, {1, 2, 3});
  for (int i = 0; i < 3; ++i) cache->put(column(5), record);
  CHECK(cache->status().kept == 1);
  cache->put(column(5), record_of(1, 3, {1, 2}));
  CHECK(cache->status().kept == 2);
}

TEST_CASE("a damaged column is missing, and others are found") {
  Bench bench;
  {
    const auto cache = bench.open();
    for (std::int32_t x = 0; x < 200; ++x) cache->put(column(x), record_of(0, 1, {0, 1}, 2'000));
  }
  // One byte in the middle of the only table: one block.
  for (const auto& file : std::filesystem::directory_iterator{bench.settings.path / "db"}) {
    if (file.path().extension() != ".sst") continue;
    std::fstream bytes{file.path(), std::ios::in | std::ios::out | std::ios::binary};
    bytes.seekp(static_cast<std::streamoff>(std::filesystem::file_size(file.path()) / 2));
    bytes.put('!');
  }
  const auto cache = bench.open();
  int found = 0;
  for (std::int32_t x = 0; x < 200; ++x) found += cache->find(column(x)).has_value() ? 1 : 0;
  CHECK(found > 100);
  CHECK(found < 200);
  CHECK(cache->status().lost == 200U - static_cast<unsigned>(found));
  CHECK(bench.log->text().find("damaged") != std::string::npos);
}

TEST_CASE("the oldest columns go when the disk's share is used up") {
  Bench bench;
  bench.settings.bytes = std::uint64_t{4} << 20;
  bench.settings.memory_bytes = std::size_t{1} << 20;
  const ColumnRecord record = record_of(0, 0, {0}, 10'000);
  constexpr std::int32_t kColumns = 3'000;  // 30 MB
  {
    const auto cache = bench.open();
    for (std::int32_t x = 0; x < kColumns; ++x) {
      cache->put(column(x), record);
      // As slowly as a generator, and not faster than the disk.
      while (!cache->find(column(x)).has_value()) cache->put(column(x), record);
    }
  }
  const auto cache = bench.open();
  CHECK(cache->status().bytes < 2 * bench.settings.bytes);
  CHECK_FALSE(cache->find(column(0)).has_value());
  CHECK(cache->find(column(kColumns - 1)).has_value());
}

TEST_CASE("a disk that is nearly full is left to the edits") {
  Bench bench;
  bench.settings.free_bytes = UINT64_MAX;
  const auto cache = bench.open();
  cache->put(column(5), record_of(1, 1, {1}));
  CHECK_FALSE(cache->find(column(5)).has_value());
  CHECK(cache->status().lost == 1);
}

TEST_CASE("a directory that cannot be written is an error that names it and what to do") {
  Bench bench;
  bench.settings.path = "/proc/self/columns";
  const auto opened = ColumnCache::open(bench.settings, bench.log, bench.clock);
  REQUIRE_FALSE(opened.has_value());
  CHECK(opened.error().find("/proc/self/columns") != std::string::npos);
  CHECK(opened.error().find("cache.disk_bytes") != std::string::npos);
  CHECK(opened.error().find('\n') == std::string::npos);
}

TEST_CASE("cheap columns are not worth a place") {
  Bench bench;
  const auto cache = bench.open();
  CHECK_FALSE(cache->worth(ColumnCache::kWorthKeeping - 1ns));
  CHECK(cache->worth(ColumnCache::kWorthKeeping));
}
