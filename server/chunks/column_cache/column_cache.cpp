#include "chunks/column_cache/column_cache.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <rocksdb/cache.h>
#include <rocksdb/db.h>
#include <rocksdb/filter_policy.h>
#include <rocksdb/table.h>

#include <talus/files/atomic_file.h>
#include <talus/files/read_file.h>
#include <talus/store/no_info_log.h>
#include <talus/store/regular_files.h>
#include <talus/store/rocks.h>
#include <talus/voxel/codec.h>

namespace talus::server {
namespace {

constexpr int kFormat = 1;
constexpr std::size_t kMaxIdentityBytes = 1024;
constexpr std::size_t kBlockBytes = std::size_t{16} << 10U;  // the columns of a patch are in one or two
constexpr int kWriteBuffers = 2;
constexpr std::size_t kMemoryParts = kWriteBuffers + 1;  // the third part is for read blocks
constexpr std::chrono::seconds kDiskCheckInterval{1};

rocksdb::Options options_of(const ColumnCacheSettings& settings) {
  rocksdb::Options options;
  options.create_if_missing = true;
  options.compaction_style = rocksdb::kCompactionStyleFIFO;
  options.compaction_options_fifo.max_table_files_size = settings.bytes;
  options.write_buffer_size = settings.memory_bytes / kMemoryParts;
  options.max_write_buffer_number = kWriteBuffers;
  // Files are never merged, only the oldest deleted: their number must not delay writes.
  options.level0_slowdown_writes_trigger = options.level0_stop_writes_trigger = 1 << 20;
  options.max_file_opening_threads = 1;           // as for the store
  options.compression = rocksdb::kNoCompression;  // payloads are already compressed
  options.info_log = std::make_shared<store::NoInfoLog>();
  options.stats_dump_period_sec = 0;
  options.stats_persist_period_sec = 0;
  rocksdb::BlockBasedTableOptions table;
  table.filter_policy.reset(rocksdb::NewBloomFilterPolicy(10));
  table.block_size = kBlockBytes;
  table.block_cache = rocksdb::NewLRUCache(settings.memory_bytes / kMemoryParts);
  options.table_factory.reset(rocksdb::NewBlockBasedTableFactory(table));
  return options;
}

rocksdb::WriteOptions without_waiting() {
  rocksdb::WriteOptions options;
  options.disableWAL = true;  // columns lost in a crash are regenerated
  options.no_slowdown = true;
  return options;
}

}  // namespace

ColumnCache::ColumnCache(const ColumnCacheSettings& settings, Logger log, const Clock& clock)
    : settings_{settings},
      log_{std::move(log)},
      clock_{clock},
      disk_checked_at_{(clock.now() - kDiskCheckInterval).time_since_epoch().count()} {}

ColumnCache::~ColumnCache() {
  if (db_ != nullptr) (void)db_->Flush({});
}

tl::expected<std::unique_ptr<ColumnCache>, std::string> ColumnCache::open(const ColumnCacheSettings& settings,
                                                                          Logger log, const Clock& clock) {
  std::unique_ptr<ColumnCache> cache{new ColumnCache{settings, std::move(log), clock}};
  if (cache->is_ours() && cache->open_database()) return cache;
  const auto begun = cache->begin_anew().and_then([&] { return cache->open_database(); });
  if (begun) return cache;
  return tl::unexpected{fmt::format(
      "the cache of columns {}: {}; give --data a directory that talusd may write, or set cache.disk_bytes "
      "to 0",
      settings.path.string(), begun.error())};
}

std::string ColumnCache::identity() const {
  return fmt::format("columns {}, codec {}, world {}\n", kFormat, kCodecVersion,
                     to_string(settings_.fingerprint));
}

bool ColumnCache::is_ours() const {
  const auto held = files::read_regular_file(identity_path(), kMaxIdentityBytes);
  return held && *held == identity();
}

tl::expected<void, std::string> ColumnCache::begin_anew() {
  std::error_code error;
  if (std::filesystem::exists(settings_.path, error)) {
    for (std::filesystem::directory_iterator entry{settings_.path, error}, end; !error && entry != end;
         entry.increment(error)) {
      const std::string name = entry->path().filename().string();
      if (name == "identity" || name == "db" || name == "pregen") continue;
      return tl::unexpected{
          fmt::format("it holds \"{}\", which is not of such a cache; move that away", name)};
    }
    log_->info("the cache of columns {} begins anew: it is of another world or version, or damaged",
               settings_.path.string());
  }
  if (!error) std::filesystem::remove_all(settings_.path, error);
  if (!error) std::filesystem::create_directories(settings_.path, error);
  if (error) return tl::unexpected{error.message()};
  return files::write_file(identity_path(), identity()).map_error([](const files::FileError& failed) {
    return failed.message();
  });
}

tl::expected<void, std::string> ColumnCache::open_database() {
  if (auto regular = store::check_regular_files(settings_.path / "db"); !regular) return regular;
  rocksdb::DB* db = nullptr;
  const auto status = rocksdb::DB::Open(options_of(settings_), (settings_.path / "db").string(), &db);
  db_.reset(db);
  if (!status.ok()) return tl::unexpected{status.ToString()};
  return {};
}

bool ColumnCache::worth(std::chrono::nanoseconds cost) const {
  const std::chrono::nanoseconds read{read_ns_.load(std::memory_order_relaxed)};
  return cost >= std::max<std::chrono::nanoseconds>(kWorthKeeping, read + read / 2);
}

std::optional<ColumnRecord> ColumnCache::find(ChunkKey column) {
  const auto began = clock_.now();
  rocksdb::PinnableSlice value;
  const auto status = db_->Get({}, db_->DefaultColumnFamily(), column_key(column), &value);
  if (status.IsNotFound()) {
    missing_.add();
    return std::nullopt;
  }
  auto record = status.ok() ? decode_column(column, std::as_bytes(std::span{value.data(), value.size()}))
                            : std::nullopt;
  if (!record) {
    lost_.add();
    if (!told_.exchange(true)) {
      log_->warn("the cache of columns: a column is damaged and made anew: {}", status.ToString());
    }
    return std::nullopt;
  }
  found_.add();
  // Average of about the last dozen reads; a race between two threads may lose one, which does not matter.
  const std::int64_t took = std::chrono::nanoseconds{clock_.now() - began}.count();
  const std::int64_t before = read_ns_.load(std::memory_order_relaxed);
  read_ns_.store(before + (took - before) / 8, std::memory_order_relaxed);
  return record;
}

void ColumnCache::put(ChunkKey column, const ColumnRecord& record) {
  static thread_local std::vector<std::byte> value;
  if (!has_room()) return lost_.add();
  encode(column, record, value);
  // A patch regenerated for another chunk mostly has the stored content: do not store it twice.
  rocksdb::PinnableSlice kept;
  if (db_->Get({}, db_->DefaultColumnFamily(), column_key(column), &kept).ok() &&
      kept == store::as_slice(value)) {
    return;
  }
  const auto status = db_->Put(without_waiting(), column_key(column), store::as_slice(value));
  if (status.ok()) return kept_.add();
  lost_.add();
  if (!status.IsIncomplete() && !told_.exchange(true)) {
    log_->warn("the cache of columns keeps nothing for now: {}", status.ToString());
  }
}

void ColumnCache::flush() {
  if (const auto status = db_->Flush({}); !status.ok() && !told_.exchange(true)) {
    log_->warn("the cache of columns keeps nothing for now: {}", status.ToString());
  }
}

bool ColumnCache::has_room() {
  const std::int64_t now = clock_.now().time_since_epoch().count();
  std::int64_t before = disk_checked_at_.load(std::memory_order_relaxed);
  constexpr std::int64_t kInterval = Clock::duration{kDiskCheckInterval}.count();
  if (now - before >= kInterval && disk_checked_at_.compare_exchange_strong(before, now)) {
    std::error_code error;
    const auto space = std::filesystem::space(settings_.path, error);
    has_room_ = !error && space.available >= settings_.free_bytes;
  }
  return has_room_;
}

ColumnCache::State ColumnCache::status() const {
  State status{found_.total(), missing_.total(), kept_.total(), lost_.total()};
  (void)db_->GetIntProperty(rocksdb::DB::Properties::kTotalSstFilesSize, &status.bytes);
  status.memory_bytes = store::rocks_memory(*db_);
  return status;
}

}  // namespace talus::server
