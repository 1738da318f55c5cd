#include "log_guard.h"

#include <string>
#include <utility>

#include <rocksdb/file_system.h>

namespace talus::store {
namespace {

using rocksdb::IODebugContext;
using rocksdb::IOOptions;
using rocksdb::IOStatus;

/// Calls made once `failure` is set do not reach the file.
class GuardedFile final : public rocksdb::FSWritableFileOwnerWrapper {
 public:
  GuardedFile(std::unique_ptr<rocksdb::FSWritableFile>&& file, bool is_log,
              std::shared_ptr<WriteFailure> failure)
      : FSWritableFileOwnerWrapper{std::move(file)}, is_log_{is_log}, failure_{std::move(failure)} {}

  IOStatus Append(const rocksdb::Slice& data, const IOOptions& options, IODebugContext* debug) override {
    return guard([&] { return FSWritableFileOwnerWrapper::Append(data, options, debug); });
  }
  IOStatus Append(const rocksdb::Slice& data, const IOOptions& options,
                  const rocksdb::DataVerificationInfo& verification, IODebugContext* debug) override {
    return guard([&] { return FSWritableFileOwnerWrapper::Append(data, options, verification, debug); });
  }
  IOStatus Flush(const IOOptions& options, IODebugContext* debug) override {
    return guard([&] { return FSWritableFileOwnerWrapper::Flush(options, debug); });
  }
  IOStatus Sync(const IOOptions& options, IODebugContext* debug) override {
    return guard([&] { return FSWritableFileOwnerWrapper::Sync(options, debug); });
  }
  IOStatus Fsync(const IOOptions& options, IODebugContext* debug) override {
    return guard([&] { return FSWritableFileOwnerWrapper::Fsync(options, debug); });
  }
  IOStatus RangeSync(std::uint64_t offset, std::uint64_t bytes, const IOOptions& options,
                     IODebugContext* debug) override {
    return guard([&] { return FSWritableFileOwnerWrapper::RangeSync(offset, bytes, options, debug); });
  }
  IOStatus Close(const IOOptions& options, IODebugContext* debug) override {
    auto closed = FSWritableFileOwnerWrapper::Close(options, debug);
    return is_log_ ? settle(std::move(closed)) : closed;
  }

 private:
  template <typename Call>
  IOStatus guard(const Call& call) {
    if (!failure_->is_set()) return is_log_ ? settle(call()) : call();
    return is_log_ ? IOStatus::OK() : IOStatus::IOError("nothing is written after a disk error");
  }
  /// REQUIRES: the file is of the log.
  IOStatus settle(IOStatus status) {
    if (!status.ok()) failure_->set(status);
    return IOStatus::OK();
  }

  const bool is_log_;
  const std::shared_ptr<WriteFailure> failure_;
};

class GuardedFiles final : public rocksdb::FileSystemWrapper {
 public:
  GuardedFiles(std::shared_ptr<rocksdb::FileSystem> files, const std::filesystem::path& database,
               std::shared_ptr<WriteFailure> failure)
      : FileSystemWrapper{std::move(files)},
        database_{database.lexically_normal()},
        failure_{std::move(failure)} {}
  [[nodiscard]] const char* Name() const override { return "talus.guarded_files"; }
  IOStatus NewWritableFile(const std::string& path, const rocksdb::FileOptions& options,
                           std::unique_ptr<rocksdb::FSWritableFile>* result, IODebugContext* debug) override {
    auto made = FileSystemWrapper::NewWritableFile(path, options, result, debug);
    const std::filesystem::path file = std::filesystem::path{path}.lexically_normal();
    // Copies elsewhere may fail.
    if (made.ok() && file.parent_path() == database_) {
      *result = std::make_unique<GuardedFile>(std::move(*result), file.extension() == ".log", failure_);
    }
    return made;
  }

 private:
  const std::filesystem::path database_;
  const std::shared_ptr<WriteFailure> failure_;
};

class GuardedEnv final : public rocksdb::EnvWrapper {
 public:
  GuardedEnv(rocksdb::Env& env, std::shared_ptr<rocksdb::FileSystem> files) : EnvWrapper{&env} {
    file_system_ = std::move(files);
    system_clock_ = env.GetSystemClock();
  }
  [[nodiscard]] const char* Name() const override { return "talus.guarded_env"; }
};

class WithoutRecovery final : public rocksdb::EventListener {
 public:
  explicit WithoutRecovery(std::shared_ptr<WriteFailure> failure) : failure_{std::move(failure)} {}
  void OnBackgroundError(rocksdb::BackgroundErrorReason, rocksdb::Status* status) override {
    if (!status->IsCorruption()) failure_->set(*status);  // the next write reports damage itself
  }
  void OnErrorRecoveryBegin(rocksdb::BackgroundErrorReason, rocksdb::Status, bool* recovers) override {
    *recovers = false;
  }

 private:
  const std::shared_ptr<WriteFailure> failure_;
};

}  // namespace

std::unique_ptr<rocksdb::Env> guard_log(rocksdb::Env& env, const std::filesystem::path& database,
                                        std::shared_ptr<WriteFailure> failure) {
  return std::make_unique<GuardedEnv>(
      env, std::make_shared<GuardedFiles>(env.GetFileSystem(), database, std::move(failure)));
}

std::shared_ptr<rocksdb::EventListener> without_recovery(std::shared_ptr<WriteFailure> failure) {
  return std::make_shared<WithoutRecovery>(std::move(failure));
}

}  // namespace talus::store
