#include "chunks/generation/generation_pool.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>
#include <variant>

#include "chunks/generation/answer_batcher.h"
#include "chunks/generation/background_thread.h"
#include "runtime/signals.h"

namespace talus::server {
namespace {

// A job with its place in each map, and one waiter.
constexpr std::int64_t kJobBytes = 384;

// Maximum time that a thread works on one thing before it yields to others.
constexpr std::chrono::milliseconds kLongestPiece{25};

// Time between checks if expensive work is still wanted; the shorter one once new work has come.
constexpr std::chrono::milliseconds kCheckInterval{5};
constexpr std::chrono::milliseconds kMinCheckInterval{1};

// Maximum number of jobs begun and ended under one lock: for that many a lock costs little, and few wait for
// long.
constexpr std::size_t kChunksAtOnce = 8;

// Number of refused flows that are considered when a piece of work ends.
constexpr std::size_t kFlowsToTell = 16;

// Pause after memory was lacking to begin anything.
constexpr std::chrono::milliseconds kMemoryRetry{100};

const GenerationError kOutOfMemory{"out of memory"};

/// Moves the waiters for Version::edited behind the others. Returns the number of the others.
std::size_t partition_by_version(std::vector<Waiter>& waiters) {
  const auto generated = [](const Waiter& waiter) { return waiter.version == Version::generated; };
  return static_cast<std::size_t>(std::partition(waiters.begin(), waiters.end(), generated) -
                                  waiters.begin());
}

void add_time(Counter& counter, std::chrono::nanoseconds time) {
  counter.add(static_cast<std::uint64_t>(time.count()));
}

}  // namespace

GenerationPool::GenerationPool(const Parts& parts, const Settings& settings, Logger log)
    : parts_{parts},
      settings_{settings},
      log_{std::move(log)},
      queue_{settings.patch_tiles, settings.max_jobs, settings.own_jobs} {}

void GenerationPool::start() {
  while (threads_.size() < settings_.threads) {
    threads_.emplace_back([this] { work(); });
  }
}

GenerationPool::~GenerationPool() {
  {
    const std::lock_guard lock{mutex_};
    stopping_ = true;
  }
  work_waits_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

std::size_t GenerationPool::add(const Waiter& waiter, std::span<const ChunkKey> keys, Urgency urgency) {
  const MailboxPtr& mailbox = waiter.mailbox;
  std::size_t accepted = 0;
  std::int64_t job_bytes = 0;
  {
    const std::lock_guard lock{mutex_};
    accepted = queue_.add(waiter, keys, urgency, parts_.memory.takes_jobs());
    if (accepted < keys.size()) {
      parts_.metrics.jobs_refused.add(keys.size() - accepted);
      if (accepted == 0 && !queue_.waits(mailbox->owner())) refused_.remember(mailbox);
    }
    if (accepted > 0) note_arrival(mailbox->flow());
    job_bytes = job_bytes_change();
  }
  parts_.memory.add(MemoryUse::jobs, job_bytes);
  if (accepted > 0) work_waits_.notify_one();
  return accepted;
}

void GenerationPool::hasten(ClientId client, std::span<const ChunkKey> keys) {
  const std::lock_guard lock{mutex_};
  for (const ChunkKey key : keys) queue_.hasten(client, key);
}

void GenerationPool::cancel(ClientId client, std::span<const ChunkKey> keys) {
  std::size_t cancelled = 0;
  std::int64_t job_bytes = 0;
  std::ptrdiff_t begun = 0;
  BegunPatchPtr dropped;
  std::vector<MailboxPtr> with_room;
  {
    const std::lock_guard lock{mutex_};
    const std::size_t jobs = queue_.jobs();
    for (const ChunkKey key : keys) queue_.cancel(client, key);
    cancelled = jobs - queue_.jobs();
    if (cancelled == 0) return;
    job_bytes = job_bytes_change();
    begun = begun_change();
    dropped = queue_.take_dropped();
    with_room = clients_with_room();
  }
  parts_.generator_memory.add_begun(begun);
  parts_.metrics.jobs_cancelled.add(cancelled);
  parts_.memory.add(MemoryUse::jobs, job_bytes);
  tell_of_room(with_room);
}

void GenerationPool::add(HeightsTask task) {
  {
    const std::lock_guard lock{mutex_};
    note_arrival(task.mailbox()->flow());
    queue_.add(std::move(task));
  }
  work_waits_.notify_one();
}

void GenerationPool::cancel_heights(ClientId client, std::uint64_t ticket) {
  std::ptrdiff_t begun = 0;
  {
    const std::lock_guard lock{mutex_};
    queue_.cancel_heights(client, ticket);
    begun = begun_change();
  }
  parts_.generator_memory.add_begun(begun);
}

void GenerationPool::jobs_resume() {
  std::vector<MailboxPtr> with_room;
  {
    const std::lock_guard lock{mutex_};
    with_room = clients_with_room();
  }
  tell_of_room(with_room);
}

GenerationPool::State GenerationPool::status() {
  const std::lock_guard lock{mutex_};
  return {queue_.jobs(), queue_.clients()};
}

void GenerationPool::work() {
  lower_priority();
  block_signals();
  std::unique_lock lock{mutex_};
  while (!stopping_) {
    std::optional<WorkQueue::Work> work;
    try {
      work = queue_.take(costs());
    } catch (const std::exception&) {
      work_waits_.wait_for(lock, kMemoryRetry);
      continue;
    }
    if (!work) {
      work_waits_.wait(lock);
      continue;
    }
    lock.unlock();
    MeasuredWork measured;
    const auto began = parts_.clock.thread_cpu();
    try {
      std::visit([&](auto& piece) { run(piece, *work, measured); }, work->what);
    } catch (const std::exception& error) {
      log_->error("a piece of work failed: {}", error.what());
      std::visit([&](auto& piece) { fail(piece); }, work->what);
    }
    const auto took = parts_.clock.thread_cpu() - began;
    count(measured);
    work->flow_use->add(FlowMeasure::generator, static_cast<std::uint64_t>(took.count()));
    end(*work, measured, took);
    lock.lock();
  }
}

void GenerationPool::end(WorkQueue::Work& work, const MeasuredWork& measured, std::chrono::nanoseconds took) {
  std::int64_t job_bytes = 0;
  std::vector<MailboxPtr> with_room;
  std::ptrdiff_t begun = 0;
  BegunPatchPtr dropped;
  {
    const std::lock_guard lock{mutex_};
    measured_costs_.add(measured);
    put_back(work);
    queue_.reconcile(work, static_cast<std::uint64_t>(took.count()));
    begun = begun_change();
    dropped = queue_.take_dropped();
    job_bytes = job_bytes_change();
    with_room = clients_with_room();
  }
  parts_.generator_memory.add_begun(begun);
  // Work that could not begin until now: jobs that came for this patch meanwhile, and its client's next.
  work_waits_.notify_one();
  parts_.memory.add(MemoryUse::jobs, job_bytes);
  tell_of_room(with_room);
}

void GenerationPool::put_back(WorkQueue::Work& work) {
  if (auto* const heights = std::get_if<HeightsTask>(&work.what)) {
    try {
      if (heights->left() > 0) queue_.put_back(std::move(*heights));
    } catch (const std::bad_alloc&) {
      heights->mailbox()->lose_mail();
    }
    return;
  }
  auto& batch = std::get<WorkQueue::Batch>(work.what);
  try {
    if (batch.begun != nullptr) return queue_.put_back(std::move(batch), work.turn);
  } catch (const std::bad_alloc&) {
    lose(batch);
  }
  queue_.release(batch.patch);
}

void GenerationPool::lose(const WorkQueue::Batch& batch) {
  for (const ChunkKey key : batch.keys) {
    if (!queue_.begin(key)) continue;
    for (const Waiter& waiter : queue_.finish(key)) waiter.mailbox->lose_mail();
  }
}

void GenerationPool::fail(const WorkQueue::Batch& batch) {
  try {
    answer(batch.keys, [](std::size_t) -> ChunkAnswer { return tl::make_unexpected(kOutOfMemory); });
  } catch (const std::exception& error) {
    log_->error("{} chunks are not answered: {}", batch.keys.size(), error.what());
    const std::lock_guard lock{mutex_};
    lose(batch);
  }
}

void GenerationPool::fail(HeightsTask& task) {
  deliver(task.mailbox(), HeightsReady{task.ticket(), tl::make_unexpected(kOutOfMemory)}, log_);
  task.give_up();
}

void GenerationPool::run(WorkQueue::Batch& batch, const WorkQueue::Work& work, MeasuredWork& measured) {
  bool dropped = false;
  BegunPatchPtr begun = std::move(batch.begun);
  const auto spent = begun == nullptr ? std::chrono::nanoseconds{} : begun->spent;
  const AskAfterStep after_step = after_step_of(work, spent, [&] {
    dropped = queue_.drop_unwanted(batch);
    if (dropped) parts_.metrics.jobs_cancelled.add(batch.keys.size());
    return !dropped;
  });
  // Chunks that were made since they were asked for wait for nothing.
  std::vector<ChunkKey> to_make = answer_known(batch.keys);
  if (begun == nullptr && parts_.patches.read_columns(batch.patch, to_make)) to_make = answer_known(to_make);
  if (to_make.empty()) return;
  PatchStore::Loan loan = parts_.patches.obtain(batch.patch, to_make, std::move(begun), after_step, measured);
  batch.begun = std::move(loan.begun);
  if (batch.begun != nullptr || dropped || loan.given_up) return;
  const auto began = parts_.clock.thread_cpu();
  answer(to_make, [&](std::size_t index) -> ChunkAnswer {
    if (EncodedChunkPtr chunk = parts_.maker.known(to_make[index])) return chunk;
    ++measured.chunks;
    return parts_.maker.chunk(loan.stacks.get(), to_make[index]);
  });
  measured.chunk_time += parts_.clock.thread_cpu() - began;
  parts_.patches.finish(loan, measured, [this] { return stopping_.load(); });
}

std::vector<ChunkKey> GenerationPool::answer_known(std::span<const ChunkKey> keys) {
  std::vector<ChunkKey> found;
  std::vector<EncodedChunkPtr> known;
  std::vector<ChunkKey> others;
  for (const ChunkKey key : keys) {
    if (EncodedChunkPtr chunk = parts_.maker.known(key)) {
      found.push_back(key);
      known.push_back(std::move(chunk));
    } else {
      others.push_back(key);
    }
  }
  answer(found, [&](std::size_t index) { return known[index]; });
  return others;
}

template <typename Chunk>
void GenerationPool::answer(std::span<const ChunkKey> keys, Chunk&& chunk) {
  struct PendingAnswer {
    std::size_t index = 0;
    ChunkAnswer answer;
    std::vector<Waiter> waiters{};
  };
  AnswerBatcher answers{log_, parts_.clock};
  std::vector<PendingAnswer> some;
  some.reserve(std::min(keys.size(), kChunksAtOnce));
  for (std::size_t next = 0; next < keys.size();) {
    {
      const std::lock_guard lock{mutex_};
      if (stopping_) return;
      for (std::size_t tried = 0; tried < kChunksAtOnce && next < keys.size(); ++tried, ++next) {
        if (queue_.begin(keys[next])) {
          some.push_back({next, nullptr});
        } else {
          parts_.metrics.jobs_cancelled.add();
        }
      }
    }
    std::size_t made = 0;
    for (PendingAnswer& each : some) {
      if (stopping_) break;  // a chunk may take long, and no client waits for it any more
      each.answer = chunk(each.index);
      ++made;
    }
    {
      const std::lock_guard lock{mutex_};
      for (PendingAnswer& each : some) each.waiters = queue_.finish(keys[each.index]);
    }
    some.resize(made);
    for (PendingAnswer& each : some) {
      const ChunkKey key = keys[each.index];
      const std::size_t generated = partition_by_version(each.waiters);
      const std::span<const Waiter> waiters{each.waiters};
      if (generated > 0) answers.add(waiters.first(generated), key, each.answer);
      if (generated < waiters.size())
        answers.add(waiters.subspan(generated), key, with_edits(key, each.answer));
    }
    some.clear();
  }
}

ChunkAnswer GenerationPool::with_edits(ChunkKey key, const ChunkAnswer& base) const {
  return base && parts_.merged != nullptr ? parts_.merged->merged(key, *base) : base;
}

void GenerationPool::run(HeightsTask& task, const WorkQueue::Work& work, MeasuredWork& measured) {
  const auto began = parts_.clock.thread_cpu();
  const auto took = [&] { return parts_.clock.thread_cpu() - began; };
  // Expensive heights give way to any cheap work, even if they were just taken again.
  const std::chrono::nanoseconds spent =
      task.tile() || task.is_begun() ? kLongestPiece : std::chrono::milliseconds{};
  const AskAfterStep after_step = after_step_of(work, spent, [&] { return queue_.is_wanted(task); });
  std::optional<GenerationError> failure;
  const std::size_t left = task.left();
  do {
    auto next = parts_.maker.heights(task, after_step);
    if (!next) failure = std::move(next.error());
    if (!next || *next != AfterStep::go_on) break;
  } while (task.left() > 0 && took() < kLongestPiece && !stopping_);
  if (task.tile()) {
    measured.map_time += took();  // counts for no mean: the cost of a map is corrected when it is made
  } else {
    measured.height_time += took();
    measured.heights += left - task.left();
  }
  if (failure) {
    deliver(task.mailbox(), HeightsReady{task.ticket(), tl::make_unexpected(*std::move(failure))}, log_);
    task.give_up();
  } else if (task.left() == 0) {
    deliver(task.mailbox(), HeightsReady{task.ticket(), task.take_found()}, log_);
  }
}

AskAfterStep GenerationPool::after_step_of(const WorkQueue::Work& work, std::chrono::nanoseconds spent,
                                           std::function<bool()> is_wanted) {
  return [this, &work, spent, is_wanted = std::move(is_wanted), began = parts_.clock.thread_cpu(),
          checked = parts_.clock.now(), arrivals = arrivals_.load(),
          piece = std::chrono::nanoseconds{kLongestPiece}]() mutable {
    if (stopping_) return AfterStep::give_up;
    const auto now = parts_.clock.now();
    const bool came = arrivals_.load(std::memory_order_relaxed) != arrivals;
    if (now < checked + (came ? kMinCheckInterval : kCheckInterval)) return AfterStep::go_on;
    checked = now;
    const std::chrono::nanoseconds took = parts_.clock.thread_cpu() - began;
    const bool long_enough = took >= piece;
    const std::lock_guard lock{mutex_};
    if (!is_wanted()) return AfterStep::give_up;
    if (!came && !long_enough) return AfterStep::go_on;
    arrivals = arrivals_;
    if (long_enough) piece += kLongestPiece;  // checking all waiting clients costs time
    const auto all = static_cast<std::uint64_t>((spent + took).count());
    return queue_.should_give_way(work.turn, all, costs()) ? AfterStep::pause : AfterStep::go_on;
  };
}

void GenerationPool::count(const MeasuredWork& measured) {
  add_time(parts_.metrics.patch_ns, measured.patch_time);
  add_time(parts_.metrics.chunk_ns, measured.chunk_time);
  add_time(parts_.metrics.heights_ns, measured.height_time);
  add_time(parts_.metrics.map_ns, measured.map_time);
}

WorkCosts GenerationPool::costs() const {
  WorkCosts costs = measured_costs_.costs();
  costs.in_memory = [this](const PatchKey& patch) { return parts_.patches.holds(patch); };
  costs.longest_piece = std::chrono::nanoseconds{kLongestPiece}.count();
  costs.max_begun = parts_.generator_memory.max_begun();
  costs.max_begun_of_flow = (costs.max_begun + 3) / 4;  // so that several flows find room
  // A flow gets all threads only while no other asks: the next flow that asks should find one.
  const bool keep_one = recent_flows_.several(parts_.clock.now()) && settings_.threads > 1;
  costs.max_in_flight = keep_one ? settings_.threads - 1 : settings_.threads;
  // Each piece in flight can be put back, unless memory is so short that a thread would have nothing to do.
  costs.max_open = std::max(costs.max_begun, settings_.threads);
  costs.max_open_of_flow = std::max(costs.max_begun_of_flow, costs.max_in_flight);
  return costs;
}

void GenerationPool::note_arrival(FlowId flow) {
  recent_flows_.asked(flow, parts_.clock.now());
  ++arrivals_;
}

std::ptrdiff_t GenerationPool::begun_change() {
  const std::size_t before = std::exchange(begun_told_, queue_.begun());
  return static_cast<std::ptrdiff_t>(begun_told_) - static_cast<std::ptrdiff_t>(before);
}

std::int64_t GenerationPool::job_bytes_change() {
  const std::size_t before = std::exchange(jobs_told_, queue_.jobs());
  jobs_.store(jobs_told_, std::memory_order_relaxed);
  return (static_cast<std::int64_t>(jobs_told_) - static_cast<std::int64_t>(before)) * kJobBytes;
}

// While jobs wait, each piece of work that ends gets here again. Otherwise all refused clients are
// notified, and the first that come fill the queue. But if memory is so short that they are served one after
// the other, only a few are notified, so that the others need not be refused again; housekeeping calls this
// for clients that had nothing to ask.
std::vector<MailboxPtr> GenerationPool::clients_with_room() {
  if (refused_.empty() || !parts_.memory.takes_jobs()) return {};
  try {
    if (queue_.jobs() == 0 && parts_.memory.takes_work()) return refused_.take_all();
    if (queue_.jobs() == 0) return refused_.take(kFlowsToTell, [](FlowId) { return true; });
    return refused_.take(kFlowsToTell, [this](FlowId flow) { return queue_.has_room(flow); });
  } catch (const std::bad_alloc&) {
    return {};  // they are notified when the next piece of work ends
  }
}

void GenerationPool::tell_of_room(const std::vector<MailboxPtr>& mailboxes) {
  for (const MailboxPtr& mailbox : mailboxes) deliver(mailbox, QueueHasRoom{}, log_);
}

}  // namespace talus::server
