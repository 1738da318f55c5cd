// A disk for RocksDB that loses power, fills up and fails. A power cut loses unsynced data, drawn by a seed:
// - a file keeps any length from its synced length to its written length. At each cut, the disk writes pages
//   of 512 bytes or 4 KiB. Each unsynced page within the length is on the disk or is zeros, in any order;
// - a file written in place has its synced content or its last;
// - new files and renames: the last are lost, even if the data of those before is lost too, as file systems
//   with a journal keep the order of names. RocksDB needs that order: it syncs the directory only after the
//   rename that makes a new manifest the current one.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <string>

#include <rocksdb/env.h>
#include <rocksdb/file_system.h>

namespace talus::server::testing {

class UnsafeDisk final : public rocksdb::FileSystemWrapper, public std::enable_shared_from_this<UnsafeDisk> {
 public:
  explicit UnsafeDisk(std::uint64_t seed)
      : FileSystemWrapper{rocksdb::FileSystem::Default()}, random_{seed} {}

  /// After so many further writes and syncs the power goes, and everything fails.
  void cut_after(std::int64_t calls) { calls_left_ = calls; }
  [[nodiscard]] bool is_off() const { return off_; }
  /// Drops what the power cut drops, once nobody has a file open, and turns the power on.
  void restart();

  /// So many further bytes fit; the write that is too much leaves a part of itself.
  void fill_after(std::int64_t bytes) { bytes_left_ = bytes; }
  void empty() { bytes_left_ = kMany; }
  /// The sync after so many others fails, and those after it until mend().
  void fail_sync_after(std::int64_t syncs) { syncs_left_ = syncs; }
  void mend() { syncs_left_ = kMany; }
  /// Since fail_sync_after().
  [[nodiscard]] std::int64_t failed_syncs() const { return std::max<std::int64_t>(0, -syncs_left_); }
  /// All reads of open tables fail, as of bad sectors.
  void fail_reads(bool fails) { reads_fail_ = fails; }
  [[nodiscard]] bool reads_fail() const { return reads_fail_; }
  /// What the disk says that it has free; none: the truth.
  void say_free(std::optional<std::uint64_t> bytes) {
    free_ = bytes ? static_cast<std::int64_t>(*bytes) : -1;
  }

  const char* Name() const override { return "UnsafeDisk"; }
  rocksdb::IOStatus NewWritableFile(const std::string& path, const rocksdb::FileOptions& options,
                                    std::unique_ptr<rocksdb::FSWritableFile>* result,
                                    rocksdb::IODebugContext* debug) override;
  rocksdb::IOStatus ReopenWritableFile(const std::string&, const rocksdb::FileOptions&,
                                       std::unique_ptr<rocksdb::FSWritableFile>*,
                                       rocksdb::IODebugContext*) override;
  rocksdb::IOStatus ReuseWritableFile(const std::string&, const std::string&, const rocksdb::FileOptions&,
                                      std::unique_ptr<rocksdb::FSWritableFile>*,
                                      rocksdb::IODebugContext*) override;
  rocksdb::IOStatus NewRandomAccessFile(const std::string& path, const rocksdb::FileOptions& options,
                                        std::unique_ptr<rocksdb::FSRandomAccessFile>* result,
                                        rocksdb::IODebugContext* debug) override;
  rocksdb::IOStatus NewRandomRWFile(const std::string& path, const rocksdb::FileOptions& options,
                                    std::unique_ptr<rocksdb::FSRandomRWFile>* result,
                                    rocksdb::IODebugContext* debug) override;
  rocksdb::IOStatus NewDirectory(const std::string& path, const rocksdb::IOOptions& options,
                                 std::unique_ptr<rocksdb::FSDirectory>* result,
                                 rocksdb::IODebugContext* debug) override;
  rocksdb::IOStatus RenameFile(const std::string& from, const std::string& to,
                               const rocksdb::IOOptions& options, rocksdb::IODebugContext* debug) override;
  rocksdb::IOStatus DeleteFile(const std::string& path, const rocksdb::IOOptions& options,
                               rocksdb::IODebugContext* debug) override;
  rocksdb::IOStatus GetFreeSpace(const std::string& path, const rocksdb::IOOptions& options,
                                 std::uint64_t* free, rocksdb::IODebugContext* debug) override;

  // For its files.
  [[nodiscard]] rocksdb::IOStatus call();
  [[nodiscard]] rocksdb::IOStatus sync_call();
  /// How many of so many bytes fit.
  [[nodiscard]] std::size_t room(std::size_t bytes);
  void wrote(const std::string& path, std::size_t bytes);
  /// Up to so many bytes, which were written when the sync began.
  void synced(const std::string& path, std::uint64_t bytes);
  [[nodiscard]] std::uint64_t written(const std::string& path);
  void wrote_in_place(const std::string& path, const std::string& synced);
  void synced_in_place(const std::string& path);
  /// Syncs wait until they are let go.
  void hold_syncs(bool held);
  /// Waits until one does.
  void await_held_sync();
  void synced_directory(const std::string& directory);

 private:
  static constexpr std::int64_t kMany = std::int64_t{1} << 60;

  struct File {
    std::uint64_t written = 0;
    std::uint64_t synced = 0;
    bool named = false;      // its directory was synced since it was made
    std::uint64_t made = 0;  // among all changes of names
  };
  struct Rename {
    std::string from;
    std::string to;
    std::optional<std::string> replaced;  // what `to` held
    std::uint64_t made = 0;
  };

  [[nodiscard]] std::uint64_t below(std::uint64_t bound) { return random_() % bound; }
  /// Cuts the file's end, and fills unsynced pages with zeros.
  void lose_pages(const std::string& path, const File& file, std::uint64_t page_bytes);

  std::atomic<std::int64_t> calls_left_{kMany};
  std::atomic<std::int64_t> bytes_left_{kMany};
  std::atomic<std::int64_t> syncs_left_{kMany};
  std::atomic<std::int64_t> free_{-1};
  std::atomic<bool> off_{false};
  std::atomic<bool> reads_fail_{false};
  std::mutex mutex_;
  std::condition_variable held_changed_;
  bool holds_ = false;
  int waiting_ = 0;  // for being let go
  std::mt19937_64 random_;
  std::map<std::string, File> files_;
  std::map<std::string, std::string> in_place_;  // synced contents of files written in place since
  std::vector<Rename> renames_;
  std::uint64_t names_ = 0;  // changes of names so far
};

/// RocksDB's environment with this disk. Where a flush failed it does not sleep for a second.
[[nodiscard]] std::unique_ptr<rocksdb::Env> environment_of(std::shared_ptr<UnsafeDisk> disk);

}  // namespace talus::server::testing
