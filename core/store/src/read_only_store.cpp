#include <talus/store/read_only_store.h>

#include <limits>
#include <utility>

#include <fmt/format.h>

#include <talus/store/open_rocks.h>
#include <talus/store/regular_files.h>
#include <talus/store/replayed_chunks.h>
#include <talus/store/replayed_editors.h>
#include <talus/store/rocks.h>

namespace talus::store {

ReadOnlyStore::ReadOnlyStore(std::filesystem::path path) : path_{std::move(path)} {}
ReadOnlyStore::~ReadOnlyStore() = default;

StoreReader ReadOnlyStore::reader() const {
  return {*db_, path_};
}

tl::expected<std::unique_ptr<ReadOnlyStore>, std::string> ReadOnlyStore::open(
    const std::filesystem::path& path) {
  if (const auto regular = check_regular_files(path / "db"); !regular) {
    return tl::unexpected{fmt::format("edits {}: {}", path.string(), regular.error())};
  }
  std::unique_ptr<ReadOnlyStore> store{new ReadOnlyStore{path}};
  auto opened = open_rocks(path, {}, RocksUse::read);
  if (!opened) return tl::unexpected{std::move(opened.error().line)};
  store->rocks_parts_ = std::move(opened->parts);
  store->db_ = std::move(opened->db);
  store->dropped_ = std::move(opened->dropped);
  const StoreReader reader = store->reader();
  const auto meta = reader.meta();
  if (!meta) return tl::unexpected{meta.error()};
  if (!*meta)
    return reader.failure(fmt::format("its record of the store's state is missing; {}", kStoreLost));
  store->meta_ = **meta;
  auto materials = reader.materials();
  if (!materials) return tl::unexpected{std::move(materials.error())};
  store->materials_ = *std::move(materials);
  auto history = reader.history(store->meta_.flushed);
  if (!history) return tl::unexpected{std::move(history.error())};
  store->history_ = *std::move(history);
  if (auto read = store->read_unflushed(); !read) return tl::unexpected{std::move(read.error())};
  return store;
}

bool ReadOnlyStore::is_damaged(const std::filesystem::path& path) {
  const auto opened = open_rocks(path, {}, RocksUse::read);
  if (!opened) return opened.error().status.IsCorruption() || opened.error().status.IsPathNotFound();
  return opened->db->VerifyChecksum().IsCorruption();
}

ReadOnlyStore::Status ReadOnlyStore::read_unflushed() {
  const StoreReader reader = this->reader();
  ReplayedChunks chunks{[&](ChunkKey key) { return reader.chunk(key); }};
  Status read;
  auto replayed = reader.replay(meta_, [&](LogRecord&& record) {
    read = chunks.apply(record);
    return read.has_value();
  });
  if (!read) return read;
  if (!replayed) return tl::unexpected{std::move(replayed.error())};
  unflushed_bytes_ = *replayed;
  for (const auto& [key, chunk] : chunks.take()) {
    const auto voxels = chunk.overrides.voxels();
    unflushed_.emplace(chunk_key(key), StoredChunk{chunk.revision, {voxels.begin(), voxels.end()}});
  }
  return {};
}

StoreReader::Result<std::optional<StoredChunk>> ReadOnlyStore::chunk(ChunkKey key) const {
  const auto newer = unflushed_.find(chunk_key(key));
  if (newer != unflushed_.end()) return std::optional{newer->second};
  return reader().chunk(key);
}

ReadOnlyStore::Status ReadOnlyStore::for_each_chunk(
    const std::function<bool(ChunkKey, const StoredChunk&)>& visit) const {
  auto newer = unflushed_.begin();
  bool goes_on = true;
  constexpr std::int32_t kLowest = std::numeric_limits<std::int32_t>::min();
  auto read = reader().for_each_chunk_value(
      {{kLowest, kLowest, kLowest}, Lod{}}, [&](ChunkKey key, StoredChunk&& chunk) {
        const std::string name = chunk_key(key);
        for (; goes_on && newer != unflushed_.end() && newer->first < name; ++newer) {
          goes_on = visit(*chunk_of_key(newer->first), newer->second);
        }
        if (!goes_on) return false;
        const bool replaced = newer != unflushed_.end() && newer->first == name;
        goes_on = visit(key, replaced ? newer->second : chunk);
        if (replaced) ++newer;
        return goes_on;
      });
  if (!read) return read;
  for (; goes_on && newer != unflushed_.end(); ++newer) {
    goes_on = visit(*chunk_of_key(newer->first), newer->second);
  }
  return {};
}

ReadOnlyStore::Status ReadOnlyStore::for_each_base_chunk(
    const std::function<bool(ChunkCoord, const StoredChunk&)>& visit) const {
  return for_each_chunk(
      [&](ChunkKey key, const StoredChunk& chunk) { return key.lod == Lod{} && visit(key.coord, chunk); });
}

std::uint64_t ReadOnlyStore::first_record() const {
  return history_.empty() ? meta_.flushed + 1 : history_.front().first;
}

std::uint64_t ReadOnlyStore::record_bytes() const {
  std::uint64_t bytes = unflushed_bytes_;
  for (const HistorySegment& segment : history_) bytes += segment.bytes;
  return bytes;
}

StoreReader::Result<std::size_t> ReadOnlyStore::count_editors() const {
  const StoreReader reader = this->reader();
  ReplayedEditors editors;
  const auto read = reader.for_each_editor([&](edits::EditorId id, StoredEditor&& stored) {
    stored.editor.results = {};  // large, and not counted here
    editors.start(id, std::move(stored));
  });
  if (!read) return tl::unexpected{read.error()};
  const auto replayed = reader.replay(meta_, [&](LogRecord&& record) {
    editors.apply(record);
    return true;
  });
  if (!replayed) return tl::unexpected{replayed.error()};
  return editors.take().size();
}

ReadOnlyStore::Status ReadOnlyStore::verify_files() const {
  if (const auto status = db_->VerifyChecksum(); !status.ok()) {
    return reader().failure(fmt::format("{}; {}", status.ToString(), remedy_for(status)));
  }
  return {};
}

std::uint64_t ReadOnlyStore::estimated_keys() const {
  std::uint64_t keys = 0;
  return db_->GetIntProperty(rocksdb::DB::Properties::kEstimateNumKeys, &keys) ? keys : 0;
}

}  // namespace talus::store
