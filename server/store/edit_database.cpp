#include "store/edit_database.h"

#include <algorithm>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <rocksdb/cache.h>
#include <rocksdb/db.h>
#include <rocksdb/env.h>
#include <rocksdb/filter_policy.h>
#include <rocksdb/table.h>
#include <rocksdb/write_batch.h>

namespace talus::server {
namespace {

/// Segments of history: as large as that, or as old.
constexpr std::uint64_t kSegmentBytes = std::uint64_t{1} << 20U;
constexpr std::int64_t kSegmentMs = std::int64_t{60} * 60 * 1000;

constexpr std::string_view kLost = "restore a backup, or give --data another directory";

rocksdb::Slice as_slice(const Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
std::span<const std::byte> bytes_of(const rocksdb::Slice& slice) {
  return std::as_bytes(std::span{slice.data(), slice.size()});
}
std::string_view text_of(const rocksdb::Slice& slice) {
  return {slice.data(), slice.size()};
}

/// What fails comes back as a Status, and talusd tells it. RocksDB's own file of lines must not be: where a
/// write to it fails, its next line ends the process.
class NoInfoLog final : public rocksdb::Logger {
 public:
  using Logger::Logv;
  void Logv(const char*, va_list) override {}
};

rocksdb::Options options_of(const EditDatabaseSettings& settings, bool create) {
  rocksdb::Options options;
  if (settings.env != nullptr) options.env = settings.env;
  options.create_if_missing = create;
  options.paranoid_checks = true;
  options.wal_recovery_mode = rocksdb::WALRecoveryMode::kTolerateCorruptedTailRecords;
  options.track_and_verify_wals_in_manifest = true;
  options.manual_wal_flush = false;
  options.recycle_log_file_num = 0;
  options.wal_compression = rocksdb::kNoCompression;
  options.write_buffer_size = settings.write_buffer_bytes;
  options.compression = rocksdb::kLZ4Compression;
  options.allow_concurrent_memtable_write = false;  // one thread writes
  options.max_background_jobs = 2;
  options.max_open_files = 256;
  options.info_log = std::make_shared<NoInfoLog>();
  options.stats_dump_period_sec = 0;
  options.stats_persist_period_sec = 0;
  rocksdb::BlockBasedTableOptions table;
  table.filter_policy.reset(rocksdb::NewBloomFilterPolicy(10));
  table.block_cache = rocksdb::NewLRUCache(settings.block_cache_bytes);
  options.table_factory.reset(rocksdb::NewBlockBasedTableFactory(table));
  return options;
}

rocksdb::ReadOptions for_scans() {
  rocksdb::ReadOptions options;
  options.fill_cache = false;
  options.total_order_seek = true;
  return options;
}

std::string prefix_of(KeyKind kind) {
  return std::string(1, static_cast<char>(kind));
}

/// Calls visit(key, value) for all keys from `first` on that begin as it does, until it returns false.
template <typename Visit>
rocksdb::Status scan(rocksdb::DB& db, const std::string& first, Visit&& visit) {
  const std::unique_ptr<rocksdb::Iterator> at{db.NewIterator(for_scans())};
  for (at->Seek(first); at->Valid(); at->Next()) {
    if (at->key().empty() || at->key()[0] != first.front()) break;
    if (!visit(at->key(), at->value())) break;
  }
  return at->status();
}

/// Whether files are there that only a database has which was in use.
bool was_in_use(rocksdb::Env& env, const std::string& path) {
  std::vector<std::string> names;
  if (!env.GetChildren(path, &names).ok()) return false;
  return std::ranges::any_of(names, [](std::string_view name) {
    return name == "CURRENT" || name.ends_with(".log") || name.ends_with(".sst");
  });
}

}  // namespace

EditDatabase::EditDatabase(const EditDatabaseSettings& settings) : settings_{settings} {}

EditDatabase::~EditDatabase() {
  if (acknowledged_) acknowledged_->sync();
}

rocksdb::Env& EditDatabase::env() const {
  return settings_.env == nullptr ? *rocksdb::Env::Default() : *settings_.env;
}

tl::unexpected<std::string> EditDatabase::failure(std::string_view what) const {
  return tl::unexpected{fmt::format("edits {}: {}", settings_.path.string(), what)};
}

tl::expected<std::unique_ptr<EditDatabase>, std::string> EditDatabase::open(
    const EditDatabaseSettings& settings) {
  std::unique_ptr<EditDatabase> database{new EditDatabase{settings}};
  const std::string path = settings.path.string();
  if (const auto made = database->env().CreateDirIfMissing(path); !made.ok()) {
    return database->failure(
        fmt::format("{}; give --data a directory that talusd may write", made.ToString()));
  }
  if (const std::uint64_t free = database->free_bytes(); free < settings.free_bytes_to_open) {
    return database->failure(fmt::format("the disk has {} bytes free; opening the store needs {}", free,
                                         settings.free_bytes_to_open));
  }
  using Step = Done (EditDatabase::*)();
  for (const Step step :
       {&EditDatabase::open_database, &EditDatabase::read_meta, &EditDatabase::check_acknowledged,
        &EditDatabase::read_materials, &EditDatabase::read_history, &EditDatabase::drop_records_beyond}) {
    if (auto good = (database.get()->*step)(); !good) return tl::unexpected{std::move(good.error())};
  }
  auto acknowledged = AcknowledgedFile::open(database->env(), database->acknowledged_path(),
                                             {database->meta_.head.position, database->meta_.link});
  if (!acknowledged) return tl::unexpected{std::move(acknowledged.error())};
  database->acknowledged_.emplace(std::move(*acknowledged));
  return database;
}

EditDatabase::Done EditDatabase::open_database() {
  // RocksDB would make an empty database of one that lost its file CURRENT.
  const bool used = was_in_use(env(), database_path()) || env().FileExists(acknowledged_path()).ok();
  rocksdb::DB* db = nullptr;
  const auto status = rocksdb::DB::Open(options_of(settings_, !used), database_path(), &db);
  db_.reset(db);
  if (status.ok()) return {};
  if (status.IsCorruption() || used) {
    return failure(fmt::format("the database does not open: {}; {}", status.ToString(), kLost));
  }
  return failure(fmt::format("{}; give --data a directory that talusd may write", status.ToString()));
}

EditDatabase::Done EditDatabase::read_meta() {
  std::string value;
  const auto status = db_->Get({}, meta_key(), &value);
  if (status.IsNotFound()) return make_store();
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), kLost));
  if (!value.empty() && static_cast<std::uint8_t>(value.front()) > kStoreFormat) {
    return failure(
        fmt::format("the store has format {}; this talusd reads format {}; run a newer talusd, or give "
                    "--data another directory",
                    static_cast<std::uint8_t>(value.front()), kStoreFormat));
  }
  const auto meta = decode_meta(std::as_bytes(std::span{value}));
  if (!meta) return failure(fmt::format("its record of the store's state is damaged; {}", kLost));
  meta_ = *meta;
  return check_meta();
}

