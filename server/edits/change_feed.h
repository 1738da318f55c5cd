// Notifies sessions of edited chunks in their Views.
//
// One thread gathers changes and sends them at most every kInterval, so that single edits wake no session and
// many edits of a chunk become one change. A session receives changes in its own boxes only. If it waits for
// the log's answer, it is not woken for kWithAnswer, so that changes and answer leave in one write. Bounded:
// on overflow of kMaxGathered chunks, or of a Mailbox, changes collapse into "any chunk may have changed".
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
  /// Waits for the thread. Gathered changes that were not sent are dropped.
  ~ChangeFeed();
  ChangeFeed(const ChangeFeed&) = delete;
  ChangeFeed& operator=(const ChangeFeed&) = delete;

  /// Starts the thread; once.
  void start();

  /// Replaces the boxes of the mailbox's owner; empty: removes the mailbox. After std::bad_alloc it is
  /// removed, too.
  void watch(const MailboxPtr& mailbox, std::span<const LevelBox> boxes);

  /// Chunks were changed. Readers of their revisions must find these already. Does not block.
  void on_changed(std::span<const ChunkChange> changes) noexcept;

  // The thread's work; not on two threads at once.
  /// Sends the gathered changes now. Sessions that expect an answer of the log are not woken.
  void send();
  /// Wakes the sessions that send() did not wake, unless they have taken their mail.
  void wake_held();
  [[nodiscard]] bool has_held() const { return !held_.empty(); }

  /// Number of mailboxes with boxes.
  [[nodiscard]] std::size_t watchers() const;

 private:
  struct Watcher {
    MailboxPtr mailbox;
    std::vector<LevelBox> boxes;
    std::vector<ChunkChange> own;  // in this round
  };
  struct Notification {
    MailboxPtr mailbox;
    ChunkChangesPtr changes;  // null: any
  };

  void run();
  /// A notification was lost: the owner must end.
  void lose(Mailbox& mailbox, const std::exception& error) const;
  [[nodiscard]] bool has_gathered() const { return any_changed_ || !gathered_.empty(); }
  void remove(const Watcher& watcher);
  /// Notifications for all watchers that any chunk may have changed.
  [[nodiscard]] std::vector<Notification> notify_all();
  /// Notifications of the changes for the sessions that watch them.
  [[nodiscard]] std::vector<Notification> notifications_of(std::span<const ChunkChange> changes);
  /// Adds a change to each session that watches it, and sessions without changes so far to `watchers`.
  void find_watchers(const ChunkChange& change, std::vector<Watcher*>& watchers);

  const Logger log_;

  std::mutex gathering_;
  std::condition_variable changed_;
  std::unordered_map<ChunkKey, ChunkChange> gathered_;
  bool any_changed_ = false;
  bool stopping_ = false;
  bool thread_waits_ = false;  // for changes
  std::thread thread_;
  std::vector<MailboxPtr> held_;  // used by the thread only; not woken yet

  mutable std::mutex watching_;
  std::unordered_map<ClientId, Watcher> watchers_;
  std::unordered_map<BoxCell, std::vector<Watcher*>, BoxCellHash> cells_;
  std::array<std::size_t, BoxCell::kScales> entries_of_scale_{};
};

}  // namespace talus::server
