// The generator threads: take what is submitted, make it in turns, and answer. Callable from any thread.
//
// No chunk is made twice: a thread puts a chunk into the cache before it ends the chunk's job, and looks
// there before it makes one; the chunks of a patch are made by one thread at a time. A chunk as generated
// never changes, so nothing in that cache is ever invalidated. Edits are merged just before an answer is
// sent, for clients that wait for Version::edited: so no such client receives a chunk without its edits.
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

#include "chunks/chunk_source.h"
#include "chunks/generation/chunk_maker.h"
#include "chunks/generation/cost_model.h"
#include "chunks/generation/generator_memory.h"
#include "chunks/generation/patch_store.h"
#include "chunks/generation/recent_flows.h"
#include "chunks/generation/refused_clients.h"
#include "chunks/generation/work_queue.h"
#include "chunks/merged_chunks.h"
#include "limits/memory/memory_budget.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

class GenerationPool {
 public:
  /// The parts that a pool works with; all of them outlive the pool.
  struct Parts {
    ChunkMaker& maker;
    PatchStore& patches;
    GeneratorMemory& generator_memory;
    Metrics& metrics;
    MemoryBudget& memory;
    const Clock& clock;
    MergedChunks* merged = nullptr;  // null: there are no edits
  };
  struct Settings {
    std::size_t threads = 1;
    int patch_tiles = 4;
    std::size_t max_jobs = 0;  // WorkQueue's max_jobs
    std::size_t own_jobs = 0;
  };
  GenerationPool(const Parts& parts, const Settings& settings, Logger log);
  /// Waits for the threads; requests that still wait are not answered.
  ~GenerationPool();
  GenerationPool(const GenerationPool&) = delete;
  GenerationPool& operator=(const GenerationPool&) = delete;

  /// Starts the threads; once.
  void start();

  /// See ChunkSource::submit().
  [[nodiscard]] std::size_t add(const Waiter& waiter, std::span<const ChunkKey> keys, Urgency urgency);
  void add(HeightsTask task);
  // See ChunkSource.
  void hasten(ClientId client, std::span<const ChunkKey> keys);
  void cancel(ClientId client, std::span<const ChunkKey> keys);
  void cancel_heights(ClientId client, std::uint64_t ticket);

  /// With fewer for each thread the threads may have no job left before clients ask for more. It is the
  /// number of jobs of two patches whose rows are not known yet.
  static constexpr std::size_t kFewJobs = 512;
  [[nodiscard]] bool has_little_to_do() const {
    return jobs_.load(std::memory_order_relaxed) < kFewJobs * settings_.threads;
  }

  /// Notifies clients that were refused for lack of memory. Call it when the budget takes jobs again, and now
  /// and then.
  void jobs_resume();

  struct State {
    std::size_t jobs = 0;
    std::size_t clients = 0;  // clients with something waiting
  };
  [[nodiscard]] State status();

 private:
  void work();
  /// Each works for a bounded time while others wait, and leaves the rest in `work`.
  void run(WorkQueue::Batch& batch, const WorkQueue::Work& work, MeasuredWork& measured);
  void run(HeightsTask& task, const WorkQueue::Work& work, MeasuredWork& measured);
  /// Answers the batch's keys that are still waited for by chunk(index of the key).
  template <typename Chunk>
  void answer(std::span<const ChunkKey> keys, Chunk&& chunk);
  /// Answers the chunks that are in memory; returns the other keys.
  [[nodiscard]] std::vector<ChunkKey> answer_known(std::span<const ChunkKey> keys);
  [[nodiscard]] ChunkAnswer with_edits(ChunkKey key, const ChunkAnswer& base) const;
  /// Answers by a failure what was not answered of the batch.
  void fail(const WorkQueue::Batch& batch);
  void fail(HeightsTask& task);
  void count(const MeasuredWork& measured);
  /// Called without the mutex, as all of these.
  void end(WorkQueue::Work& work, const MeasuredWork& measured, std::chrono::nanoseconds took);

  /// Returns what a piece of work asks after each step: the piece is given up if the pool stops or
  /// is_wanted(), which is called under the mutex, returns false; it yields to other clients' cheaper work
  /// when that comes, or after kLongestPiece. `spent`: time before this piece.
  [[nodiscard]] AskAfterStep after_step_of(const WorkQueue::Work& work, std::chrono::nanoseconds spent,
                                           std::function<bool()> is_wanted);

  // Called under the mutex.
  void note_arrival(FlowId flow);
  /// Puts back what is not done, or ends it.
  void put_back(WorkQueue::Work& work);
  /// Waiters for chunks of the batch that are not finished get no answer: their mailboxes record it.
  void lose(const WorkQueue::Batch& batch);
  [[nodiscard]] WorkCosts costs() const;
  /// Returns by how many bytes the jobs have changed since the last call. Report it to the budget without the
  /// mutex, as the budget may call back.
  [[nodiscard]] std::int64_t job_bytes_change();
  /// Returns by how much the work that yielded has changed since the last call; report it in the same way.
  [[nodiscard]] std::ptrdiff_t begun_change();
  /// Returns the clients to be notified that there is room for their jobs now.
  [[nodiscard]] std::vector<MailboxPtr> clients_with_room();

  // Called without the mutex.
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
  std::size_t jobs_told_ = 0;               // as the budget knows it
  std::atomic<std::size_t> jobs_{0};        // as the budget knows it
  std::size_t begun_told_ = 0;              // as the budget knows it
  std::atomic<bool> stopping_{false};       // changes under the mutex
  std::atomic<std::uint64_t> arrivals_{0};  // submissions so far; changes under the mutex

  std::vector<std::thread> threads_;
};

}  // namespace talus::server
