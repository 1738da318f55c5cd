#include "edits/store_writer.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace talus::server {

StoreWriter::StoreWriter(store::EditDatabase& database, EditState& state, const Clock& clock,
                         const StoreWriterSettings& settings, OnChanged on_changed,
                         std::function<void()> wake)
    : database_{database},
      state_{state},
      settings_{settings},
      on_changed_{std::move(on_changed)},
      pending_write_{clock},
      flusher_{state, database, [this] { return is_put_synced(); }},
      watch_{database.path()} {
  if (database_.has_log_elsewhere()) syncer_.emplace(database_, clock, std::move(wake));
  const TimePoint now = std::chrono::steady_clock::now();
  next_flush_ = now + settings_.flush_interval;
  next_check_ = now + settings_.retry_interval;
  check_disk();
  publish();
}

StoreWriter::State StoreWriter::status() const {
  std::string disk_wait = disk_wait_text();
  const std::lock_guard lock{mutex_};
  State status = status_;
  status.disk_wait = std::move(disk_wait);
  return status;
}

std::string StoreWriter::disk_wait_text() const {
  const Clock::duration age =
      std::max(pending_write_.age(), syncer_ ? syncer_->sync_age() : Clock::duration{});
  if (age <= kDiskPatience) return {};
  return fmt::format("edits {}: a write has waited for the disk for over {} s; check the disk",
                     database_.path().string(), kDiskPatience.count());
}

edits::Batch& StoreWriter::begin(std::int64_t date_ms) {
  edits::Head head = state_.head();
  head.time_ms = date_ms;
  return pending_.emplace(state_, head, database_.materials()).batch;
}

bool StoreWriter::store(std::vector<EditLog::Callback> done, const store::StreamPlace& place) {
  pending_->done = std::move(done);
  pending_->place = place;
  return write();
}

std::vector<EditLog::Callback> StoreWriter::take_done() {
  return std::exchange(pending_->done, {});
}

bool StoreWriter::write() {
  if (gone_) return false;
  auto written = pending_write_.run([&] { return database_.append(pending_->batch, pending_->place); });
  if (!written) {
    refuse(std::move(written.error()));
    return false;
  }
  const std::vector<ChunkChange> changed = state_.commit(std::move(pending_->batch));
  publish();
  const std::vector<edits::EntryResult>& applied = pending_->batch.applied();
  for (std::size_t i = 0; i < pending_->done.size(); ++i) pending_->done[i](&applied[i]);
  if (!changed.empty() && on_changed_) on_changed_(changed);
  pending_.reset();
  return true;
}

StoreWriter::TimePoint StoreWriter::next_poll() const {
  if (broken_) return next_check_;
  if (!flusher_.is_running()) return std::min(next_flush_, next_check_);
  // The end of a sync wakes the waiting thread.
  return flush_sync_ == 0 ? TimePoint::min() : next_check_;
}

void StoreWriter::poll() {
  hear_sync();
  const TimePoint now = std::chrono::steady_clock::now();
  if (now >= next_check_) {
    next_check_ = now + settings_.retry_interval;
    check_place();
    if (broken_) {
      if (!gone_) retry();
    } else if (database_.has_unsynced()) {
      sync();
    }
    check_disk();
    publish();
  }
  if (!broken_) flush_some();
  // Small edits of chunks with many may dirty more than a slice each time.
  while (!broken_ && state_.dirty_bytes() > 4 * settings_.flush_bytes) {
    wait_for_sync();
    if (!broken_) flush_some();
  }
}

void StoreWriter::sync() {
  if (syncer_) {
    (void)syncer_->begin();
  } else if (auto synced = pending_write_.run([&] { return database_.sync(); }); !synced) {
    refuse(std::move(synced.error()));
  }
}

void StoreWriter::hear_sync() {
  if (!syncer_) return;
  const auto ended = syncer_->take_ended();
  if (!ended) return;
  if (!ended->done) {
    // A database that is broken already is reopened anyway.
    if (!broken_) refuse(ended->done.error());
    return;
  }
  synced_to_ = ended->number;
  database_.end_sync(ended->written);
}

tl::expected<bool, std::string> StoreWriter::is_put_synced() {
  if (!syncer_) {
    if (auto synced = database_.sync(); !synced) return tl::unexpected{std::move(synced.error())};
    return true;
  }
  if (flush_sync_ == 0) flush_sync_ = syncer_->begin();
  if (synced_to_ < flush_sync_) return false;
  flush_sync_ = 0;
  return true;
}

void StoreWriter::wait_for_sync() {
  while (!broken_ && synced_to_ < flush_sync_) {
    syncer_->wait();
    hear_sync();
  }
}

void StoreWriter::flush_some() {
  const TimePoint now = std::chrono::steady_clock::now();
  if (!flusher_.is_running()) {
    if (now < next_flush_ && state_.dirty_bytes() < settings_.flush_bytes) return;
    next_flush_ = now + settings_.flush_interval;
    if (state_.head().position == database_.meta().flushed) return;
    flusher_.start();
  }
  if (auto stepped = pending_write_.run([&] { return flusher_.step(); }); !stepped)
    refuse(std::move(stepped.error()));
}

void StoreWriter::flush_all() {
  if (broken_) return;
  while (flusher_.is_running() || state_.head().position != database_.meta().flushed) {
    if (!flusher_.is_running()) flusher_.start();
    wait_for_sync();
    if (broken_) return;
    // Values that cannot be written are in the log's records, and the next start reads them.
    if (!pending_write_.run([&] { return flusher_.step(); })) return;
  }
  (void)database_.settle();
}

void StoreWriter::check_place() {
  auto gone = watch_.gone();
  gone_ = gone.has_value();
  if (gone_) refuse(*std::move(gone));
}

void StoreWriter::check_disk() {
  const std::uint64_t free = database_.free_bytes();
  disk_full_ = free < settings_.free_bytes;
  if (disk_full_ && !broken_) {
    const std::lock_guard lock{mutex_};
    status_.read_only = fmt::format("edits {}: the disk has {} bytes free; edits are taken again from {} on",
                                    database_.path().string(), free, settings_.free_bytes);
    is_read_only_ = true;
  }
}

void StoreWriter::refuse(std::string reason) {
  broken_ = true;
  next_check_ = std::chrono::steady_clock::now() + settings_.retry_interval;
  const std::lock_guard lock{mutex_};
  status_.gone = gone_;
  status_.read_only = std::move(reason);
  is_read_only_ = true;
}

void StoreWriter::retry() {
  if (auto recovered = database_.recover(); !recovered) {
    refuse(std::move(recovered.error()));
    return;
  }
  broken_ = false;
  // Values that were written and not synced may be lost.
  flush_sync_ = 0;
  if (syncer_) syncer_->forget_errors();
  if (flusher_.is_running()) flusher_.abandon();
  if (pending_) (void)write();
}

void StoreWriter::publish() {
  const std::lock_guard lock{mutex_};
  status_.head = state_.head();
  status_.stream = database_.meta().stream;
  status_.gone = gone_;
  if (!broken_ && !disk_full_) {
    status_.read_only.reset();
    is_read_only_ = false;
  }
}

}  // namespace talus::server
