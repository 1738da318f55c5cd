// Chunks with their edits: merged from the chunk as generated and its overrides, encoded once a revision and
// kept in memory alone. Callable from any thread.
#pragma once

#include <cstddef>
#include <cstdint>

#include <tl/expected.hpp>

#include <talus/voxel/coords.h>

#include "chunks/cache/chunk_cache.h"
#include "chunks/chunk_overlay.h"
#include "edits/applied_edits.h"
#include "runtime/log/logger.h"

namespace talus::server {

class MergedChunks final : public ChunkOverlay {
 public:
  /// `edits` outlives this. Keeps nothing before set_capacity().
  MergedChunks(const AppliedEdits& edits, Logger log) : edits_{edits}, log_{std::move(log)} {}

  [[nodiscard]] std::uint64_t revision(ChunkKey key) const override { return edits_.revision(key); }
  [[nodiscard]] ChunkAnswer merged(ChunkKey key, const EncodedChunkPtr& base) noexcept override;

  /// The version that is in memory, where it is newer than `revision`; else null. Another may be newer still.
  [[nodiscard]] EncodedChunkPtr newer(ChunkKey key, std::uint64_t revision);

  void set_capacity(std::size_t capacity_bytes) override { cache_.set_capacity(capacity_bytes); }
  [[nodiscard]] bool fit(std::size_t& looks) override { return cache_.fit(looks); }
  [[nodiscard]] std::size_t bytes() const override { return cache_.bytes(); }

 private:
  [[nodiscard]] tl::expected<EncodedChunkPtr, std::string> merge(ChunkKey key,
                                                                 const EncodedChunk& base) const;

  const AppliedEdits& edits_;
  const Logger log_;
  ChunkCache cache_{0};
};

}  // namespace talus::server
