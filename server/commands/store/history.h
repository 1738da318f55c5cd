// What the records of the log that are kept say of one voxel, and of one subject: piece by piece, so that
// memory does not grow with how much there is.
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

/// Entries of the log whose records are kept.
struct KeptRecords {
  std::uint64_t first = 0;
  std::uint64_t last = 0;          // less than `first`: none is kept
  std::int64_t first_time_ms = 0;  // since 1970; of none: the time of the store's last entry
  [[nodiscard]] bool any() const { return first <= last; }
};
[[nodiscard]] tl::expected<KeptRecords, std::string> kept_records(const store::ReadOnlyStore& store);

struct VoxelHistory {
  std::int64_t time_ms = 0;  // since 1970
  std::uint64_t position = 0;
  std::uint64_t revision = 0;
  std::string subject;  // of the token of who did it; empty: of no token
  edits::EditorId editor;
  MaterialId before{};
  MaterialId after{};
};

/// All changes of the voxel, the oldest first.
[[nodiscard]] tl::expected<void, std::string> history_of(
    const store::ReadOnlyStore& store, VoxelPos voxel, const std::function<void(const VoxelHistory&)>& visit,
    ProgressBar& progress);

struct SubjectQuery {
  std::string subject;             // empty: of no token
  std::int64_t since_ms = 0;       // 1970; of the log's time
  std::uint64_t after = 0;         // entries after this position alone
  std::size_t most_edits = 1'000;  // that are listed
};

/// One edit that changed something.
struct SubjectEdit {
  std::int64_t time_ms = 0;  // since 1970
  std::uint64_t position = 0;
  std::uint64_t revision = 0;
  edits::EditorId editor;
  std::size_t voxels = 0;
  VoxelPos first;  // the lowest corner of the box around them
  VoxelPos last;   // the highest, which is in it
};

/// What is known when the last of them was visited.
struct SubjectSummary {
  /// More than these are not told apart, and fewer than that are worth reading.
  static constexpr std::size_t kMostOthers = 1'000;

  std::uint64_t listed = 0;
  std::uint64_t last_position = 0;  // of the last that is listed
  bool more = false;                // there are others after them
  bool met = false;                 // whatever the query's bounds: there is an edit of that subject
  /// Where none was met: whose edits there are, and how many, those with the most first.
  std::vector<std::pair<std::string, std::uint64_t>> others;
  bool more_others = false;  // beyond kMostOthers
};

/// Visits the edits of a subject, the oldest first. Reads records up to those that it visits and one more.
[[nodiscard]] tl::expected<SubjectSummary, std::string> subject_history(
    const store::ReadOnlyStore& store, const SubjectQuery& query,
    const std::function<void(const SubjectEdit&)>& visit, ProgressBar& progress);

}  // namespace talus::server
