#include <talus/store/edit_database.h>

#include <algorithm>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <rocksdb/db.h>
#include <rocksdb/env.h>
#include <rocksdb/sst_file_reader.h>
#include <rocksdb/utilities/checkpoint.h>
#include <rocksdb/write_batch.h>
#include <talus/files/atomic_file.h>
#include <talus/store/id_check.h>
#include <talus/store/open_rocks.h>
#include <talus/store/regular_files.h>
#include <talus/store/rename_check.h>
#include <talus/store/rocks.h>
#include <talus/store/store_identity.h>
#include <talus/store/write_failure.h>

namespace talus::store {
namespace {

/// A history segment ends at this size or this age.
constexpr std::uint64_t kSegmentBytes = std::uint64_t{1} << 20U;
constexpr std::int64_t kSegmentMs = std::int64_t{60} * 60 * 1000;

/// Overhead of a batch besides its entries: the store's meta value, keys.
constexpr std::size_t kMinBatchBytes = 256;

/// True if files exist that only a used database has.
bool was_in_use(rocksdb::Env& env, const std::string& path) {
  std::vector<std::string> names;
  if (!env.GetChildren(path, &names).ok()) return false;
  return std::ranges::any_of(names, [](std::string_view name) {
    return name == "CURRENT" || name.ends_with(".log") || name.ends_with(".sst");
  });
}

/// Returns true if all chunks and editors in a table can be read.
bool has_whole_state(rocksdb::Env& env, const std::string& table) {
  const rocksdb::Options options = rocks_options({.env = &env, .block_cache_bytes = 0}, false);
  rocksdb::SstFileReader reader{options};
  if (!reader.Open(table).ok()) return false;
  const std::unique_ptr<rocksdb::Iterator> at{reader.NewIterator(for_scans())};
  for (const KeyKind kind : {KeyKind::chunk, KeyKind::editor}) {
    const std::string prefix = prefix_of(kind);
    for (at->Seek(prefix); at->Valid() && at->key().starts_with(prefix);) at->Next();
    if (!at->status().ok()) return false;
  }
  return true;
}

}  // namespace

EditDatabase::EditDatabase(const EditDatabaseSettings& settings) : settings_{settings} {}

EditDatabase::~EditDatabase() {
  if (acknowledged_) acknowledged_->sync();
}

rocksdb::Env& EditDatabase::env() const {
  return settings_.env == nullptr ? *rocksdb::Env::Default() : *settings_.env;
}

StoreReader EditDatabase::reader() const {
  return {*db_, settings_.path};
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
  using Step = Status (EditDatabase::*)();
  for (const Step step :
       {&EditDatabase::open_database, &EditDatabase::read_meta, &EditDatabase::check_acknowledged,
        &EditDatabase::become_another, &EditDatabase::read_materials, &EditDatabase::read_history,
        &EditDatabase::drop_records_beyond}) {
    if (auto good = (database.get()->*step)(); !good) return tl::unexpected{std::move(good.error())};
  }
  auto acknowledged = AcknowledgedFile::open(database->env(), database->acknowledged_path(),
                                             {database->meta_.head.position, database->meta_.link});
  if (!acknowledged) return tl::unexpected{std::move(acknowledged.error())};
  database->acknowledged_.emplace(std::move(*acknowledged));
  return database;
}

EditDatabase::Status EditDatabase::open_database() {
  if (const auto regular = check_regular_files(database_path()); !regular) return failure(regular.error());
  // RocksDB would create an empty database if the file CURRENT was lost.
  const bool used = was_in_use(env(), database_path()) || has_acknowledged();
  was_there_ = used;
  auto opened = open_rocks(settings_.path,
                           {settings_.env, settings_.memory.write_buffer_bytes,
                            settings_.memory.block_cache_bytes, settings_.log_elsewhere},
                           RocksUse::write, !used);
  if (opened) {
    db_ = std::move(opened->db);
    rocks_parts_ = std::move(opened->parts);
    write_failure_ = std::move(opened->failure);
    dropped_ = std::move(opened->dropped);
    return {};
  }
  const rocksdb::Status& status = opened.error().status;
  if (status.IsCorruption() || used) return tl::unexpected{std::move(opened.error().line)};
  return failure(
      fmt::format("{}; {}", status.ToString(),
                  status.IsNoSpace() ? remedy_for(status) : "give --data a directory that talusd may write"));
}

EditDatabase::Status EditDatabase::read_meta() {
  auto meta = reader().meta();
  if (!meta) return tl::unexpected{std::move(meta.error())};
  if (!*meta) return make_store();
  meta_ = **meta;
  return check_meta();
}

EditDatabase::Status EditDatabase::make_store() {
  const std::unique_ptr<rocksdb::Iterator> any{db_->NewIterator(for_scans())};
  any->SeekToFirst();
  if (any->Valid() || !any->status().ok() || has_acknowledged()) {
    return failure(fmt::format("its record of the store's state is missing; {}", kStoreLost));
  }
  meta_.fingerprint = settings_.fingerprint;
  meta_.store_id = settings_.store_id;
  rocksdb::WriteBatch batch;
  encode(meta_, value_);
  batch.Put(meta_key(), as_slice(value_));
  return write(batch, true);
}

EditDatabase::Status EditDatabase::check_meta() const {
  if (meta_.fingerprint != settings_.fingerprint) {
    return failure(
        fmt::format("the edits belong to the world with fingerprint {}; this world has fingerprint {}; give "
                    "--data another directory, or --world the edits' world",
                    to_string(meta_.fingerprint), to_string(settings_.fingerprint)));
  }
  // If the file is missing, the store gets a new id below; store.toml may have it already.
  if (meta_.store_id != settings_.store_id && has_acknowledged()) {
    return failure(ids_differ(meta_.store_id, settings_.store_id));
  }
  if (const auto other = level_rule_differs(meta_)) return failure(*other);
  return {};
}

EditDatabase::Status EditDatabase::check_acknowledged() {
  return store::check_acknowledged(env(), settings_.path, meta_);
}

// Without the file entries may be lost and their revisions reused, so clients that know the store by its id
// must discard their copies. The file is written last, so that an interrupted call is repeated entirely.
EditDatabase::Status EditDatabase::become_another() {
  if (!was_there_ || has_acknowledged()) return {};
  if (settings_.log_elsewhere) return {};  // lost entries are read again from the shared log, unchanged
  meta_.store_id = random_store_id();
  const std::string text = store_text({meta_.store_id, meta_.fingerprint});
  if (const auto written = files::write_file(settings_.path / "store.toml", text); !written) {
    return tl::unexpected{written.error().message()};
  }
  rocksdb::WriteBatch batch;
  encode(meta_, value_);
  batch.Put(meta_key(), as_slice(value_));
  return write(batch, true);
}

EditDatabase::Status EditDatabase::read_materials() {
  auto materials = reader().materials();
  if (!materials) return tl::unexpected{std::move(materials.error())};
  materials_ = *std::move(materials);
  return {};
}

EditDatabase::Status EditDatabase::read_history() {
  auto history = reader().history(meta_.flushed);
  if (!history) return tl::unexpected{std::move(history.error())};
  history_ = *std::move(history);
  for (const HistorySegment& segment : history_) history_bytes_ += segment.bytes;
  publish_history();
  return {};
}

EditDatabase::Status EditDatabase::drop_records_beyond() {
  bool any = false;
  const auto status = scan(*db_, log_key(meta_.head.position + 1), [&](const auto&, const auto&) {
    any = true;
    return false;
  });
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), remedy_for(status)));
  if (!any) return {};
  rocksdb::WriteBatch batch;
  batch.DeleteRange(log_key(meta_.head.position + 1), log_key(UINT64_MAX));
  return write(batch, true);
}

