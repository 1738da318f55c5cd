#include "edits/edited_chunks.h"

#include <algorithm>
#include <utility>

namespace talus::server {

EncodedChunkPtr EditedChunks::find(ChunkKey key) {
  const std::uint64_t newest = edits_.revision(key);
  if (newest == kBaseRevision) return base_.find(key);
  EncodedChunkPtr chunk = merged_.newer(key, newest - 1);
  (chunk == nullptr ? metrics_.cache_misses : metrics_.cache_hits).add();
  return chunk;
}

EncodedChunkPtr EditedChunks::newer(ChunkKey key, std::uint64_t revision) {
  return edits_.revision(key) <= revision ? nullptr : merged_.newer(key, revision);
}

MixedRows EditedChunks::column(ChunkKey key) {
  MixedRows rows = base_.column(key);
  const ChunkRange edited = edits_.edited_rows(key);
  if (edited.size() == 0) return rows;
  rows.first = std::min(rows.first, static_cast<std::int32_t>(edited.first));
  rows.last = std::max(rows.last, static_cast<std::int32_t>(edited.last));
  return rows;
}

std::size_t EditedChunks::submit(const MailboxPtr& mailbox, std::span<const ChunkKey> keys, Urgency urgency) {
  // Only once: generator threads read it from then on.
  if (!mailbox->sees_edits()) mailbox->see_edits();
  return base_.submit(mailbox, keys, urgency);
}

void EditedChunks::set_wanted(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) {
  feed_.watch(mailbox, boxes);
  base_.set_wanted(mailbox, boxes);
}

}  // namespace talus::server
