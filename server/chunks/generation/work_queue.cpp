#include "chunks/generation/work_queue.h"

#include <algorithm>
#include <utility>

namespace talus::server {
namespace {

template <typename... Calls>
struct Overloaded : Calls... {
  using Calls::operator()...;
};
template <typename... Calls>
Overloaded(Calls...) -> Overloaded<Calls...>;

/// Returns the entry with which work of that urgency enters the turns.
FairEntry entry_of(Urgency urgency) {
  return {.offset = urgency == Urgency::soon ? -double{WorkQueue::kPatchesAhead} : 0};
}

/// Maximum number of clients that one take() crowds out. The next take() asks the others again.
constexpr std::size_t kCrowdedOutAtOnce = 16;

auto waiter_of(std::vector<Waiter>& waiters, ClientId client) {
  return std::find_if(waiters.begin(), waiters.end(),
                      [&](const Waiter& each) { return each.mailbox->owner() == client; });
}

}  // namespace

WorkQueue::WorkQueue(int patch_tiles, std::size_t max_jobs, std::size_t own_jobs)
    : patch_tiles_{patch_tiles}, max_jobs_{max_jobs}, own_jobs_{own_jobs} {
  to_crowd_out_.reserve(kCrowdedOutAtOnce);
}

bool WorkQueue::may_add(const Mailbox& mailbox) const {
  const std::size_t jobs = of(mailbox.flow()).jobs;
  return jobs < free_jobs() && waiting_of(mailbox.owner()) < free_jobs() - jobs;
}

WorkQueue::Job* WorkQueue::Jobs::find(ChunkKey key) {
  for (std::size_t from = first;; ++from) {
    const auto begin = keys.begin() + static_cast<std::ptrdiff_t>(from);
    from = static_cast<std::size_t>(std::find(begin, keys.end(), key) - keys.begin());
    if (from == keys.size()) return nullptr;
    if (!jobs[from].ended) return &jobs[from];
  }
}

void WorkQueue::Jobs::reserve(std::size_t more) {
  const std::size_t needed = keys.size() + more;
  if (needed <= std::min(keys.capacity(), jobs.capacity())) return;
  keys.reserve(std::max(needed, 2 * keys.size()));
  jobs.reserve(std::max(needed, 2 * jobs.size()));
}

void WorkQueue::Jobs::add(ChunkKey key, Job job) {
  reserve(1);
  jobs.push_back(std::move(job));
  keys.push_back(key);
  ++open;
}

// Removes ended jobs when they are more than the others: amortised, each job moves once.
void WorkQueue::Jobs::end(Job& job) {
  job.ended = true;
  --open;
  while (first < jobs.size() && jobs[first].ended) ++first;
  if (jobs.size() < 32 || 2 * open > jobs.size()) return;
  std::size_t kept = 0;
  for (std::size_t i = first; i < jobs.size(); ++i) {
    if (jobs[i].ended) continue;
    if (kept != i) {
      jobs[kept] = std::move(jobs[i]);
      keys[kept] = keys[i];
    }
    ++kept;
  }
  jobs.erase(jobs.begin() + static_cast<std::ptrdiff_t>(kept), jobs.end());
  keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(kept), keys.end());
  first = 0;
}

std::size_t WorkQueue::add(const Waiter& waiter, std::span<const ChunkKey> keys, Urgency urgency,
                           bool new_jobs) {
  const MailboxPtr& mailbox = waiter.mailbox;
  // A client that waits for far chunks is not refused near ones.
  const auto found = clients_.find(mailbox->owner());
  const bool own = own_jobs_ > (found == clients_.end() ? 0 : found->second.waiting[urgency]);
  std::size_t added = 0;
  auto patch = patches_.end();
  try {
    for (const ChunkKey key : keys) {
      const PatchKey patch_key = patch_of(key, patch_tiles_);
      if (patch == patches_.end() || patch->first != patch_key) patch = patches_.find(patch_key);
      const bool known = patch != patches_.end();
      Job* const taken = known ? patch->second.taken.find(key) : nullptr;
      Job* const waiting = known && taken == nullptr ? patch->second.waiting.find(key) : nullptr;
      if (taken != nullptr) {
        if (urgency == Urgency::soon) patch->second.hastened = true;
        if (waiter_of(taken->waiters, mailbox->owner()) == taken->waiters.end()) {
          taken->waiters.push_back(waiter);
        }
      } else {
        if (waiting == nullptr && (!new_jobs || !(own || may_add(*mailbox)))) break;
        if (!known) patch = patches_.try_emplace(patch_key).first;
        add(waiter, key, urgency, patch->first, patch->second, waiting);
      }
      ++added;
    }
  } catch (const std::bad_alloc&) {
    if (patch != patches_.end()) drop_if_unused(patch);
  }
  return added;
}