EditDatabase::Status EditDatabase::for_each_chunk(
    const std::function<void(ChunkKey, std::uint64_t)>& visit) const {
  return reader().for_each_chunk(visit);
}

EditDatabase::Status EditDatabase::for_each_editor(
    const std::function<void(edits::EditorId, StoredEditor&&)>& visit) const {
  return reader().for_each_editor(visit);
}

EditDatabase::Status EditDatabase::replay(const std::function<bool(LogRecord&&)>& visit) {
  UnflushedBatch all{.position = meta_.head.position, .link = meta_.link};
  auto bytes = reader().replay(meta_, [&](LogRecord&& record) {
    all.time_ms = record.time_ms;
    return visit(std::move(record));
  });
  if (!bytes) return tl::unexpected{std::move(bytes.error())};
  all.bytes = *bytes;
  if (meta_.head.position > meta_.flushed) unflushed_.push_back(all);
  return {};
}

tl::expected<std::optional<StoredChunk>, std::string> EditDatabase::chunk(ChunkKey key) const {
  const std::shared_lock lock{handle_};
  if (!db_) return failure("the store is closed after a disk error, and opened again each second");
  return reader().chunk(key);
}

EditDatabase::Status EditDatabase::for_each_record(std::uint64_t first,
                                                   const std::function<bool(LogRecord&&)>& visit) const {
  if (!db_) return failure("the store is closed after a disk error, and opened again each second");
  return reader().for_each_record(meta_, first, visit);
}

