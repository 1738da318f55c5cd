// The first failed write or sync of an open database.
#pragma once

#include <atomic>
#include <mutex>

#include <rocksdb/status.h>

namespace talus::store {

/// Once set, nothing more is written until the database is opened again. Callable from any thread.
class WriteFailure {
 public:
  [[nodiscard]] bool is_set() const { return is_set_.load(std::memory_order_acquire); }
  /// OK if nothing failed.
  [[nodiscard]] rocksdb::Status get() const {
    const std::lock_guard lock{mutex_};
    return status_;
  }
  /// Keeps the first.
  void set(const rocksdb::Status& status) {
    const std::lock_guard lock{mutex_};
    if (!status_.ok()) return;
    status_ = status;
    is_set_.store(true, std::memory_order_release);
  }

 private:
  mutable std::mutex mutex_;
  rocksdb::Status status_;
  std::atomic<bool> is_set_{false};
};

}  // namespace talus::store
