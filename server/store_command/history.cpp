#include "store_command/history.h"

#include <algorithm>
#include <utility>

namespace talus::server {
namespace {

/// REQUIRES: the record changes something.
SubjectHistory::Changes changes_of(const LogRecord& record) {
  SubjectHistory::Changes all{record.time_ms, record.position, record.revision, record.editor, 0, {}, {}};
  for (const edits::ChunkChanges& changes : record.changes) {
    const VoxelPos origin = chunk_origin(changes.chunk);
    for (const edits::VoxelChange& voxel : changes.voxels) {
      const VoxelPos at = voxel_at(origin, local_of(voxel.index));
      if (all.voxels++ == 0) all.first = all.last = at;
      all.first = {std::min(all.first.x, at.x), std::min(all.first.y, at.y), std::min(all.first.z, at.z)};
      all.last = {std::max(all.last.x, at.x), std::max(all.last.y, at.y), std::max(all.last.z, at.z)};
    }
  }
  return all;
}

}  // namespace

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

tl::expected<SubjectHistory, std::string> subject_history(const ReadOnlyStore& store,
                                                          const SubjectQuery& query, ProgressBar& progress) {
  const StoreMeta& meta = store.meta();
  SubjectHistory history{{}, false, store.first_record(), meta.head.time_ms};
  progress.expect(meta.head.position + 1 - history.first_position);
  bool first = true;
  const auto read = store.reader().for_each_record(meta, history.first_position, [&](LogRecord&& record) {
    progress.advance(1);
    if (std::exchange(first, false)) history.first_time_ms = record.time_ms;
    if (record.position <= query.after || record.time_ms < query.since_ms) return true;
    if (record.changes.empty() || record.subject != query.subject) return true;
    history.more = history.edits.size() == query.most_edits;
    if (!history.more) history.edits.push_back(changes_of(record));
    return !history.more;
  });
  if (!read) return tl::unexpected{read.error()};
  return history;
}

}  // namespace talus::server
