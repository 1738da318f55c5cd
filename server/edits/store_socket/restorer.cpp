#include "edits/store_socket/restorer.h"

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <talus/voxel/coords.h>

#include "edits/random_editor.h"

namespace talus::server {
namespace {

constexpr std::chrono::seconds kPatience{30};

/// Voxels side by side that change alike are one fill.
void add_fills(const edits::ChunkChanges& changes, std::vector<edits::Fill>& fills) {
  std::uint16_t last = 0;
  bool joins = false;
  for (const edits::VoxelChange& voxel : changes.voxels) {
    const bool next = joins && voxel.index == last + 1 && voxel.index % kChunkSize != 0 &&
                      fills.back().only == voxel.before && fills.back().material == voxel.after;
    if (next) {
      ++fills.back().last.x;
    } else {
      const VoxelPos at = voxel_at(chunk_origin(changes.chunk), local_of(voxel.index));
      fills.push_back({at, at, voxel.after, voxel.before});
    }
    last = voxel.index;
    joins = true;
  }
}

}  // namespace

tl::expected<edits::Applied, Restorer::Failure> Restorer::append(LogEntry entry) {
  using Answer = tl::expected<edits::Applied, Failure>;
  const auto failure_of = [](const LogFailure& failed) {
    using enum LogFailure::Kind;
    const bool passes = failed.kind == busy || failed.kind == unwritable || failed.kind == cut_off;
    return tl::unexpected{Failure{failed.reason, passes}};
  };
  struct Waits {
    std::mutex mutex;
    std::condition_variable_any comes;
    std::optional<Answer> answer;
  };
  const auto waits = std::make_shared<Waits>();  // the answer may come when nobody waits any more
  const auto taken = log_.append(
      std::move(entry), [waits, failure_of](const tl::expected<const edits::Applied*, LogFailure>& outcome) {
        {
          const std::lock_guard lock{waits->mutex};
          waits->answer = outcome ? Answer{**outcome} : failure_of(outcome.error());
        }
        waits->comes.notify_all();
      });
  if (!taken) return failure_of(taken.error());
  std::unique_lock lock{waits->mutex};
  if (waits->comes.wait_for(lock, ends_, kPatience, [&] { return waits->answer.has_value(); })) {
    return *std::move(waits->answer);
  }
  if (ends_.stop_requested()) {
    return tl::unexpected{
        Failure{"the server ends, and whether the log has the edit is open; run the command again", false}};
  }
  return tl::unexpected{Failure{fmt::format("the log has not answered for {} s", kPatience.count()), false}};
}

tl::expected<Restorer::Restored, Restorer::Failure> Restorer::restore(
    const std::vector<edits::ChunkChanges>& changes) {
  using Kind = edits::Applied::Kind;
  if (editor_ == edits::EditorId{}) {
    const edits::EditorId editor = random_editor();
    const auto attached = append(edits::AttachEntry{editor, 1, std::string{kRestorerSubject}});
    if (!attached) return tl::unexpected{attached.error()};
    if (attached->kind != Kind::attached) {
      return tl::unexpected{Failure{"as many edit this world as may; try again when some have gone", false}};
    }
    editor_ = editor;
  }
  edits::EditEntry entry{editor_, 1, ++sequence_, {}, {}};
  for (const edits::ChunkChanges& chunk : changes) {
    add_fills(chunk, entry.edit.fills);
    std::vector<Override>& base = entry.base[chunk.chunk];
    for (const edits::VoxelChange& voxel : chunk.voxels) base.push_back({voxel.index, voxel.base});
  }
  const auto applied = append(std::move(entry));
  if (!applied) return tl::unexpected{applied.error()};
  if (applied->kind != Kind::done) {
    editor_ = {};  // forgotten, or the entry breaks a bound
    return tl::unexpected{Failure{"the log did not apply the edit; run the command again", false}};
  }
  return Restored{applied->revision, applied->result.changed};
}

}  // namespace talus::server
