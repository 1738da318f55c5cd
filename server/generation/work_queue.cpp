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
    Client& state = enter(client);
    if (++state.jobs[job.patch] == 1) state.order.push_back(job.patch);
  }
  return true;
}

void WorkQueue::add(HeightsTask task) {
  enter(task.client).heights.push_back(std::move(task));
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
  heights.erase(task);
}

std::optional<WorkQueue::Work> WorkQueue::take(const WorkPrices& prices) {
  const auto quantum = static_cast<std::int64_t>(prices.patch);
  for (;;) {
    std::optional<std::int64_t> least_debt;  // of those who could begin something
    for (std::size_t turn = clients_.size(); turn > 0; --turn) {
      Client& client = clients_.at(turns().front());
      if (!std::exchange(client.in_turn, true)) {
        client.balance = std::min(client.balance + quantum, quantum);
      }
      if (client.balance > 0) {
        if (auto work = take_of(client, prices)) return work;
      } else if (may_begin(client, prices)) {
        least_debt = std::min(least_debt.value_or(-client.balance), -client.balance);
      }
      end_turn();
    }
    if (!least_debt) {
      forget_idle();
      return std::nullopt;
    }
    // All who could go on owe something: so many rounds would pass before the first may.
    for (auto& [id, client] : clients_) client.balance += *least_debt / quantum * quantum;
  }
}

void WorkQueue::settle(const Work& work, std::uint64_t cost) {
  const auto found = clients_.find(work.client.get());
  if (found == clients_.end()) return;
  --found->second.under_way;
  found->second.balance += static_cast<std::int64_t>(work.price) - static_cast<std::int64_t>(cost);
}

std::optional<WorkQueue::Work> WorkQueue::take_of(Client& client, const WorkPrices& prices) {
  if (client.under_way >= prices.most_at_once) return std::nullopt;
  const ChunkClientPtr self = client.self.lock();
  Work work{{}, self, 0};
  const auto patch = free_patch(client);
  const bool chunks = patch != client.order.end();
  client.heights_next = !client.heights.empty() && (client.heights_next || !chunks);
  if (std::exchange(client.heights_next, !client.heights_next)) {
    HeightsTask task = std::move(client.heights.front());
    client.heights.pop_front();
    work.price = prices.height * task.columns.size();
    work.what = std::move(task);
  } else {
    if (!chunks) return std::nullopt;
    Batch batch = take_patch(PatchKey{*patch}, self);
    const bool at_hand = prices.at_hand && prices.at_hand(batch.patch);
    work.price = (at_hand ? 0 : prices.patch) + prices.chunk * batch.keys.size();
    work.what = std::move(batch);
  }
  client.balance -= static_cast<std::int64_t>(work.price);
  ++client.under_way;
  return work;
}

std::deque<PatchKey>::const_iterator WorkQueue::free_patch(const Client& client) const {
  return std::find_if(client.order.begin(), client.order.end(),
                      [&](const PatchKey& patch) { return !patches_.at(patch).taken; });
}

bool WorkQueue::may_begin(const Client& client, const WorkPrices& prices) const {
  if (client.under_way >= prices.most_at_once) return false;
  return !client.heights.empty() || free_patch(client) != client.order.end();
}

void WorkQueue::end_turn() {
  const ChunkClient* const id = turns().front();
  turns().pop_front();
  const auto client = clients_.find(id);
  client->second.in_turn = false;
  const bool faded = client->second.idle() && client->second.under_way == 0 && client->second.balance >= 0;
  if (faded && std::exchange(client->second.fading, true)) {
    clients_.erase(client);
    return;
  }
  client->second.fading = faded;
  turns_.push_back(id);
}

// Where nobody waits, nobody is owed anything.
void WorkQueue::forget_idle() {
  const auto busy = [](const auto& each) { return !each.second.idle() || each.second.under_way > 0; };
  if (std::any_of(clients_.begin(), clients_.end(), busy)) return;
  clients_.clear();
  fresh_.clear();
  turns_.clear();
}

std::size_t WorkQueue::clients() const {
  return static_cast<std::size_t>(
      std::count_if(clients_.begin(), clients_.end(), [](const auto& each) { return !each.second.idle(); }));
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

WorkQueue::Client& WorkQueue::enter(const ChunkClientPtr& client) {
  const auto [found, added] = clients_.try_emplace(client.get());
  Client& state = found->second;
  if (added) fresh_.push_back(client.get());
  // What another owed who was in the same place of memory is not this one's debt.
  if (state.self.expired()) {
    state.balance = 0;
    state.under_way = 0;
  }
  state.self = client;
  return state;
}

void WorkQueue::leave(const ChunkClient& client, const PatchKey& patch) {
  Client& state = clients_.at(&client);
  const auto jobs = state.jobs.find(patch);
  if (--jobs->second > 0) return;
  state.jobs.erase(jobs);
  state.order.erase(std::find(state.order.begin(), state.order.end(), patch));
}

WorkQueue::Batch WorkQueue::take_patch(const PatchKey& patch, const ChunkClientPtr& client) {
  PatchWork& work = patches_.at(patch);
  work.taken = true;
  Batch batch{patch, std::exchange(work.waiting, {})};
  std::stable_partition(batch.keys.begin(), batch.keys.end(), [&](ChunkKey key) {
    const auto& waiters = jobs_.at(key).waiters;
    return std::find(waiters.begin(), waiters.end(), client) != waiters.end();
  });
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