EditDatabase::Done EditDatabase::make_store() {
  const std::unique_ptr<rocksdb::Iterator> any{db_->NewIterator(for_scans())};
  any->SeekToFirst();
  const bool acknowledged = !env().FileExists(acknowledged_path()).IsNotFound();
  if (any->Valid() || !any->status().ok() || acknowledged) {
    return failure(fmt::format("its record of the store's state is missing; {}", kLost));
  }
  meta_.fingerprint = settings_.fingerprint;
  meta_.store_id = settings_.store_id;
  rocksdb::WriteBatch batch;
  encode(meta_, value_);
  batch.Put(meta_key(), as_slice(value_));
  return write(batch, true);
}

EditDatabase::Done EditDatabase::check_meta() const {
  if (meta_.fingerprint != settings_.fingerprint) {
    return failure(
        fmt::format("the edits belong to the world with fingerprint {}; this world has fingerprint {}; give "
                    "--data another directory, or --world the edits' world",
                    to_string(meta_.fingerprint), to_string(settings_.fingerprint)));
  }
  if (meta_.store_id != settings_.store_id) {
    return failure(
        fmt::format("the edits belong to store {}; this directory's store.toml has {}; put back the "
                    "directory's own edits, or give --data another directory",
                    to_string(meta_.store_id), to_string(settings_.store_id)));
  }
  if (meta_.level_rule != edits::kLevelRule) {
    return failure(
        fmt::format("its coarse levels were made by rule {}; this talusd has rule {}; run a talusd "
                    "with that rule, or give --data another directory",
                    meta_.level_rule, edits::kLevelRule));
  }
  return {};
}

EditDatabase::Done EditDatabase::check_acknowledged() {
  const auto read = AcknowledgedFile::read(env(), acknowledged_path());
  if (!read) return failure(read.error());
  if (!*read) return {};
  const Acknowledged& acknowledged = **read;
  if (acknowledged.position > meta_.head.position) {
    return failure(
        fmt::format("entries {} to {} of its log were acknowledged and are lost, as the disk lost "
                    "the end of the log; restore a backup, or delete {} to go on without them",
                    meta_.head.position + 1, acknowledged.position, acknowledged_path()));
  }
  if (acknowledged.position == meta_.head.position && acknowledged.link != meta_.link) {
    return failure(
        fmt::format("entry {} of its log is not the one that was acknowledged; restore a backup, or "
                    "delete {} to go on with what is there",
                    meta_.head.position, acknowledged_path()));
  }
  return {};
}

