// Disables RocksDB's info log file.
#pragma once

#include <cstdarg>

#include <rocksdb/env.h>

namespace talus::store {

/// Errors are returned as a Status, which talusd reports. RocksDB's own log file is unsafe: after a failed
/// write to it, its next line aborts the process.
class NoInfoLog final : public rocksdb::Logger {
 public:
  using Logger::Logv;
  void Logv(const char*, va_list) override {}
};

}  // namespace talus::store
