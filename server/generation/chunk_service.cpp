#include "generation/chunk_service.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "generation/background_thread.h"
#include "generation/handover.h"
#include "metrics/thread_time.h"

namespace talus::server {
namespace {

using Clock = std::chrono::steady_clock;

// Of the bytes for chunks, what is kept of columns beside them: a column takes less than the smallest chunk.
constexpr std::size_t kShareOfRows = 16;

// In which who asks is taken to go on asking.
constexpr std::chrono::seconds kLately{1};

// Of a column, when its patch is dropped.
constexpr std::int32_t kMostKeptRows = 8;

// A job with its place in each map, one waiter.
constexpr std::size_t kJobBytes = 384;

// A generator at work, in the bytes of what it makes: fields of a patch and its halo, planes for the next,
// the patch itself, and one to spare.
constexpr std::size_t kPatchesAtWork = 5;

// At most this part of the memory budget is reckoned to generators.
constexpr std::uint64_t kGeneratorsShare = 8;

// What work costs before any was measured.
constexpr std::uint64_t kFirstPatchNs = 2'000'000;
constexpr std::uint64_t kFirstChunkNs = 20'000;
constexpr std::uint64_t kFirstHeightNs = 500;

ChunkKey column_of(ChunkKey key) {
  return {{key.coord.x, 0, key.coord.z}, key.lod};
}

/// Counts the thread's time from here to the end of the block. Asking for it costs a call of the kernel, so
/// chunks are timed a patch at a time.
class Timed {
 public:
  explicit Timed(Counter& ns) : ns_{ns} {}
  ~Timed() { ns_.add(static_cast<std::uint64_t>((thread_time() - began_).count())); }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  Counter& ns_;
  std::chrono::nanoseconds began_ = thread_time();
};

}  // namespace

ChunkService::ChunkService(std::unique_ptr<const Generator> generator, const ServiceSettings& settings,
                           Logger log, Metrics& metrics, MemoryBudget& memory)
    : generator_{std::move(generator)},
      log_{std::move(log)},
      metrics_{metrics},
      settings_{settings},
      memory_{memory},
      fitted_bytes_{settings.chunk_cache_bytes + settings.patch_cache_bytes},
      chunks_{settings.chunk_cache_bytes - settings.chunk_cache_bytes / kShareOfRows},
      spare_patches_{settings.threads},
      patches_{settings.patch_cache_bytes},
      rows_{settings.chunk_cache_bytes / kShareOfRows},
      queue_{settings.patch_tiles, settings.queue_chunks} {}

void ChunkService::start() {
  while (threads_.size() < settings_.threads) {
    threads_.emplace_back([this] { work(); });
  }
}

ChunkService::~ChunkService() {
  {
    const std::lock_guard lock{mutex_};
    stopping_ = true;
  }
  work_waits_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

EncodedChunkPtr ChunkService::find(ChunkKey key) {
  EncodedChunkPtr chunk = generator_->instant(key);
  if (chunk == nullptr) {
    chunk = chunks_.find(key);
    if (chunk != nullptr) {
      metrics_.cache_hits.add();
      return chunk;
    }
    chunk = uniform_by_rows(key);
  }
  (chunk != nullptr ? metrics_.uniform_answers : metrics_.cache_misses).add();
  return chunk;
}

EncodedChunkPtr ChunkService::uniform_by_rows(ChunkKey key) {
  const auto known = rows_.find(column_of(key));
  if (!known || (key.coord.y >= known->first && key.coord.y <= known->last)) return nullptr;
  return generator_->uniform(key.coord.y < known->first ? known->below : kAir);
}

terrain::MixedRange ChunkService::rows(ChunkKey key) {
  const auto known = rows_.find(column_of(key));
  return known ? *known : generator_->rows_anywhere(key.lod);
}

ChunkService::Submission ChunkService::submit(const ChunkClientPtr& client, ChunkKey key) {
  EncodedChunkPtr finished;
  {
    const std::lock_guard lock{mutex_};
    // A job puts its chunk in the cache before it ends, so a chunk is in one of both from its first job on.
    if (!queue_.has_job(key)) finished = chunks_.find(key);
    const bool room = queue_.has_job(key) || memory_.takes_work();
    if (finished == nullptr && (!room || !queue_.add(client, key))) {
      metrics_.jobs_refused.add();
      return Submission::refused;
    }
    note_client(*client);
    note_jobs();
  }
  if (finished != nullptr) {
    client->chunks_ready({{key, std::move(finished)}});
  } else {
    work_waits_.notify_one();
  }
  return Submission::queued;
}

void ChunkService::cancel(const ChunkClient& client, ChunkKey key) {
  const std::lock_guard lock{mutex_};
  const std::size_t jobs = queue_.jobs();
  queue_.cancel(client, key);
  if (queue_.jobs() < jobs) metrics_.jobs_cancelled.add();
  note_jobs();
}

void ChunkService::submit_heights(HeightsTask task) {
  {
    const std::lock_guard lock{mutex_};
    queue_.add(std::move(task));
  }
  work_waits_.notify_one();
}

void ChunkService::cancel_heights(const ChunkClient& client, std::uint64_t ticket) {
  const std::lock_guard lock{mutex_};
  queue_.cancel_heights(client, ticket);
}

ChunkService::Status ChunkService::status() {
  Status status;
  status.chunk_cache_bytes = chunks_.bytes();
  status.patch_cache_bytes = patches_.bytes();
  const std::lock_guard lock{mutex_};
  status.jobs = queue_.jobs();
  status.clients = queue_.clients();
  return status;
}

void ChunkService::work() {
  be_in_background();
  std::unique_lock lock{mutex_};
  while (!stopping_) {
    auto work = queue_.take(prices());
    if (!work) {
      work_waits_.wait(lock);
      continue;
    }
    lock.unlock();
    const auto began = thread_time();
    std::visit([this](const auto& piece) { run(piece); }, work->what);
    const auto took = thread_time() - began;
    const auto* batch = std::get_if<WorkQueue::Batch>(&work->what);
    lock.lock();
    queue_.settle(*work, static_cast<std::uint64_t>(took.count()));
    note_jobs();
    if (batch != nullptr) queue_.release(batch->patch);
    // What could not be begun until now: jobs that came for this patch meanwhile, and its client's next.
    work_waits_.notify_one();
  }
}

WorkPrices ChunkService::prices() const {
  const auto mean = [](const Counter& ns, const Counter& pieces, std::uint64_t first) {
    const std::uint64_t count = pieces.total();
    return count == 0 ? first : std::max<std::uint64_t>(1, ns.total() / count);
  };
  return {mean(metrics_.patch_ns, metrics_.patches_made, kFirstPatchNs),
          mean(metrics_.chunk_ns, metrics_.chunks_made, kFirstChunkNs),
          mean(metrics_.heights_ns, metrics_.heights_made, kFirstHeightNs),
          [this](const PatchKey& patch) { return patches_.holds(patch); }, most_at_once()};
}

std::size_t ChunkService::most_at_once() const {
  const bool alone = Clock::now() - last_together_ > kLately;
  return alone || settings_.threads == 1 ? settings_.threads : settings_.threads - 1;
}

void ChunkService::note_client(const ChunkClient& client) {
  const Clock::time_point now = Clock::now();
  const bool another = std::exchange(last_client_, &client) != &client;
  if (another && now - last_asked_ < kLately) last_together_ = now;
  last_asked_ = now;
}

void ChunkService::note_jobs() {
  memory_.set(MemoryUse::jobs, queue_.jobs() * kJobBytes);
}

void ChunkService::note_patch(std::size_t bytes) {
  std::size_t largest = largest_patch_bytes_.load();
  while (bytes > largest && !largest_patch_bytes_.compare_exchange_weak(largest, bytes)) {
  }
  const std::uint64_t wanted = settings_.threads * kPatchesAtWork * std::max(bytes, largest);
  // More would leave no room for anybody, for good.
  const std::uint64_t most = memory_.limit_bytes() == 0 ? wanted : memory_.limit_bytes() / kGeneratorsShare;
  if (wanted > most && !warned_of_generators_.exchange(true)) {
    log_->warn(
        "generators at work may take {} MiB, more than an eighth of limits.memory_bytes ({} MiB): raise "
        "that, or "
        "set fewer threads.generator or a smaller generation.patch_tiles",
        wanted >> 20U, memory_.limit_bytes() >> 20U);
  }
  memory_.set(MemoryUse::generators, std::min(wanted, most));
}

void ChunkService::fit_caches() {
  const std::unique_lock lock{fitting_, std::try_to_lock};
  if (!lock) return;  // somebody is at it
  const std::uint64_t wanted = settings_.chunk_cache_bytes + settings_.patch_cache_bytes;
  const std::uint64_t allowed = memory_.for_caches(wanted);
  const std::uint64_t apart = allowed > fitted_bytes_ ? allowed - fitted_bytes_ : fitted_bytes_ - allowed;
  if (apart > wanted / 256 || (allowed == wanted && apart > 0)) {
    const auto part = [&](std::size_t bytes) {
      return static_cast<std::size_t>(static_cast<double>(bytes) * static_cast<double>(allowed) /
                                      static_cast<double>(wanted));
    };
    chunks_.set_capacity(part(settings_.chunk_cache_bytes - settings_.chunk_cache_bytes / kShareOfRows));
    rows_.set_capacity(part(settings_.chunk_cache_bytes / kShareOfRows));
    patches_.set_capacity(part(settings_.patch_cache_bytes));
    fitted_bytes_ = allowed;
  }
  memory_.set(MemoryUse::chunk_cache, chunks_.bytes() + rows_.bytes());
  memory_.set(MemoryUse::patch_cache, patches_.bytes());
}

void ChunkService::run(const WorkQueue::Batch& batch) {
  DroppedPatches dropped;
  const StacksPtr stacks = stacks_of(batch.patch, dropped);
  make_chunks(batch, stacks.get());
  if (stacks != nullptr && used_up(batch.patch, *stacks)) patches_.drop(batch.patch);
  // When nobody waits for this thread any more.
  for (const auto& [patch, gone] : dropped) keep_chunks(patch, *gone);
}

void ChunkService::make_chunks(const WorkQueue::Batch& batch, const terrain::Stacks* stacks) {
  const Timed timed{metrics_.chunk_ns};
  Handover handover{log_};
  for (const ChunkKey key : batch.keys) {
    {
      const std::lock_guard lock{mutex_};
      if (stopping_) continue;
      if (!queue_.begin(key)) {
        metrics_.jobs_cancelled.add();
        continue;
      }
    }
    const ChunkAnswer answer = make_chunk(stacks, key);
    std::vector<ChunkClientPtr> waiters;
    {
      const std::lock_guard lock{mutex_};
      waiters = queue_.finish(key);
    }
    handover.add(waiters, key, answer);
  }
  handover.flush();
}

void ChunkService::run(const HeightsTask& task) {
  const HeightsAnswer answer = make_heights(task);
  try {
    task.client->heights_ready(task.ticket, answer);
  } catch (const std::exception& error) {
    log_->error("heights could not be handed over: {}", error.what());
  }
}

HeightsAnswer ChunkService::make_heights(const HeightsTask& task) {
  try {
    const Timed timed{metrics_.heights_ns};
    metrics_.heights_made.add(task.columns.size());
    return generator_->heights(task.columns);
  } catch (const std::exception& error) {
    log_->error("heights of {} columns failed: {}", task.columns.size(), error.what());
    return tl::make_unexpected(GenerationFailed{error.what()});
  }
}

StacksPtr ChunkService::stacks_of(const PatchKey& patch, DroppedPatches& dropped) {
  StacksPtr stacks = patches_.find(patch);
  if (stacks != nullptr) return stacks;
  try {
    stacks = make_patch(patch);
    note_patch(stacks->bytes());
    note_rows(patch, *stacks);
    dropped = patches_.put(patch, stacks);
  } catch (const std::exception& error) {
    log_->error("patch ({}, {}) at level of detail {} failed: {}", patch.x, patch.z, patch.lod.value(),
                error.what());
  }
  return stacks;
}

StacksPtr ChunkService::make_patch(const PatchKey& patch) {
  const Timed timed{metrics_.patch_ns};
  metrics_.patches_made.add();
  auto stacks = spare_patches_.take();
  generator_->make_patch(patch, *stacks);
  return spare_patches_.share(std::move(stacks));
}

void ChunkService::keep_chunks(const PatchKey& patch, const terrain::Stacks& stacks) {
  const Timed timed{metrics_.chunk_ns};
  for_each_column(patch, [&](ChunkKey column) {
    const terrain::MixedRange mixed = generator_->rows(stacks, column);
    // Worlds can be far deeper than what anybody looks at.
    const std::int32_t last = std::min(mixed.last, mixed.first + kMostKeptRows - 1);
    for (std::int32_t y = mixed.first; y <= last; ++y) {
      const ChunkKey key{{column.coord.x, y, column.coord.z}, column.lod};
      if (!chunks_.holds(key)) (void)make_chunk(&stacks, key);
    }
  });
}

bool ChunkService::used_up(const PatchKey& patch, const terrain::Stacks& stacks) {
  bool all_kept = true;
  for_each_column(patch, [&](ChunkKey column) {
    if (!all_kept) return;
    const auto known = rows_.find(column);
    const terrain::MixedRange mixed = known ? *known : generator_->rows(stacks, column);
    all_kept = std::int64_t{mixed.last} - mixed.first < kMostKeptRows;
    for (std::int32_t y = mixed.first; all_kept && y <= mixed.last; ++y) {
      all_kept = chunks_.holds({{column.coord.x, y, column.coord.z}, column.lod});
    }
  });
  return all_kept;
}

void ChunkService::note_rows(const PatchKey& patch, const terrain::Stacks& stacks) {
  for_each_column(patch, [&](ChunkKey column) { rows_.put(column, generator_->rows(stacks, column), 0); });
}

template <typename Visit>
void ChunkService::for_each_column(const PatchKey& patch, Visit&& visit) const {
  for (int z = 0; z < settings_.patch_tiles; ++z) {
    for (int x = 0; x < settings_.patch_tiles; ++x) {
      visit(
          ChunkKey{{patch.x * settings_.patch_tiles + x, 0, patch.z * settings_.patch_tiles + z}, patch.lod});
    }
  }
}

ChunkAnswer ChunkService::make_chunk(const terrain::Stacks* stacks, ChunkKey key) {
  if (stacks == nullptr) return tl::make_unexpected(GenerationFailed{"its patch could not be generated"});
  try {
    metrics_.chunks_made.add();
    EncodedChunkPtr chunk = generator_->make_chunk(*stacks, key);
    chunks_.put(key, chunk);
    return chunk;
  } catch (const std::exception& error) {
    log_->error("chunk {} failed: {}", to_string(key), error.what());
    return tl::make_unexpected(GenerationFailed{error.what()});
  }
}

}  // namespace talus::server
