// Syncs a store's log on a thread of its own, so that the writer does not wait for the disk.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include <talus/store/edit_database.h>

#include "edits/pending_write.h"
#include "runtime/clock.h"

namespace talus::server {

/// For the thread that writes the database.
class LogSyncer {
 public:
  /// `database`, of a shared log, and `clock` outlive this. `on_ended` is called on the syncer's thread when
  /// take_ended() has something.
  LogSyncer(store::EditDatabase& database, const Clock& clock, std::function<void()> on_ended = {});
  /// Waits for the current sync.
  ~LogSyncer();
  LogSyncer(const LogSyncer&) = delete;
  LogSyncer& operator=(const LogSyncer&) = delete;

  /// Requests a sync. All writes so far are durable once a sync with the returned number, or a greater one,
  /// has succeeded. If a sync is in progress another follows it.
  std::uint64_t begin();
  struct SyncResult {
    std::uint64_t number = 0;
    store::EditDatabase::SyncPoint written;
    store::EditDatabase::Status done;
  };
  /// The last ended sync, once.
  [[nodiscard]] std::optional<SyncResult> take_ended();
  /// The database was reopened: failures of syncs that began before are not reported.
  void forget_errors();
  /// Blocks until take_ended() has a result. REQUIRES: a sync was begun whose result it has not returned.
  void wait();
  /// How long the current sync has waited for the disk. Any thread.
  [[nodiscard]] Clock::duration sync_age() const { return pending_.age(); }

 private:
  void run();

  store::EditDatabase& database_;
  const std::function<void()> on_ended_;
  PendingWrite pending_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t begun_ = 0;  // the newest
  store::EditDatabase::SyncPoint written_;
  std::uint64_t run_ = 0;        // the newest that was started
  std::uint64_t forgotten_ = 0;  // errors up to this one are not reported
  std::optional<SyncResult> ended_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace talus::server
