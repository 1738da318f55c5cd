// Notices that other programs deleted or replaced the files of an open store. The store's descriptors go on
// working, but later writes are lost.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <string>

namespace talus::store {

class StoreWatch {
 public:
  /// Remembers the lock and the database that the data directory `path` has now.
  explicit StoreWatch(std::filesystem::path path);
  /// Names a file that was deleted or replaced since, in one line; nullopt if all are in their places.
  [[nodiscard]] std::optional<std::string> gone() const;

 private:
  using Identity = std::optional<struct stat>;  // nullopt: the file does not exist

  const std::filesystem::path path_;
  const Identity lock_;
  const Identity database_;
  const Identity current_;  // RocksDB replaces it: only its existence counts
};

}  // namespace talus::store
