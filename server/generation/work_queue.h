// What the generators have yet to do, and whose turn it is. For one thread; GenerationPool locks.
//
// A job is one chunk, however many clients wait for it; it is dropped with its last waiter. Jobs are grouped
// by patch, and a patch is worked on by one thread at a time.
//
// Clients take turns by deficit round robin. A turn is worth a new patch; a client spends it on patches of
// its own, in the order in which it asked, and between them on heights. Whoever else waits for chunks of the
// patch gets them with it, for nothing: a job is done in the turn of the waiter whose turn comes first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <variant>
#include <vector>

#include <talus/terrain/heights.h>
#include <talus/voxel/coords.h>

#include "chunks/mailbox.h"
#include "generation/deficit_round_robin.h"
#include "generation/patch.h"
#include "generation/work_costs.h"
#include "memory/hysteresis_gate.h"

namespace talus::server {

/// Columns whose heights the mailbox's owner waits for. It never gives a ticket twice, so that an answer
/// which a cancellation missed is told from a later one.
struct HeightsTask {
  MailboxPtr mailbox;
  std::uint64_t ticket = 0;
  std::vector<terrain::BaseColumn> columns;
};

class WorkQueue {
 public:
  struct Batch {
    PatchKey patch;
    std::vector<ChunkKey> keys;  // first those for which the turn's client waits
  };
  struct Work {
    std::variant<Batch, HeightsTask> what;
    ClientId client{};        // whose turn it was
    std::uint64_t price = 0;  // what it has paid
  };

  /// Full with `max_jobs` jobs, until fewer than three quarters of them are left.
  WorkQueue(int patch_tiles, std::size_t max_jobs);

  /// Lets the mailbox's owner wait for the chunk; once, however often it asks. False where that needs a new
  /// job and the queue is full.
  [[nodiscard]] bool add(const MailboxPtr& mailbox, ChunkKey key);
  void add(HeightsTask task);
  [[nodiscard]] bool has_job(ChunkKey key) const { return jobs_.contains(key); }
  [[nodiscard]] bool full() const { return !gate_.open(); }

  /// No effect where the client does not wait for the chunk.
  void cancel(ClientId client, ChunkKey key);
  /// No effect where the task is not waiting any more.
  void cancel_heights(ClientId client, std::uint64_t ticket);

  /// The next piece of work, if any may be begun. A Batch's patch is the taker's until release().
  [[nodiscard]] std::optional<Work> take(const WorkCosts& costs = {});
  /// The piece is done and did cost `cost`: its client pays the difference, or gets it back.
  void reconcile(const Work& work, std::uint64_t cost);
  /// Whether somebody still waits for a chunk of a taken batch; where not, the job is gone.
  [[nodiscard]] bool begin(ChunkKey key);
  /// Ends the job; its waiters are the caller's to answer.
  [[nodiscard]] std::vector<MailboxPtr> finish(ChunkKey key);
  void release(const PatchKey& patch);

  [[nodiscard]] std::size_t jobs() const { return jobs_.size(); }
  /// How many jobs more it would take.
  [[nodiscard]] std::size_t free_jobs() const { return full() ? 0 : max_jobs_ - jobs_.size(); }
  /// Those with something waiting.
  [[nodiscard]] std::size_t clients() const;

 private:
  struct Job {
    PatchKey patch;
    std::vector<MailboxPtr> waiters;
    bool taken = false;
  };
  struct PatchWork {
    std::vector<ChunkKey> waiting;
    bool taken = false;
  };
  struct Client {
    std::deque<PatchKey> order;                        // exactly the keys of `jobs`
    std::unordered_map<PatchKey, std::uint32_t> jobs;  // waiting ones of each patch
    std::deque<HeightsTask> heights;
    bool heights_next = true;   // heights and patches take turns, where it waits for both
    std::size_t in_flight = 0;  // pieces taken in its turns and not reconciled
    [[nodiscard]] bool idle() const { return order.empty() && heights.empty(); }
  };
  using Clients = std::unordered_map<ClientId, Client>;

  Client& enter(ClientId client);
  /// The client waits for one job less of the patch.
  void leave(ClientId client, const PatchKey& patch);
  void drop_if_done(Clients::iterator client);
  [[nodiscard]] bool can_begin(const Client& client, const WorkCosts& costs) const;
  [[nodiscard]] std::deque<PatchKey>::const_iterator free_patch(const Client& client) const;
  /// The first piece of a client that can begin one.
  [[nodiscard]] Work take_of(ClientId id, const WorkCosts& costs);
  [[nodiscard]] Batch take_patch(const PatchKey& patch, ClientId client);
  void drop_if_unused(const PatchKey& patch);
  void note_jobs() {
    gate_.update([this] { return jobs_.size(); });
  }

  const int patch_tiles_;
  const std::size_t max_jobs_;
  HysteresisGate gate_;
  std::unordered_map<ChunkKey, Job> jobs_;
  std::unordered_map<PatchKey, PatchWork> patches_;
  Clients clients_;  // those with something waiting or in flight
  DeficitRoundRobin<ClientId> turns_;
};

}  // namespace talus::server
