#include "store_command/history.h"

#include <algorithm>
#include <utility>

namespace talus::server {

tl::expected<VoxelHistory, std::string> history_of(const ReadOnlyStore& store, VoxelPos voxel,
                                                   ProgressBar& progress) {
  const auto key = chunk_holding(voxel, Lod{});
  if (!key) return tl::unexpected{key.error().message};
  const auto index = static_cast<std::uint16_t>(voxel_index(local_pos(voxel)));
  const StoreMeta& meta = store.meta();
  VoxelHistory history{{}, store.first_record(), meta.head.time_ms};
  progress.expect(meta.head.position + 1 - history.first_position);
  bool first = true;
  const auto read = store.reader().for_each_record(meta, history.first_position, [&](LogRecord&& record) {
    progress.advance(1);
    if (std::exchange(first, false)) history.first_time_ms = record.time_ms;
    const auto chunk = std::ranges::find(record.changes, key->coord, &edits::ChunkChanges::chunk);
    if (chunk == record.changes.end()) return true;
    const auto change = std::ranges::lower_bound(chunk->voxels, index, {}, &edits::VoxelChange::index);
    if (change != chunk->voxels.end() && change->index == index) {
      history.changes.push_back({record.time_ms, record.position, record.revision, std::move(record.subject),
                                 record.editor, change->before, change->after});
    }
    return true;
  });
  if (!read) return tl::unexpected{read.error()};
  return history;
}

}  // namespace talus::server
