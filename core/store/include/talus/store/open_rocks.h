// Opens a store's RocksDB database. The torn end of its log or manifest, as a power cut leaves it, is
// dropped; other damage is refused, with the damaged file's name.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/rocks.h>
#include <talus/store/write_failure.h>

namespace talus::store {

struct OpenedRocks {
  std::shared_ptr<const void> parts;  // the database refers to them
  std::unique_ptr<rocksdb::DB> db;
  /// Set once a write, a sync or work in the background failed: a write or sync of `db` counts only if this
  /// is not set after it, and none may follow.
  std::shared_ptr<WriteFailure> failure;
  std::string dropped;  // one line about what was dropped; empty if nothing was
};

struct RocksFailure {
  rocksdb::Status status;
  std::string line;  // names the store and the damage, and ends with a remedy
};

enum class RocksUse { read, write };

/// Opens the database in `store`/db. Refuses to drop a torn end if the file acknowledged is ahead of the
/// rest. With settings.point_in_time the log ends at its first damage.
[[nodiscard]] tl::expected<OpenedRocks, RocksFailure> open_rocks(const std::filesystem::path& store,
                                                                 const RocksSettings& settings, RocksUse use,
                                                                 bool create = false);

}  // namespace talus::store
