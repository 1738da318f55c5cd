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

/// Adjacent voxels of a row with the same change become one fill.
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

tl::expected<edits::EntryResult, EditError> Restorer::append(LogEntry entry) {
  using Answer = tl::expected<edits::EntryResult, EditError>;
  struct Waits {
    std::mutex mutex;
    std::condition_variable_any comes;
    std::optional<Answer> answer;
  };
  const auto waits = std::make_shared<Waits>();  // the answer may come after the wait
  const auto accepted = log_.append(
      std::move(entry), [waits](const tl::expected<const edits::EntryResult*, EditError>& outcome) {
        {
          const std::lock_guard lock{waits->mutex};
          waits->answer = outcome ? Answer{**outcome} : tl::unexpected{outcome.error()};
        }
        waits->comes.notify_all();
      });
  if (!accepted) return tl::unexpected{accepted.error()};
  std::unique_lock lock{waits->mutex};
  if (waits->comes.wait_for(lock, ends_, kPatience, [&] { return waits->answer.has_value(); })) {
    return *std::move(waits->answer);
  }
  if (ends_.stop_requested()) {
    return edit_error(
        EditErrorCode::unanswered,
        "the server is shutting down, and it is unknown whether the log has the edit; run the command "
        "again");
  }
  return edit_error(EditErrorCode::unanswered,
                    fmt::format("the log has not answered for {} s", kPatience.count()));
}

tl::expected<Restorer::Result, EditError> Restorer::restore(const std::vector<edits::ChunkChanges>& changes) {
  using Kind = edits::EntryResult::Kind;
  if (editor_ == edits::EditorId{}) {
    const edits::EditorId editor = random_editor();
    const auto attached = append(edits::AttachEntry{editor, 1, std::string{kRestorerSubject}});
    if (!attached) return tl::unexpected{attached.error()};
    if (attached->kind != Kind::attached) {
      return edit_error(EditErrorCode::editors_full,
                        fmt::format("the editor table is full (limit {} editors); retry later",
                                    edits::kMaxEditors + edits::kOperatorEditors));
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
    editor_ = {};  // forgotten, or the entry exceeds a bound
    return edit_error(EditErrorCode::invalid, "the log did not apply the edit; run the command again");
  }
  return Result{applied->revision, applied->result.changed};
}

}  // namespace talus::server
