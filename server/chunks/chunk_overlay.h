// Edits on top of generated chunks. Generators consult it just before they answer, so that a client that has
// seen an edit never gets a chunk without it.
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

  /// Revision of the chunk's newest version; kBaseRevision if it was never edited. Never decreases. Reads
  /// only memory.
  [[nodiscard]] virtual std::uint64_t revision(ChunkKey key) const = 0;
  /// Returns the newest version of a chunk with a revision other than kBaseRevision; `base` is the generated
  /// chunk. May read the disk: call it on generator threads. Does not throw: the waiting clients get the
  /// error.
  [[nodiscard]] virtual ChunkAnswer merged(ChunkKey key, const EncodedChunkPtr& base) noexcept = 0;

  // Its cache, which gets its size from the memory budget together with all others; the same as in
  // ShardedCache.
  virtual void set_capacity(std::size_t capacity_bytes) = 0;
  [[nodiscard]] virtual bool fit(std::size_t& looks) = 0;
  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

}  // namespace talus::server
