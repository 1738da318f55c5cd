// Syncs a store's log on a thread of its own: who writes it does not wait for the disk.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include <talus/store/edit_database.h>

namespace talus::server {

/// Of the thread that writes the database.
class LogSyncer {
 public:
  /// `database`, whose log is elsewhere, outlives this. `on_ended` is called on the syncer's thread when
  /// take_ended() has something.
  explicit LogSyncer(store::EditDatabase& database, std::function<void()> on_ended = {});
  /// Waits for the sync that is under way.
  ~LogSyncer();
  LogSyncer(const LogSyncer&) = delete;
  LogSyncer& operator=(const LogSyncer&) = delete;

  /// All that was written so far is on the disk once a sync of this number, or of a greater one, has ended
  /// well. Where one is under way another follows it.
  std::uint64_t begin();
  struct Ended {
    std::uint64_t number = 0;
    store::EditDatabase::Written written;
    store::EditDatabase::Done done;
  };
  /// The sync that ended last, once.
  [[nodiscard]] std::optional<Ended> take_ended();
  /// The database was opened again: that a sync failed that was begun before is told no more.
  void forget_errors();
  /// Waits until one has ended that take_ended() did not give. REQUIRES: one was begun that it did not give.
  void wait();

 private:
  void run();

  store::EditDatabase& database_;
  const std::function<void()> on_ended_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t begun_ = 0;  // the newest
  store::EditDatabase::Written written_;
  std::uint64_t run_ = 0;        // the newest that is under way, or was
  std::uint64_t forgotten_ = 0;  // errors up to this one are not told
  std::optional<Ended> ended_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace talus::server
