// What the generators have yet to do, and whose turn it is. No threads here: ChunkService locks.
//
// A job is one chunk, however many clients wait for it; it dies with its last waiter. Jobs are grouped by
// patch, a patch is worked on by one thread at a time, and clients take turns: each turn is one patch (or
// one heights task) of the client's own, in the order in which it asked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <variant>
#include <vector>

#include <talus/voxel/coords.h>

#include "generation/chunk_client.h"
#include "generation/patch.h"

namespace talus::server {

class WorkQueue {
 public:
  struct Batch {
    PatchKey patch;
    std::vector<ChunkKey> keys;
  };
  using Work = std::variant<Batch, HeightsTask>;

  WorkQueue(int patch_tiles, std::size_t most_jobs);

  /// Lets `client` wait for the chunk; once, however often it asks. False where the queue is full.
  [[nodiscard]] bool add(const ChunkClientPtr& client, ChunkKey key);
  void add(HeightsTask task);
  [[nodiscard]] bool has_job(ChunkKey key) const { return jobs_.contains(key); }

  void cancel(const ChunkClient& client, ChunkKey key);
  /// No effect where the task is not waiting any more.
  void cancel_heights(const ChunkClient& client, std::uint64_t ticket);

  /// The next piece of work, if any may be begun. A Batch's patch is the taker's until release().
  [[nodiscard]] std::optional<Work> take();
  /// Whether somebody still waits for a chunk of a taken batch; where not, the job is gone.
  [[nodiscard]] bool begin(ChunkKey key);
  /// Ends the job; its waiters are the caller's to answer.
  [[nodiscard]] std::vector<ChunkClientPtr> finish(ChunkKey key);
  void release(const PatchKey& patch);

  [[nodiscard]] std::size_t jobs() const { return jobs_.size(); }
  [[nodiscard]] std::size_t clients() const { return clients_.size(); }

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
    std::deque<PatchKey> order;                        // exactly the keys of `jobs`
    std::unordered_map<PatchKey, std::uint32_t> jobs;  // waiting ones, a patch
    std::deque<HeightsTask> heights;
    [[nodiscard]] bool idle() const { return order.empty() && heights.empty(); }
  };

  Client& enter(const ChunkClient& client);
  void leave(const ChunkClient& client, const PatchKey& patch);
  void leave_if_idle(const ChunkClient& client);
  [[nodiscard]] Batch take_patch(const PatchKey& patch);
  void drop_if_unused(const PatchKey& patch);

  int patch_tiles_;
  std::size_t most_jobs_;
  std::unordered_map<ChunkKey, Job> jobs_;
  std::unordered_map<PatchKey, PatchWork> patches_;
  std::unordered_map<const ChunkClient*, Client> clients_;  // those with something waiting
  std::deque<const ChunkClient*> turns_;                    // exactly the keys of clients_
};

}  // namespace talus::server
