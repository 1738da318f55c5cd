// What one subject did within a box since some time, and what is to be put back: each voxel that still is as
// that subject left it becomes what it was before. Where somebody else has built since, nothing is touched.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
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
  std::string subject;        // empty: of no token
  std::int64_t since_ms = 0;  // 1970; of the log's time
  VoxelPos first;             // the box's lowest corner
  VoxelPos last;              // the highest, which is in it
};

/// Who changed voxels of the box since the time, and how many; one that changed twice counts twice.
struct Changer {
  std::string subject;  // empty: of no token
  std::size_t voxels = 0;
};

/// By the records of the log, one after the other. Pure.
class Rollback {
 public:
  /// Voxels that one command rolls back: about 600 MB of memory.
  static constexpr std::size_t kMaxVoxels = std::size_t{8} << 20U;

  /// Others than the subject whose names are kept.
  static constexpr std::size_t kMaxOthers = 1000;

  explicit Rollback(RollbackRequest request) : request_{std::move(request)} {}

  /// The next record. False: it touches more than kMaxVoxels.
  [[nodiscard]] bool add(const store::LogRecord& record);

  [[nodiscard]] std::size_t voxels() const;
  /// Voxels that the subject changed and a rollback has put back since.
  [[nodiscard]] std::size_t already_back() const { return already_back_; }
  /// Those that others have changed since; not to be put back.
  [[nodiscard]] std::size_t taken_over() const { return taken_over_; }
  /// Whether the subject changed any voxel there.
  [[nodiscard]] bool met_subject() const { return met_subject_; }
  /// Those who did so before the subject was met, the busiest first. Complete where it never was, up to
  /// kMaxOthers.
  [[nodiscard]] std::vector<Changer> others() const;
  /// As edits: in each `before` is what the voxel is now, and `after` what it becomes.
  [[nodiscard]] std::vector<std::vector<edits::ChunkChanges>> slices() const;

 private:
  struct Touched {
    MaterialId original{};  // before the subject came
    MaterialId put{};       // what it is now
    MaterialId base{};
  };
  using Chunk = std::unordered_map<std::uint16_t, Touched>;  // by index

  [[nodiscard]] bool has(VoxelPos at) const;
  void count_other(const std::string& subject, const edits::ChunkChanges& changes);

  const RollbackRequest request_;
  std::map<ChunkCoord, Chunk> chunks_;
  std::size_t held_ = 0;
  std::size_t already_back_ = 0;
  std::size_t taken_over_ = 0;
  bool met_subject_ = false;
  std::map<std::string, std::size_t> others_;  // voxels by subject
};

struct RollbackPlan {
  std::vector<std::vector<edits::ChunkChanges>> slices;
  std::size_t voxels = 0;
  std::size_t already_back = 0;
  std::size_t taken_over = 0;
  bool met_subject = false;
  std::vector<Changer> others;       // where the subject was not met; the busiest first
  std::uint64_t first_position = 0;  // how far back the records go
  std::int64_t first_time_ms = 0;
};
[[nodiscard]] tl::expected<RollbackPlan, std::string> plan_rollback(const store::ReadOnlyStore& store,
                                                                    const RollbackRequest& request,
                                                                    ProgressBar& progress);

using Restore = std::function<tl::expected<Restorer::Restored, Restorer::Failure>(
    const std::vector<edits::ChunkChanges>&)>;
/// Makes the edits one by one, and each that is refused for now again for a minute. Returns how many voxels
/// changed. Whoever is interrupted does the whole again: what was put back is not the subject's any more.
[[nodiscard]] tl::expected<std::uint64_t, std::string> roll_back(const RollbackPlan& plan,
                                                                 const Restore& restore,
                                                                 ProgressBar& progress);

}  // namespace talus::server
