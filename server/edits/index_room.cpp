#include "edits/index_room.h"

#include <algorithm>

#include <fmt/format.h>

namespace talus::server {

tl::expected<void, LogFailure> keep_to_index(const EditState& state, LogEntry& entry) {
  auto* const edit = std::get_if<edits::EditEntry>(&entry);
  if (edit == nullptr || !state.is_full()) return {};
  const auto is_new = [&](ChunkCoord chunk) { return state.revision({chunk, Lod{}}) == 0; };
  if (std::ranges::none_of(edit->base, is_new, &edits::BaseVoxels::value_type::first)) return {};
  // Some of them only so that material may slide into them.
  const auto touched = edits::touched_voxels(edit->edit);
  if (!touched) return {};  // applying says so
  const auto chunk = std::ranges::find_if(*touched, is_new, &edits::TouchedChunk::chunk);
  if (chunk == touched->end()) {
    edit->settles = nullptr;
    return {};
  }
  return tl::unexpected{
      LogFailure{LogFailure::Kind::index_full,
                 fmt::format("chunk {} was never edited, and the index of edited chunks has its limit of {} "
                             "bytes; edit chunks that were edited before",
                             to_string(chunk->chunk), state.index_limit())}};
}

}  // namespace talus::server
