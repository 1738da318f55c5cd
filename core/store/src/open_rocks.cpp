#include <talus/store/open_rocks.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <rocksdb/env.h>
#include <rocksdb/file_system.h>
#include <rocksdb/wal_filter.h>
#include <rocksdb/write_batch.h>

#include <talus/store/acknowledged_file.h>
#include <talus/store/store_reader.h>

#include "log_damage.h"
#include "log_guard.h"

namespace talus::store {
namespace {

/// Reports a hole in the log as damage. RocksDB takes a header of zeros for preallocated space, skips the
/// rest of its block, and would go on with the next one.
class LogOrder final : public rocksdb::WalFilter {
 public:
  [[nodiscard]] const char* Name() const override { return "talus.log_order"; }
  void ColumnFamilyLogNumberMap(const std::map<std::uint32_t, std::uint64_t>& numbers,
                                const std::map<std::string, std::uint32_t>&) override {
    if (!numbers.empty()) first_log_ = numbers.begin()->second;
    has_begun_ = true;
  }
  WalProcessingOption LogRecordFound(unsigned long long number, const std::string&,
                                     const rocksdb::WriteBatch& batch, rocksdb::WriteBatch*, bool*) override {
    if (number < first_log_) return WalProcessingOption::kContinueProcessing;
    std::uint64_t sequence = 0;
    for (std::size_t i = 8; i-- > 0;) sequence = sequence << 8U | static_cast<std::uint8_t>(batch.Data()[i]);
    if (next_ != 0 && sequence > next_) return WalProcessingOption::kCorruptedRecord;
    next_ = sequence + batch.Count();
    return WalProcessingOption::kContinueProcessing;
  }

  /// True if the manifest was sound, and the log was read.
  [[nodiscard]] bool has_begun() const { return has_begun_; }
  /// Number of the first log that has data which no table has.
  [[nodiscard]] std::uint64_t first_log() const { return first_log_; }

 private:
  bool has_begun_ = false;
  std::uint64_t first_log_ = 0;
  std::uint64_t next_ = 0;  // the sequence number that comes next; 0: unknown
};

/// Ends a file earlier than the disk does.
class ShortFile final : public rocksdb::FSSequentialFileOwnerWrapper {
 public:
  ShortFile(std::unique_ptr<rocksdb::FSSequentialFile>&& file, std::uint64_t bytes)
      : FSSequentialFileOwnerWrapper{std::move(file)}, left_{bytes} {}
  rocksdb::IOStatus Read(std::size_t bytes, const rocksdb::IOOptions& options, rocksdb::Slice* result,
                         char* scratch, rocksdb::IODebugContext* debug) override {
    auto read = FSSequentialFileOwnerWrapper::Read(std::min<std::uint64_t>(bytes, left_), options, result,
                                                   scratch, debug);
    left_ -= result->size();
    return read;
  }

 private:
  std::uint64_t left_;
};

/// Shows the manifest without its torn end.
class ShortManifest final : public rocksdb::FileSystemWrapper {
 public:
  ShortManifest(std::shared_ptr<rocksdb::FileSystem> files, std::string path, std::uint64_t bytes)
      : FileSystemWrapper{std::move(files)}, path_{std::move(path)}, bytes_{bytes} {}
  [[nodiscard]] const char* Name() const override { return "talus.short_manifest"; }
  rocksdb::IOStatus NewSequentialFile(const std::string& path, const rocksdb::FileOptions& options,
                                      std::unique_ptr<rocksdb::FSSequentialFile>* result,
                                      rocksdb::IODebugContext* debug) override {
    auto opened = FileSystemWrapper::NewSequentialFile(path, options, result, debug);
    if (opened.ok() && path == path_) *result = std::make_unique<ShortFile>(std::move(*result), bytes_);
    return opened;
  }

 private:
  const std::string path_;
  const std::uint64_t bytes_;
};

/// What an open database refers to.
struct Parts {
  LogOrder order;
  std::shared_ptr<rocksdb::Env> short_manifest;
  std::shared_ptr<WriteFailure> failure = std::make_shared<WriteFailure>();
  std::unique_ptr<rocksdb::Env> guarded;
};

/// Opens one database, in several ways until one is right.
class Opener {
 public:
  Opener(const std::filesystem::path& store, const RocksSettings& settings)
      : store_{store},
        path_{(store / "db").string()},
        settings_{settings},
        env_{settings.env == nullptr ? *rocksdb::Env::Default() : *settings.env} {}

  [[nodiscard]] tl::expected<OpenedRocks, RocksFailure> open(RocksUse use, bool create) {
    if (use == RocksUse::write) remove_unfinished_options(env_, path_);
    // RocksDB drops the manifest's last record in silence if its length is wrong.
    if (!find_manifest_damage(env_, path_)) {
      const auto status = attempt(use, create);
      if (status.ok()) return take();
      if (!status.IsCorruption()) return failure(status);
    }
    if (auto dropped = drop_torn(); !dropped) return tl::unexpected{std::move(dropped.error())};
    if (use == RocksUse::read) return take();
    db_.reset();
    if (const auto status = attempt(use, false); !status.ok()) return failure(status);
    return take();
  }

