#include "unsafe_disk.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include <rocksdb/system_clock.h>
#include <sanitizer/lsan_interface.h>

#include "scratch_directory.h"

// RocksDB 7.8 leaks the memtable that it has made if a fault keeps it from noting the log before it in the
// manifest (DBImpl::SwitchMemtable with track_and_verify_wals_in_manifest).
extern "C" const char* __lsan_default_suppressions() {
  return "leak:rocksdb::DBImpl::SwitchMemtable\n";
}

namespace talus::server::testing {
namespace {

namespace fs = std::filesystem;
using rocksdb::IODebugContext;
using rocksdb::IOOptions;
using rocksdb::IOStatus;
using rocksdb::Slice;

/// RocksDB opens one file by several spellings of its path.
std::string normal(const std::string& path) {
  return fs::path{path}.lexically_normal().string();
}

class AppendedFile final : public rocksdb::FSWritableFileOwnerWrapper {
 public:
  AppendedFile(std::unique_ptr<rocksdb::FSWritableFile> file, std::string path, UnsafeDisk& disk)
      : FSWritableFileOwnerWrapper{std::move(file)}, path_{std::move(path)}, disk_{disk} {}

  IOStatus Append(const Slice& data, const IOOptions& options, IODebugContext* debug) override {
    if (auto on = disk_.call(); !on.ok()) return on;
    const std::size_t fits = disk_.room(data.size());
    IOStatus status = FSWritableFileOwnerWrapper::Append(Slice{data.data(), fits}, options, debug);
    disk_.wrote(path_, fits);
    return status.ok() && fits < data.size() ? IOStatus::NoSpace("the test's disk is full") : status;
  }
  IOStatus Append(const Slice& data, const IOOptions& options, const rocksdb::DataVerificationInfo&,
                  IODebugContext* debug) override {
    return Append(data, options, debug);
  }
  IOStatus Sync(const IOOptions&, IODebugContext*) override {
    const std::uint64_t written = disk_.written(path_);
    IOStatus status = disk_.sync_call();
    // The test's disk is in memory: what it calls synced stays.
    if (status.ok()) disk_.synced(path_, written);
    return status;
  }
  IOStatus Fsync(const IOOptions& options, IODebugContext* debug) override { return Sync(options, debug); }
  IOStatus RangeSync(std::uint64_t, std::uint64_t, const IOOptions&, IODebugContext*) override {
    return IOStatus::OK();
  }
  IOStatus Allocate(std::uint64_t, std::uint64_t, const IOOptions&, IODebugContext*) override {
    return IOStatus::OK();
  }

 private:
  std::string path_;
  UnsafeDisk& disk_;
};

class ReadFile final : public rocksdb::FSRandomAccessFileOwnerWrapper {
 public:
  ReadFile(std::unique_ptr<rocksdb::FSRandomAccessFile> file, std::string path, UnsafeDisk& disk)
      : FSRandomAccessFileOwnerWrapper{std::move(file)}, path_{std::move(path)}, disk_{disk} {}

  IOStatus Read(std::uint64_t offset, std::size_t bytes, const IOOptions& options, Slice* result,
                char* scratch, IODebugContext* debug) const override {
    if (disk_.reads_fail()) return failure();
    return FSRandomAccessFileOwnerWrapper::Read(offset, bytes, options, result, scratch, debug);
  }
  IOStatus MultiRead(rocksdb::FSReadRequest* requests, std::size_t count, const IOOptions& options,
                     IODebugContext* debug) override {
    if (disk_.reads_fail()) return failure();
    return FSRandomAccessFileOwnerWrapper::MultiRead(requests, count, options, debug);
  }

 private:
  /// As RocksDB says it of a file of the system's.
  [[nodiscard]] IOStatus failure() const {
    return IOStatus::IOError("While pread: " + path_, std::generic_category().message(EIO));
  }

