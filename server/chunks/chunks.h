// The world's chunks, as generated and with their edits: caches in memory, and one on disk, before a pool of
// generator threads.
//
// A chunk that is cached, or uniform whatever the surface is, is found with no lock but its shard's.
// Otherwise a client waits for a job, and the answer comes into its mailbox. Chunks as generated are
// immutable, all of revision kBaseRevision, so nothing is ever invalidated. A chunk that was never edited
// costs Version::edited one look-up of its revision; edited chunks have a cache of their own
// (merged_chunks.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "chunks/applied_edits.h"
#include "chunks/cache/chunk_cache.h"
#include "chunks/change_feed.h"
#include "chunks/chunk_source.h"
#include "chunks/column_cache/column_cache.h"
#include "chunks/generation/chunk_maker.h"
#include "chunks/generation/column_rows.h"
#include "chunks/generation/generation_pool.h"
#include "chunks/generation/generator.h"
#include "chunks/generation/generator_memory.h"
#include "chunks/generation/map_cache.h"
#include "chunks/generation/patch_store.h"
#include "chunks/generation/wanted_chunks.h"
#include "chunks/merged_chunks.h"
#include "limits/memory/memory_budget.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

struct GenerationSettings {
  std::size_t threads = 1;
  int patch_tiles = 4;           // along each edge of a patch; a power of two
  std::size_t queue_chunks = 0;  // jobs of all clients together, beyond each client's own
  std::size_t chunk_cache_bytes = 0;
  std::size_t patch_cache_bytes = 0;
  std::size_t own_chunks = 16;         // a client with fewer jobs may submit more in any case
  std::size_t piece_bytes = 0;         // see GeneratorMemory
  std::size_t ground_bytes = 0;        // see GeneratorMemory
  std::size_t map_cache_bytes = 0;     // part of chunk_cache_bytes
  std::size_t merged_cache_bytes = 0;  // part of chunk_cache_bytes: for edited chunks
};

class Chunks final : public ChunkSource {
 public:
  /// The edits of the world, and the feed that notifies of them. Both outlive the Chunks.
  struct Edits {
    const AppliedEdits& applied;
    ChangeFeed& feed;
  };
  /// `metrics`, `memory` and `clock` outlive this. Nothing is generated before start(). Without `edits` both
  /// versions of a chunk are the one as generated. `columns`: the cache on disk for columns that were
  /// expensive to make; null: they are not kept.
  Chunks(std::unique_ptr<const Generator> generator, const GenerationSettings& settings, Logger log,
         Metrics& metrics, MemoryBudget& memory, const Clock& clock,
         std::optional<Edits> edits = std::nullopt, std::unique_ptr<ColumnCache> columns = nullptr);
  /// Starts the threads; once.
  void start();
  /// Waits for the threads. Jobs that are still queued are not answered.
  ~Chunks() override;
  Chunks(const Chunks&) = delete;
  Chunks& operator=(const Chunks&) = delete;

  [[nodiscard]] EncodedChunkPtr find(ChunkKey key, Version version) override;
  [[nodiscard]] EncodedChunkPtr newer(ChunkKey key, std::uint64_t revision) override;
  [[nodiscard]] std::uint64_t revision(ChunkKey key) const override {
    return edits_ ? edits_->applied.revision(key) : kBaseRevision;
  }
  [[nodiscard]] std::optional<ChangedVoxels> changes_since(ChunkKey key, std::uint64_t since,
                                                           std::size_t max_voxels) const override;
  void edited_chunks(const LevelBox& box, const ColumnFilter& wanted,
                     std::vector<ChunkKey>& found) const override {
    if (edits_) edits_->applied.edited_chunks(box, wanted, found);
  }
  /// Exact once the column's terrain was generated, until that is evicted.
  [[nodiscard]] MixedRows column(ChunkKey key, Version version) override;
  [[nodiscard]] bool has_little_to_do() const override { return pool_.has_little_to_do(); }
  [[nodiscard]] int columns_together() const override { return std::min(settings_.patch_tiles, 4); }
  [[nodiscard]] std::size_t submit(const MailboxPtr& mailbox, std::span<const ChunkKey> keys, Urgency urgency,
                                   Version version) override;
  void hasten(ClientId client, std::span<const ChunkKey> keys) override;
  void cancel(ClientId client, std::span<const ChunkKey> keys) override;
  void set_wanted(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) override;
  void set_watched(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) override;
  void submit_heights(const MailboxPtr& mailbox, std::uint64_t ticket, HeightsQuery query) override;
  void cancel_heights(ClientId client, std::uint64_t ticket) override;
  [[nodiscard]] PicturePtr find_map(const map::Tile& tile) override;

  /// Maximum evictions of one fit_caches(): chunks and rows of columns, and tiles of patches, but always one
  /// patch. Freeing them takes about a millisecond.
  static constexpr std::size_t kChunksPerFit = 1024;
  static constexpr std::size_t kTilesPerFit = 256;

  /// Makes the caches as large as the memory budget now allows, by bounded work per call; false if there is
  /// more to evict: call it again soon. Call it now and then in any case: caches shrink before any work is
  /// refused.
  [[nodiscard]] bool fit_caches();

  /// Reports the memory of the cache of columns on disk to the memory budget. Once a second is enough.
  void count_columns();

  /// When it returns, all that was generated and is worth keeping is on the disk.
  void keep_on_disk();

  struct State {
    std::size_t jobs = 0;
    std::size_t clients = 0;  // that wait for an answer
    std::size_t chunk_cache_bytes = 0;
    std::size_t patch_cache_bytes = 0;
    std::size_t map_cache_bytes = 0;
    std::optional<ColumnCache::State> columns{};  // nullopt: nothing is kept on disk
  };
  [[nodiscard]] State status();

 private:
  const std::unique_ptr<const Generator> generator_;
  const GenerationSettings settings_;
  Metrics& metrics_;
  MemoryBudget& memory_;
  const std::optional<Edits> edits_;
  std::mutex fitting_;
  std::uint64_t fitted_bytes_;
  // Each is used by the members after it.
  const std::unique_ptr<ColumnCache> columns_;
  ChunkCache chunks_;
  ColumnRows rows_;
  MapCache maps_;
  const std::unique_ptr<MergedChunks> merged_;  // null: there are no edits
  ChunkMaker maker_;
  WantedChunks wanted_;
  GeneratorMemory generator_memory_;
  PatchStore patches_;
  GenerationPool pool_;
};

}  // namespace talus::server