 private:
  [[nodiscard]] rocksdb::Status attempt(RocksUse use, bool create) {
    db_.reset();
    parts_ = std::make_shared<Parts>();
    parts_->short_manifest = short_manifest_;
    rocksdb::Options options = rocks_options(settings_, create);
    options.wal_filter = &parts_->order;
    rocksdb::DB* db = nullptr;
    if (use == RocksUse::read) {
      auto status = rocksdb::DB::OpenForReadOnly(options, path_, &db);
      db_.reset(db);
      return status;
    }
    parts_->guarded = guard_log(*options.env, path_, parts_->failure);
    options.env = parts_->guarded.get();
    options.listeners.push_back(without_recovery(parts_->failure));
    options.max_bgerror_resume_count = 0;
    auto status = rocksdb::DB::Open(options, path_, &db);
    db_.reset(db);
    if (parts_->failure->is_set()) status = parts_->failure->get();
    if (!status.ok()) db_.reset();
    return status;
  }

  /// Opens the database for reading, without the torn ends of its manifest and its log.
  [[nodiscard]] tl::expected<void, RocksFailure> drop_torn() {
    auto torn = find_manifest_damage(env_, path_);
    if (torn && !torn->is_torn) torn.reset();
    if (torn) {
      drop(*torn, "was torn or damaged; the log has all that it named");
      short_manifest_ = rocksdb::NewCompositeEnv(std::make_shared<ShortManifest>(
          env_.GetFileSystem(), fmt::format("{}/{}", path_, torn->file), torn->offset));
      settings_.env = short_manifest_.get();
    }
    const auto status = attempt(RocksUse::read, false);
    std::optional<LogDamage> damage;
    if (status.IsCorruption() && parts_->order.has_begun())
      damage = find_log_damage(env_, path_, parts_->order.first_log());
    const std::string in_manifest = torn ? fmt::format(", in {}", place_of(*torn)) : "";
    if (!status.ok() && !damage) return failure(status, in_manifest);
    const auto refuse = [&] { return failure(status, fmt::format(", in {}", place_of(*damage))); };
    if (damage) {
      settings_.point_in_time = true;
      if (!attempt(RocksUse::read, false).ok()) return refuse();
    }
    if (torn && !has_whole_log(torn->file)) {
      return failure(rocksdb::Status::Corruption(
                         "the log lacks data whose table a lost record of the manifest may name"),
                     in_manifest);
    }
    const auto meta = StoreReader{*db_, store_}.meta();
    if (damage && (!meta || !*meta)) return refuse();
    if (!meta || !*meta) return {};  // the caller reports it
    if (damage && (*meta)->stream.sequence != 0) {
      drop(*damage, "was torn or damaged; its entries are read again from the log that all servers share");
    } else if (damage) {
      const bool follows = !damage->entry_behind || *damage->entry_behind == (*meta)->head.position + 1;
      if (!damage->is_torn || !follows) return refuse();
      drop(*damage, "was torn, as by a power cut; none of it was acknowledged");
    }
    if (auto whole = check_acknowledged(env_, store_, **meta); !whole) {
      return tl::unexpected{RocksFailure{
          can_read_acknowledged(env_, store_) ? rocksdb::Status::Corruption() : rocksdb::Status::IOError(),
          std::move(whole.error())}};
    }
    return {};
  }

  /// Returns false if a write may be in neither a table of the manifest nor the log. RocksDB deletes a log
  /// once a record of the manifest, synced, names the tables that have its data.
  [[nodiscard]] bool has_whole_log(const std::string& manifest) const {
    const auto logs = log_numbers(env_, path_);
    const auto first = std::ranges::lower_bound(logs, parts_->order.first_log());
    if (first == logs.end()) return false;
    if (*first == parts_->order.first_log()) return true;
    // A start names a log that never existed, makes the log of its first writes, then the manifest; numbers
    // rise. A flush makes a log after the manifest. The sequence numbers in the tables prove nothing: a
    // compaction into the last level sets them to 0.
    constexpr std::string_view kPrefix = "MANIFEST-";
    std::uint64_t number = 0;
    std::from_chars(manifest.data() + kPrefix.size(), manifest.data() + manifest.size(), number);
    return *first < number;
  }

  void drop(const LogDamage& damage, std::string_view why) {
    dropped_ +=
        fmt::format("{}{} {}, and it is dropped", dropped_.empty() ? "" : "; ", place_of(damage), why);
  }
  [[nodiscard]] std::string place_of(const LogDamage& damage) const {
    return fmt::format("{}/{} from byte {} on", path_, damage.file, damage.offset);
  }
  [[nodiscard]] tl::unexpected<RocksFailure> failure(const rocksdb::Status& status,
                                                     std::string_view more = {}) const {
    return tl::unexpected{
        RocksFailure{status, fmt::format("edits {}: the database does not open: {}{}; {}", store_.string(),
                                         status.ToString(), more, remedy_for(status))}};
  }
  [[nodiscard]] OpenedRocks take() {
    auto failure = parts_->failure;
    return {std::move(parts_), std::move(db_), std::move(failure), std::move(dropped_)};
  }

  const std::filesystem::path& store_;
  const std::string path_;
  RocksSettings settings_;
  rocksdb::Env& env_;
  std::shared_ptr<rocksdb::Env> short_manifest_;
  std::shared_ptr<Parts> parts_;
  std::unique_ptr<rocksdb::DB> db_;
  std::string dropped_;
};

}  // namespace

tl::expected<OpenedRocks, RocksFailure> open_rocks(const std::filesystem::path& store,
                                                   const RocksSettings& settings, RocksUse use, bool create) {
  return Opener{store, settings}.open(use, create);
}

}  // namespace talus::store
