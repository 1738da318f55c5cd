// Searches the kept log records for one voxel or one subject. Streams them, so that memory use does not grow
// with the log.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include <talus/progress/progress_bar.h>
#include <talus/store/read_only_store.h>

namespace talus::server {

/// Range of the log's entries whose records are kept.
struct KeptRecords {
  std::uint64_t first = 0;
  std::uint64_t last = 0;          // less than `first` if none is kept
  std::int64_t first_time_ms = 0;  // since 1970; if none is kept, the time of the store's last entry
  [[nodiscard]] bool any() const { return first <= last; }
};
[[nodiscard]] tl::expected<KeptRecords, std::string> kept_records(const store::ReadOnlyStore& store);

struct VoxelHistory {
  std::int64_t time_ms = 0;  // since 1970
  std::uint64_t position = 0;
  std::uint64_t revision = 0;
  std::string subject;  // of the editor's token; empty: without a token
  edits::EditorId editor;
  MaterialId before{};
  MaterialId after{};
};

/// Visits all changes of the voxel, oldest first.
[[nodiscard]] tl::expected<void, std::string> history_of(
    const store::ReadOnlyStore& store, VoxelPos voxel, const std::function<void(const VoxelHistory&)>& visit,
    ProgressBar& progress);

struct SubjectQuery {
  std::string subject;            // empty: edits without a token
  std::int64_t since_ms = 0;      // since 1970, by the log's time
  std::uint64_t after = 0;        // only entries after this position
  std::size_t max_edits = 1'000;  // maximum number of edits listed
};

/// One edit that changed something.
struct SubjectEdit {
  std::int64_t time_ms = 0;  // since 1970
  std::uint64_t position = 0;
  std::uint64_t revision = 0;
  edits::EditorId editor;
  std::size_t voxels = 0;
  VoxelPos first;  // lowest corner of the bounding box
  VoxelPos last;   // highest corner, inclusive
};

/// Result of a search, known after the last visit.
struct SubjectSummary {
  /// Maximum number of subjects in `others`; few readers need more.
  static constexpr std::size_t kMaxOtherSubjects = 1'000;

  std::uint64_t listed = 0;
  std::uint64_t last_position = 0;  // of the last edit listed
  bool more = false;                // more edits follow
  bool met = false;                 // the subject has an edit, even outside the query's bounds
  /// If `met` is false: other subjects with their numbers of edits, most edits first.
  std::vector<std::pair<std::string, std::uint64_t>> others;
  bool more_others = false;  // there are more than kMaxOtherSubjects
};

/// Visits the edits of a subject, oldest first. Stops one edit after the last one listed.
[[nodiscard]] tl::expected<SubjectSummary, std::string> subject_history(
    const store::ReadOnlyStore& store, const SubjectQuery& query,
    const std::function<void(const SubjectEdit&)>& visit, ProgressBar& progress);

}  // namespace talus::server
