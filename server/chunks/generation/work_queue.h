// The work that waits for the generators, and its order. For one thread; GenerationPool locks.
//
// A job is one chunk, however many clients wait for it; it is dropped with its last waiter. Jobs lie with
// their patch, which is worked on by one thread at a time: most are asked for, taken and ended together.
//
// Flows share by a FairQueue, and so do the clients within a flow, and for each client its work wanted soon
// and later. Two kinds of work go before other work until their flow is ahead of its share by kPatchesAhead
// new patches: work of a flow that had none, and work wanted soon. So a player who takes a step, joins or
// jumps does not wait for the far land of others, and a flow that jumps without end has no more in all than
// the others. A client's pieces are its patches, in the order in which it asked, alternating with its
// heights. Other clients that wait for chunks of the patch get them with it at no cost: a job is done in the
// turn of the waiter whose turn comes first.
//
// An expensive piece yields midway: it comes back as it is, and any turn of a client that waits for it
// continues it. What is put back holds memory, so it has a limit, of each flow and in all. Expensive work
// wanted later is not begun while it could not be put back: its client waits in a queue of its own until
// another piece is done.
//
// The queue is shared by dynamic thresholds (Choudhury and Hahne, 1998): a flow may have as many jobs as
// there is room left, and a client as many as its flow has room then. So two flows take a third of the queue
// each, two clients of a flow a third of its part, and the next flow finds room.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include <talus/terrain/heights.h>
#include <talus/voxel/coords.h>

#include "chunks/generation/begun_patch.h"
#include "chunks/generation/heights_task.h"
#include "chunks/generation/patch.h"
#include "chunks/generation/work_costs.h"
#include "chunks/mailbox.h"
#include "limits/flows/fair_queue.h"
#include "limits/flows/flow_use.h"

namespace talus::server {

class WorkQueue {
 public:
  struct Batch {
    PatchKey patch;
    std::vector<ChunkKey> keys;  // first the chunks for which the turn's client waits
    BegunPatchPtr begun{};
  };
  struct Turn {
    FlowId flow{};
    ClientId client{};
    Urgency urgency{};
  };
  struct Work {
    std::variant<Batch, HeightsTask> what;
    Turn turn;                  // in which it was taken
    double price = 0;           // reserved for it in that turn, in new patches
    bool is_expensive = false;  // may be put back
    FlowUsePtr flow_use{};      // gets the cost
  };

  /// The 27 chunks around a player lie over at most four patches, all chunks of a small View over nine.
  static constexpr int kPatchesAhead = 16;

  /// Holds at most `max_jobs` jobs, except that a client that waits for fewer than `own_jobs` of an urgency
  /// may ask for any number of that at once: so a client that waits for nothing is not refused.
  WorkQueue(int patch_tiles, std::size_t max_jobs, std::size_t own_jobs = 0);

  /// Lets the waiter wait for the chunks; for each once, in the version of the first add(). Returns the
  /// number, from the first on: it ends at the first that needs a new job if the queue is full, or if
  /// `new_jobs` is false. Throws std::bad_alloc, and then the owner waits for the chunks before the one that
  /// failed.
  [[nodiscard]] std::size_t add(const Waiter& waiter, std::span<const ChunkKey> keys,
                                Urgency urgency = Urgency::later, bool new_jobs = true);
  /// The client wants the chunk soon, and with it all chunks of its patch for which it waits. No effect if
  /// threads have taken all of them. Throws std::bad_alloc, and then nothing changed.
  void hasten(ClientId client, ChunkKey key);
  void add(HeightsTask task);
  /// Returns true if the client waits for a chunk that no thread has taken.
  [[nodiscard]] bool waits(ClientId client) const { return waiting_of(client) > 0; }
  /// Returns true if a flow that was refused may ask again.
  [[nodiscard]] bool has_room(FlowId flow) const { return of(flow).jobs < free_jobs(); }

  /// No effect if the client does not wait for the chunk.
  void cancel(ClientId client, ChunkKey key);
  /// No effect if the task is done.
  void cancel_heights(ClientId client, std::uint64_t ticket);

