#include "commands/store/history.h"

#include <algorithm>
#include <map>
#include <utility>

namespace talus::server {
namespace {

/// REQUIRES: the record changes something.
SubjectEdit edit_of(const store::LogRecord& record) {
  SubjectEdit all{record.time_ms, record.position, record.revision, record.editor, 0, {}, {}};
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

/// Counts edits by subject, for up to kMaxOtherSubjects subjects.
class Others {
 public:
  void count(const std::string& subject) {
    const auto at = edits_.find(subject);
    if (at != edits_.end()) {
      ++at->second;
    } else if (edits_.size() < SubjectSummary::kMaxOtherSubjects) {
      edits_.emplace(subject, 1);
    } else {
      more_ = true;
    }
  }
  void give(SubjectSummary& summary) {
    summary.others.assign(edits_.begin(), edits_.end());
    std::ranges::stable_sort(summary.others, std::ranges::greater{},
                             &std::pair<std::string, std::uint64_t>::second);
    summary.more_others = more_;
  }

 private:
  std::map<std::string, std::uint64_t> edits_;
  bool more_ = false;
};

}  // namespace

tl::expected<KeptRecords, std::string> kept_records(const store::ReadOnlyStore& store) {
  const store::StoreMeta& meta = store.meta();
  KeptRecords kept{store.first_record(), meta.head.position, meta.head.time_ms};
  if (!kept.any()) return kept;
  const auto read = store.reader().for_each_record(meta, kept.first, [&](store::LogRecord&& record) {
    kept.first_time_ms = record.time_ms;
    return false;
  });
  if (!read) return tl::unexpected{read.error()};
  return kept;
}

tl::expected<void, std::string> history_of(const store::ReadOnlyStore& store, VoxelPos voxel,
                                           const std::function<void(const VoxelHistory&)>& visit,
                                           ProgressBar& progress) {
  const auto key = chunk_holding(voxel, Lod{});
  if (!key) return tl::unexpected{key.error().message};
  const auto index = static_cast<std::uint16_t>(voxel_index(local_pos(voxel)));
  const store::StoreMeta& meta = store.meta();
  progress.expect(meta.head.position + 1 - store.first_record());
  return store.reader().for_each_record(meta, store.first_record(), [&](store::LogRecord&& record) {
    progress.advance(1);
    const auto chunk = std::ranges::find(record.changes, key->coord, &edits::ChunkChanges::chunk);
    if (chunk == record.changes.end()) return true;
    const auto change = std::ranges::lower_bound(chunk->voxels, index, {}, &edits::VoxelChange::index);
    if (change != chunk->voxels.end() && change->index == index) {
      visit({record.time_ms, record.position, record.revision, std::move(record.subject), record.editor,
             change->before, change->after});
    }
    return true;
  });
}

tl::expected<SubjectSummary, std::string> subject_history(
    const store::ReadOnlyStore& store, const SubjectQuery& query,
    const std::function<void(const SubjectEdit&)>& visit, ProgressBar& progress) {
  const store::StoreMeta& meta = store.meta();
  SubjectSummary summary;
  Others others;
  progress.expect(meta.head.position + 1 - store.first_record());
  const auto read =
      store.reader().for_each_record(meta, store.first_record(), [&](store::LogRecord&& record) {
        progress.advance(1);
        if (record.changes.empty()) return true;
        if (record.subject != query.subject) {
          if (!summary.met) others.count(record.subject);
          return true;
        }
        summary.met = true;
        if (record.position <= query.after || record.time_ms < query.since_ms) return true;
        summary.more = summary.listed == query.max_edits;
        if (summary.more) return false;
        visit(edit_of(record));
        ++summary.listed;
        summary.last_position = record.position;
        return true;
      });
  if (!read) return tl::unexpected{read.error()};
  if (!summary.met) others.give(summary);
  return summary;
}

}  // namespace talus::server
