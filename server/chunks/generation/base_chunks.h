// The ChunkSource of chunks as generated: caches in memory, and one on disk, in front of a pool of generator
// threads.
//
// A chunk that is cached, or uniform whatever the surface is, is found with no lock but its shard's.
// Otherwise a client waits for a job, and the answer comes into its mailbox. Nothing here is ever
// invalidated: chunks as generated are immutable, all of revision kBaseRevision.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "chunks/cache/chunk_cache.h"
#include "chunks/chunk_overlay.h"
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
#include "limits/memory/memory_budget.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

struct GenerationSettings {
  std::size_t threads = 1;
  int patch_tiles = 4;           // along each edge of a patch; a power of two
  std::size_t queue_chunks = 0;  // maximum number of jobs of all clients, in addition to each client's own
  std::size_t chunk_cache_bytes = 0;
  std::size_t patch_cache_bytes = 0;
  std::size_t own_chunks = 16;         // a client with fewer jobs may always ask for more
  std::size_t piece_bytes = 0;         // GeneratorMemory's piece_bytes
  std::size_t ground_bytes = 0;        // GeneratorMemory's ground_bytes
  std::size_t map_cache_bytes = 0;     // part of chunk_cache_bytes
  std::size_t merged_cache_bytes = 0;  // part of chunk_cache_bytes, for the overlay, if there is one
};

class BaseChunks final : public ChunkSource {
 public:
  /// `metrics`, `memory` and `clock` outlive this. Nothing is generated before start(). Clients that see
  /// edits (Mailbox::sees_edits) are answered through `overlay`, which outlives this too; null: there are no
  /// edits. `columns` keeps what was expensive to make; null: nothing is kept.
  BaseChunks(std::unique_ptr<const Generator> generator, const GenerationSettings& settings, Logger log,
             Metrics& metrics, MemoryBudget& memory, const Clock& clock, ChunkOverlay* overlay = nullptr,
             std::unique_ptr<ColumnCache> columns = nullptr);
  /// Starts the threads; once.
  void start();
  /// Waits for the threads; requests that still wait are not answered.
  ~BaseChunks() override;
  BaseChunks(const BaseChunks&) = delete;
  BaseChunks& operator=(const BaseChunks&) = delete;

  [[nodiscard]] EncodedChunkPtr find(ChunkKey key) override;
  /// Always returns null: there is one version.
  [[nodiscard]] EncodedChunkPtr newer(ChunkKey key, std::uint64_t revision) override;
  /// Exact after the column's terrain was generated, until that is evicted.
  [[nodiscard]] MixedRows column(ChunkKey key) override;
  [[nodiscard]] bool has_little_to_do() const override { return pool_.has_little_to_do(); }
  [[nodiscard]] int columns_together() const override { return std::min(settings_.patch_tiles, 4); }
  [[nodiscard]] std::size_t submit(const MailboxPtr& mailbox, std::span<const ChunkKey> keys,
                                   Urgency urgency) override;
  void hasten(ClientId client, std::span<const ChunkKey> keys) override;
  void cancel(ClientId client, std::span<const ChunkKey> keys) override;
  void set_wanted(const MailboxPtr& mailbox, std::span<const LevelBox> boxes) override;
  void submit_heights(const MailboxPtr& mailbox, std::uint64_t ticket, HeightsQuery query) override;
  void cancel_heights(ClientId client, std::uint64_t ticket) override;
  [[nodiscard]] PicturePtr find_map(const map::Tile& tile) override;

  /// The maximum that one fit_caches() evicts: chunks and columns' rows, and tiles of patches, but always one
  /// patch. Freeing them takes about a millisecond.
  static constexpr std::size_t kChunksPerFit = 1024;
  static constexpr std::size_t kTilesPerFit = 256;

  /// Makes the caches as large as the budget now allows, by a bounded slice of work a call. Returns false if
  /// there is more to evict: call it again soon. Call it now and then in any case: caches shrink before
  /// anything is refused.
  [[nodiscard]] bool fit_caches();

  /// Reports to the memory budget what the cache of columns on disk holds in memory. Call it about once a
  /// second.
  void count_columns();

  /// Writes to disk what is worth keeping; it is there when this returns.
  void keep_on_disk();

  struct Status {
    std::size_t jobs = 0;
    std::size_t clients = 0;  // clients with something waiting
    std::size_t chunk_cache_bytes = 0;
    std::size_t patch_cache_bytes = 0;
    std::size_t map_cache_bytes = 0;
    std::optional<ColumnCache::Status> columns{};  // nullopt: nothing is kept on disk
  };
  [[nodiscard]] Status status();

 private:
  const std::unique_ptr<const Generator> generator_;
  const GenerationSettings settings_;
  Metrics& metrics_;
  MemoryBudget& memory_;
  ChunkOverlay* const overlay_;
  std::mutex fitting_;
  std::uint64_t fitted_bytes_;
  // In the order of their use: each is used by the members after it.
  const std::unique_ptr<ColumnCache> columns_;
  ChunkCache chunks_;
  ColumnRows rows_;
  MapCache maps_;
  ChunkMaker maker_;
  WantedChunks wanted_;
  GeneratorMemory generator_memory_;
  PatchStore patches_;
  GenerationPool pool_;
};

}  // namespace talus::server