  /// The next piece of work, if any may be begun. A Batch's patch is the taker's until release(). Throws
  /// std::bad_alloc, and then nothing was taken.
  [[nodiscard]] std::optional<Work> take(const WorkCosts& costs = {});
  /// Heights that were taken continue at their client's next turn, unless they were cancelled meanwhile.
  /// Before reconcile(). Throws std::bad_alloc, and then the task is what it was.
  void put_back(HeightsTask&& task);
  /// A batch's patch that was begun: the jobs that were not finished wait again. Before reconcile() and
  /// instead of release(). Throws std::bad_alloc, and then the batch is what it was.
  void put_back(Batch&& batch, const Turn& turn);
  /// The piece is done and cost `cost`: the turn's flow and client are charged this instead of the price.
  void reconcile(const Work& work, std::uint64_t cost);
  /// Returns true if a client still waits for a chunk of a taken batch that was not finished; otherwise the
  /// job is gone.
  [[nodiscard]] bool begin(ChunkKey key);
  /// Drops the jobs of a taken batch and returns true, unless a client waits for one of them, or for others
  /// of its patch.
  [[nodiscard]] bool drop_unwanted(const Batch& batch);
  /// Returns true if a piece of this turn that took `spent` so far should be put back now: another client
  /// could begin something that is likely to take less time than the rest of it, and pieces that were put
  /// back do not hold too much memory, of the flow or in all. If all pieces are as expensive each is made
  /// whole, so that the first is soon there.
  [[nodiscard]] bool should_give_way(const Turn& turn, std::uint64_t spent, const WorkCosts& costs) const;
  /// Returns true if heights that were taken were not cancelled since.
  [[nodiscard]] bool is_wanted(const HeightsTask& task) const;
  /// Ends the job. Returns its waiters, which the caller answers.
  [[nodiscard]] std::vector<Waiter> finish(ChunkKey key);
  void release(const PatchKey& patch);

  [[nodiscard]] std::size_t jobs() const { return jobs_; }
  /// Number of pieces that were put back and hold memory.
  [[nodiscard]] std::size_t begun() const { return begun_; }
  /// Returns a patch that was begun and for which no client waits any more; null if there is not one. Destroy
  /// it without the lock: it may be large. If there were several between two calls the others are destroyed
  /// at once.
  [[nodiscard]] BegunPatchPtr take_dropped() { return std::move(dropped_); }
  /// Number of clients with something waiting.
  [[nodiscard]] std::size_t clients() const;

 private:
  struct Job {
    FlowId flow;  // of a waiter; the job counts as its
    std::vector<Waiter> waiters;
    bool ended = false;
  };
  /// Jobs in the order in which they came. Searches begin at the first open one: there are few, or they end
  /// in that order.
  struct Jobs {
    std::vector<ChunkKey> keys;
    std::vector<Job> jobs;  // as many as keys
    std::size_t first = 0;  // all before it are ended
    std::size_t open = 0;   // number of jobs that are not ended
    [[nodiscard]] bool empty() const { return open == 0; }
    /// Returns null if there is no such job, or it is ended.
    [[nodiscard]] Job* find(ChunkKey key);
    /// After it `more` jobs can be added without an allocation.
    void reserve(std::size_t more);
    void add(ChunkKey key, Job job);
    /// Ends the job that find() returned. May move others.
    void end(Job& job);
  };
  struct PatchWork {
    Jobs waiting;
    Jobs taken;  // empty if no thread works on the patch, or it has ended them all
    bool is_taken = false;
    bool hastened = false;  // while it was taken a client began to want it soon
    BegunPatchPtr begun{};
    FlowId begun_by{};
  };
  // Not an array: if the constructor of one of its deques throws, GCC 12 leaks and clang 14 terminates.
  template <typename Value>
  struct ByUrgency {
    Value soon;
    Value later;
    [[nodiscard]] Value& operator[](Urgency urgency) { return urgency == Urgency::soon ? soon : later; }
    [[nodiscard]] const Value& operator[](Urgency urgency) const {
      return urgency == Urgency::soon ? soon : later;
    }
  };
  struct JobsOfPatch {
    std::uint32_t count = 0;
    Urgency urgency{};
  };
  struct Client {
    FlowId flow{};
    ByUrgency<std::deque<PatchKey>> order;           // together exactly the keys of `jobs`
    std::unordered_map<PatchKey, JobsOfPatch> jobs;  // waiting jobs of each patch
    std::deque<HeightsTask> heights;                 // all wanted later
    std::vector<std::uint64_t> taken_heights;        // tickets of tasks that may be put back
    ByUrgency<std::size_t> waiting{};                // jobs, in `jobs`
    bool heights_next = true;                        // heights and patches alternate if it waits for both
    std::size_t in_flight = 0;                       // pieces taken in its turns and not reconciled
    FlowUsePtr flow_use{};
    [[nodiscard]] bool idle() const { return jobs.empty() && heights.empty(); }
    [[nodiscard]] bool wants(Urgency urgency) const {
      return !order[urgency].empty() || (urgency == Urgency::later && !heights.empty());
    }
    [[nodiscard]] std::size_t all_waiting() const { return waiting[Urgency::soon] + waiting[Urgency::later]; }
  };
  using Clients = std::unordered_map<ClientId, Client>;
  using Patches = std::unordered_map<PatchKey, PatchWork>;
  struct Flow {
    std::size_t jobs = 0;
    std::size_t in_flight = 0;  // pieces
    std::size_t begun = 0;
    std::size_t expensive_in_flight = 0;  // pieces
  };

