// Edits that restore voxels to an earlier material, if they still have the expected one. Each object is an
// editor of its own.
#pragma once

#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/evaluate.h>

#include "edits/edit_log.h"

namespace talus::server {

/// The subject of these edits in a store's history.
inline constexpr std::string_view kRestorerSubject = edits::kOperatorSubject;

class Restorer {
 public:
  /// Maximum number of voxels of one edit, so that no large one delays players' edits.
  static constexpr std::size_t kMaxVoxels = 4'096;

  struct Result {
    std::uint64_t revision = 0;
    std::uint64_t changed = 0;
  };

  /// `log` outlives this. A stop of `ends` ends the wait for it.
  explicit Restorer(EditLog& log, std::stop_token ends = {}) : log_{log}, ends_{std::move(ends)} {}

  /// One edit: each voxel of material `before` becomes `after`, the others stay. Blocks until the log
  /// answers. Not on the log's thread.
  [[nodiscard]] tl::expected<Result, EditError> restore(const std::vector<edits::ChunkChanges>& changes);

 private:
  [[nodiscard]] tl::expected<edits::EntryResult, EditError> append(LogEntry entry);

  EditLog& log_;
  const std::stop_token ends_;
  edits::EditorId editor_;  // 0: not attached yet
  std::uint64_t sequence_ = 0;
};

}  // namespace talus::server
