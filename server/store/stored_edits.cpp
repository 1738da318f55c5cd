#include "store/stored_edits.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <talus/edits/staging.h>

namespace talus::server {
namespace {

ChunkKey column_of(ChunkKey key) {
  return {{key.coord.x, 0, key.coord.z}, key.lod};
}

}  // namespace

tl::expected<std::unique_ptr<StoredEdits>, std::string> StoredEdits::open(
    const std::filesystem::path& directory, ContentHash fingerprint) {
  auto data = DataDirectory::open_to_read(directory, fingerprint);
  if (!data) return tl::unexpected{std::move(data.error())};
  EditDatabaseSettings settings;
  settings.path = directory;
  settings.fingerprint = fingerprint;
  settings.store_id = data->store_id();
  auto database = EditDatabase::open_to_read(settings);
  if (!database) return tl::unexpected{std::move(database.error())};
  std::unique_ptr<StoredEdits> edits{new StoredEdits{*std::move(data), *std::move(database)}};
  if (auto done = edits->read(); !done) return tl::unexpected{std::move(done.error())};
  return edits;
}

void StoredEdits::note(ChunkKey key) {
  const ChunkRange one{key.coord.y, key.coord.y};
  const auto [at, added] = rows_.try_emplace(column_of(key), one);
  if (added) return;
  at->second.first = std::min(at->second.first, one.first);
  at->second.last = std::max(at->second.last, one.last);
}

EditDatabase::Done StoredEdits::read() {
  auto done = database_->for_each_chunk([this](ChunkKey key, std::uint64_t) { note(key); });
  if (!done) return done;
  EditDatabase::Done applied;
  done = database_->replay([&](LogRecord&& record) {
    applied = apply(record);
    return applied.has_value();
  });
  return applied ? done : applied;
}

// Outcomes are absolute: made again where the chunk has them already, they come to the same.
EditDatabase::Done StoredEdits::apply(const LogRecord& record) {
  for (const edits::ChunkWrites& writes : edits::writes_at_all_levels(record.changes)) {
    const auto [at, added] = changed_.try_emplace(writes.key);
    if (added) {
      auto before = flushed(writes.key);
      if (!before) return tl::unexpected{std::move(before.error())};
      at->second = *std::move(before);
      note(writes.key);
    }
    if (at->second.revision >= record.revision) continue;  // it was written after this record
    at->second.overrides.apply(writes.writes);
    at->second.revision = record.revision;
  }
  return {};
}

tl::expected<StoredEdits::Chunk, std::string> StoredEdits::flushed(ChunkKey key) const {
  auto stored = database_->chunk(key);
  if (!stored) return tl::unexpected{std::move(stored.error())};
  if (!*stored) return Chunk{};
  return Chunk{(*stored)->revision, edits::ChunkOverrides{std::move((*stored)->voxels)}};
}

ChunkRange StoredEdits::edited_rows(ChunkKey key) const {
  const auto found = rows_.find(column_of(key));
  return found == rows_.end() ? ChunkRange{} : found->second;
}

tl::expected<edits::ChunkOverrides, std::string> StoredEdits::overrides(ChunkKey key) const {
  if (!edited_rows(key).contains(key.coord.y)) return edits::ChunkOverrides{};
  if (const auto found = changed_.find(key); found != changed_.end()) return found->second.overrides;
  auto chunk = flushed(key);
  if (!chunk) return tl::unexpected{std::move(chunk.error())};
  return std::move(chunk->overrides);
}

}  // namespace talus::server
