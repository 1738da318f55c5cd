#include "commands/store/rollback.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace talus::server {
namespace {

constexpr std::chrono::milliseconds kRetry{200};
constexpr int kMaxTries = 300;

/// True if the chunk that begins at `at` overlaps the box along one axis.
bool meets(std::int64_t at, std::int64_t first, std::int64_t last) {
  return at <= last && at + kChunkSize > first;
}

}  // namespace

bool Rollback::has(VoxelPos at) const {
  const VoxelPos& first = request_.first;
  const VoxelPos& last = request_.last;
  return at.x >= first.x && at.x <= last.x && at.y >= first.y && at.y <= last.y && at.z >= first.z &&
         at.z <= last.z;
}

void Rollback::count_other(const std::string& subject, const edits::ChunkChanges& changes) {
  const VoxelPos origin = chunk_origin(changes.chunk);
  const auto inside = static_cast<std::size_t>(std::ranges::count_if(
      changes.voxels, [&](const auto& voxel) { return has(voxel_at(origin, local_of(voxel.index))); }));
  if (inside == 0) return;
  const auto known = others_.find(subject);
  if (known != others_.end()) {
    known->second += inside;
  } else if (others_.size() < kMaxOtherSubjects) {
    others_.emplace(subject, inside);
  }
}

void Rollback::start_anew() {
  chunks_.clear();
  held_ = already_back_ = taken_over_ = 0;
  met_subject_ = false;
  others_.clear();
}

bool Rollback::add(const store::LogRecord& record) {
  const bool is_since = record.time_ms >= request_.since_ms;
  // Earlier records were made before `since_ms`, even if a clock that was ahead dated them later.
  if (!is_since) {
    const bool is_discarding = met_subject_ || date_fell_to_ms_;
    if (is_discarding) date_fell_to_ms_ = std::min(record.time_ms, date_fell_to_ms_.value_or(record.time_ms));
    start_anew();
  }
  const bool is_subjects = record.subject == request_.subject && is_since;
  const VoxelPos& first = request_.first;
  const VoxelPos& last = request_.last;
  for (const edits::ChunkChanges& changes : record.changes) {
    const VoxelPos origin = chunk_origin(changes.chunk);
    if (!meets(origin.x, first.x, last.x) || !meets(origin.y, first.y, last.y) ||
        !meets(origin.z, first.z, last.z)) {
      continue;
    }
    if (is_since && !is_subjects && !met_subject_) count_other(record.subject, changes);
    const auto held = chunks_.find(changes.chunk);
    if (held == chunks_.end() && !is_subjects) continue;
    Chunk& chunk = held == chunks_.end() ? chunks_[changes.chunk] : held->second;
    for (const edits::VoxelChange& voxel : changes.voxels) {
      const auto touched = chunk.find(voxel.index);
      if (!is_subjects) {
        if (touched == chunk.end()) continue;
        const bool is_back = record.subject == kRestorerSubject && voxel.after == touched->second.original;
        ++(is_back ? already_back_ : taken_over_);
        chunk.erase(touched);
        --held_;
        continue;
      }
      if (touched != chunk.end()) {
        touched->second.put = voxel.after;
        continue;
      }
      if (!has(voxel_at(origin, local_of(voxel.index)))) continue;
      met_subject_ = true;
      if (++held_ > kMaxVoxels) return false;
      chunk.emplace(voxel.index, TouchedVoxel{voxel.before, voxel.after, voxel.base});
    }
  }
  return true;
}

std::size_t Rollback::voxels() const {
  std::size_t count = 0;
  for (const auto& [coord, chunk] : chunks_) {
    count += static_cast<std::size_t>(std::ranges::count_if(
        chunk, [](const auto& each) { return each.second.put != each.second.original; }));
  }
  return count;
}

std::vector<Changer> Rollback::others() const {
  std::vector<Changer> others;
  for (const auto& [subject, voxels] : others_) others.push_back({subject, voxels});
  std::ranges::stable_sort(others, std::ranges::greater{}, &Changer::voxels);
  return others;
}

std::vector<std::vector<edits::ChunkChanges>> Rollback::slices() const {
  std::vector<std::vector<edits::ChunkChanges>> slices;
  std::size_t room = 0;  // room for voxels in the last slice
  for (const auto& [coord, chunk] : chunks_) {
    std::vector<edits::VoxelChange> voxels;
    for (const auto& [index, touched] : chunk) {
      if (touched.put == touched.original) continue;
      voxels.push_back({index, touched.put, touched.original, touched.base});
    }
    std::ranges::sort(voxels, {}, &edits::VoxelChange::index);
    for (std::size_t done = 0; done < voxels.size();) {
      if (room == 0 || slices.back().size() == edits::kMaxChunks) {
        slices.emplace_back();
        room = Restorer::kMaxVoxels;
      }
      const std::size_t count = std::min(room, voxels.size() - done);
      const auto from = voxels.begin() + static_cast<std::ptrdiff_t>(done);
      slices.back().push_back({coord, {from, from + static_cast<std::ptrdiff_t>(count)}});
      done += count;
      room -= count;
    }
  }
  return slices;
}

tl::expected<RollbackPlan, std::string> plan_rollback(const store::ReadOnlyStore& store,
                                                      const RollbackRequest& request, ProgressBar& progress) {
  const store::StoreMeta& meta = store.meta();
  RollbackPlan plan;
  plan.first_position = store.first_record();
  plan.first_time_ms = meta.head.time_ms;
  progress.expect(meta.head.position + 1 - plan.first_position);
  Rollback rollback{request};
  bool first = true;
  bool fits = true;
  const auto read = store.reader().for_each_record(meta, plan.first_position, [&](store::LogRecord&& record) {
    progress.advance(1);
    if (std::exchange(first, false)) plan.first_time_ms = record.time_ms;
    fits = rollback.add(record);
    return fits;
  });
  if (!read) return tl::unexpected{read.error()};
  if (!fits) {
    return tl::unexpected{fmt::format("the subject changed more than {} voxels there; give a smaller --box",
                                      Rollback::kMaxVoxels)};
  }
  plan.slices = rollback.slices();
  plan.voxels = rollback.voxels();
  plan.already_back = rollback.already_back();
  plan.taken_over = rollback.taken_over();
  plan.met_subject = rollback.met_subject();
  plan.date_fell_to_ms = rollback.date_fell_to_ms();
  if (!plan.met_subject) plan.others = rollback.others();
  return plan;
}

tl::expected<std::uint64_t, std::string> roll_back(const RollbackPlan& plan, const Restore& restore,
                                                   ProgressBar& progress) {
  progress.expect(plan.voxels);
  std::uint64_t changed = 0;
  for (const std::vector<edits::ChunkChanges>& slice : plan.slices) {
    for (int tries = 1;; ++tries) {
      const auto restored = restore(slice);
      if (restored) {
        changed += restored->changed;
        break;
      }
      if (!is_transient(restored.error().code) || tries == kMaxTries) {
        return tl::unexpected{
            fmt::format("{} of {} voxels were put back, then: {}; run the command again for the rest",
                        changed, plan.voxels, restored.error().message)};
      }
      std::this_thread::sleep_for(kRetry);
    }
    for (const edits::ChunkChanges& chunk : slice) progress.advance(chunk.voxels.size());
  }
  return changed;
}

}  // namespace talus::server
