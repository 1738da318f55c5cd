// What the generators have yet to do, and whose turn it is. No threads here: ChunkService locks.
//
// A job is one chunk, however many clients wait for it; it dies with its last waiter. Jobs are grouped by
// patch, and a patch is worked on by one thread at a time.
//
// Clients take turns by deficit round robin (Shreedhar and Varghese, 1995). A turn brings a client as much
// as a new patch costs; it spends that on patches of its own, in the order in which it asked, and between
// them on heights, until nothing is left. The last piece may overdraw, which its next turns pay off, also if
// it has left meanwhile. Who had nothing waiting goes first, once in a round (as flows in FQ-CoDel, RFC
// 8290): a walker's few chunks do not wait for those who always want more. So clients get equal time of the
// generators, whatever they ask for. Who else waits for chunks of the patch gets them with it, for nothing: a
// job is done in the turn of the waiter whose turn comes first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <unordered_map>
#include <variant>
#include <vector>

#include <talus/voxel/coords.h>

#include "generation/chunk_client.h"
#include "generation/patch.h"

namespace talus::server {

/// What work is likely to cost, in any unit.
struct WorkPrices {
  std::uint64_t patch = 1;  // to make one; at least 1
  std::uint64_t chunk = 0;
  std::uint64_t height = 0;                        // a column's
  std::function<bool(const PatchKey&)> at_hand{};  // whether the patch need not be made; unset: none is
  std::size_t most_at_once = SIZE_MAX;             // pieces of one client's that may be under way
};

class WorkQueue {
 public:
  struct Batch {
    PatchKey patch;
    std::vector<ChunkKey> keys;  // first those for which the turn's client waits
  };
  struct Work {
    std::variant<Batch, HeightsTask> what;
    ChunkClientPtr client;    // whose turn it was
    std::uint64_t price = 0;  // what it has paid
  };

  WorkQueue(int patch_tiles, std::size_t most_jobs);

  /// Lets `client` wait for the chunk; once, however often it asks. False where the queue is full.
  [[nodiscard]] bool add(const ChunkClientPtr& client, ChunkKey key);
  void add(HeightsTask task);
  [[nodiscard]] bool has_job(ChunkKey key) const { return jobs_.contains(key); }

  void cancel(const ChunkClient& client, ChunkKey key);
  /// No effect where the task is not waiting any more.
  void cancel_heights(const ChunkClient& client, std::uint64_t ticket);

  /// The next piece of work, if any may be begun. A Batch's patch is the taker's until release().
  [[nodiscard]] std::optional<Work> take(const WorkPrices& prices = {});
  /// What the piece did cost: its client pays the difference, or gets it back.
  void settle(const Work& work, std::uint64_t cost);
  /// Whether somebody still waits for a chunk of a taken batch; where not, the job is gone.
  [[nodiscard]] bool begin(ChunkKey key);
  /// Ends the job; its waiters are the caller's to answer.
  [[nodiscard]] std::vector<ChunkClientPtr> finish(ChunkKey key);
  void release(const PatchKey& patch);

  [[nodiscard]] std::size_t jobs() const { return jobs_.size(); }
  /// Who have something waiting.
  [[nodiscard]] std::size_t clients() const;

 private:
  struct Job {
    PatchKey patch;
    std::vector<ChunkClientPtr> waiters;
    bool taken = false;
  };
  struct PatchWork {
    std::vector<ChunkKey> waiting;
    bool taken = false;
  };
  struct Client {
    std::weak_ptr<ChunkClient> self;
    std::int64_t balance = 0;   // what it may spend; negative: what it owes
    std::size_t under_way = 0;  // pieces taken in its turns and not settled
    bool in_turn = false;
    bool fading = false;         // had nothing waiting when its turn ended; forgotten if so again
    std::deque<PatchKey> order;  // exactly the keys of `jobs`
    std::unordered_map<PatchKey, std::uint32_t> jobs;  // waiting ones, a patch
    std::deque<HeightsTask> heights;
    bool heights_next = true;  // heights and patches take turns, where it waits for both
    [[nodiscard]] bool idle() const { return order.empty() && heights.empty(); }
  };

  Client& enter(const ChunkClientPtr& client);
  void leave(const ChunkClient& client, const PatchKey& patch);
  /// The first piece of the client's own that may be begun.
  [[nodiscard]] std::optional<Work> take_of(Client& client, const WorkPrices& prices);
  /// Whether it has one.
  [[nodiscard]] bool may_begin(const Client& client, const WorkPrices& prices) const;
  [[nodiscard]] std::deque<PatchKey>::const_iterator free_patch(const Client& client) const;
  [[nodiscard]] Batch take_patch(const PatchKey& patch, const ChunkClientPtr& client);
  /// Whose turn it is, of those there are.
  [[nodiscard]] std::deque<const ChunkClient*>& turns() { return fresh_.empty() ? turns_ : fresh_; }
  void end_turn();
  void forget_idle();
  void drop_if_unused(const PatchKey& patch);

  int patch_tiles_;
  std::size_t most_jobs_;
  std::unordered_map<ChunkKey, Job> jobs_;
  std::unordered_map<PatchKey, PatchWork> patches_;
  // Those with something waiting, and until their turn comes those that had; who owes stays until it is paid.
  std::unordered_map<const ChunkClient*, Client> clients_;
  // Exactly the keys of clients_ between them. Those who had nothing waiting go before all others.
  std::deque<const ChunkClient*> fresh_;
  std::deque<const ChunkClient*> turns_;
};

}  // namespace talus::server
