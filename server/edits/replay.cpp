#include "edits/replay.h"

#include <string>
#include <utility>

namespace talus::server {

Replay::Replay(const store::EditDatabase& database, const ChunkIndex& index)
    : chunks_{[&](ChunkKey key) -> tl::expected<std::optional<store::StoredChunk>, std::string> {
        if (index.revision(key) == 0) return std::nullopt;
        auto stored = database.chunk(key);
        if (stored && !*stored) return tl::unexpected{"chunk " + to_string(key) + " is missing"};
        return stored;
      }} {}

bool Replay::apply(const store::LogRecord& record) {
  const bool changed = !record.changes.empty();
  if (revision_ && record.revision != *revision_ + (changed ? 1 : 0)) return false;
  revision_ = record.revision;
  editors_.apply(record);
  return chunks_.apply(record).has_value();
}

}  // namespace talus::server
