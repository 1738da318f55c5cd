// What the records of the log that are kept say of one voxel.
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

}  // namespace talus::server
