// Measures what a column of chunks as generated costs: made anew, read from a database on disk, found in
// memory. docs/decisions/07-columns-on-disk.md decides by this table which worlds keep what they generate.
// bench_base_cache [DIRECTORY]: where the database lies, on the disk to be measured.
#include <fcntl.h>
#include <time.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <rocksdb/db.h>
#include <rocksdb/filter_policy.h>
#include <rocksdb/table.h>
#include <rocksdb/write_batch.h>

#include <talus/terrain/world.h>

#include "chunks/cache/chunk_cache.h"
#include "chunks/generation/patch.h"
#include "chunks/generation/terrain_generator.h"
#include "fixtures.h"

namespace {

using namespace talus;
using namespace talus::server;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kPatchTiles = 4;
constexpr std::uint32_t kStored = 200'000;  // columns in the database
constexpr int kReads = 4'000;

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "bench_base_cache: %s\n", what.c_str());
  std::exit(1);
}

void check(const rocksdb::Status& status) {
  if (!status.ok()) fail(status.ToString());
}

double cpu_us() {
  timespec used{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) * 1e6 + static_cast<double>(used.tv_nsec) / 1e3;
}

double wall_us() {
  return std::chrono::duration<double, std::micro>(Clock::now().time_since_epoch()).count();
}

struct ColumnResult {
  std::string value;  // of a column: its chunks' payloads with their lengths
  std::vector<std::pair<ChunkKey, EncodedChunkPtr>> chunks;
};

struct Cost {
  double column_us = 0;
  std::vector<ColumnResult> columns;
};

std::string value_of(const std::vector<std::pair<ChunkKey, EncodedChunkPtr>>& chunks) {
  std::string value;
  for (const auto& [key, chunk] : chunks) {
    const auto length = static_cast<std::uint32_t>(chunk->payload().size());
    value.append(reinterpret_cast<const char*>(&key.coord.y), sizeof key.coord.y);
    const ContentHash hash = chunk->hash();
    value.append(reinterpret_cast<const char*>(&hash), sizeof hash);
    value.append(reinterpret_cast<const char*>(&length), sizeof length);
    value.append(reinterpret_cast<const char*>(chunk->payload().data()), length);
  }
  const auto sum = XXH3_64bits(value.data(), value.size());
  value.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  return value;
}

/// The patches around a place with everything that the world has, one after another by one thread.
Cost make(const terrain::World& parsed, std::int32_t patches, Lod lod) {
  const auto world = std::make_shared<const terrain::World>(parsed);
  const TerrainGenerator generator{world, kPatchTiles, 1, std::size_t{8} << 20};
  Cost cost;
  const double began = cpu_us();
  for (std::int32_t z = 0; z < patches; ++z) {
    for (std::int32_t x = 0; x < patches; ++x) {
      const PatchKey patch{x - (16 >> lod.value()), z - (48 >> lod.value()), lod};
      const auto making = generator.start_patch(patch, {});
      while (making->step()) {
      }
      const terrain::Stacks stacks = making->take();
      for_each_column(patch, kPatchTiles, [&](ChunkKey column) {
        const MixedRows rows = generator.mixed_rows(stacks, column);
        ColumnResult made;
        for (std::int32_t y = rows.first; y <= rows.last; ++y) {
          const ChunkKey key{{column.coord.x, y, column.coord.z}, column.lod};
          made.chunks.emplace_back(key, generator.make_chunk(stacks, key));
        }
        cost.columns.push_back(std::move(made));
      });
    }
  }
  cost.column_us = (cpu_us() - began) / static_cast<double>(cost.columns.size());
  for (ColumnResult& made : cost.columns) made.value = value_of(made.chunks);
  return cost;
}

std::string key_of(std::uint32_t column) {
  std::string key(9, '\0');
  for (int i = 0; i < 4; ++i) key[static_cast<std::size_t>(4 - i)] = static_cast<char>(column >> (8 * i));
  return key;
}

class Store {
 public:
  Store(fs::path path, const std::vector<ColumnResult>& columns) : path_{std::move(path)} {
    fs::remove_all(path_);
    options_.create_if_missing = true;
    options_.compaction_style = rocksdb::kCompactionStyleFIFO;
    options_.compaction_options_fifo.max_table_files_size = std::uint64_t{4} << 30U;
    options_.compression = rocksdb::kNoCompression;
    options_.write_buffer_size = std::size_t{16} << 20U;
    rocksdb::BlockBasedTableOptions table;
    table.filter_policy.reset(rocksdb::NewBloomFilterPolicy(10));
    table.no_block_cache = true;
    options_.table_factory.reset(rocksdb::NewBlockBasedTableFactory(table));
    open();
    rocksdb::WriteOptions unlogged;
    unlogged.disableWAL = true;
    const double began = cpu_us();
    for (std::uint32_t first = 0; first < kStored; first += 16) {
      rocksdb::WriteBatch batch;
      for (std::uint32_t c = first; c < first + 16; ++c)
        batch.Put(key_of(c), columns[c % columns.size()].value);
      check(db_->Write(unlogged, &batch));
    }
    check(db_->Flush({}));
    write_us_ = (cpu_us() - began) / kStored;
    db_.reset();
    open();
  }
  ~Store() {
    db_.reset();
    fs::remove_all(path_);
  }
  [[nodiscard]] double write_us() const { return write_us_; }

