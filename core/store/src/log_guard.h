// Keeps a failed write or sync of the log from RocksDB. RocksDB 7.8 ends the process if it meets a log file
// that has failed before: in a sync on another thread, and in its own recovery from a full disk.
#pragma once

#include <filesystem>
#include <memory>

#include <rocksdb/env.h>
#include <rocksdb/listener.h>
#include <talus/store/write_failure.h>

namespace talus::store {

/// `env` for the database in the directory `database`, opened for writing. A failed call of a log file sets
/// `failure` and seems to succeed. From then on the log stays as it is, and writes of the database's other
/// files fail, so that no table and no manifest takes a lost write as done. REQUIRES: a write or sync counts
/// only if `failure` is not set after it. `env` must outlive the result.
[[nodiscard]] std::unique_ptr<rocksdb::Env> guard_log(rocksdb::Env& env,
                                                      const std::filesystem::path& database,
                                                      std::shared_ptr<WriteFailure> failure);

/// Sets `failure` if work in the background fails, and keeps RocksDB from going on by itself once there is
/// space: the database must be opened again.
[[nodiscard]] std::shared_ptr<rocksdb::EventListener> without_recovery(std::shared_ptr<WriteFailure> failure);

}  // namespace talus::store
