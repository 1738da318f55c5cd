#include "store/rocks.h"

#include <rocksdb/cache.h>
#include <rocksdb/env.h>
#include <rocksdb/filter_policy.h>
#include <rocksdb/table.h>

#include "store/no_info_log.h"

namespace talus::server {

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
  // No memtable_insert_with_hint_prefix_extractor, however well the order of keys suits it: RocksDB 7.8 keeps
  // one hint for keys and for DeleteRange, which lie in different lists.
  options.max_background_jobs = 2;
  options.max_open_files = 256;
  options.info_log = std::make_shared<NoInfoLog>();
  options.stats_dump_period_sec = 0;
  options.stats_persist_period_sec = 0;
  rocksdb::BlockBasedTableOptions table;
  table.filter_policy.reset(rocksdb::NewBloomFilterPolicy(10));
  table.block_cache = rocksdb::NewLRUCache(settings.block_cache_bytes);
  options.table_factory.reset(rocksdb::NewBlockBasedTableFactory(table));
  return options;
}

rocksdb::ReadOptions for_scans() {
  rocksdb::ReadOptions options;
  options.fill_cache = false;
  options.total_order_seek = true;
  return options;
}

}  // namespace talus::server