EditDatabase::Status EditDatabase::checkpoint(const std::filesystem::path& path) const {
  const std::shared_lock lock{copying_};
  if (!db_) return failure("the store is closed after a disk error, and opened again each second");
  rocksdb::Checkpoint* made = nullptr;
  rocksdb::Status status = rocksdb::Checkpoint::Create(db_.get(), &made);
  const std::unique_ptr<rocksdb::Checkpoint> checkpoint{made};
  // Copies the log instead of flushing it, so that edits are not delayed.
  if (status.ok()) status = checkpoint->CreateCheckpoint(path.string(), UINT64_MAX);
  if (!status.ok()) return failure(fmt::format("checkpoint {}: {}", path.string(), status.ToString()));
  return {};
}

std::unique_ptr<EditDatabase::HeldFiles> EditDatabase::hold_files() const {
  return std::make_unique<HeldFiles>(*this);
}

EditDatabase::HeldFiles::HeldFiles(const EditDatabase& database)
    : database_{database}, stays_open_{database.copying_} {
  // A closed database removes no files.
  held_ = database_.db_ && database_.db_->DisableFileDeletions().ok();
}

EditDatabase::HeldFiles::~HeldFiles() {
  if (held_) database_.db_->EnableFileDeletions(false).PermitUncheckedError();
}

EditDatabase::Status EditDatabase::append(const edits::Batch& applied, const StreamPlace& place) {
  StoreMeta meta = meta_;
  meta.head = applied.head();
  meta.stream = place;
  if (!applied.applied().empty()) {
    meta.link = encode(applied.applied(), meta.head.time_ms, meta.link, entries_);
  } else {
    entries_.clear();
  }
  rocksdb::WriteBatch batch{entries_.size() + kMinBatchBytes};
  if (!entries_.empty()) batch.Put(log_key(meta.head.position), as_slice(entries_));
  for (const edits::EntryResult& each : applied.applied()) {
    for (const auto& [name, id] : each.materials) put_material(name, id, batch);
  }
  encode(meta, value_);
  batch.Put(meta_key(), as_slice(value_));
  if (auto written = write(batch, settings_.sync && !settings_.log_elsewhere); !written) return written;
  meta_ = meta;
  if (!entries_.empty()) {
    unflushed_.push_back({meta.head.position, meta.link, entries_.size(), meta.head.time_ms});
  }
  for (const edits::EntryResult& each : applied.applied()) {
    for (const auto& [name, id] : each.materials) materials_.insert_or_assign(name, id);
  }
  if (settings_.log_elsewhere) {
    unsynced_ = true;
  } else {
    acknowledged_->write({meta.head.position, meta.link});
  }
  return {};
}

EditDatabase::Status EditDatabase::sync() {
  const SyncPoint written = begin_sync();
  if (auto synced = sync_log(); !synced) return synced;
  end_sync(written);
  return {};
}

EditDatabase::SyncPoint EditDatabase::begin_sync() {
  unsynced_ = false;
  return {meta_.head.position, meta_.link};
}

