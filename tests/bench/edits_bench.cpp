// How many edits a second the log of one machine takes, beside RocksDB's own synced batches of the same bytes
// in the same run; how long a store takes to open; what applying costs. bench_edits [DIRECTORY [settle |
// open | rate [8 | 100000]]]: where the stores lie, on the disk to be measured; what settling costs alone, or
// opening, or edits a second.
#include <time.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <rocksdb/db.h>
#include <rocksdb/write_batch.h>

#include <talus/store/edit_database.h>
#include <talus/store/store_builder.h>

#include "edits/edit_state.h"
#include "edits/local_log.h"
#include "runtime/clock.h"

namespace {

using namespace talus;
using namespace talus::server;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kEditors = 64;
constexpr double kSeconds = 2.0;
constexpr int kEntries = 10'000;  // of each editor
constexpr MaterialId kBase{1};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double cpu_seconds() {
  timespec used{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) / 1e9;
}

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "bench_edits: %s\n", what.c_str());
  std::exit(1);
}

store::EditDatabaseSettings settings_at(const fs::path& path) {
  return {.path = path, .fingerprint = {1, 2}, .store_id = {3, 4}};
}

struct Store {
  explicit Store(const fs::path& path) {
    auto opened = store::EditDatabase::open(settings_at(path));
    if (!opened) fail(opened.error());
    database = std::move(*opened);
    auto read = EditState::open(*database, {});
    if (!read) fail(read.error());
    state = std::move(*read);
  }
  std::unique_ptr<store::EditDatabase> database;
  std::unique_ptr<EditState> state;
};

ChunkCoord chunk_number(std::uint32_t number) {
  return {static_cast<std::int32_t>(number % 400), 2, static_cast<std::int32_t>(number / 400)};
}

/// A voxel of one of `chunks` chunks, of a material that it has not.
edits::EditEntry one_voxel(edits::EditorId id, std::uint32_t chunks, std::mt19937& random) {
  const ChunkCoord chunk = chunk_number(static_cast<std::uint32_t>(random() % chunks));
  const auto index = static_cast<std::uint16_t>(random() % kChunkVolume);
  const VoxelPos origin = chunk_origin(chunk);
  const VoxelPos at{origin.x + index % 32, origin.y + index / 1024, origin.z + index / 32 % 32};
  edits::EditEntry entry{id, 1, 0, {}, {}};
  entry.edit.writes.push_back({at, MaterialId{static_cast<std::uint16_t>(2 + random() % 50)}});
  entry.base[chunk].push_back({index, kBase});
  entry.touched.push_back({chunk, {index}});  // as EditIntake hands it on
  return entry;
}

/// Editors that have one edit under way each, on the log's thread.
class Editors {
 public:
  Editors(LocalLog& log, std::uint32_t chunks) : log_{log} {
    std::mt19937 random{7};
    for (std::uint64_t i = 0; i < kEditors; ++i) {
      auto& own = entries_.emplace_back();
      for (int n = 0; n < kEntries; ++n) own.push_back(one_voxel({i + 1, 1}, chunks, random));
    }
    sequences_.resize(kEditors);
    end_ =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kSeconds));
    for (std::size_t i = 0; i < kEditors; ++i) {
      ++waiting_;
      const auto attached = [this, i](const auto& applied) {
        if (!applied) fail(applied.error().message);
        answered(i);
      };
      if (!log_.append(edits::AttachEntry{{i + 1, 1}, 1, "somebody"}, attached)) fail("the log refuses");
    }
  }

  /// Edits a second.
  double run() {
    const auto start = Clock::now();
    std::unique_lock lock{mutex_};
    quiet_.wait(lock, [this] { return waiting_ == 0; });
    return static_cast<double>(edits_) / seconds_since(start);
  }

 private:
  void answered(std::size_t editor) {
    if (Clock::now() > end_) {
      const std::lock_guard lock{mutex_};
      --waiting_;
      quiet_.notify_one();
      return;
    }
    auto& own = entries_[editor];
    if (sequences_[editor] == own.size()) fail("it is faster than there are edits made for it");
    // Making it is not the log's work, nor is this.
    edits::EditEntry entry = std::move(own[sequences_[editor]]);
    entry.sequence = ++sequences_[editor];
    const auto taken = log_.append(std::move(entry), [this, editor](const auto& applied) {
      if (!applied) fail(applied.error().message);
      if ((*applied)->kind != edits::EntryResult::Kind::done) fail("an edit was not done");
      ++edits_;
      answered(editor);
    });
    if (!taken) fail("the log refuses");
  }

  LocalLog& log_;
  std::vector<std::vector<edits::EditEntry>> entries_;
  std::vector<std::uint64_t> sequences_;
  Clock::time_point end_;
  std::mutex mutex_;
  std::condition_variable quiet_;
  int waiting_ = 0;
  std::uint64_t edits_ = 0;
};

