// Makes chunks, heights and maps by a Generator: counted, with failures as answers. Callable from any thread.
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
  /// All but the log outlive this. `maps`: where drawn tiles are kept; null: nowhere.
  ChunkMaker(const Generator& generator, ChunkCache& cache, ColumnRows& rows, Metrics& metrics, Logger log,
             MapCache* maps = nullptr)
      : generator_{generator},
        cache_{cache},
        rows_{rows},
        metrics_{metrics},
        log_{std::move(log)},
        maps_{maps} {}

  /// The chunk where it costs nothing to know it, is in the cache, or is uniform as its column's rows say;
  /// else null.
  [[nodiscard]] EncodedChunkPtr known(ChunkKey key) const;

  /// The chunk over its patch's stacks, which is in the cache when this returns. Null `stacks`: the patch
  /// could not be made.
  [[nodiscard]] ChunkAnswer chunk(const terrain::Stacks* stacks, ChunkKey key);
  /// Goes on with the task's next piece, as far as after_step() lets it: AfterStep::go_on once it is added.
  [[nodiscard]] tl::expected<AfterStep, GenerationFailed> heights(HeightsTask& task,
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
