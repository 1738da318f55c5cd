// What the records of the log that are kept say of one voxel, and of one subject.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/progress/progress_bar.h>

#include "store/read_only_store.h"

namespace talus::server {

struct VoxelHistory {
  struct Change {
    std::int64_t time_ms = 0;  // since 1970
    std::uint64_t position = 0;
    std::uint64_t revision = 0;
    std::string subject;  // of the token of who did it; empty: of no token
    edits::EditorId editor;
    MaterialId before{};
    MaterialId after{};
  };
  std::vector<Change> changes;  // the oldest first
  /// How far back the records go; of none: what there is now.
  std::uint64_t first_position = 0;
  std::int64_t first_time_ms = 0;
};

[[nodiscard]] tl::expected<VoxelHistory, std::string> history_of(const ReadOnlyStore& store, VoxelPos voxel,
                                                                 ProgressBar& progress);

struct SubjectQuery {
  std::string subject;             // empty: of no token
  std::int64_t since_ms = 0;       // 1970; of the log's time
  std::uint64_t after = 0;         // entries after this position alone
  std::size_t most_edits = 1'000;  // that are listed
};

struct SubjectHistory {
  /// Of one edit that changed something.
  struct Changes {
    std::int64_t time_ms = 0;  // since 1970
    std::uint64_t position = 0;
    std::uint64_t revision = 0;
    edits::EditorId editor;
    std::size_t voxels = 0;
    VoxelPos first;  // the lowest corner of the box around them
    VoxelPos last;   // the highest, which is in it
  };
  std::vector<Changes> edits;  // the oldest first
  bool more = false;           // there are others after them
  /// How far back the records go; of none: what there is now.
  std::uint64_t first_position = 0;
  std::int64_t first_time_ms = 0;
};

/// Reads all records up to those that it lists and one more, and holds no more than these.
[[nodiscard]] tl::expected<SubjectHistory, std::string> subject_history(const ReadOnlyStore& store,
                                                                        const SubjectQuery& query,
                                                                        ProgressBar& progress);

}  // namespace talus::server
