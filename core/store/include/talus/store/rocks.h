// RocksDB settings and helpers of the edit store.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <rocksdb/db.h>
#include <rocksdb/options.h>

#include <talus/store/keys.h>
#include <talus/store/sealed_value.h>

namespace talus::store {

struct RocksSettings {
  rocksdb::Env* env = nullptr;  // null: the system's
  std::size_t write_buffer_bytes = std::size_t{32} << 20U;
  std::size_t block_cache_bytes = std::size_t{8} << 20U;
  /// Writes are not synced one by one; after a power cut, recovery stops at the first lost write.
  bool point_in_time = false;
};

[[nodiscard]] rocksdb::Options rocks_options(const RocksSettings& settings, bool create);

/// Memory of a database: unflushed writes, cached blocks, and the index and filter of each open table.
/// Callable from any thread.
[[nodiscard]] std::size_t rocks_memory(rocksdb::DB& db);

/// Advice to the operator for a database that cannot be opened or read.
[[nodiscard]] std::string_view remedy_for(const rocksdb::Status& status);

/// Deletes unfinished files of options, which RocksDB keeps for ever if it is killed while it writes them.
/// REQUIRES: the database is not open.
void remove_unfinished_options(rocksdb::Env& env, const std::string& database);

/// Options for sequential reads, which bypass the cache.
[[nodiscard]] rocksdb::ReadOptions for_scans();

[[nodiscard]] inline rocksdb::Slice as_slice(const Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
[[nodiscard]] inline std::span<const std::byte> bytes_of(const rocksdb::Slice& slice) {
  return std::as_bytes(std::span{slice.data(), slice.size()});
}
[[nodiscard]] inline std::string_view text_of(const rocksdb::Slice& slice) {
  return {slice.data(), slice.size()};
}

[[nodiscard]] inline std::string prefix_of(KeyKind kind) {
  return std::string(1, static_cast<char>(kind));
}

/// Calls visit(key, value) for all keys from `first` on that share its first byte, until it returns false.
template <typename Visit>
rocksdb::Status scan(rocksdb::DB& db, const std::string& first, Visit&& visit) {
  const std::unique_ptr<rocksdb::Iterator> at{db.NewIterator(for_scans())};
  for (at->Seek(first); at->Valid(); at->Next()) {
    if (at->key().empty() || at->key()[0] != first.front()) break;
    if (!visit(at->key(), at->value())) break;
  }
  return at->status();
}

}  // namespace talus::store
