// Notifies sessions of edited chunks in their Views.
//
// Changes are gathered, and sent at most every kInterval by one thread: an edit wakes no session by itself,
// and many edits of a chunk are one change. Each session receives the changes in its own boxes alone. A
// session that waits for the log's answer is about to be woken by that: changes and answer then leave in one
// write, so nothing else wakes it for kWithAnswer. Bounded: beyond kMaxGathered chunks, and beyond what a
// Mailbox takes of its own, "any chunk may have changed" is sent instead.
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
  /// Waits for the thread. Changes that were gathered and not sent are never sent.
  ~ChangeFeed();
  ChangeFeed(const ChangeFeed&) = delete;
  ChangeFeed& operator=(const ChangeFeed&) = delete;

  /// Starts the thread; once.
  void start();

  /// Replaces the boxes in which the mailbox's owner is notified of changes; empty: it is notified of none,
  /// and the mailbox is released. Throws std::bad_alloc, and then the owner is notified of none.
  void watch(const MailboxPtr& mailbox, std::span<const LevelBox> boxes);

  /// Records changes. Their revisions must be visible already. Does not wait for other threads.
  void on_changed(std::span<const ChunkChange> changes) noexcept;

  // The thread calls these; not on two threads at once.
  /// Sends the gathered changes. Sessions that expect an answer of the log are not woken, but held.
  void send();
  /// Wakes the held sessions that have not taken their mail yet.
  void wake_held();
  [[nodiscard]] bool has_held() const { return !held_.empty(); }

  /// Returns the number of clients with boxes.
  [[nodiscard]] std::size_t watchers() const;

 private:
  struct Watcher {
    MailboxPtr mailbox;
    std::vector<LevelBox> boxes;
    std::vector<ChunkChange> own;  // changes to be sent to it now
  };
  struct Notification {
    MailboxPtr mailbox;
    ChunkChangesPtr changes;  // null: any chunk may have changed
  };

  void run();
  /// Ends the mailbox's owner, to which changes could not be sent.
  void lose(Mailbox& mailbox, const std::exception& error) const;
  [[nodiscard]] bool has_gathered() const { return any_changed_ || !gathered_.empty(); }
  void remove(const Watcher& watcher);
  /// Returns a notification for every watcher, that any chunk may have changed.
  [[nodiscard]] std::vector<Notification> notify_all();
  /// Returns a notification for every watcher of some of the chunks.
  [[nodiscard]] std::vector<Notification> notify_watchers(std::span<const ChunkChange> changes);
  /// Adds a change to the watchers of its chunk, and a watcher that had no change before to `watchers`.
  void find_watchers(const ChunkChange& change, std::vector<Watcher*>& watchers);

  const Logger log_;

  std::mutex gathering_;
  std::condition_variable changed_;
  std::unordered_map<ChunkKey, ChunkChange> gathered_;
  bool any_changed_ = false;
  bool stopping_ = false;
  bool thread_waits_ = false;  // for changes
  std::thread thread_;
  std::vector<MailboxPtr> held_;  // of the thread alone

  mutable std::mutex watching_;
  std::unordered_map<ClientId, Watcher> watchers_;
  std::unordered_map<BoxCell, std::vector<Watcher*>, BoxCellHash> cells_;
  std::array<std::size_t, BoxCell::kScales> entries_of_scale_{};
};

}  // namespace talus::server
