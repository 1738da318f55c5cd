// Records how far edits were acknowledged, in a small file next to the database. RocksDB cannot tell a log
// that lost its end from one that was never longer; with this file the store can. It is written in place
// after each synced batch, without a sync of its own: a power cut may leave it behind the database, which is
// safe, but never ahead of it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/records.h>

namespace rocksdb {
class Env;
class RandomRWFile;
}  // namespace rocksdb

namespace talus::store {

class AcknowledgedFile {
 public:
  /// Reads the file; nullopt if it does not exist. An error is one line: the file is unreadable or damaged.
  [[nodiscard]] static tl::expected<std::optional<AcknowledgedState>, std::string> read(
      rocksdb::Env& env, const std::string& path);
  /// Writes `now`, syncs, and keeps the file open.
  [[nodiscard]] static tl::expected<AcknowledgedFile, std::string> open(rocksdb::Env& env,
                                                                        const std::string& path,
                                                                        const AcknowledgedState& now);
  AcknowledgedFile(AcknowledgedFile&&) noexcept;
  AcknowledgedFile& operator=(AcknowledgedFile&&) noexcept;
  ~AcknowledgedFile();

  /// Ignores failures: the file stays behind, but the data that it would acknowledge is already on the disk.
  void write(const AcknowledgedState& now);
  void sync();

 private:
  explicit AcknowledgedFile(std::unique_ptr<rocksdb::RandomRWFile> file);

  std::unique_ptr<rocksdb::RandomRWFile> file_;
  Bytes bytes_;
};

/// Checks that a database at `meta` contains everything that the file in `directory` acknowledges. An error
/// is one line and names the lost entries.
[[nodiscard]] tl::expected<void, std::string> check_acknowledged(rocksdb::Env& env,
                                                                 const std::filesystem::path& directory,
                                                                 const StoreMeta& meta);
[[nodiscard]] tl::expected<void, std::string> check_acknowledged(const std::filesystem::path& directory,
                                                                 const StoreMeta& meta);

/// False if the file exists and cannot be read, so that check_acknowledged() fails without damage.
[[nodiscard]] bool can_read_acknowledged(rocksdb::Env& env, const std::filesystem::path& directory);
[[nodiscard]] bool can_read_acknowledged(const std::filesystem::path& directory);

}  // namespace talus::store
