#include "generation/work_queue.h"

#include <algorithm>
#include <utility>

namespace talus::server {
namespace {

auto waiter_of(std::vector<MailboxPtr>& waiters, ClientId client) {
  return std::find_if(waiters.begin(), waiters.end(),
                      [&](const MailboxPtr& each) { return each->owner() == client; });
}

}  // namespace

WorkQueue::WorkQueue(int patch_tiles, std::size_t max_jobs, std::size_t own_jobs)
    : patch_tiles_{patch_tiles}, max_jobs_{max_jobs}, own_jobs_{own_jobs} {}

bool WorkQueue::may_add(const Mailbox& mailbox) const {
  const std::size_t jobs = of(mailbox.flow()).jobs;
  return jobs < free_jobs() && waiting_of(mailbox.owner()) < free_jobs() - jobs;
}

std::size_t WorkQueue::add(const MailboxPtr& mailbox, std::span<const ChunkKey> keys, bool new_jobs) {
  const bool own = waiting_of(mailbox->owner()) < own_jobs_;
  std::size_t added = 0;
  for (const ChunkKey key : keys) {
    if (!jobs_.contains(key) && (!new_jobs || !(own || may_add(*mailbox)))) break;
    add(mailbox, key);
    ++added;
  }
  return added;
}

void WorkQueue::add(const MailboxPtr& mailbox, ChunkKey key) {
  auto found = jobs_.find(key);
  if (found == jobs_.end()) {
    const FlowId flow = mailbox->flow();
    const PatchKey patch = patch_of(key, patch_tiles_);
    found = jobs_.emplace(key, Job{patch, flow, {}, false}).first;
    patches_[patch].waiting.push_back(key);
    ++flows_[flow].jobs;
  }
  Job& job = found->second;
  if (waiter_of(job.waiters, mailbox->owner()) != job.waiters.end()) return;
  job.waiters.push_back(mailbox);
  if (!job.taken) {
    Client& client = enter(*mailbox);
    if (++client.jobs[job.patch] == 1) client.order.push_back(job.patch);
    ++client.waiting;
  }
}

void WorkQueue::add(HeightsTask task) {
  enter(*task.mailbox()).heights.push_back(std::move(task));
}

void WorkQueue::cancel(ClientId client, ChunkKey key) {
  const auto found = jobs_.find(key);
  if (found == jobs_.end()) return;
  Job& job = found->second;
  const auto waiter = waiter_of(job.waiters, client);
  if (waiter == job.waiters.end()) return;
  job.waiters.erase(waiter);
  const auto counts = [&](const MailboxPtr& each) { return each->flow() == job.flow; };
  if (!job.waiters.empty() && std::none_of(job.waiters.begin(), job.waiters.end(), counts)) {
    move(job, job.waiters.front()->flow());
  }
  if (job.taken) return;  // begin() or finish() ends it

  const PatchKey patch = job.patch;
  leave(client, patch);
  if (!job.waiters.empty()) return;
  (void)erase(found);
  auto& waiting = patches_.at(patch).waiting;
  waiting.erase(std::find(waiting.begin(), waiting.end(), key));
  drop_if_unused(patch);
}

void WorkQueue::cancel_heights(ClientId client, std::uint64_t ticket) {
  const auto found = clients_.find(client);
  if (found == clients_.end()) return;
  std::erase_if(found->second.heights, [&](const HeightsTask& task) { return task.ticket() == ticket; });
  std::erase(found->second.taken_heights, ticket);
  drop_if_done(found);
}

void WorkQueue::put_back(HeightsTask task) {
  Client& client = enter(*task.mailbox());
  if (std::erase(client.taken_heights, task.ticket()) > 0) client.heights.push_front(std::move(task));
}

std::optional<WorkQueue::Work> WorkQueue::take(const WorkCosts& costs) {
  const auto next = turns_.next(
      static_cast<std::int64_t>(costs.patch),
      [&](FlowId flow) { return of(flow).in_flight < costs.max_in_flight; },
      [&](ClientId id) {
        const auto client = clients_.find(id);
        return client != clients_.end() && can_begin(client->second);
      },
      [&](ClientId id) { return clients_.contains(id); });
  if (!next) return std::nullopt;
  Work work = take_of(*next, costs);
  turns_.charge(*next, static_cast<std::int64_t>(work.price));
  return work;
}

void WorkQueue::reconcile(const Work& work, std::uint64_t cost) {
  turns_.charge(work.turn, static_cast<std::int64_t>(cost) - static_cast<std::int64_t>(work.price));
  --flows_.at(work.turn.flow).in_flight;
  drop_if_unused(work.turn.flow);
  const auto client = clients_.find(work.turn.client);
  --client->second.in_flight;
  if (const auto* task = std::get_if<HeightsTask>(&work.what)) {
    std::erase(client->second.taken_heights, task->ticket());
  }
  drop_if_done(client);
}

WorkQueue::Work WorkQueue::take_of(FlowTurns::Turn turn, const WorkCosts& costs) {
  Client& client = clients_.at(turn.client);
  ++client.in_flight;
  ++flows_[turn.flow].in_flight;
  const auto patch = free_patch(client);
  const bool chunks = patch != client.order.end();
  const bool heights = !client.heights.empty() && (client.heights_next || !chunks);
  client.heights_next = !heights;
  if (heights) {
    HeightsTask task = std::move(client.heights.front());
    client.heights.pop_front();
    client.taken_heights.push_back(task.ticket());
    const std::uint64_t price = std::min(costs.height * task.left(), costs.longest_piece);
    return {std::move(task), turn, price, client.flow_use};
  }
  Batch batch = take_patch(PatchKey{*patch}, turn.client);
  const bool in_memory = costs.in_memory && costs.in_memory(batch.patch);
  const std::uint64_t price = (in_memory ? 0 : costs.patch) + costs.chunk * batch.keys.size();
  return {std::move(batch), turn, price, client.flow_use};
}

std::deque<PatchKey>::const_iterator WorkQueue::free_patch(const Client& client) const {
  return std::find_if(client.order.begin(), client.order.end(),
                      [&](const PatchKey& patch) { return !patches_.at(patch).taken; });
}

bool WorkQueue::can_begin(const Client& client) const {
  return !client.heights.empty() || free_patch(client) != client.order.end();
}

std::size_t WorkQueue::clients() const {
  return static_cast<std::size_t>(
      std::count_if(clients_.begin(), clients_.end(), [](const auto& each) { return !each.second.idle(); }));
}

bool WorkQueue::begin(ChunkKey key) {
  const auto found = jobs_.find(key);
  if (!found->second.waiters.empty()) return true;
  (void)erase(found);
  return false;
}

bool WorkQueue::drop_unwanted(const Batch& batch) {
  if (!patches_.at(batch.patch).waiting.empty()) return false;
  const bool wanted = std::any_of(batch.keys.begin(), batch.keys.end(),
                                  [&](ChunkKey key) { return !jobs_.at(key).waiters.empty(); });
  if (wanted) return false;
  for (const ChunkKey key : batch.keys) (void)erase(jobs_.find(key));
  return true;
}

bool WorkQueue::is_wanted(const HeightsTask& task) const {
  const auto& taken = clients_.at(task.mailbox()->owner()).taken_heights;
  return std::find(taken.begin(), taken.end(), task.ticket()) != taken.end();
}

std::vector<MailboxPtr> WorkQueue::finish(ChunkKey key) {
  return erase(jobs_.find(key));
}

void WorkQueue::move(Job& job, FlowId flow) {
  ++flows_[flow].jobs;
  --flows_.at(job.flow).jobs;
  drop_if_unused(job.flow);
  job.flow = flow;
}

std::vector<MailboxPtr> WorkQueue::erase(Jobs::iterator job) {
  const FlowId flow = job->second.flow;
  --flows_.at(flow).jobs;
  drop_if_unused(flow);
  std::vector<MailboxPtr> waiters = std::move(job->second.waiters);
  jobs_.erase(job);
  return waiters;
}

void WorkQueue::release(const PatchKey& patch) {
  patches_.at(patch).taken = false;
  drop_if_unused(patch);
}

WorkQueue::Client& WorkQueue::enter(const Mailbox& mailbox) {
  turns_.enter({mailbox.flow(), mailbox.owner()});
  Client& client = clients_[mailbox.owner()];
  client.flow_use = mailbox.flow_use();
  return client;
}

std::size_t WorkQueue::waiting_of(ClientId client) const {
  const auto found = clients_.find(client);
  return found == clients_.end() ? 0 : found->second.waiting;
}

WorkQueue::Flow WorkQueue::of(FlowId flow) const {
  const auto found = flows_.find(flow);
  return found == flows_.end() ? Flow{} : found->second;
}

void WorkQueue::leave(ClientId client, const PatchKey& patch) {
  const auto found = clients_.find(client);
  Client& state = found->second;
  --state.waiting;
  const auto jobs = state.jobs.find(patch);
  if (--jobs->second > 0) return;
  state.jobs.erase(jobs);
  state.order.erase(std::find(state.order.begin(), state.order.end(), patch));
  drop_if_done(found);
}

void WorkQueue::drop_if_done(Clients::iterator client) {
  if (client->second.idle() && client->second.in_flight == 0) clients_.erase(client);
}

WorkQueue::Batch WorkQueue::take_patch(const PatchKey& patch, ClientId client) {
  PatchWork& work = patches_.at(patch);
  work.taken = true;
  Batch batch{patch, std::exchange(work.waiting, {})};
  std::stable_partition(batch.keys.begin(), batch.keys.end(), [&](ChunkKey key) {
    auto& waiters = jobs_.at(key).waiters;
    return waiter_of(waiters, client) != waiters.end();
  });
  for (const ChunkKey key : batch.keys) {
    Job& job = jobs_.at(key);
    job.taken = true;
    for (const MailboxPtr& waiter : job.waiters) leave(waiter->owner(), patch);
  }
  return batch;
}

void WorkQueue::drop_if_unused(const PatchKey& patch) {
  const auto found = patches_.find(patch);
  if (!found->second.taken && found->second.waiting.empty()) patches_.erase(found);
}

void WorkQueue::drop_if_unused(FlowId flow) {
  const auto found = flows_.find(flow);
  if (found->second.jobs == 0 && found->second.in_flight == 0) flows_.erase(found);
}

}  // namespace talus::server
