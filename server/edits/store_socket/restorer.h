// Edits that give voxels back what they were: each voxel that still holds what it is said to hold. An editor
// of its own, that lives as long as the object.
#pragma once

#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/evaluate.h>

#include "edits/edit_log.h"

namespace talus::server {

/// Whose these edits are, in a store's history.
inline constexpr std::string_view kRestorerSubject = edits::kOperatorSubject;

class Restorer {
 public:
  /// Voxels of one edit, so that players' edits wait for none that is large.
  static constexpr std::size_t kMaxVoxels = 4'096;

  struct Restored {
    std::uint64_t revision = 0;
    std::uint64_t changed = 0;
  };
  struct Failure {
    std::string reason;  // one line
    bool busy = false;   // the same again may succeed, and does no harm where it did already
  };

  /// `log` outlives this. Once `ends` is requested nothing waits for it any more.
  explicit Restorer(EditLog& log, std::stop_token ends = {}) : log_{log}, ends_{std::move(ends)} {}

  /// One edit: each voxel of material `before` becomes `after`, the others stay. Waits for the log. Not on
  /// the log's thread.
  [[nodiscard]] tl::expected<Restored, Failure> restore(const std::vector<edits::ChunkChanges>& changes);

 private:
  [[nodiscard]] tl::expected<edits::Applied, Failure> append(LogEntry entry);

  EditLog& log_;
  const std::stop_token ends_;
  edits::EditorId editor_;  // 0: not attached yet
  std::uint64_t sequence_ = 0;
};

}  // namespace talus::server