struct Rate {
  double edits = 0;
  double cpu_us = 0;      // of the process, an edit: also where others take the processors
  double bytes_each = 0;  // of a record
};

Rate edits_a_second(const fs::path& path, std::uint32_t chunks) {
  fs::remove_all(path);
  Store store{path};
  const SystemClock clock;
  LocalLog log{*store.database, *store.state, clock, {}, {}};
  Editors editors{log, chunks};
  const double cpu = cpu_seconds();
  Rate rate;
  rate.edits = editors.run();
  rate.cpu_us = (cpu_seconds() - cpu) / (rate.edits * kSeconds) * 1e6;
  log.stop();
  std::vector<store::LogRecord> batch;
  const auto read = store.database->for_each_record(65, [&](store::LogRecord&& record) {
    batch.push_back(std::move(record));
    return batch.size() < kEditors;
  });
  if (!read) fail(read.error());
  store::Bytes value;
  encode(batch, 0, value);
  rate.bytes_each = static_cast<double>(value.size()) / kEditors;
  return rate;
}

/// As many values of as many bytes in each synced batch, and the state's: what a log costs at least.
Rate rocksdb_a_second(const fs::path& path, std::size_t bytes_each) {
  fs::remove_all(path);
  fs::create_directories(path);
  rocksdb::Options options;
  options.create_if_missing = true;
  options.write_buffer_size = std::size_t{32} << 20U;
  rocksdb::DB* opened = nullptr;
  if (const auto status = rocksdb::DB::Open(options, path.string(), &opened); !status.ok())
    fail(status.ToString());
  const std::unique_ptr<rocksdb::DB> db{opened};
  rocksdb::WriteOptions synced;
  synced.sync = true;
  const std::string value(bytes_each, 'v');
  const std::string meta(133, 'm');
  std::uint64_t position = 0;
  const auto start = Clock::now();
  const double cpu = cpu_seconds();
  while (seconds_since(start) < kSeconds) {
    rocksdb::WriteBatch batch;
    for (int i = 0; i < kEditors; ++i) batch.Put(store::log_key(++position), value);
    batch.Put("m", meta);
    if (const auto status = db->Write(synced, &batch); !status.ok()) fail(status.ToString());
  }
  return {.edits = static_cast<double>(position) / seconds_since(start),
          .cpu_us = (cpu_seconds() - cpu) / static_cast<double>(position) * 1e6};
}

void compare(const fs::path& directory, const char* name, std::uint32_t chunks) {
  std::vector<double> ours;
  std::vector<double> theirs;
  std::vector<double> ratios;
  for (int round = 0; round < 3; ++round) {
    const Rate rate = edits_a_second(directory / "edits", chunks);
    ours.push_back(rate.edits);
    const Rate bare = rocksdb_a_second(directory / "rocksdb", static_cast<std::size_t>(rate.bytes_each));
    theirs.push_back(bare.edits);
    ratios.push_back(ours.back() / theirs.back());
    std::printf(
        "  %-16s %9.0f edits/s  RocksDB %9.0f/s  ratio %.2f  %.1f and %.1f us of CPU each, %.0f bytes a "
        "record\n",
        name, ours.back(), theirs.back(), ratios.back(), rate.cpu_us, bare.cpu_us, rate.bytes_each);
  }
  std::sort(ours.begin(), ours.end());
  std::sort(theirs.begin(), theirs.end());
  std::sort(ratios.begin(), ratios.end());
  std::printf("%-18s %9.0f edits/s  RocksDB %9.0f/s  ratio %.2f  (medians)\n", name, ours[1], theirs[1],
              ratios[1]);
}