  std::string path_;
  UnsafeDisk& disk_;
};

class FileInPlace final : public rocksdb::FSRandomRWFileOwnerWrapper {
 public:
  FileInPlace(std::unique_ptr<rocksdb::FSRandomRWFile> file, std::string path, UnsafeDisk& disk)
      : FSRandomRWFileOwnerWrapper{std::move(file)},
        path_{std::move(path)},
        disk_{disk},
        synced_{read_whole(path_)} {}

  IOStatus Write(std::uint64_t offset, const Slice& data, const IOOptions& options,
                 IODebugContext* debug) override {
    if (disk_.is_off()) return IOStatus::IOError("the power is off");
    disk_.wrote_in_place(path_, synced_);
    return FSRandomRWFileOwnerWrapper::Write(offset, data, options, debug);
  }
  IOStatus Sync(const IOOptions&, IODebugContext*) override {
    if (disk_.is_off()) return IOStatus::IOError("the power is off");
    disk_.synced_in_place(path_);
    synced_ = read_whole(path_);
    return IOStatus::OK();
  }

 private:
  std::string path_;
  UnsafeDisk& disk_;
  std::string synced_;
};

class SyncedDirectory final : public rocksdb::FSDirectory {
 public:
  SyncedDirectory(std::string path, UnsafeDisk& disk) : path_{std::move(path)}, disk_{disk} {}
  IOStatus Fsync(const IOOptions&, IODebugContext*) override {
    IOStatus status = disk_.sync_call();
    if (status.ok()) disk_.synced_directory(path_);
    return status;
  }

