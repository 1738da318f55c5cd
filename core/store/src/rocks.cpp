#include <talus/store/rocks.h>

#include <algorithm>
#include <cerrno>
#include <initializer_list>
#include <string>
#include <system_error>
#include <vector>

#include <rocksdb/cache.h>
#include <rocksdb/env.h>
#include <rocksdb/filter_policy.h>
#include <rocksdb/slice_transform.h>
#include <rocksdb/table.h>

#include <talus/store/no_info_log.h>
#include <talus/store/store_reader.h>

namespace talus::store {
namespace {

/// Chunk keys arrive in sorted slices, so each is inserted near the previous one. RocksDB 7.8 shares one
/// insertion hint between keys and the starts of range deletions, which live in different lists. So the
/// domain excludes log keys, the only ones deleted by range.
class ChunksInOrder final : public rocksdb::SliceTransform {
 public:
  [[nodiscard]] const char* Name() const override { return "talus.chunks_in_order"; }
  [[nodiscard]] rocksdb::Slice Transform(const rocksdb::Slice& key) const override { return {key.data(), 1}; }
  [[nodiscard]] bool InDomain(const rocksdb::Slice& key) const override {
    return !key.empty() && static_cast<KeyKind>(key[0]) == KeyKind::chunk;
  }
};

}  // namespace

rocksdb::Options rocks_options(const RocksSettings& settings, bool create) {
  rocksdb::Options options;
  if (settings.env != nullptr) options.env = settings.env;
  options.create_if_missing = create;
  options.paranoid_checks = true;
  options.wal_recovery_mode = settings.point_in_time
                                  ? rocksdb::WALRecoveryMode::kPointInTimeRecovery
                                  : rocksdb::WALRecoveryMode::kTolerateCorruptedTailRecords;
  options.track_and_verify_wals_in_manifest = true;
  options.manual_wal_flush = false;
  options.recycle_log_file_num = 0;
  options.wal_compression = rocksdb::kNoCompression;
  options.write_buffer_size = settings.write_buffer_bytes;
  options.compression = rocksdb::kLZ4Compression;
  options.allow_concurrent_memtable_write = false;  // one thread writes
  options.memtable_insert_with_hint_prefix_extractor = std::make_shared<ChunksInOrder>();
  options.max_background_jobs = 2;
  options.max_open_files = 256;
  options.max_file_opening_threads = 1;  // RocksDB ends the process if the system refuses it one of several
  options.info_log = std::make_shared<NoInfoLog>();
  options.stats_dump_period_sec = 0;
  options.stats_persist_period_sec = 0;
  rocksdb::BlockBasedTableOptions table;
  table.filter_policy.reset(rocksdb::NewBloomFilterPolicy(10));
  table.block_cache = rocksdb::NewLRUCache(settings.block_cache_bytes);
  options.table_factory.reset(rocksdb::NewBlockBasedTableFactory(table));
  return options;
}

std::size_t rocks_memory(rocksdb::DB& db) {
  using Properties = rocksdb::DB::Properties;
  std::size_t bytes = 0;
  for (const std::string& property :
       {Properties::kSizeAllMemTables, Properties::kBlockCacheUsage, Properties::kEstimateTableReadersMem}) {
    std::uint64_t of_property = 0;
    if (db.GetIntProperty(property, &of_property)) bytes += of_property;
  }
  return bytes;
}

std::string_view remedy_for(const rocksdb::Status& status) {
  if (status.IsNoSpace()) return "its disk is full: nothing is damaged; free some space, or inodes";
  // RocksDB keeps only the text of an error number.
  const std::string text = status.ToString();
  const auto is = [&](std::initializer_list<int> errors) {
    return status.IsIOError() && std::ranges::any_of(errors, [&](int error) {
             return text.ends_with(std::generic_category().message(error));
           });
  };
  if (is({EACCES, EPERM, EROFS})) {
    return "nothing is damaged; let talusd's user read and write all files of the data directory";
  }
  if (is({EMFILE, ENFILE})) return "nothing is damaged; raise the limit of open files";
  if (is({EDQUOT})) return "its user's quota is full: nothing is damaged; raise the quota";
  if (is({EFBIG})) return "nothing is damaged; raise the limit of a file's size (ulimit -f)";
  if (is({EIO, ENXIO, ENODEV, ETIMEDOUT, ESTALE})) {
    return "its disk fails: check it and the kernel's log; if it stays so, restore a backup on another disk";
  }
  // As older versions of RocksDB say of a table or a manifest of a newer one.
  for (const std::string_view newer :
       {"unsupported format_version", "unknown checksum type", "unknown tag"}) {
    if (text.find(newer) != text.npos) {
      return "a newer talusd may have written it: start that one, or restore a backup";
    }
  }
  return kStoreLost;
}

void remove_unfinished_options(rocksdb::Env& env, const std::string& database) {
  std::vector<std::string> names;
  if (!env.GetChildren(database, &names).ok()) return;
  for (const std::string& name : names) {
    if (name.starts_with("OPTIONS-") && name.ends_with(".dbtmp")) {
      env.DeleteFile(database + '/' + name).PermitUncheckedError();
    }
  }
}

rocksdb::ReadOptions for_scans() {
  rocksdb::ReadOptions options;
  options.fill_cache = false;
  options.total_order_seek = true;
  return options;
}

}  // namespace talus::store