void WorkQueue::add(const Waiter& waiter, ChunkKey key, Urgency urgency, const PatchKey& patch,
                    PatchWork& work, Job* waiting) {
  const MailboxPtr& mailbox = waiter.mailbox;
  Client& client = enter(*mailbox, urgency);
  if (urgency == Urgency::soon) hasten(client, mailbox->owner(), patch);
  if (waiting != nullptr && waiter_of(waiting->waiters, mailbox->owner()) != waiting->waiters.end()) return;
  const bool first_of_patch = !client.jobs.contains(patch);
  try {
    // Everything that may throw comes first.
    Flow& flow = flows_[mailbox->flow()];
    JobsOfPatch& jobs = client.jobs.try_emplace(patch, JobsOfPatch{0, urgency}).first->second;
    Job added{mailbox->flow(), {waiter}};
    waiting == nullptr ? work.waiting.reserve(1) : waiting->waiters.reserve(waiting->waiters.size() + 1);
    if (first_of_patch) client.order[urgency].push_back(patch);
    if (waiting == nullptr) {
      work.waiting.add(key, std::move(added));
      ++flow.jobs;
      ++jobs_;
    } else {
      waiting->waiters.push_back(waiter);
    }
    ++jobs.count;
    ++client.waiting[jobs.urgency];
  } catch (...) {
    if (first_of_patch) client.jobs.erase(patch);
    drop_if_unused(mailbox->flow());
    drop_if_done(clients_.find(mailbox->owner()));
    throw;
  }
}

void WorkQueue::hasten(ClientId client, ChunkKey key) {
  const PatchKey patch = patch_of(key, patch_tiles_);
  if (const auto found = clients_.find(client); found != clients_.end()) hasten(found->second, client, patch);
  const auto work = patches_.find(patch);
  if (work == patches_.end()) return;
  Job* const taken = work->second.taken.find(key);
  if (taken != nullptr && waiter_of(taken->waiters, client) != taken->waiters.end())
    work->second.hastened = true;
}

void WorkQueue::hasten(Client& client, ClientId id, const PatchKey& patch) {
  const auto jobs = client.jobs.find(patch);
  if (jobs == client.jobs.end() || jobs->second.urgency == Urgency::soon) return;
  turns_.enter(entry_of(Urgency::soon), client.flow, id, Urgency::soon);
  client.order[Urgency::soon].push_back(patch);
  std::deque<PatchKey>& later = client.order[Urgency::later];
  later.erase(std::find(later.begin(), later.end(), patch));
  client.waiting[Urgency::later] -= jobs->second.count;
  client.waiting[Urgency::soon] += jobs->second.count;
  jobs->second.urgency = Urgency::soon;
}

void WorkQueue::add(HeightsTask task) {
  const ClientId owner = task.mailbox()->owner();
  Client& client = enter(*task.mailbox(), Urgency::later);
  try {
    client.heights.push_back(std::move(task));
  } catch (...) {
    drop_if_done(clients_.find(owner));
    throw;
  }
}

void WorkQueue::cancel(ClientId client, ChunkKey key) {
  const auto patch = patches_.find(patch_of(key, patch_tiles_));
  if (patch == patches_.end()) return;
  PatchWork& work = patch->second;
  Job* const taken = work.taken.find(key);
  Job* const job = taken != nullptr ? taken : work.waiting.find(key);
  if (job == nullptr) return;
  const auto waiter = waiter_of(job->waiters, client);
  if (waiter == job->waiters.end()) return;
  const auto stays = [&](const Waiter& each) { return each.mailbox->owner() != client; };
  const auto counts = [&](const Waiter& each) { return stays(each) && each.mailbox->flow() == job->flow; };
  if (std::none_of(job->waiters.begin(), job->waiters.end(), counts)) {
    const auto other = std::find_if(job->waiters.begin(), job->waiters.end(), stays);
    if (other != job->waiters.end()) move(*job, other->mailbox->flow());  // may throw
  }
  job->waiters.erase(waiter);
  if (taken != nullptr) return;  // begin() or finish() ends it

  leave(client, patch->first);
  if (!job->waiters.empty()) return;
  (void)erase(work.waiting, *job);
  drop_if_unused(patch);
}

