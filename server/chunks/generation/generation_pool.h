// The generator threads: what is submitted, in whose turn it is made, and who is told. Callable from any
// thread.
//
// Why no chunk is made twice: a thread puts a chunk into the cache before it ends the chunk's job, and looks
// there before it makes one, which a patch's chunks are by one thread at a time. A chunk as generated never
// changes, so nothing in that cache is ever invalidated. Edits are laid over a chunk when it is made, for
// those alone who see edits: the overlay keeps a cache of its own.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "chunks/chunk_overlay.h"
#include "chunks/chunk_source.h"
#include "chunks/generation/chunk_maker.h"
#include "chunks/generation/cost_model.h"
#include "chunks/generation/generator_memory.h"
#include "chunks/generation/patch_store.h"
#include "chunks/generation/recent_flows.h"
#include "chunks/generation/refused_clients.h"
#include "chunks/generation/work_queue.h"
#include "limits/memory/memory_budget.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

class GenerationPool {
 public:
  /// What a pool works with; all of it outlives the pool.
  struct Parts {
    ChunkMaker& maker;
    PatchStore& patches;
    GeneratorMemory& generator_memory;
    Metrics& metrics;
    MemoryBudget& memory;
    const Clock& clock;
    ChunkOverlay* overlay = nullptr;  // null: no edits
  };
  struct Settings {
    std::size_t threads = 1;
    int patch_tiles = 4;
    std::size_t max_jobs = 0;  // as WorkQueue's
    std::size_t own_jobs = 0;
  };
  GenerationPool(const Parts& parts, const Settings& settings, Logger log);
  /// Waits for the threads; what still waits is not answered.
  ~GenerationPool();
  GenerationPool(const GenerationPool&) = delete;
  GenerationPool& operator=(const GenerationPool&) = delete;

  /// Starts the threads; once.
  void start();

  // As ChunkSource defines them.
  [[nodiscard]] std::size_t submit(const MailboxPtr& mailbox, std::span<const ChunkKey> keys,
                                   Urgency urgency);
  void hasten(ClientId client, std::span<const ChunkKey> keys);
  void cancel(ClientId client, std::span<const ChunkKey> keys);
  void submit_heights(HeightsTask task);
  void cancel_heights(ClientId client, std::uint64_t ticket);

  /// With fewer for each thread the threads may have no job left before clients ask for more. So many are
  /// those of two patches whose rows are not known yet.
  static constexpr std::size_t kFewJobs = 512;
  [[nodiscard]] bool has_little_to_do() const {
    return jobs_.load(std::memory_order_relaxed) < kFewJobs * settings_.threads;
  }

  /// Tells clients that were refused for want of memory; call it when the budget takes jobs again, and now
  /// and then.
  void jobs_resume();

  struct Status {
    std::size_t jobs = 0;
    std::size_t clients = 0;  // with something waiting
  };
  [[nodiscard]] Status status();

 private:
  void work();
  /// Each goes on for a bounded time while others wait, and leaves the rest in `work`.
  void run(WorkQueue::Batch& batch, const WorkQueue::Work& work, MeasuredWork& measured);
  void run(HeightsTask& task, const WorkQueue::Work& work, MeasuredWork& measured);
  /// Those of a batch's keys that are still waited for, by chunk(their index).
  template <typename Chunk>
  void answer(std::span<const ChunkKey> keys, Chunk&& chunk);
  /// Those that are in memory; returns the others.
  [[nodiscard]] std::vector<ChunkKey> answer_known(std::span<const ChunkKey> keys);
  /// Puts those waiters that see edits behind the others, and returns the first of them.
  [[nodiscard]] std::size_t edits_seen_from(std::vector<MailboxPtr>& waiters) const;
  [[nodiscard]] ChunkAnswer with_edits(ChunkKey key, const ChunkAnswer& base) const;
  /// Answers by a failure what of it was not answered.
  void fail(const WorkQueue::Batch& batch);
  void fail(HeightsTask& task);
  void count(const MeasuredWork& measured);
  /// Without the mutex, as all of these.
  void end(WorkQueue::Work& work, const MeasuredWork& measured, std::chrono::nanoseconds took);

  /// For a piece of work: it is given up once the pool stops, or is_wanted() is false, which is called under
  /// the mutex; and gives way to other clients' cheaper work after kLongestPiece. `spent`: before this piece.
  [[nodiscard]] AskAfterStep after_step_of(const WorkQueue::Work& work, std::chrono::nanoseconds spent,
                                           std::function<bool()> is_wanted);

  // Under the mutex.
  /// Puts back what is not done, or ends it.
  void put_back(WorkQueue::Work& work);
  /// Those who wait for what of the batch is not finished get no answer: their mailboxes say so.
  void lose(const WorkQueue::Batch& batch);
  [[nodiscard]] WorkCosts costs() const;
  /// Bytes of jobs since the last call: to be told to the budget without the mutex, which it may come back
  /// to.
  [[nodiscard]] std::int64_t job_bytes_change();
  /// Of what was begun and gave way, likewise.
  [[nodiscard]] std::ptrdiff_t begun_change();
  /// Those to be told that there is room for their jobs now.
  [[nodiscard]] std::vector<MailboxPtr> clients_with_room();

  // Without the mutex.
  void tell_of_room(const std::vector<MailboxPtr>& mailboxes);

  const Parts parts_;
  const Settings settings_;
  const Logger log_;

  std::mutex mutex_;
  std::condition_variable work_waits_;
  WorkQueue queue_;
  CostModel measured_costs_;
  RecentFlows recent_flows_;
  RefusedClients refused_;
  std::size_t jobs_told_ = 0;          // to the budget
  std::atomic<std::size_t> jobs_{0};   // likewise
  std::size_t begun_told_ = 0;         // likewise
  std::atomic<bool> stopping_{false};  // changes under the mutex

  std::vector<std::thread> threads_;
};

}  // namespace talus::server