 private:
  std::string path_;
  UnsafeDisk& disk_;
};

class HastyClock final : public rocksdb::SystemClockWrapper {
 public:
  HastyClock() : SystemClockWrapper{rocksdb::SystemClock::Default()} {}
  const char* Name() const override { return "HastyClock"; }
  void SleepForMicroseconds(int micros) override {
    SystemClockWrapper::SleepForMicroseconds(std::min(micros, 1'000));
  }
};

class TestEnvironment final : public rocksdb::EnvWrapper {
 public:
  explicit TestEnvironment(std::shared_ptr<UnsafeDisk> disk)
      : EnvWrapper{rocksdb::NewCompositeEnv(std::move(disk))} {
    system_clock_ = std::make_shared<HastyClock>();
  }
  const char* Name() const override { return "TestEnvironment"; }
};

}  // namespace

std::unique_ptr<rocksdb::Env> environment_of(std::shared_ptr<UnsafeDisk> disk) {
  return std::make_unique<TestEnvironment>(std::move(disk));
}

IOStatus UnsafeDisk::call() {
  if (calls_left_.fetch_sub(1) <= 0) off_ = true;
  return off_ ? IOStatus::IOError("the power is off") : IOStatus::OK();
}

IOStatus UnsafeDisk::sync_call() {
  {
    std::unique_lock lock{mutex_};
    ++waiting_;
    held_changed_.notify_all();
    held_changed_.wait(lock, [&] { return !holds_; });
    --waiting_;
  }
  if (auto on = call(); !on.ok()) return on;
  return syncs_left_.fetch_sub(1) <= 0 ? IOStatus::IOError("the test's disk does not sync") : IOStatus::OK();
}

std::size_t UnsafeDisk::room(std::size_t bytes) {
  const std::int64_t left = bytes_left_.fetch_sub(static_cast<std::int64_t>(bytes));
  return static_cast<std::size_t>(std::clamp<std::int64_t>(left, 0, static_cast<std::int64_t>(bytes)));
}

void UnsafeDisk::wrote(const std::string& path, std::size_t bytes) {
  const std::lock_guard lock{mutex_};
  files_[path].written += bytes;
}

std::uint64_t UnsafeDisk::written(const std::string& path) {
  const std::lock_guard lock{mutex_};
  return files_[path].written;
}

void UnsafeDisk::synced(const std::string& path, std::uint64_t bytes) {
  const std::lock_guard lock{mutex_};
  std::uint64_t& synced = files_[path].synced;
  synced = std::max(synced, bytes);
}

void UnsafeDisk::wrote_in_place(const std::string& path, const std::string& synced) {
  const std::lock_guard lock{mutex_};
  in_place_.try_emplace(path, synced);
}

void UnsafeDisk::synced_in_place(const std::string& path) {
  const std::lock_guard lock{mutex_};
  in_place_.erase(path);
}

void UnsafeDisk::hold_syncs(bool held) {
  {
    const std::lock_guard lock{mutex_};
    holds_ = held;
  }
  held_changed_.notify_all();
}

void UnsafeDisk::await_held_sync() {
  std::unique_lock lock{mutex_};
  held_changed_.wait(lock, [&] { return waiting_ > 0; });
}

void UnsafeDisk::synced_directory(const std::string& directory) {
  const std::lock_guard lock{mutex_};
  const auto is_in = [&](const std::string& path) { return fs::path{path}.parent_path() == directory; };
  for (auto& [path, file] : files_) file.named = file.named || is_in(path);
  std::erase_if(renames_, [&](const Rename& each) { return is_in(each.to); });
}

IOStatus UnsafeDisk::NewWritableFile(const std::string& path, const rocksdb::FileOptions& options,
                                     std::unique_ptr<rocksdb::FSWritableFile>* result,
                                     IODebugContext* debug) {
  if (auto on = call(); !on.ok()) return on;
  std::unique_ptr<rocksdb::FSWritableFile> file;
  if (auto made = FileSystemWrapper::NewWritableFile(path, options, &file, debug); !made.ok()) return made;
  const std::lock_guard lock{mutex_};
  files_[normal(path)] = {.made = ++names_};
  *result = std::make_unique<AppendedFile>(std::move(file), normal(path), *this);
  return IOStatus::OK();
}

IOStatus UnsafeDisk::ReopenWritableFile(const std::string&, const rocksdb::FileOptions&,
                                        std::unique_ptr<rocksdb::FSWritableFile>*, IODebugContext*) {
  return IOStatus::NotSupported("the test's disk");
}
IOStatus UnsafeDisk::ReuseWritableFile(const std::string&, const std::string&, const rocksdb::FileOptions&,
                                       std::unique_ptr<rocksdb::FSWritableFile>*, IODebugContext*) {
  return IOStatus::NotSupported("the test's disk");
}

IOStatus UnsafeDisk::NewRandomAccessFile(const std::string& path, const rocksdb::FileOptions& options,
                                         std::unique_ptr<rocksdb::FSRandomAccessFile>* result,
                                         IODebugContext* debug) {
  auto status = FileSystemWrapper::NewRandomAccessFile(path, options, result, debug);
  if (status.ok()) *result = std::make_unique<ReadFile>(std::move(*result), path, *this);
  return status;
}

IOStatus UnsafeDisk::NewRandomRWFile(const std::string& path, const rocksdb::FileOptions& options,
                                     std::unique_ptr<rocksdb::FSRandomRWFile>* result,
                                     IODebugContext* debug) {
  if (auto on = call(); !on.ok()) return on;
  std::unique_ptr<rocksdb::FSRandomRWFile> file;
  if (auto made = FileSystemWrapper::NewRandomRWFile(path, options, &file, debug); !made.ok()) return made;
  *result = std::make_unique<FileInPlace>(std::move(file), normal(path), *this);
  return IOStatus::OK();
}

IOStatus UnsafeDisk::NewDirectory(const std::string& path, const IOOptions&,
                                  std::unique_ptr<rocksdb::FSDirectory>* result, IODebugContext*) {
  *result = std::make_unique<SyncedDirectory>(normal(path), *this);
  return IOStatus::OK();
}

IOStatus UnsafeDisk::RenameFile(const std::string& from, const std::string& to, const IOOptions& options,
                                IODebugContext* debug) {
  if (auto on = call(); !on.ok()) return on;
  Rename rename{normal(from), normal(to), {}};
  if (fs::exists(rename.to)) rename.replaced = read_whole(rename.to);
  if (auto renamed = FileSystemWrapper::RenameFile(from, to, options, debug); !renamed.ok()) return renamed;
  const std::lock_guard lock{mutex_};
  if (const auto file = files_.find(rename.from); file != files_.end()) {
    files_[rename.to] = file->second;
    files_[rename.to].named = true;  // as the rename is, or is undone
    files_.erase(file);
  }
  in_place_.erase(rename.to);
  rename.made = ++names_;
  renames_.push_back(std::move(rename));
  return IOStatus::OK();
}

IOStatus UnsafeDisk::DeleteFile(const std::string& path, const IOOptions& options, IODebugContext* debug) {
  if (auto on = call(); !on.ok()) return on;
  {
    const std::lock_guard lock{mutex_};
    files_.erase(normal(path));
    in_place_.erase(normal(path));
    std::erase_if(renames_, [&](const Rename& each) { return each.to == normal(path); });
  }
  return FileSystemWrapper::DeleteFile(path, options, debug);
}

IOStatus UnsafeDisk::GetFreeSpace(const std::string& path, const IOOptions& options, std::uint64_t* free,
                                  IODebugContext* debug) {
  if (free_ < 0) return FileSystemWrapper::GetFreeSpace(path, options, free, debug);
  *free = static_cast<std::uint64_t>(free_.load());
  return IOStatus::OK();
}

void UnsafeDisk::lose_pages(const std::string& path, const File& file, std::uint64_t page_bytes) {
  const std::uint64_t unsynced = file.written - file.synced;
  if (unsynced == 0) return;
  // The end is lost, or pages are, or both.
  const std::uint64_t how = below(3);
  const std::uint64_t bytes = file.synced + (how == 0 ? unsynced : below(unsynced + 1));
  fs::resize_file(path, bytes);
  if (how == 2) return;
  std::fstream out{path, std::ios::in | std::ios::out | std::ios::binary};
  const std::uint64_t rarity = 2 + below(3);
  for (std::uint64_t at = file.synced; at < bytes;) {
    const std::uint64_t end = std::min(bytes, (at / page_bytes + 1) * page_bytes);
    if (below(rarity) == 0) out.seekp(static_cast<std::streamoff>(at)) << std::string(end - at, '\0');
    at = end;
  }
}

void UnsafeDisk::restart() {
  const std::lock_guard lock{mutex_};
  const std::uint64_t page_bytes = below(2) == 0 ? 512 : 4096;
  // Half of the time all names are there; else a tail of those that were not synced is lost.
  std::vector<std::uint64_t> unsynced_names;
  for (const Rename& each : renames_) unsynced_names.push_back(each.made);
  for (const auto& [path, file] : files_) {
    if (!file.named) unsynced_names.push_back(file.made);
  }
  std::sort(unsynced_names.begin(), unsynced_names.end());
  const std::uint64_t kept =
      unsynced_names.empty() || below(2) == 0 ? names_ : unsynced_names[below(unsynced_names.size())] - 1;
  for (; !renames_.empty(); renames_.pop_back()) {
    const Rename& last = renames_.back();
    if (last.made <= kept || !fs::exists(last.to)) continue;
    fs::rename(last.to, last.from);
    files_.erase(last.to);
    if (last.replaced) std::ofstream{last.to, std::ios::binary} << *last.replaced;
  }
  for (const auto& [path, file] : files_) {
    if (!fs::exists(path)) continue;
    if (!file.named && file.made > kept) {
      fs::remove(path);
      continue;
    }
    lose_pages(path, file, page_bytes);
  }
  for (const auto& [path, synced] : in_place_) {
    if (fs::exists(path) && below(2) == 0) std::ofstream{path, std::ios::binary} << synced;
  }
  files_.clear();
  in_place_.clear();
  calls_left_ = kMany;
  off_ = false;
}

}  // namespace talus::server::testing
