// Where chunks come from: the memory cache, or a pool of generator threads. Callable from any thread.
//
// A chunk that is cached, or uniform whatever the surface does, is found with no lock but its shard's.
// Otherwise a client waits for a job; the answer comes through its ChunkClient, on a generator thread.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "cache/chunk_cache.h"
#include "cache/patch_cache.h"
#include "cache/sharded_cache.h"
#include "cache/spare_patches.h"
#include "generation/generator.h"
#include "generation/work_queue.h"
#include "log/logger.h"
#include "memory/memory_budget.h"
#include "metrics/metrics.h"

namespace talus::server {

struct ServiceSettings {
  std::size_t threads = 1;
  int patch_tiles = 4;
  std::size_t queue_chunks = 0;
  std::size_t chunk_cache_bytes = 0;
  std::size_t patch_cache_bytes = 0;
};

class ChunkService {
 public:
  /// `metrics` and `memory`, the whole server's, outlive it. Nothing is generated before start().
  ChunkService(std::unique_ptr<const Generator> generator, const ServiceSettings& settings, Logger log,
               Metrics& metrics, MemoryBudget& memory);
  /// Starts the threads; once.
  void start();
  /// Waits for the threads; what still waits is not answered.
  ~ChunkService();
  ChunkService(const ChunkService&) = delete;
  ChunkService& operator=(const ChunkService&) = delete;

  /// The chunk where it is at hand; else null.
  [[nodiscard]] EncodedChunkPtr find(ChunkKey key);

  /// Rows of chunks outside which every chunk of the key's column is known to be uniform: of one rock below
  /// them, of air above. Exact once its terrain was generated, until that is forgotten.
  [[nodiscard]] terrain::MixedRange rows(ChunkKey key);

  enum class Submission : std::uint8_t { queued, refused };
  /// Lets `client` wait for the chunk. Refused where the queue is full: no answer will come.
  [[nodiscard]] Submission submit(const ChunkClientPtr& client, ChunkKey key);
  /// An answer that is on its way already may still come.
  void cancel(const ChunkClient& client, ChunkKey key);

  void submit_heights(HeightsTask task);
  void cancel_heights(const ChunkClient& client, std::uint64_t ticket);

  /// The whole server's. New jobs are refused where it takes no work.
  [[nodiscard]] MemoryBudget& memory() { return memory_; }
  /// Makes the caches as large as the budget now allows. Call it now and then: they shrink before anything is
  /// refused.
  void fit_caches();

  struct Status {
    std::size_t jobs = 0;
    std::size_t clients = 0;  // who wait for something
    std::size_t chunk_cache_bytes = 0;
    std::size_t patch_cache_bytes = 0;
  };
  [[nodiscard]] Status status();

 private:
  /// The chunk where its column's terrain was generated once and the key lies below or above all that is
  /// mixed.
  [[nodiscard]] EncodedChunkPtr uniform_by_rows(ChunkKey key);
  void work();
  void run(const WorkQueue::Batch& batch);
  void run(const HeightsTask& task);
  /// And hands them over to those who still wait.
  void make_chunks(const WorkQueue::Batch& batch, const terrain::Stacks* stacks);
  /// Means of what was measured so far.
  [[nodiscard]] WorkPrices prices() const;
  /// One client gets all threads only while nobody else asks: who asks next should find one.
  [[nodiscard]] std::size_t most_at_once() const;
  void note_client(const ChunkClient& client);
  void note_jobs();
  void note_patch(std::size_t bytes);
  /// Makes the chunks of a patch that is being dropped: they are a fiftieth of its size, and who looks at one
  /// of its columns mostly comes to look at the others.
  void keep_chunks(const PatchKey& patch, const terrain::Stacks& stacks);
  /// Whether all mixed chunks of the patch are in the cache, where they stay longer for their size, and no
  /// column has more of them than are kept.
  [[nodiscard]] bool used_up(const PatchKey& patch, const terrain::Stacks& stacks);
  template <typename Visit>
  void for_each_column(const PatchKey& patch, Visit&& visit) const;
  void note_rows(const PatchKey& patch, const terrain::Stacks& stacks);
  [[nodiscard]] StacksPtr make_patch(const PatchKey& patch);
  [[nodiscard]] StacksPtr stacks_of(const PatchKey& patch, DroppedPatches& dropped);
  [[nodiscard]] ChunkAnswer make_chunk(const terrain::Stacks* stacks, ChunkKey key);
  [[nodiscard]] HeightsAnswer make_heights(const HeightsTask& task);

  std::unique_ptr<const Generator> generator_;
  Logger log_;
  Metrics& metrics_;
  const ServiceSettings settings_;
  MemoryBudget& memory_;
  std::mutex fitting_;
  std::uint64_t fitted_bytes_ = 0;
  std::atomic<std::size_t> largest_patch_bytes_{0};
  std::atomic<bool> warned_of_generators_{false};
  ChunkCache chunks_;
  SparePatches spare_patches_;
  PatchCache patches_;
  ShardedCache<ChunkKey, terrain::MixedRange> rows_;  // of columns, by their chunk at y = 0

  std::mutex mutex_;
  std::condition_variable work_waits_;
  WorkQueue queue_;
  bool stopping_ = false;
  // Who asked last, when, and when two last asked within kLately of each other; under the mutex too.
  const ChunkClient* last_client_ = nullptr;
  std::chrono::steady_clock::time_point last_asked_{};
  std::chrono::steady_clock::time_point last_together_{};

  std::vector<std::thread> threads_;
};

}  // namespace talus::server