EditDatabase::Done EditDatabase::read_materials() {
  bool sound = true;
  const auto status = scan(*db_, prefix_of(KeyKind::material), [&](const auto& key, const auto& value) {
    const auto name = material_of_key(text_of(key));
    const auto material = decode_material(text_of(key), bytes_of(value));
    sound = name && material;
    if (sound) materials_.emplace(*name, *material);
    return sound;
  });
  if (status.ok() && sound) return {};
  return failure(fmt::format("its table of materials is damaged: {}; {}", status.ToString(), kLost));
}

EditDatabase::Done EditDatabase::read_history() {
  bool sound = true;
  const auto status = scan(*db_, prefix_of(KeyKind::history), [&](const auto& key, const auto& value) {
    const auto segment = decode_history(text_of(key), bytes_of(value));
    sound = segment && segment->last <= meta_.flushed &&
            (history_.empty() || history_.back().last + 1 == segment->first);
    if (!sound) return false;
    history_.push_back(*segment);
    history_bytes_ += segment->bytes;
    return true;
  });
  if (status.ok() && sound) return {};
  return failure(fmt::format("its table of history is damaged: {}; {}", status.ToString(), kLost));
}

EditDatabase::Done EditDatabase::drop_records_beyond() {
  bool any = false;
  const auto status = scan(*db_, log_key(meta_.head.position + 1), [&](const auto&, const auto&) {
    any = true;
    return false;
  });
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), kLost));
  if (!any) return {};
  rocksdb::WriteBatch batch;
  batch.DeleteRange(log_key(meta_.head.position + 1), log_key(UINT64_MAX));
  return write(batch, true);
}

EditDatabase::Done EditDatabase::for_each_chunk(
    const std::function<void(ChunkKey, std::uint64_t)>& visit) const {
  std::string damaged;
  const auto status = scan(*db_, prefix_of(KeyKind::chunk), [&](const auto& key, const auto& value) {
    const auto chunk = chunk_of_key(text_of(key));
    const auto revision = decode_chunk_revision(text_of(key), bytes_of(value));
    if (!chunk || !revision) {
      damaged = chunk ? "chunk " + to_string(*chunk) : "the key of a chunk";
      return false;
    }
    visit(*chunk, *revision);
    return true;
  });
  if (!damaged.empty()) return failure(fmt::format("{} is damaged; {}", damaged, kLost));
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), kLost));
  return {};
}

EditDatabase::Done EditDatabase::for_each_editor(
    const std::function<void(edits::EditorId, StoredEditor&&)>& visit) const {
  bool sound = true;
  const auto status = scan(*db_, prefix_of(KeyKind::editor), [&](const auto& key, const auto& value) {
    const auto id = editor_of_key(text_of(key));
    auto editor = decode_editor(text_of(key), bytes_of(value));
    sound = id && editor;
    if (sound) visit(*id, std::move(*editor));
    return sound;
  });
  if (!sound) return failure(fmt::format("the record of an editor is damaged; {}", kLost));
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), kLost));
  return {};
}

EditDatabase::Done EditDatabase::replay(const std::function<bool(LogRecord&&)>& visit) {
  std::uint64_t position = meta_.flushed;
  std::uint64_t link = meta_.flushed_link;
  bool sound = true;
  Unflushed all;
  const auto status = scan(*db_, log_key(position + 1), [&](const auto& key, const auto& value) {
    if (position == meta_.head.position) return false;
    const auto at = position_of_key(text_of(key));
    auto record = decode_record(bytes_of(value), link);
    sound = at == position + 1 && record && record->position == *at;
    if (!sound) return false;
    all.bytes += value.size();
    all.time_ms = record->time_ms;
    position = *at;
    sound = visit(std::move(*record));
    return sound;
  });
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), kLost));
  if (!sound || position != meta_.head.position || link != meta_.link) {
    return failure(fmt::format("entry {} of its log is damaged or lost, of {} that were acknowledged; {}",
                               std::min(position + 1, meta_.head.position), meta_.head.position, kLost));
  }
  all.position = position;
  all.link = link;
  if (position > meta_.flushed) unflushed_.push_back(all);
  return {};
}

