// RocksDB without its own file of lines.
#pragma once

#include <cstdarg>

#include <rocksdb/env.h>

namespace talus::store {

/// What fails comes back as a Status, and talusd tells it. RocksDB's own file of lines must not be: where a
/// write to it fails, its next line ends the process.
class NoInfoLog final : public rocksdb::Logger {
 public:
  using Logger::Logv;
  void Logv(const char*, va_list) override {}
};

}  // namespace talus::store
