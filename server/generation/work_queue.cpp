#include "generation/work_queue.h"

#include <algorithm>
#include <utility>

namespace talus::server {

WorkQueue::WorkQueue(int patch_tiles, std::size_t most_jobs)
    : patch_tiles_{patch_tiles}, most_jobs_{most_jobs} {}

bool WorkQueue::add(const ChunkClientPtr& client, ChunkKey key) {
  auto found = jobs_.find(key);
  if (found == jobs_.end()) {
    if (jobs_.size() >= most_jobs_) return false;
    const PatchKey patch = patch_of(key, patch_tiles_);
    found = jobs_.emplace(key, Job{patch, {}, false}).first;
    patches_[patch].waiting.push_back(key);
  }
  Job& job = found->second;
  if (std::find(job.waiters.begin(), job.waiters.end(), client) != job.waiters.end()) return true;
  job.waiters.push_back(client);
  if (!job.taken) {
    Client& state = enter(*client);
    if (++state.jobs[job.patch] == 1) state.order.push_back(job.patch);
  }
  return true;
}

void WorkQueue::add(HeightsTask task) {
  enter(*task.client).heights.push_back(std::move(task));
}

void WorkQueue::cancel(const ChunkClient& client, ChunkKey key) {
  const auto found = jobs_.find(key);
  if (found == jobs_.end()) return;
  Job& job = found->second;
  const auto waiter = std::find_if(job.waiters.begin(), job.waiters.end(),
                                   [&](const ChunkClientPtr& each) { return each.get() == &client; });
  if (waiter == job.waiters.end()) return;
  const ChunkClientPtr alive = *waiter;
  job.waiters.erase(waiter);
  if (job.taken) return;  // begin() or finish() ends it

  const PatchKey patch = job.patch;
  leave(client, patch);
  if (!job.waiters.empty()) return;
  jobs_.erase(found);
  auto& waiting = patches_.at(patch).waiting;
  waiting.erase(std::find(waiting.begin(), waiting.end(), key));
  drop_if_unused(patch);
}

void WorkQueue::cancel_heights(const ChunkClient& client, std::uint64_t ticket) {
  const auto found = clients_.find(&client);
  if (found == clients_.end()) return;
  auto& heights = found->second.heights;
  const auto task = std::find_if(heights.begin(), heights.end(),
                                 [&](const HeightsTask& each) { return each.ticket == ticket; });
  if (task == heights.end()) return;
  const ChunkClientPtr alive = task->client;
  heights.erase(task);
  leave_if_idle(client);
}

std::optional<WorkQueue::Work> WorkQueue::take() {
  for (std::size_t turn = 0; turn < turns_.size(); ++turn) {
    const ChunkClient* const id = turns_.front();
    turns_.pop_front();
    turns_.push_back(id);
    Client& client = clients_.at(id);
    if (!client.heights.empty()) {
      HeightsTask task = std::move(client.heights.front());
      client.heights.pop_front();
      leave_if_idle(*id);
      return Work{std::move(task)};
    }
    const auto free = std::find_if(client.order.begin(), client.order.end(),
                                   [&](const PatchKey& patch) { return !patches_.at(patch).taken; });
    if (free != client.order.end()) return Work{take_patch(PatchKey{*free})};
  }
  return std::nullopt;
}

bool WorkQueue::begin(ChunkKey key) {
  const auto found = jobs_.find(key);
  if (!found->second.waiters.empty()) return true;
  jobs_.erase(found);
  return false;
}

std::vector<ChunkClientPtr> WorkQueue::finish(ChunkKey key) {
  auto job = jobs_.extract(key);
  return std::move(job.mapped().waiters);
}

void WorkQueue::release(const PatchKey& patch) {
  patches_.at(patch).taken = false;
  drop_if_unused(patch);
}

WorkQueue::Client& WorkQueue::enter(const ChunkClient& client) {
  const auto [found, added] = clients_.try_emplace(&client);
  if (added) turns_.push_back(&client);
  return found->second;
}

void WorkQueue::leave(const ChunkClient& client, const PatchKey& patch) {
  Client& state = clients_.at(&client);
  const auto jobs = state.jobs.find(patch);
  if (--jobs->second > 0) return;
  state.jobs.erase(jobs);
  state.order.erase(std::find(state.order.begin(), state.order.end(), patch));
  leave_if_idle(client);
}

void WorkQueue::leave_if_idle(const ChunkClient& client) {
  const auto found = clients_.find(&client);
  if (!found->second.idle()) return;
  clients_.erase(found);
  turns_.erase(std::find(turns_.begin(), turns_.end(), &client));
}

WorkQueue::Batch WorkQueue::take_patch(const PatchKey& patch) {
  PatchWork& work = patches_.at(patch);
  work.taken = true;
  Batch batch{patch, std::exchange(work.waiting, {})};
  for (const ChunkKey key : batch.keys) {
    Job& job = jobs_.at(key);
    job.taken = true;
    for (const ChunkClientPtr& waiter : job.waiters) leave(*waiter, patch);
  }
  return batch;
}

void WorkQueue::drop_if_unused(const PatchKey& patch) {
  const auto found = patches_.find(patch);
  if (!found->second.taken && found->second.waiting.empty()) patches_.erase(found);
}

}  // namespace talus::server
