#include "store/stored_edits.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "store/acknowledged_file.h"

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
  std::error_code ignored;
  if (!std::filesystem::is_directory(directory / "db", ignored)) {
    return tl::unexpected{
        fmt::format("store {}: there is no database of edits; a store that talusd has opened has one",
                    directory.string())};
  }
  auto store = ReadOnlyStore::open(directory);
  if (!store) return tl::unexpected{std::move(store.error())};
  if (auto all = check_acknowledged(directory, (*store)->meta()); !all)
    return tl::unexpected{std::move(all.error())};
  std::unique_ptr<StoredEdits> edits{new StoredEdits{*std::move(data), *std::move(store)}};
  auto read = edits->store_->for_each_chunk([&](ChunkKey key, const StoredChunk&) {
    edits->note(key);
    return true;
  });
  if (!read) return tl::unexpected{std::move(read.error())};
  return edits;
}

void StoredEdits::note(ChunkKey key) {
  const ChunkRange one{key.coord.y, key.coord.y};
  const auto [at, added] = rows_.try_emplace(column_of(key), one);
  if (added) return;
  at->second.first = std::min(at->second.first, one.first);
  at->second.last = std::max(at->second.last, one.last);
}

ChunkRange StoredEdits::edited_rows(ChunkKey key) const {
  const auto found = rows_.find(column_of(key));
  return found == rows_.end() ? ChunkRange{} : found->second;
}

tl::expected<edits::ChunkOverrides, std::string> StoredEdits::overrides(ChunkKey key) const {
  if (!edited_rows(key).contains(key.coord.y)) return edits::ChunkOverrides{};
  auto chunk = store_->chunk(key);
  if (!chunk) return tl::unexpected{std::move(chunk.error())};
  if (!*chunk) return edits::ChunkOverrides{};
  return edits::ChunkOverrides{std::move((*chunk)->voxels)};
}

}  // namespace talus::server
