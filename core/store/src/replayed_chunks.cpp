#include <talus/store/replayed_chunks.h>

#include <utility>

#include <talus/edits/staging.h>

namespace talus::store {

tl::expected<void, std::string> ReplayedChunks::apply(const LogRecord& record) {
  for (const edits::ChunkWrites& writes : edits::writes_at_all_levels(record.changes)) {
    const auto [at, added] = chunks_.try_emplace(writes.key);
    Chunk& chunk = at->second;
    if (added) {
      auto stored = load_(writes.key);
      if (!stored) return tl::unexpected{std::move(stored.error())};
      if (*stored) chunk = {(*stored)->revision, edits::ChunkOverrides{std::move((*stored)->voxels)}};
    }
    if (chunk.revision >= record.revision) continue;  // the stored chunk includes this record
    chunk.overrides.apply(writes.writes);
    chunk.revision = record.revision;
  }
  return {};
}

}  // namespace talus::store