EditDatabase::Status EditDatabase::sync_log() const {
  const std::shared_lock lock{copying_};
  if (auto open = check_written({}); !open) return open;
  return check_written(db_->SyncWAL());
}

void EditDatabase::end_sync(const SyncPoint& written) {
  acknowledged_->write({written.position, written.link});
}

EditDatabase::Status EditDatabase::enter(const StreamPlace& place) {
  StoreMeta meta = meta_;
  meta.stream = place;
  rocksdb::WriteBatch batch;
  encode(meta, value_);
  batch.Put(meta_key(), as_slice(value_));
  if (auto written = write(batch, true); !written) return written;
  meta_ = meta;
  return {};
}

void EditDatabase::put_material(const std::string& name, MaterialId id, rocksdb::WriteBatch& batch) {
  const std::string key = material_key(name);
  encode(key, id, value_);
  batch.Put(key, as_slice(value_));
}

EditDatabase::Status EditDatabase::put(const Slice& slice) {
  return write(*slice.batch_, false);
}

void EditDatabase::extend_history(const UnflushedBatch& flushed, std::uint64_t first,
                                  rocksdb::WriteBatch& batch) {
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
    return flushed.time_ms - each.last_time_ms > settings_.history.age.count();
  };
  while (!history_.empty() && (history_bytes_ > settings_.history.bytes || too_old(history_.front()))) {
    const HistorySegment& oldest = history_.front();
    batch.DeleteRange(log_key(oldest.first), log_key(oldest.last + 1));
    batch.Delete(history_key(oldest.first));
    history_bytes_ -= oldest.bytes;
    history_.pop_front();
  }
}

void EditDatabase::publish_history() {
  history_size_ = history_bytes_;
  history_since_ms_ = history_.empty() ? 0 : history_.front().last_time_ms;
}

EditDatabase::Status EditDatabase::mark_flushed(std::uint64_t position) {
  UnflushedBatch flushed;
  auto left = unflushed_.begin();
  for (; left != unflushed_.end() && left->position <= position; ++left) {
    flushed.position = left->position;
    flushed.link = left->link;
    flushed.bytes += left->bytes;
    flushed.time_ms = left->time_ms;
  }
  if (left == unflushed_.begin()) return {};
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
  publish_history();
  meta_ = meta;
  unflushed_.erase(unflushed_.begin(), left);
  return {};
}

EditDatabase::Status EditDatabase::settle() {
  if (auto synced = sync_log(); !synced) return synced;
  return check_written(db_->Flush({}));
}

EditDatabase::Status EditDatabase::recover() {
  if (!damage_.empty()) return tl::unexpected{damage_};
  if (const std::uint64_t free = free_bytes(); free < settings_.free_bytes_to_open) {
    return failure(
        fmt::format("the disk has {} bytes free; writing needs {}", free, settings_.free_bytes_to_open));
  }
  const std::unique_lock not_copied{copying_, std::try_to_lock};
  if (!not_copied)
    return failure("after a disk error it is opened again when a copy or a sync of it has ended");
  const std::unique_lock lock{handle_};
  db_.reset();
  if (auto opened = open_database(); !opened) {
    db_.reset();
    return opened;
  }
  std::string value;
  const auto status = db_->Get({}, meta_key(), &value);
  const auto meta = decode_meta(std::as_bytes(std::span{value}));
  // The batch whose write failed may be on the disk or not.
  if (status.ok() && meta && meta->head.position >= meta_.head.position) {
    unsynced_ = settings_.log_elsewhere;  // the failed sync must be repeated
    return {};
  }
  db_.reset();
  if (!status.ok() && !status.IsNotFound()) {
    return failure(fmt::format("{}; {}", status.ToString(), remedy_for(status)));
  }
  const std::string what = fmt::format("after a disk error entry {} of its log is lost", meta_.head.position);
  if (!settings_.log_elsewhere || !status.ok() || !meta)
    return failure(fmt::format("{}; {}", what, kStoreLost));
  auto lost = failure(what + "; a start of the server reads it again from the log that all share");
  if (settings_.on_lost_end) settings_.on_lost_end(lost.value());
  return lost;
}

