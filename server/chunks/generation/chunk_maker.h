// Makes chunks, heights and maps by a Generator: counts them, and answers failures. Callable from any thread.
#pragma once

#include <talus/terrain/extraction.h>
#include <talus/terrain/stacks.h>
#include <talus/voxel/coords.h>

#include "chunks/cache/chunk_cache.h"
#include "chunks/generation/column_rows.h"
#include "chunks/generation/generator.h"
#include "chunks/generation/heights_task.h"
#include "chunks/generation/map_cache.h"
#include "chunks/mailbox.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

class ChunkMaker {
 public:
  /// All but the log outlive this. `maps` keeps drawn tiles; null: nothing is kept.
  ChunkMaker(const Generator& generator, ChunkCache& cache, ColumnRows& rows, Metrics& metrics, Logger log,
             MapCache* maps = nullptr)
      : generator_{generator},
        cache_{cache},
        rows_{rows},
        metrics_{metrics},
        log_{std::move(log)},
        maps_{maps} {}

  /// Returns the chunk if it is known at no cost, is in the cache, or is uniform by its column's rows; else
  /// null.
  [[nodiscard]] EncodedChunkPtr known(ChunkKey key) const;

  /// Returns the chunk over its patch's stacks, which is in the cache when this returns. Null `stacks`: the
  /// patch could not be made.
  [[nodiscard]] ChunkAnswer chunk(const terrain::Stacks* stacks, ChunkKey key);
  /// Makes the task's next piece, as far as after_step() lets it. Returns AfterStep::go_on when it is added.
  [[nodiscard]] tl::expected<AfterStep, GenerationError> heights(HeightsTask& task,
                                                                 const AskAfterStep& after_step);

 private:
  const Generator& generator_;
  ChunkCache& cache_;
  ColumnRows& rows_;
  Metrics& metrics_;
  const Logger log_;
  MapCache* const maps_;
};

}  // namespace talus::server