  /// `waiting`: the chunk's job, if there is one and no thread has taken it.
  void add(const Waiter& waiter, ChunkKey key, Urgency urgency, const PatchKey& patch, PatchWork& work,
           Job* waiting);
  Client& enter(const Mailbox& mailbox, Urgency urgency);
  /// All that the client waits for of the patch is wanted soon.
  void hasten(Client& client, ClientId id, const PatchKey& patch);
  /// The client waits for one job less of the patch.
  void leave(ClientId client, const PatchKey& patch);
  void drop_if_done(Clients::iterator client);
  /// If the client waits because no expensive piece may be begun, adds it to to_crowd_out_ if there is room.
  [[nodiscard]] FairState readiness(FlowId flow, ClientId id, Urgency urgency, const WorkCosts& costs);
  /// Returns true if an expensive piece of the flow that is wanted later may be begun.
  [[nodiscard]] bool may_open(FlowId flow, const WorkCosts& costs) const;
  [[nodiscard]] static bool is_expensive(const HeightsTask& task, const WorkCosts& costs);
  [[nodiscard]] bool is_expensive(const PatchKey& patch, const WorkCosts& costs) const;
  /// `opens`: an expensive piece may be begun.
  [[nodiscard]] bool can_begin(const Client& client, Urgency urgency, bool opens,
                               const WorkCosts& costs) const;
  /// Returns true if the client could begin something that is likely to cost less than `max_cost`.
  [[nodiscard]] bool can_begin_for_less(const Client& client, std::uint64_t max_cost,
                                        const WorkCosts& costs) const;
  /// Returns true if the client's first heights may be taken.
  [[nodiscard]] static bool heights_may_begin(const Client& client, bool opens, const WorkCosts& costs);
  /// Returns the first patch of that urgency on which a thread may work for the client.
  [[nodiscard]] std::optional<PatchKey> free_patch(const Client& client, Urgency urgency, bool opens,
                                                   const WorkCosts& costs) const;
  /// Lets a client that was crowded out come back if an expensive piece of its flow may be begun.
  void let_one_in(const WorkCosts& costs);
  void crowd_out();
  void count_begun(FlowId flow, bool more);
  /// Lets all waiters for jobs of `work` that were taken wait for the patch again, without counting them, and
  /// gives all its waiters turns.
  void enter_waiters(const PatchKey& patch, const PatchWork& work, Urgency urgency);
  void leave_where_none_waits(const PatchKey& patch, const PatchWork& work);
  /// Takes the first piece of a client that can begin one.
  [[nodiscard]] Work take_of(const Turn& turn, const WorkCosts& costs);
  [[nodiscard]] Batch take_patch(const PatchKey& patch, ClientId client);
  /// The job counts as another flow's from now on.
  void move(Job& job, FlowId flow);
  /// Ends the job; returns its waiters.
  std::vector<Waiter> erase(Jobs& jobs, Job& job);
  void end_taken(PatchWork& work);
  void drop_if_unused(Patches::iterator patch);
  void drop_if_unused(FlowId flow);
  [[nodiscard]] Flow of(FlowId flow) const;
  [[nodiscard]] std::size_t waiting_of(ClientId client) const;
  [[nodiscard]] std::size_t free_jobs() const { return max_jobs_ - std::min(max_jobs_, jobs_); }
  [[nodiscard]] bool may_add(const Mailbox& mailbox) const;

  const int patch_tiles_;
  const std::size_t max_jobs_;
  const std::size_t own_jobs_;
  std::size_t jobs_ = 0;
  std::size_t begun_ = 0;
  BegunPatchPtr dropped_{};
  Patches patches_;
  Clients clients_;                            // with something waiting or in flight
  std::unordered_map<FlowId, Flow> flows_;     // with jobs, pieces in flight, or something begun
  static constexpr unsigned kShareOfSoon = 3;  // for each client; work wanted later has 1
  FairQueue<FlowId, ClientId, Classes<Urgency, 2, kShareOfSoon>> turns_{
      {FairRule{.lead = kPatchesAhead}, FairRule{}, FairRule{}}};
  double patch_cost_ = 1;  // unit of the turns' costs: of a new patch, or of the longest piece
  std::size_t expensive_in_flight_ = 0;
  FairQueue<FlowId, ClientId> crowded_out_;  // clients whose work wanted later may not be begun yet
  std::vector<std::pair<FlowId, ClientId>> to_crowd_out_;  // while take() looks for a piece
};

}  // namespace talus::server