void WorkQueue::cancel_heights(ClientId client, std::uint64_t ticket) {
  const auto found = clients_.find(client);
  if (found == clients_.end()) return;
  std::erase_if(found->second.heights, [&](const HeightsTask& task) {
    if (task.ticket() != ticket) return false;
    if (task.is_begun()) count_begun(found->second.flow, false);
    return true;
  });
  std::erase(found->second.taken_heights, ticket);
  drop_if_done(found);
}

void WorkQueue::put_back(HeightsTask&& task) {
  Client& client = enter(*task.mailbox(), Urgency::later);
  const auto taken = std::find(client.taken_heights.begin(), client.taken_heights.end(), task.ticket());
  if (taken == client.taken_heights.end()) return;
  // Everything that may throw comes first.
  client.heights.emplace_front(task.mailbox(), task.ticket(), HeightsQuery{});
  client.heights.front() = std::move(task);
  client.taken_heights.erase(taken);
  if (client.heights.front().is_begun()) count_begun(client.flow, true);
}

void WorkQueue::put_back(Batch&& batch, const Turn& turn) {
  const auto found = patches_.find(batch.patch);
  PatchWork& work = found->second;
  // Everything that may throw comes first.
  work.waiting.reserve(work.taken.open);
  enter_waiters(found->first, work, work.hastened ? Urgency::soon : turn.urgency);
  while (!work.taken.empty()) {
    const std::size_t first = work.taken.first;
    Job& job = work.taken.jobs[first];
    if (job.waiters.empty()) {
      (void)erase(work.taken, job);
      continue;
    }
    for (const Waiter& waiter : job.waiters) {
      Client& client = clients_.at(waiter.mailbox->owner());
      JobsOfPatch& jobs = client.jobs.at(found->first);
      ++jobs.count;
      ++client.waiting[jobs.urgency];
    }
    work.waiting.add(work.taken.keys[first], std::move(job));
    work.taken.end(job);
  }
  work.taken = {};
  work.is_taken = false;
  work.hastened = false;
  if (!work.waiting.empty()) {
    work.begun = std::move(batch.begun);
    work.begun_by = turn.flow;
    count_begun(turn.flow, true);
  }
  if (batch.begun != nullptr && dropped_ == nullptr) dropped_ = std::move(batch.begun);
  drop_if_unused(found);
}

void WorkQueue::enter_waiters(const PatchKey& patch, const PatchWork& work, Urgency urgency) {
  // Clients that asked for more of the patch meanwhile may have been crowded out.
  for (const Job& job : work.waiting.jobs) {
    for (const Waiter& waiter : job.waiters) {
      const ClientId id = waiter.mailbox->owner();
      (void)enter(*waiter.mailbox, clients_.at(id).jobs.at(patch).urgency);
    }
  }
  try {
    for (const Job& job : work.taken.jobs) {
      for (const Waiter& waiter : job.waiters) {
        Client& client = enter(*waiter.mailbox, urgency);
        if (client.jobs.try_emplace(patch, JobsOfPatch{0, urgency}).second) {
          client.order[urgency].push_front(patch);
        } else if (urgency == Urgency::soon) {
          hasten(client, waiter.mailbox->owner(), patch);
        }
      }
    }
  } catch (...) {
    leave_where_none_waits(patch, work);
    throw;
  }
}

void WorkQueue::leave_where_none_waits(const PatchKey& patch, const PatchWork& work) {
  for (const Job& job : work.taken.jobs) {
    for (const Waiter& waiter : job.waiters) {
      const auto client = clients_.find(waiter.mailbox->owner());
      if (client == clients_.end()) continue;
      const auto jobs = client->second.jobs.find(patch);
      if (jobs != client->second.jobs.end() && jobs->second.count == 0) {
        std::erase(client->second.order[jobs->second.urgency], patch);
        client->second.jobs.erase(jobs);
      }
      drop_if_done(client);
    }
  }
}

void WorkQueue::count_begun(FlowId flow, bool more) {
  std::size_t& of_flow = flows_.at(flow).begun;
  more ? ++of_flow : --of_flow;
  more ? ++begun_ : --begun_;
  if (!more) drop_if_unused(flow);
}

