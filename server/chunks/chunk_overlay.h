// Edits over chunks as generated. Whoever generates a chunk asks just before it answers, so that nobody who
// sees edits is given a chunk without them.
#pragma once

#include <cstddef>
#include <cstdint>

#include <talus/voxel/coords.h>

#include "chunks/encoded_chunk.h"
#include "chunks/mailbox.h"

namespace talus::server {

/// Callable from any thread.
class ChunkOverlay {
 public:
  virtual ~ChunkOverlay() = default;

  /// Of the chunk's newest version; kBaseRevision: no edit ever changed it. Never falls. Reads memory alone.
  [[nodiscard]] virtual std::uint64_t revision(ChunkKey key) const = 0;
  /// The newest version of a chunk whose revision is not kBaseRevision; `base` is the chunk as generated. May
  /// read the disk: on generator threads. Throws nothing: whoever waits is told what went wrong.
  [[nodiscard]] virtual ChunkAnswer merged(ChunkKey key, const EncodedChunkPtr& base) noexcept = 0;

  // Its cache, which is made as large as the memory budget allows together with all others: as those of
  // ShardedCache.
  virtual void set_capacity(std::size_t capacity_bytes) = 0;
  [[nodiscard]] virtual bool fit(std::size_t& looks) = 0;
  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

}  // namespace talus::server
