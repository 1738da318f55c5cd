// Undoes the changes of one subject in a box since a time: each voxel still as that subject left it gets its
// previous material. Voxels changed by others since are left alone.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/evaluate.h>
#include <talus/progress/progress_bar.h>
#include <talus/store/read_only_store.h>

#include "edits/store_socket/restorer.h"

namespace talus::server {

struct RollbackRequest {
  std::string subject;        // empty: edits without a token
  std::int64_t since_ms = 0;  // since 1970, by the log's time
  VoxelPos first;             // lowest corner of the box
  VoxelPos last;              // highest corner, inclusive
};

/// A subject that changed voxels of the box since the time. A voxel changed twice counts twice.
struct Changer {
  std::string subject;  // empty: without a token
  std::size_t voxels = 0;
};

/// Computes the rollback from consecutive log records. Pure.
class Rollback {
 public:
  /// Maximum number of voxels per command: about 600 MB of memory.
  static constexpr std::size_t kMaxVoxels = std::size_t{8} << 20U;

  /// Maximum number of other subjects recorded.
  static constexpr std::size_t kMaxOtherSubjects = 1000;

  explicit Rollback(RollbackRequest request) : request_{std::move(request)} {}

  /// Adds the next record. False if more than kMaxVoxels voxels are affected.
  [[nodiscard]] bool add(const store::LogRecord& record);

  [[nodiscard]] std::size_t voxels() const;
  /// Voxels of the subject that an earlier rollback already restored.
  [[nodiscard]] std::size_t already_back() const { return already_back_; }
  /// Voxels of the subject that others have changed since; not restored.
  [[nodiscard]] std::size_t taken_over() const { return taken_over_; }
  /// True if the subject changed any voxel in the box.
  [[nodiscard]] bool met_subject() const { return met_subject_; }
  /// The lowest date, if it is before the time, of an entry that follows changes by the subject in the box
  /// dated since: those are not restored.
  [[nodiscard]] std::optional<std::int64_t> date_fell_to_ms() const { return date_fell_to_ms_; }
  /// Other subjects that changed the box before the first change by the subject, busiest first. Complete, up
  /// to kMaxOtherSubjects, if the subject changed nothing.
  [[nodiscard]] std::vector<Changer> others() const;
  /// The edits to make; in each change `before` is the current material and `after` the restored one.
  [[nodiscard]] std::vector<std::vector<edits::ChunkChanges>> slices() const;

 private:
  struct TouchedVoxel {
    MaterialId original{};  // before the subject's first change
    MaterialId put{};       // the subject's last change
    MaterialId base{};
  };
  using Chunk = std::unordered_map<std::uint16_t, TouchedVoxel>;  // by voxel index

  [[nodiscard]] bool has(VoxelPos at) const;
  /// Forgets all records.
  void start_anew();
  void count_other(const std::string& subject, const edits::ChunkChanges& changes);

  const RollbackRequest request_;
  std::map<ChunkCoord, Chunk> chunks_;
  std::size_t held_ = 0;
  std::size_t already_back_ = 0;
  std::size_t taken_over_ = 0;
  bool met_subject_ = false;
  std::optional<std::int64_t> date_fell_to_ms_;
  std::map<std::string, std::size_t> others_;  // voxels by subject
};

struct RollbackPlan {
  std::vector<std::vector<edits::ChunkChanges>> slices;
  std::size_t voxels = 0;
  std::size_t already_back = 0;
  std::size_t taken_over = 0;
  bool met_subject = false;
  std::optional<std::int64_t> date_fell_to_ms;
  std::vector<Changer> others;       // only if met_subject is false; busiest first
  std::uint64_t first_position = 0;  // oldest record read
  std::int64_t first_time_ms = 0;
};
[[nodiscard]] tl::expected<RollbackPlan, std::string> plan_rollback(const store::ReadOnlyStore& store,
                                                                    const RollbackRequest& request,
                                                                    ProgressBar& progress);

using Restore =
    std::function<tl::expected<Restorer::Result, EditError>(const std::vector<edits::ChunkChanges>&)>;
/// Makes the edits one by one, retrying each temporarily rejected one for a minute. Returns the number of
/// voxels changed. An interrupted rollback can be repeated: restored voxels no longer count as the subject's.
[[nodiscard]] tl::expected<std::uint64_t, std::string> roll_back(const RollbackPlan& plan,
                                                                 const Restore& restore,
                                                                 ProgressBar& progress);

}  // namespace talus::server