std::optional<WorkQueue::Work> WorkQueue::take(const WorkCosts& costs) {
  patch_cost_ = static_cast<double>(std::min(costs.patch, costs.longest_piece));
  to_crowd_out_.clear();
  let_one_in(costs);
  const auto next = turns_.next(Overloaded{
      [&](FlowId flow) {
        return of(flow).in_flight < costs.max_in_flight ? FairState::ready : FairState::blocked;
      },
      [&](FlowId flow, ClientId id, Urgency urgency) { return readiness(flow, id, urgency, costs); }});
  crowd_out();
  if (!next) {
    if (turns_.empty() && crowded_out_.empty()) turns_.clear();  // no client waits: shares begin anew
    return std::nullopt;
  }
  const auto [flow, client, urgency] = *next;
  Work work = take_of({flow, client, urgency}, costs);
  turns_.reserve(work.price, flow, client, urgency);
  return work;
}

void WorkQueue::let_one_in(const WorkCosts& costs) {
  if (crowded_out_.empty()) return;
  const auto next = crowded_out_.next(
      Overloaded{[&](FlowId flow) {
                   const bool opens = of(flow).in_flight < costs.max_in_flight && may_open(flow, costs);
                   return opens ? FairState::ready : FairState::blocked;
                 },
                 [&](FlowId /*flow*/, ClientId id) {
                   const auto client = clients_.find(id);
                   const bool wants = client != clients_.end() && client->second.wants(Urgency::later);
                   return wants ? FairState::ready : FairState::idle;
                 }});
  if (!next) return;
  const auto [flow, client] = *next;
  turns_.enter(entry_of(Urgency::later), flow, client, Urgency::later);
  crowded_out_.charge(1, flow, client);
  crowded_out_.leave(flow, client);
}

void WorkQueue::crowd_out() {
  for (const auto& [flow, client] : to_crowd_out_) {
    crowded_out_.enter({}, flow, client);
    turns_.leave(flow, client, Urgency::later);
  }
}

void WorkQueue::reconcile(const Work& work, std::uint64_t cost) {
  const auto [flow, id, urgency] = work.turn;
  turns_.reserve(-work.price, flow, id, urgency);
  turns_.charge(static_cast<double>(cost) / patch_cost_, flow, id, urgency);
  --flows_.at(flow).in_flight;
  if (work.is_expensive) {
    --flows_.at(flow).expensive_in_flight;
    --expensive_in_flight_;
  }
  drop_if_unused(flow);
  const auto client = clients_.find(id);
  --client->second.in_flight;
  if (const auto* task = std::get_if<HeightsTask>(&work.what)) {
    std::erase(client->second.taken_heights, task->ticket());
  }
  drop_if_done(client);
}

WorkQueue::Work WorkQueue::take_of(const Turn& turn, const WorkCosts& costs) {
  Client& client = clients_.at(turn.client);
  const bool opens = turn.urgency == Urgency::soon || may_open(turn.flow, costs);
  const auto patch = free_patch(client, turn.urgency, opens, costs);
  const bool heights = turn.urgency == Urgency::later && heights_may_begin(client, opens, costs) &&
                       (client.heights_next || !patch);
  const bool expensive = heights ? is_expensive(client.heights.front(), costs) : is_expensive(*patch, costs);
  // This keeps the client and its flow, also if it takes their last work.
  Flow& flow = flows_[turn.flow];
  ++flow.in_flight;
  ++client.in_flight;
  const auto count = [&] {  // nothing throws any more
    if (!expensive) return;
    ++flow.expensive_in_flight;
    ++expensive_in_flight_;
  };
  try {
    if (heights) {
      client.taken_heights.push_back(client.heights.front().ticket());
      HeightsTask task = std::move(client.heights.front());
      client.heights.pop_front();
      client.heights_next = false;
      if (task.is_begun()) count_begun(turn.flow, false);
      const std::uint64_t price = std::min(costs.height * task.left(), costs.longest_piece);
      count();
      return {std::move(task), turn, static_cast<double>(price) / patch_cost_, expensive, client.flow_use};
    }
    Batch batch = take_patch(*patch, turn.client);
    client.heights_next = true;
    const bool in_memory = costs.in_memory && costs.in_memory(batch.patch);
    const std::uint64_t price =
        (in_memory ? 0 : std::min(costs.patch, costs.longest_piece)) + costs.chunk * batch.keys.size();
    count();
    return {std::move(batch), turn, static_cast<double>(price) / patch_cost_, expensive, client.flow_use};
  } catch (...) {
    --client.in_flight;
    --flow.in_flight;
    drop_if_unused(turn.flow);
    throw;
  }
}