  /// Pages that hold the database's files, out of the system's memory.
  void forget_pages() const {
    for (const auto& file : fs::directory_iterator{path_}) {
      const int fd = ::open(file.path().c_str(), O_RDONLY | O_CLOEXEC);
      if (fd < 0) continue;
      ::fdatasync(fd);
      ::posix_fadvise(fd, 0, 0, POSIX_FADV_DONTNEED);
      ::close(fd);
    }
  }

  /// Processor and wall time of a column's coming from the disk into the chunk cache.
  [[nodiscard]] std::pair<double, double> read(std::size_t columns, std::uint32_t seed) const {
    std::mt19937 random{seed};
    ChunkCache cache{std::size_t{256} << 20U};
    const double cpu = cpu_us();
    const double wall = wall_us();
    for (int i = 0; i < kReads; ++i) {
      const auto column = static_cast<std::uint32_t>(random() % kStored);
      rocksdb::PinnableSlice value;
      check(db_->Get({}, db_->DefaultColumnFamily(), key_of(column), &value));
      take(value.ToStringView(), static_cast<std::int32_t>(column % columns), cache);
    }
    return {(cpu_us() - cpu) / kReads, (wall_us() - wall) / kReads};
  }

 private:
  void open() {
    rocksdb::DB* db = nullptr;
    check(rocksdb::DB::Open(options_, path_.string(), &db));
    db_.reset(db);
  }

  static void take(std::string_view value, std::int32_t x, ChunkCache& cache) {
    std::uint64_t sum = 0;
    const std::size_t end = value.size() - sizeof sum;
    std::memcpy(&sum, value.data() + end, sizeof sum);
    if (sum != XXH3_64bits(value.data(), end)) fail("a checksum is wrong");
    for (std::size_t at = 0; at < end;) {
      std::int32_t y = 0;
      ContentHash hash;
      std::uint32_t length = 0;
      std::memcpy(&y, value.data() + at, sizeof y);
      std::memcpy(&hash, value.data() + at + sizeof y, sizeof hash);
      std::memcpy(&length, value.data() + at + sizeof y + sizeof hash, sizeof length);
      at += sizeof y + sizeof hash + sizeof length;
      const std::string_view payload = value.substr(at, length);
      cache.put({{x, y, 0}, Lod{}},
                std::make_shared<const EncodedChunk>(hash, std::as_bytes(std::span{payload})));
      at += length;
    }
  }

  fs::path path_;
  rocksdb::Options options_;
  std::unique_ptr<rocksdb::DB> db_;
  double write_us_ = 0;
};

double found_in_memory_us(const std::vector<ColumnResult>& columns) {
  ChunkCache cache{std::size_t{256} << 20U};
  std::size_t chunks = 0;
  for (const ColumnResult& made : columns) {
    for (const auto& [key, chunk] : made.chunks) cache.put(key, chunk);
    chunks += made.chunks.size();
  }
  if (chunks == 0) return 0;
  constexpr int kRounds = 50;
  std::size_t found = 0;
  const double began = cpu_us();
  for (int round = 0; round < kRounds; ++round) {
    for (const ColumnResult& made : columns) {
      for (const auto& [key, chunk] : made.chunks) found += cache.find(key) != nullptr ? 1U : 0U;
    }
  }
  if (found != chunks * kRounds) fail("a chunk is missing");
  return (cpu_us() - began) / kRounds / static_cast<double>(columns.size());
}

void measure(const fs::path& directory, const char* name, const terrain::World& world, Lod lod,
             std::int32_t patches) {
  const Cost cost = make(world, patches, lod);
  std::size_t chunks = 0;
  std::size_t bytes = 0;
  for (const ColumnResult& made : cost.columns) {
    chunks += made.chunks.size();
    bytes += made.value.size();
  }
  const auto columns = static_cast<double>(cost.columns.size());
  const Store store{directory / "columns", cost.columns};
  (void)store.read(cost.columns.size(), 1);  // fills the system's memory of the files
  const auto warm = store.read(cost.columns.size(), 2);
  store.forget_pages();
  const auto cold = store.read(cost.columns.size(), 3);
  std::printf("| %-28s | %d | %4.1f | %6.0f | %8.1f | %6.1f | %6.1f | %6.1f | %6.2f | %6.2f | %6.1f |\n",
              name, static_cast<int>(lod.value()), static_cast<double>(chunks) / columns,
              static_cast<double>(bytes) / columns, cost.column_us, warm.first, cold.first, cold.second,
              found_in_memory_us(cost.columns), store.write_us(), cost.column_us / cold.second);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const fs::path directory =
      (argc > 1 ? fs::path{argv[1]} : fs::temp_directory_path()) / "talus-bench-base-cache";
  fs::create_directories(directory);
  std::printf("microseconds a column of chunks; of made, found and written: processor time\n");
  std::printf(
      "| world | level | mixed chunks | bytes | made | disk, warm | disk, cold | its wall | memory | written "
      "| made / cold wall |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const char* name :
       {"classic", "canyon", "hills", "features", "default", "archipelago", "mesas", "alpine"}) {
    measure(directory, name, bench::sample_world(name), Lod{}, 6);
    measure(directory, name, bench::sample_world(name), Lod::of(3), 4);
  }
  const std::string classic = bench::text_of_world("classic");
  for (const int steps : {8, 32}) {
    const std::string eroded =
        "method = \"erosion\"\nerosion_steps = " + std::to_string(steps) + "\n" + classic;
    measure(directory, ("classic, " + std::to_string(steps) + " steps of erosion").c_str(),
            terrain::World::parse(eroded, "eroded").value(), Lod{}, 3);
  }
  fs::remove_all(directory);
  return 0;
}
