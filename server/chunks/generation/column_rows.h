// Stores for columns whose terrain was generated which rows of chunks are mixed. Bounded in bytes; callable
// from any thread, a call locks one shard.
#pragma once

#include <cstddef>
#include <optional>

#include <talus/terrain/extraction.h>
#include <talus/voxel/coords.h>

#include "chunks/cache/sharded_cache.h"
#include "chunks/chunk_source.h"
#include "chunks/generation/generator.h"

namespace talus::server {

class ColumnRows {
 public:
  /// `generator` outlives this.
  ColumnRows(const Generator& generator, int patch_tiles, std::size_t capacity_bytes)
      : generator_{generator}, patch_tiles_{patch_tiles}, rows_{capacity_bytes} {}

  /// Returns the exact rows of the key's column; nullopt if it was not generated, or was evicted.
  [[nodiscard]] std::optional<MixedRows> exact(ChunkKey key) { return rows_.find(column_of(key)); }
  /// Returns the rows of the key's column as far as they are known.
  [[nodiscard]] MixedRows known(ChunkKey key) {
    const auto rows = exact(key);
    return rows ? *rows : generator_.mixed_rows_anywhere(key.lod);
  }
  /// Stores all columns of the patch. Throws std::bad_alloc, and then has stored some.
  void note(const PatchKey& patch, const terrain::Stacks& stacks) {
    for_each_column(patch, patch_tiles_,
                    [&](ChunkKey column) { rows_.put(column, generator_.mixed_rows(stacks, column), 0); });
  }

  /// Returns the rows of one column from the cache. `column` is a column_of().
  void note(ChunkKey column, const MixedRows& rows) { rows_.put(column, rows, 0); }

  /// As in ShardedCache.
  void set_capacity(std::size_t capacity_bytes) { rows_.set_capacity(capacity_bytes); }
  [[nodiscard]] bool fit(std::size_t& probes) { return rows_.fit(probes); }
  [[nodiscard]] std::size_t bytes() const { return rows_.bytes(); }

 private:
  const Generator& generator_;
  const int patch_tiles_;
  ShardedCache<ChunkKey, MixedRows> rows_;  // keys are column_of()
};

}  // namespace talus::server