bool WorkQueue::may_open(FlowId flow, const WorkCosts& costs) const {
  const Flow& its = of(flow);
  return begun_ + expensive_in_flight_ < costs.max_open &&
         its.begun + its.expensive_in_flight < costs.max_open_of_flow;
}

bool WorkQueue::is_expensive(const HeightsTask& task, const WorkCosts& costs) {
  return task.is_begun() || task.tile() || costs.height * task.left() > costs.longest_piece;
}

bool WorkQueue::is_expensive(const PatchKey& patch, const WorkCosts& costs) const {
  if (patches_.at(patch).begun != nullptr) return true;
  return costs.patch > costs.longest_piece && !(costs.in_memory && costs.in_memory(patch));
}

bool WorkQueue::heights_may_begin(const Client& client, bool opens, const WorkCosts& costs) {
  if (client.heights.empty()) return false;
  const HeightsTask& task = client.heights.front();
  return opens || task.is_begun() || !is_expensive(task, costs);
}

std::optional<PatchKey> WorkQueue::free_patch(const Client& client, Urgency urgency, bool opens,
                                              const WorkCosts& costs) const {
  for (const PatchKey& patch : client.order[urgency]) {
    const PatchWork& work = patches_.at(patch);
    if (work.is_taken) continue;
    if (opens || work.begun != nullptr || !is_expensive(patch, costs)) return patch;
  }
  return std::nullopt;
}

FairState WorkQueue::readiness(FlowId flow, ClientId id, Urgency urgency, const WorkCosts& costs) {
  const auto found = clients_.find(id);
  if (found == clients_.end()) return FairState::idle;
  const Client& client = found->second;
  const bool opens = urgency == Urgency::soon || may_open(flow, costs);
  if (can_begin(client, urgency, opens, costs)) return FairState::ready;
  if (!opens && to_crowd_out_.size() < kCrowdedOutAtOnce && can_begin(client, urgency, true, costs)) {
    to_crowd_out_.emplace_back(flow, id);
  }
  return client.wants(urgency) || client.in_flight > 0 ? FairState::blocked : FairState::idle;
}

bool WorkQueue::can_begin(const Client& client, Urgency urgency, bool opens, const WorkCosts& costs) const {
  return (urgency == Urgency::later && heights_may_begin(client, opens, costs)) ||
         free_patch(client, urgency, opens, costs);
}

bool WorkQueue::can_begin_for_less(const Client& client, std::uint64_t max_cost,
                                   const WorkCosts& costs) const {
  if (of(client.flow).in_flight >= costs.max_in_flight) return false;
  if (!client.heights.empty()) {
    const HeightsTask& task = client.heights.front();
    if (!task.tile() && costs.height * task.left() < max_cost) return true;
  }
  for (const Urgency urgency : {Urgency::soon, Urgency::later}) {
    const auto patch = free_patch(client, urgency, true, costs);
    if (!patch) continue;
    if (costs.patch < max_cost || (costs.in_memory && costs.in_memory(*patch))) return true;
  }
  return false;
}

bool WorkQueue::should_give_way(const Turn& turn, std::uint64_t spent, const WorkCosts& costs) const {
  if (begun_ >= costs.max_begun || of(turn.flow).begun >= costs.max_begun_of_flow) return false;
  // A piece that takes longer than most is likely to take as long again.
  const std::uint64_t left = spent < costs.patch ? costs.patch - spent : spent;
  return std::any_of(clients_.begin(), clients_.end(), [&](const auto& each) {
    return each.first != turn.client && can_begin_for_less(each.second, left, costs);
  });
}

std::size_t WorkQueue::clients() const {
  return static_cast<std::size_t>(
      std::count_if(clients_.begin(), clients_.end(), [](const auto& each) { return !each.second.idle(); }));
}

bool WorkQueue::begin(ChunkKey key) {
  Jobs& taken = patches_.at(patch_of(key, patch_tiles_)).taken;
  Job* const job = taken.find(key);
  if (job == nullptr) return false;
  if (!job->waiters.empty()) return true;
  (void)erase(taken, *job);
  return false;
}

bool WorkQueue::drop_unwanted(const Batch& batch) {
  PatchWork& work = patches_.at(batch.patch);
  if (!work.waiting.empty()) return false;
  for (const Job& job : work.taken.jobs) {
    if (!job.waiters.empty()) return false;
  }
  end_taken(work);
  return true;
}

void WorkQueue::end_taken(PatchWork& work) {
  while (!work.taken.empty()) (void)erase(work.taken, work.taken.jobs[work.taken.first]);
}