tl::expected<std::optional<StoredChunk>, std::string> EditDatabase::chunk(ChunkKey key) const {
  const std::shared_lock lock{handle_};
  if (!db_) return failure("the store is closed after an error of the disk, and tried again each second");
  const std::string name = chunk_key(key);
  rocksdb::PinnableSlice value;
  const auto status = db_->Get({}, db_->DefaultColumnFamily(), name, &value);
  if (status.IsNotFound()) return std::nullopt;
  if (!status.ok()) return failure(fmt::format("chunk {}: {}", to_string(key), status.ToString()));
  auto chunk = decode_chunk_value(name, bytes_of(value));
  if (!chunk) return failure(fmt::format("chunk {} is damaged; {}", to_string(key), kLost));
  return chunk;
}

EditDatabase::Done EditDatabase::for_each_record(std::uint64_t first,
                                                 const std::function<bool(LogRecord&&)>& visit) const {
  if (!db_) return failure("the store is closed after an error of the disk, and tried again each second");
  std::uint64_t position = std::max<std::uint64_t>(first, 1) - 1;
  bool sound = true;
  std::uint64_t link = 0;
  const auto status = scan(*db_, log_key(position + 1), [&](const auto& key, const auto& value) {
    const auto at = position_of_key(text_of(key));
    if (!at || *at > meta_.head.position) return false;
    // The link before the first record of a scan is not at hand but for the very first of the log.
    auto record = position + 1 == *at && (link != 0 || *at == 1) ? decode_record(bytes_of(value), link)
                                                                 : decode_record_alone(bytes_of(value), link);
    sound = record && record->position == *at;
    if (!sound) return false;
    position = *at;
    return visit(std::move(*record));
  });
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), kLost));
  if (!sound) return failure(fmt::format("entry {} of its log is damaged; {}", position + 1, kLost));
  return {};
}

EditDatabase::Done EditDatabase::append(const edits::Batch& applied) {
  rocksdb::WriteBatch batch;
  StoreMeta meta = meta_;
  meta.head = applied.head();
  Unflushed unflushed{.position = meta.head.position, .time_ms = meta.head.time_ms};
  for (const edits::Applied& each : applied.applied()) {
    meta.link = encode(each, meta.head.time_ms, meta.link, value_);
    unflushed.bytes += value_.size();
    batch.Put(log_key(each.position), as_slice(value_));
  }
  unflushed.link = meta.link;
  encode(meta, value_);
  batch.Put(meta_key(), as_slice(value_));
  if (auto written = write(batch, settings_.sync); !written) return written;
  meta_ = meta;
  unflushed_.push_back(unflushed);
  acknowledged_->write({meta.head.position, meta.link});
  return {};
}

EditDatabase::Done EditDatabase::put(const Slice& slice) {
  return write(*slice.batch_, false);
}

void EditDatabase::extend_history(const Unflushed& flushed, std::uint64_t first, rocksdb::WriteBatch& batch) {
  const bool fits = !history_.empty() && history_.back().bytes < kSegmentBytes &&
                    flushed.time_ms - history_.back().last_time_ms < kSegmentMs;
  if (!fits) history_.push_back({.first = first});
  HistorySegment& segment = history_.back();
  segment.last = flushed.position;
  segment.bytes += flushed.bytes;
  segment.last_time_ms = flushed.time_ms;
  history_bytes_ += flushed.bytes;
  const std::string key = history_key(segment.first);
  encode(key, segment, value_);
  batch.Put(key, as_slice(value_));
  const auto too_old = [&](const HistorySegment& each) {
    return flushed.time_ms - each.last_time_ms > settings_.history_age.count();
  };
  while (!history_.empty() && (history_bytes_ > settings_.history_bytes || too_old(history_.front()))) {
    const HistorySegment& oldest = history_.front();
    batch.DeleteRange(log_key(oldest.first), log_key(oldest.last + 1));
    batch.Delete(history_key(oldest.first));
    history_bytes_ -= oldest.bytes;
    history_.pop_front();
  }
}

