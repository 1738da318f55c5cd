// Tells sessions which chunks of their Views were edited.
//
// Changes are gathered, and told at most every kInterval by one thread: an edit wakes no session by itself,
// and of many edits of a chunk one change is told. Each is told those of its own boxes alone. A session that
// waits for the log's answer is about to be woken by that: changes and answer then leave in one write, so for
// kWithAnswer nothing else wakes it. Bounded: beyond
// kMaxGathered chunks, and beyond what a Mailbox takes of its own, "any chunk may have changed" is told
// instead.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <span>
#include <thread>
#include <unordered_map>
#include <vector>

#include <talus/voxel/view_shape.h>

#include "chunks/box_cells.h"
#include "chunks/chunk_change.h"
#include "chunks/mailbox.h"
#include "runtime/log/logger.h"

namespace talus::server {

/// Callable from any thread.
class ChangeFeed {
 public:
  static constexpr std::chrono::milliseconds kInterval{5};
  static constexpr std::chrono::milliseconds kWithAnswer{2};
  static constexpr std::size_t kMaxGathered = 16'384;

  explicit ChangeFeed(Logger log) : log_{std::move(log)} {}
  /// Waits for the thread. What was gathered and not told stays untold.
  ~ChangeFeed();
  ChangeFeed(const ChangeFeed&) = delete;
  ChangeFeed& operator=(const ChangeFeed&) = delete;

  /// Starts the thread; once.
  void start();

  /// The mailbox's owner is told of changes in these boxes from now on, in place of those before; empty: of
  /// none, and the mailbox is let go. Throws std::bad_alloc, and then the owner is told of none.
  void watch(const MailboxPtr& mailbox, std::span<const LevelBox> boxes);

  /// Chunks were changed. Whoever asks for their revisions must find these already. Waits for nobody.
  void on_changed(std::span<const ChunkChange> changes) noexcept;

  // What the thread does; not on two threads at once.
  /// Tells now what was gathered. Who expects an answer of the log finds it, and is not woken.
  void tell();
  /// Wakes those, but for who has found it by now.
  void wake_held();
  [[nodiscard]] bool has_held() const { return !held_.empty(); }

  /// Who watches anything.
  [[nodiscard]] std::size_t watchers() const;

 private:
  struct Watcher {
    MailboxPtr mailbox;
    std::vector<LevelBox> boxes;
    std::vector<ChunkChange> own;  // of the round
  };
  struct Told {
    MailboxPtr mailbox;
    ChunkChangesPtr changes;  // null: any
  };

  void run();
  /// Its owner is to end: it could not be told.
  void lose(Mailbox& mailbox, const std::exception& error) const;
  [[nodiscard]] bool has_gathered() const { return any_changed_ || !gathered_.empty(); }
  void remove(const Watcher& watcher);
  /// All who watch anything, that any chunk may have changed.
  [[nodiscard]] std::vector<Told> tell_all();
  /// Who watches some of the chunks, and which.
  [[nodiscard]] std::vector<Told> who_watches(std::span<const ChunkChange> changes);
  /// Adds a change to those of who watches it, and who had none before to `watchers`.
  void find_watchers(const ChunkChange& change, std::vector<Watcher*>& watchers);

  const Logger log_;

  std::mutex gathering_;
  std::condition_variable changed_;
  std::unordered_map<ChunkKey, ChunkChange> gathered_;
  bool any_changed_ = false;
  bool stopping_ = false;
  bool thread_waits_ = false;  // for changes
  std::thread thread_;
  std::vector<MailboxPtr> held_;  // the thread's

  mutable std::mutex watching_;
  std::unordered_map<ClientId, Watcher> watchers_;
  std::unordered_map<BoxCell, std::vector<Watcher*>, BoxCellHash> cells_;
  std::array<std::size_t, BoxCell::kScales> entries_of_scale_{};
};

}  // namespace talus::server