bool WorkQueue::is_wanted(const HeightsTask& task) const {
  const auto& taken = clients_.at(task.mailbox()->owner()).taken_heights;
  return std::find(taken.begin(), taken.end(), task.ticket()) != taken.end();
}

std::vector<Waiter> WorkQueue::finish(ChunkKey key) {
  Jobs& taken = patches_.at(patch_of(key, patch_tiles_)).taken;
  return erase(taken, *taken.find(key));
}

void WorkQueue::move(Job& job, FlowId flow) {
  ++flows_[flow].jobs;
  --flows_.at(job.flow).jobs;
  drop_if_unused(job.flow);
  job.flow = flow;
}

std::vector<Waiter> WorkQueue::erase(Jobs& jobs, Job& job) {
  --flows_.at(job.flow).jobs;
  drop_if_unused(job.flow);
  --jobs_;
  std::vector<Waiter> waiters = std::move(job.waiters);
  jobs.end(job);
  return waiters;
}

void WorkQueue::release(const PatchKey& patch) {
  const auto found = patches_.find(patch);
  end_taken(found->second);
  found->second.taken = {};
  found->second.is_taken = false;
  found->second.hastened = false;
  drop_if_unused(found);
}

WorkQueue::Client& WorkQueue::enter(const Mailbox& mailbox, Urgency urgency) {
  turns_.enter(entry_of(urgency), mailbox.flow(), mailbox.owner(), urgency);
  Client& client = clients_[mailbox.owner()];
  client.flow = mailbox.flow();
  client.flow_use = mailbox.flow_use();
  return client;
}

std::size_t WorkQueue::waiting_of(ClientId client) const {
  const auto found = clients_.find(client);
  return found == clients_.end() ? 0 : found->second.all_waiting();
}

WorkQueue::Flow WorkQueue::of(FlowId flow) const {
  const auto found = flows_.find(flow);
  return found == flows_.end() ? Flow{} : found->second;
}

void WorkQueue::leave(ClientId client, const PatchKey& patch) {
  const auto found = clients_.find(client);
  Client& state = found->second;
  const auto jobs = state.jobs.find(patch);
  const Urgency urgency = jobs->second.urgency;
  --state.waiting[urgency];
  if (--jobs->second.count > 0) return;
  state.jobs.erase(jobs);
  std::deque<PatchKey>& order = state.order[urgency];
  order.erase(std::find(order.begin(), order.end(), patch));
  drop_if_done(found);
}

void WorkQueue::drop_if_done(Clients::iterator client) {
  if (!client->second.idle() || client->second.in_flight > 0) return;
  crowded_out_.leave(client->second.flow, client->first);
  clients_.erase(client);
}

WorkQueue::Batch WorkQueue::take_patch(const PatchKey& patch, ClientId client) {
  PatchWork& work = patches_.at(patch);
  Jobs& waiting = work.waiting;
  work.taken.reserve(waiting.open);
  Batch batch{patch, {}};
  batch.keys.reserve(waiting.open);
  if (work.begun != nullptr) {
    batch.begun = std::move(work.begun);
    count_begun(work.begun_by, false);
  }
  // First the jobs for which the turn's client waits.
  for (const bool is_clients : {true, false}) {
    for (std::size_t i = waiting.first; i < waiting.jobs.size(); ++i) {
      Job& job = waiting.jobs[i];
      if (job.waiters.empty()) continue;  // it is ended, or was among the first
      if (is_clients && waiter_of(job.waiters, client) == job.waiters.end()) continue;
      for (const Waiter& waiter : job.waiters) leave(waiter.mailbox->owner(), patch);
      work.taken.add(waiting.keys[i], std::move(job));
      job.waiters.clear();
    }
  }
  batch.keys.assign(work.taken.keys.begin(), work.taken.keys.end());
  waiting = {};
  work.is_taken = true;
  return batch;
}

void WorkQueue::drop_if_unused(Patches::iterator patch) {
  if (patch->second.is_taken || !patch->second.waiting.empty()) return;
  if (patch->second.begun != nullptr) {
    count_begun(patch->second.begun_by, false);
    if (dropped_ == nullptr) dropped_ = std::move(patch->second.begun);
  }
  patches_.erase(patch);
}

void WorkQueue::drop_if_unused(FlowId flow) {
  const auto found = flows_.find(flow);
  if (found != flows_.end() && found->second.jobs == 0 && found->second.in_flight == 0 &&
      found->second.begun == 0)
    flows_.erase(found);
}

}  // namespace talus::server