EditDatabase::Done EditDatabase::mark_flushed(std::uint64_t position) {
  Unflushed flushed;
  auto left = unflushed_.begin();
  for (; left != unflushed_.end() && left->position <= position; ++left) {
    flushed.position = left->position;
    flushed.link = left->link;
    flushed.bytes += left->bytes;
    flushed.time_ms = left->time_ms;
  }
  if (left == unflushed_.begin()) return {};
  // RocksDB's log is of several files, of which the newest may outlive a power cut that takes the end of the
  // one before. So nothing may say that chunks were put before they are on the disk.
  if (!db_) return failure("the store is closed after an error of the disk");
  if (const auto synced = db_->SyncWAL(); !synced.ok()) return failure(synced.ToString());
  StoreMeta meta = meta_;
  meta.flushed = flushed.position;
  meta.flushed_link = flushed.link;
  rocksdb::WriteBatch batch;
  encode(meta, value_);
  batch.Put(meta_key(), as_slice(value_));
  const auto history = history_;
  const std::uint64_t history_bytes = history_bytes_;
  extend_history(flushed, meta_.flushed + 1, batch);
  if (auto written = write(batch, false); !written) {
    history_ = history;
    history_bytes_ = history_bytes;
    return written;
  }
  meta_ = meta;
  unflushed_.erase(unflushed_.begin(), left);
  return {};
}

EditDatabase::Done EditDatabase::settle() {
  if (!db_) return failure("the store is closed after an error of the disk");
  rocksdb::Status status = db_->FlushWAL(true);
  if (status.ok()) status = db_->Flush({});
  if (!status.ok()) return failure(status.ToString());
  return {};
}

EditDatabase::Done EditDatabase::recover() {
  if (const std::uint64_t free = free_bytes(); free < settings_.free_bytes_to_open) {
    return failure(
        fmt::format("the disk has {} bytes free; writing needs {}", free, settings_.free_bytes_to_open));
  }
  const std::unique_lock lock{handle_};
  db_.reset();
  if (auto opened = open_database(); !opened) {
    db_.reset();
    return opened;
  }
  std::string value;
  const auto status = db_->Get({}, meta_key(), &value);
  const auto meta = decode_meta(std::as_bytes(std::span{value}));
  // The batch whose write failed may be there, or not.
  if (status.ok() && meta && meta->head.position >= meta_.head.position) return {};
  db_.reset();
  return failure(
      fmt::format("after an error of the disk entry {} of its log is lost; {}", meta_.head.position, kLost));
}

std::uint64_t EditDatabase::free_bytes() const {
  std::uint64_t free = 0;
  // Where the file system does not say, nobody stops for it.
  return env().GetFreeSpace(settings_.path.string(), &free).ok() ? free : UINT64_MAX;
}

EditDatabase::Done EditDatabase::bind(const std::map<std::string, MaterialId>& materials) {
  std::map<MaterialId, std::string> names;
  for (const auto& [name, id] : materials_) names.emplace(id, name);
  rocksdb::WriteBatch batch;
  for (const auto& [name, id] : materials) {
    const auto bound = materials_.find(name);
    if (bound != materials_.end() && bound->second != id) {
      return failure(fmt::format("material {} has id {} in the store and {} here; it must keep {}", name,
                                 to_integer(bound->second), to_integer(id), to_integer(bound->second)));
    }
    const auto [holder, free] = names.emplace(id, name);
    if (!free && holder->second != name) {
      return failure(fmt::format("material id {} is {} in the store and {} here; it must stay {}",
                                 to_integer(id), holder->second, name, holder->second));
    }
    if (bound != materials_.end()) continue;
    const std::string key = material_key(name);
    encode(key, id, value_);
    batch.Put(key, as_slice(value_));
  }
  if (batch.Count() == 0) return {};
  if (auto written = write(batch, true); !written) return written;
  for (const auto& each : materials) materials_.insert(each);
  return {};
}

EditDatabase::Done EditDatabase::write(rocksdb::WriteBatch& batch, bool sync) {
  if (!db_) return failure("the store is closed after an error of the disk");
  rocksdb::WriteOptions options;
  options.sync = sync;
  const auto status = db_->Write(options, &batch);
  if (!status.ok()) return failure(status.ToString());
  return {};
}

EditDatabase::Slice::Slice() : batch_{std::make_unique<rocksdb::WriteBatch>()} {}
EditDatabase::Slice::~Slice() = default;

void EditDatabase::Slice::put(ChunkKey key, std::uint64_t revision, std::span<const Override> voxels) {
  const std::string name = chunk_key(key);
  encode(name, revision, voxels, value_);
  batch_->Put(name, as_slice(value_));
  ++count_;
}

void EditDatabase::Slice::put(edits::EditorId id, std::uint64_t position, const edits::Editor& editor) {
  const std::string name = editor_key(id);
  encode(name, position, editor, value_);
  batch_->Put(name, as_slice(value_));
  ++count_;
}

void EditDatabase::Slice::erase(edits::EditorId id) {
  batch_->Delete(editor_key(id));
  ++count_;
}

std::size_t EditDatabase::Slice::bytes() const {
  return batch_->GetDataSize();
}

}  // namespace talus::server
