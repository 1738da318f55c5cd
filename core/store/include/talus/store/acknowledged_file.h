// How far edits were acknowledged, in a small file beside the database. RocksDB takes a log that lost its end
// for one that was never written further; by this file the store knows better. It is written after each
// synced batch, in place and without a sync of its own: a power cut may leave it behind the database, which
// is sound, but never before it.
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
  /// What the file says; nothing where there is none. An error is one line: it cannot be read, or is damaged.
  [[nodiscard]] static tl::expected<std::optional<Acknowledged>, std::string> read(rocksdb::Env& env,
                                                                                   const std::string& path);
  /// Makes it say `now`, on the disk, and keeps it open.
  [[nodiscard]] static tl::expected<AcknowledgedFile, std::string> open(rocksdb::Env& env,
                                                                        const std::string& path,
                                                                        const Acknowledged& now);
  AcknowledgedFile(AcknowledgedFile&&) noexcept;
  AcknowledgedFile& operator=(AcknowledgedFile&&) noexcept;
  ~AcknowledgedFile();

  /// A failure has no consequence but that the file stays behind: what it would say is on the disk already.
  void write(const Acknowledged& now);
  void sync();

 private:
  explicit AcknowledgedFile(std::unique_ptr<rocksdb::RandomRWFile> file);

  std::unique_ptr<rocksdb::RandomRWFile> file_;
  Bytes bytes_;
};

/// Whether a database that stands where `meta` says has all that the file beside it, in `directory`, says was
/// acknowledged. An error is one line, and names what is lost.
[[nodiscard]] tl::expected<void, std::string> check_acknowledged(rocksdb::Env& env,
                                                                 const std::filesystem::path& directory,
                                                                 const StoreMeta& meta);
[[nodiscard]] tl::expected<void, std::string> check_acknowledged(const std::filesystem::path& directory,
                                                                 const StoreMeta& meta);

}  // namespace talus::store