bool EditDatabase::has_acknowledged() const {
  return !env().FileExists(acknowledged_path()).IsNotFound();
}

std::uint64_t EditDatabase::free_bytes() const {
  std::uint64_t free = 0;
  // An unknown amount of free space does not block writing.
  return env().GetFreeSpace(settings_.path.string(), &free).ok() ? free : UINT64_MAX;
}

std::size_t EditDatabase::memory_bytes() const {
  const std::shared_lock lock{handle_, std::try_to_lock};
  // A reopened database soon uses as much as before.
  if (lock) memory_ = db_ ? rocks_memory(*db_) : 0;
  return memory_;
}

EditDatabase::Status EditDatabase::bind(const edits::MaterialIds& materials) {
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
    if (bound == materials_.end()) put_material(name, id, batch);
  }
  if (batch.Count() == 0) return {};
  if (auto written = write(batch, true); !written) return written;
  for (const auto& each : materials) materials_.insert(each);
  return {};
}

EditDatabase::Status EditDatabase::rename(const std::string& from, const std::string& to) {
  const auto id = check_rename(materials_, from, to);
  if (!id) return failure(id.error());
  rocksdb::WriteBatch batch;
  batch.Delete(material_key(from));
  put_material(to, *id, batch);
  if (auto written = write(batch, true); !written) return written;
  materials_.erase(from);
  materials_.emplace(to, *id);
  return {};
}

EditDatabase::Status EditDatabase::name_generated(const edits::MaterialIds& materials) {
  edits::MaterialIds names = materials;
  rocksdb::WriteBatch batch;
  for (const auto& [name, id] : materials_) {
    const auto named = materials.find(name);
    if (to_integer(id) >= edits::kFirstBound && named != materials.end()) {
      return failure(fmt::format(
          "material {} is placeable in the store, with id {}; the world may not generate a material of that "
          "name; give it another name by talusd store rename, or merge the two by talusd store rebase",
          name, to_integer(id)));
    }
    if (to_integer(id) >= edits::kFirstBound) {
      names.emplace(name, id);
    } else if (named == materials.end()) {
      batch.Delete(material_key(name));
    }
  }
  if (names == materials_) return {};
  for (const auto& [name, id] : materials) put_material(name, id, batch);
  if (auto written = write(batch, true); !written) return written;
  materials_ = std::move(names);
  return {};
}

EditDatabase::Status EditDatabase::write(rocksdb::WriteBatch& batch, bool sync) {
  if (auto open = check_written({}); !open) return open;
  rocksdb::WriteOptions options;
  options.sync = sync;
  const auto status = db_->Write(options, &batch);
  if (status.IsCorruption() && damage_.empty()) find_damage(status);
  if (!damage_.empty()) return tl::unexpected{damage_};
  return check_written(status);
}

EditDatabase::Status EditDatabase::check_written(const rocksdb::Status& status) const {
  if (!db_) return failure("the store is closed after a disk error");
  if (!status.ok()) write_failure_->set(status);
  if (!write_failure_->is_set()) return {};
  return failure(write_failure_->get().ToString() +
                 "; nothing more is written until the store is opened again");
}

void EditDatabase::find_damage(const rocksdb::Status& status) {
  // Reads only the damaged table: all writes wait meanwhile.
  const std::string text = status.ToString();
  std::vector<rocksdb::LiveFileMetaData> tables;
  db_->GetLiveFilesMetaData(&tables);
  const auto damaged = std::ranges::find_if(
      tables, [&](const auto& table) { return text.find(table.db_path + table.name) != std::string::npos; });
  const char* const lost =
      damaged != tables.end() && has_whole_state(env(), damaged->db_path + damaged->name)
          ? "all chunks and editors in that table can be read, and records of the log's history are lost; "
            "restore a backup, or stop talusd and carry all voxels over by talusd store export and import"
          : "chunks or editors may be lost; restore a backup";
  damage_ = failure(fmt::format("damage was met while tables were merged: {}; {}", text, lost)).value();
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

}  // namespace talus::store
