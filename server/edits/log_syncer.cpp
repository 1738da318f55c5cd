#include "edits/log_syncer.h"

#include <utility>

#include "runtime/signals.h"

namespace talus::server {

LogSyncer::LogSyncer(store::EditDatabase& database, const Clock& clock, std::function<void()> on_ended)
    : database_{database}, on_ended_{std::move(on_ended)}, pending_{clock} {
  thread_ = std::thread{[this] {
    block_signals();
    run();
  }};
}

LogSyncer::~LogSyncer() {
  {
    const std::lock_guard lock{mutex_};
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::uint64_t LogSyncer::begin() {
  std::uint64_t number = 0;
  {
    const std::lock_guard lock{mutex_};
    number = ++begun_;
    written_ = database_.begin_sync();
  }
  changed_.notify_all();
  return number;
}

std::optional<LogSyncer::SyncResult> LogSyncer::take_ended() {
  const std::lock_guard lock{mutex_};
  return std::exchange(ended_, std::nullopt);
}

void LogSyncer::forget_errors() {
  const std::lock_guard lock{mutex_};
  forgotten_ = begun_;
  if (ended_ && !ended_->done) ended_.reset();
}

void LogSyncer::wait() {
  std::unique_lock lock{mutex_};
  changed_.wait(lock, [&] { return ended_.has_value(); });
}

void LogSyncer::run() {
  std::unique_lock lock{mutex_};
  for (;;) {
    changed_.wait(lock, [&] { return stopping_ || run_ < begun_; });
    if (stopping_) return;
    run_ = begun_;
    SyncResult ended{run_, written_, {}};
    lock.unlock();
    ended.done = pending_.run([&] { return database_.sync_log(); });
    lock.lock();
    if (!ended.done && ended.number <= forgotten_) continue;
    // An error is kept whatever other syncs report: the database is reopened then.
    if (!ended_ || ended_->done) ended_ = std::move(ended);
    changed_.notify_all();
    if (!on_ended_) continue;
    lock.unlock();
    on_ended_();
    lock.lock();
  }
}

}  // namespace talus::server