/// A store of 20,000 chunks with 50 edited voxels each.
void open_store(const fs::path& path) {
  fs::remove_all(path);
  {
    Store store{path};
    const SystemClock clock;
    LocalLog log{*store.database, *store.state, clock, {}, {}};
    std::mt19937 random{7};
    std::mutex mutex;
    std::condition_variable answered;
    std::uint32_t waiting = 0;
    const auto append = [&](LogEntry entry) {
      std::unique_lock lock{mutex};
      answered.wait(lock, [&] { return waiting < 500; });
      ++waiting;
      const auto done = [&](const auto& applied) {
        if (!applied) fail(applied.error().message);
        const std::lock_guard in_turn{mutex};
        --waiting;
        answered.notify_one();
      };
      if (!log.append(std::move(entry), done)) fail("the log refuses");
    };
    append(edits::AttachEntry{{1, 1}, 1, ""});
    for (std::uint32_t chunk = 0; chunk < 20'000; ++chunk) {
      edits::EditEntry entry{{1, 1}, 1, chunk + 1, {}, {}};
      const VoxelPos origin = chunk_origin(chunk_number(chunk));
      auto& base = entry.base[chunk_number(chunk)];
      for (std::uint16_t i = 0; i < 50; ++i) {
        const auto index = static_cast<std::uint16_t>(i * 600 + random() % 600);
        entry.edit.writes.push_back(
            {{origin.x + index % 32, origin.y + index / 1024, origin.z + index / 32 % 32},
             MaterialId{static_cast<std::uint16_t>(2 + random() % 9)}});
        base.push_back({index, kBase});
      }
      append(std::move(entry));
    }
    log.stop();
  }
  std::vector<double> times;
  for (int i = 0; i < 5; ++i) {
    const auto start = Clock::now();
    const Store store{path};
    times.push_back(seconds_since(start));
    if (store.state->index().chunks() < 20'000) fail("chunks are missing");
  }
  std::sort(times.begin(), times.end());
  std::printf("opening 1,000,000 voxels in 20,000 chunks: %.3f s (median of 5, worst %.3f s)\n", times[2],
              times[4]);
}

/// A store of a million chunks with one edited voxel each.
void open_many_chunks(const fs::path& path) {
  constexpr int kSide = 1'000;
  fs::remove_all(path);
  fs::create_directories(path);
  {
    auto builder = store::StoreBuilder::create(path, {{3, 4}, {1, 2}}, 0, 0);
    if (!builder) fail(builder.error());
    for (std::int32_t x = 0; x < kSide; ++x) {
      for (std::int32_t z = 0; z < kSide; ++z) {
        // Of an odd x, so a sample of no coarser level.
        const Override voxel{static_cast<std::uint16_t>((x * kSide + z) % 16'384 * 2 + 1), MaterialId{2}};
        if (auto added = (*builder)->add({x, 3, z}, 1, {&voxel, 1}); !added) fail(added.error());
      }
    }
    if (auto finished = (*builder)->finish(1, 1); !finished) fail(finished.error());
  }
  std::vector<double> times;
  for (int i = 0; i < 5; ++i) {
    const auto start = Clock::now();
    const Store store{path};
    times.push_back(seconds_since(start));
    if (store.state->index().chunks() != kSide * kSide) fail("chunks are missing");
  }
  std::sort(times.begin(), times.end());
  std::printf("opening 1,000,000 edited chunks: %.2f s (median of 5, worst %.2f s)\n", times[2], times[4]);
}

/// Evaluating, staging and committing alone.
void apply_costs(const fs::path& path) {
  fs::remove_all(path);
  Store store{path};
  const auto batch_of = [&](const std::vector<edits::EditEntry>& entries, bool attach) {
    const EditState::Reader reading{*store.state};
    edits::Batch batch{reading, store.state->editors(), store.state->head(), 1};
    if (attach) batch.apply(edits::AttachEntry{{1, 1}, 1, ""});
    for (const auto& each : entries) batch.apply(each);
    store.state->commit(std::move(batch));
  };
  batch_of({}, true);
  std::mt19937 random{7};
  std::uint64_t sequence = 0;
  for (const std::uint32_t chunks : {8U, 100'000U}) {
    std::vector<double> times;
    for (int round = 0; round < 300; ++round) {
      std::vector<edits::EditEntry> entries;
      for (int i = 0; i < 64; ++i) {
        entries.push_back(one_voxel({1, 1}, chunks, random));
        entries.back().sequence = ++sequence;
      }
      const auto start = Clock::now();
      batch_of(entries, false);
      times.push_back(seconds_since(start) / 64);
    }
    std::sort(times.begin(), times.end());
    std::printf("apply and commit of one voxel in %u chunks: %.2f us\n", chunks,
                times[times.size() / 2] * 1e6);
  }
  std::vector<double> times;
  for (int round = 0; round < 7; ++round) {
    edits::EditEntry entry{{1, 1}, 1, ++sequence, {}, {}};
    entry.edit.fills.push_back(
        {{0, 9'000, 0}, {63, 9'015, 63}, MaterialId{static_cast<std::uint16_t>(2 + round)}, {}});
    const auto all = edits::touched_voxels(entry.edit);
    for (const auto& touched : *all) {
      for (const std::uint16_t index : touched.voxels) entry.base[touched.chunk].push_back({index, kBase});
    }
    const auto start = Clock::now();
    batch_of({entry}, false);
    times.push_back(seconds_since(start));
  }
  std::sort(times.begin(), times.end());
  std::printf("apply and commit of 65,536 voxels: %.2f ms\n", times[3] * 1e3);
}

/// What settling adds on the log's thread: where nothing is loose, and at worst, where shelves and sand of
/// many shapes are set loose all over the box.
void settle_costs() {
  constexpr MaterialId kRock{1};
  constexpr MaterialId kSand{3};
  constexpr MaterialId kPlanks{300};
  const auto rules = std::make_shared<const edits::SettleRules>(
      edits::SettleRules{{kSand, 160}, {MaterialId{4}, 175}, {MaterialId{5}, 190}, {MaterialId{6}, 215}});
  struct Empty final : edits::OverrideSource {
    const edits::ChunkOverrides* find(ChunkKey) const override { return nullptr; }
  } none;
  /// CPU microseconds of applying it to generated ground of `ground` rows of rock, above it `above`.
  const auto cost = [&](const edits::Edit& edit, bool settles, std::int64_t ground, MaterialId above) {
    edits::EditEntry entry{{1, 1}, 1, 1, edit, {}, settles ? rules : nullptr};
    const auto loose = settles ? edits::settle_box(edit) : std::nullopt;
    for (const auto& touched : edits::with_settling(edits::touched_voxels(edit).value(), loose)) {
      const std::int64_t low = chunk_origin(touched.chunk).y;
      for (const std::uint16_t index : touched.voxels) {
        entry.base[touched.chunk].push_back({index, low + index / 1024 < ground ? kRock : above});
      }
    }
    const edits::Editors editors;
    std::vector<double> times;
    for (int round = 0; round < 9; ++round) {
      edits::Batch batch{none, editors, {}, 1};
      batch.apply(edits::AttachEntry{{1, 1}, 1, ""});
      const double start = cpu_seconds();
      const bool done = batch.apply(entry).kind == edits::EntryResult::Kind::done;
      times.push_back((cpu_seconds() - start) * 1e6);
      if (!done) fail("an edit was not done");
    }
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
  };
  edits::Edit dig;
  dig.writes.push_back({{100, 100, 100}, kAir});
  std::printf(
      "apply of one voxel dug in rock: %.1f us, with settling %.1f us; in sand with settling %.0f us\n",
      cost(dig, false, 1'000, kAir), cost(dig, true, 1'000, kAir), cost(dig, true, 50, kSand));
  std::mt19937 random{7};
  double worst = 0;
  for (int round = 0; round < 200; ++round) {
    const auto width = static_cast<std::int64_t>(2 + random() % 13);
    const auto height = static_cast<std::int64_t>(8 + random() % 48);
    const auto shelves = static_cast<std::uint32_t>(random() % 6);
    const auto sand = static_cast<std::uint32_t>(1 + random() % 8);
    edits::Edit build;
    for (std::int64_t y = 0; y < height; ++y) {
      for (std::int64_t z = 0; z < width; ++z) {
        for (std::int64_t x = 0; x < width; ++x) {
          const MaterialId material = random() % 64 < shelves ? kPlanks : random() % 8 < sand ? kSand : kAir;
          build.writes.push_back({{24 + x, 24 + y, 24 + z}, material});
        }
      }
    }
    worst = std::max(worst, cost(build, true, 24, kAir));
  }
  std::printf("apply of the worst of 200 edits that settle: %.2f ms\n", worst / 1e3);
}

}  // namespace

int main(int argc, char** argv) {
  const fs::path directory = (argc > 1 ? fs::path{argv[1]} : fs::temp_directory_path()) / "talus-bench-edits";
  fs::create_directories(directory);
  std::printf("64 waiting editors, one voxel an edit, each batch synced\n");
  const std::string only = argc > 2 ? argv[2] : "";
  if (only != "rate" && only != "open") settle_costs();
  if (only == "settle") return 0;
  if (only == "rate") {
    const bool few = argc <= 3 || std::string_view{argv[3]} == "8";
    if (few) compare(directory, "8 chunks", 8);
    if (argc <= 3 || !few) compare(directory, "100,000 chunks", 100'000);
    fs::remove_all(directory);
    return 0;
  }
  open_store(directory / "open");
  open_many_chunks(directory / "many");
  fs::remove_all(directory / "many");
  if (only == "open") return 0;
  apply_costs(directory / "apply");
  compare(directory, "8 chunks", 8);
  compare(directory, "100,000 chunks", 100'000);
  fs::remove_all(directory);
  return 0;
}
