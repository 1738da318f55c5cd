// Chunks with their edits: the overrides merged over the chunk as generated, encoded once per revision and
// kept in memory alone. Callable from any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include <talus/voxel/coords.h>

#include "chunks/applied_edits.h"
#include "chunks/cache/chunk_cache.h"
#include "chunks/mailbox.h"
#include "runtime/log/logger.h"

namespace talus::server {

class MergedChunks {
 public:
  /// `edits` outlives this.
  MergedChunks(const AppliedEdits& edits, Logger log, std::size_t capacity_bytes)
      : edits_{edits}, log_{std::move(log)}, cache_{capacity_bytes} {}

  /// Returns the chunk with its newest edits; `base` is the chunk as generated, and is returned itself if the
  /// chunk was never edited. It may read the disk: call it on generator threads. Failures are values.
  [[nodiscard]] ChunkAnswer merged(ChunkKey key, const EncodedChunkPtr& base) noexcept;

  /// Returns the chunk that is in memory if it is newer than `revision`; else null. There may be a newer
  /// revision still.
  [[nodiscard]] EncodedChunkPtr newer(ChunkKey key, std::uint64_t revision);

  /// See ShardedCache.
  void set_capacity(std::size_t capacity_bytes) { cache_.set_capacity(capacity_bytes); }
  [[nodiscard]] bool fit(std::size_t& probes) { return cache_.fit(probes); }
  [[nodiscard]] std::size_t bytes() const { return cache_.bytes(); }

 private:
  [[nodiscard]] tl::expected<EncodedChunkPtr, std::string> merge(ChunkKey key,
                                                                 const EncodedChunk& base) const;

  const AppliedEdits& edits_;
  const Logger log_;
  ChunkCache cache_;
};

}  // namespace talus::server
