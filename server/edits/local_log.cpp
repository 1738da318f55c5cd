#include "edits/local_log.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace talus::server {
namespace {

/// All chunks whose overrides the edit may read, at every level.
std::vector<ChunkKey> chunks_read_by(const edits::EditEntry& entry) {
  std::vector<ChunkKey> keys;
  for (const auto& [chunk, voxels] : entry.base) {
    keys.push_back({chunk, Lod{}});
    std::vector<edits::OverrideWrite> writes;
    for (const Override& voxel : voxels) writes.push_back({voxel.index, voxel.material});
    for (const edits::ChunkWrites& coarse : edits::coarse_writes(chunk, writes)) keys.push_back(coarse.key);
  }
  return keys;
}

tl::unexpected<LogFailure> failed(LogFailure::Kind kind, std::string reason) {
  return tl::unexpected{LogFailure{kind, std::move(reason)}};
}

}  // namespace

LocalLog::LocalLog(EditDatabase& database, EditState& state, const Clock& clock,
                   const LocalLogSettings& settings, OnChanged on_changed)
    : database_{database},
      state_{state},
      clock_{clock},
      settings_{settings},
      on_changed_{std::move(on_changed)},
      flusher_{state, database} {
  const TimePoint now = std::chrono::steady_clock::now();
  next_flush_ = now + settings_.flush_interval;
  next_check_ = now + settings_.retry_interval;
  check_disk();
  publish();
  thread_ = std::thread{[this] { run(); }};
}

LocalLog::~LocalLog() {
  stop();
}

void LocalLog::stop() {
  {
    const std::lock_guard lock{mutex_};
    stopping_ = true;
  }
  wake_.notify_one();
  if (thread_.joinable()) thread_.join();
}

tl::expected<void, LogFailure> LocalLog::append(LogEntry entry, Done done) {
  if (auto* const edit = std::get_if<edits::EditEntry>(&entry); edit != nullptr && state_.is_full()) {
    if (auto fits = keep_to_index(*edit); !fits) return fits;
  }
  const std::size_t bytes = bytes_of(entry);
  bool wakes = false;
  {
    const std::lock_guard lock{mutex_};
    if (stopping_) return failed(LogFailure::Kind::busy, "this server is about to end");
    if (status_.read_only) return failed(LogFailure::Kind::unwritable, *status_.read_only);
    if (queue_.size() >= settings_.queue_entries || queue_bytes_ + bytes > settings_.queue_bytes) {
      return failed(LogFailure::Kind::busy, "as many edits wait to be written as may");
    }
    wakes = queue_.empty();
    queue_bytes_ += bytes;
    queue_.push_back({std::move(entry), std::move(done), bytes});
  }
  if (wakes) wake_.notify_one();
  return {};
}

tl::expected<void, LogFailure> LocalLog::keep_to_index(edits::EditEntry& edit) const {
  const auto is_new = [&](ChunkCoord chunk) { return state_.revision({chunk, Lod{}}) == 0; };
  if (std::ranges::none_of(edit.base, is_new, &edits::BaseVoxels::value_type::first)) return {};
  // Some of them only so that material may slide into them.
  const auto touched = edits::touched_voxels(edit.edit);
  if (!touched) return {};  // applying says so
  const auto chunk = std::ranges::find_if(*touched, is_new, &edits::TouchedChunk::chunk);
  if (chunk == touched->end()) {
    edit.settles = nullptr;
    return {};
  }
  return failed(LogFailure::Kind::index_full,
                fmt::format("chunk {} was never edited, and the index of edited chunks has its limit of {} "
                            "bytes; edit chunks that were edited before",
                            to_string(chunk->chunk), state_.index_limit()));
}

LocalLog::Status LocalLog::status() const {
  const std::lock_guard lock{mutex_};
  Status status = status_;
  status.waiting = queue_.size();
  return status;
}

void LocalLog::run() {
  for (;;) {
    const bool flushes = flusher_.is_running() && !broken_;
    std::vector<Waiting> entries = take(flushes   ? TimePoint::min()
                                        : broken_ ? next_check_
                                                  : std::min(next_flush_, next_check_));
    const bool none = entries.empty();
    if (!none) apply(std::move(entries));
    const TimePoint now = std::chrono::steady_clock::now();
    if (now >= next_check_) {
      next_check_ = now + settings_.retry_interval;
      if (broken_) retry();
      check_disk();
      publish();
    }
    if (!broken_) flush_some();
    // Small edits of chunks with many may dirty more than a slice each time.
    while (!broken_ && state_.dirty_bytes() > 16 * settings_.flush_bytes) flush_some();
    const std::lock_guard lock{mutex_};
    if (stopping_ && queue_.empty()) break;
  }
  if (!broken_) flush_all();
}

std::vector<LocalLog::Waiting> LocalLog::take(TimePoint until) {
  std::vector<Waiting> taken;
  std::unique_lock lock{mutex_};
  const auto wanted = [&] { return stopping_ || !queue_.empty(); };
  if (until != TimePoint::min()) wake_.wait_until(lock, until, wanted);
  taken.reserve(std::min(queue_.size(), kBatchEntries));
  std::size_t bytes = 0;
  while (!queue_.empty() && taken.size() < kBatchEntries) {
    const std::size_t size = queue_.front().bytes;
    if (!taken.empty() && bytes + size > kBatchBytes) break;
    bytes += size;
    queue_bytes_ -= size;
    taken.push_back(std::move(queue_.front()));
    queue_.pop_front();
  }
  return taken;
}

void LocalLog::apply(std::vector<Waiting> entries) {
  if (broken_ || disk_full_) {
    const auto failure = failed(LogFailure::Kind::unwritable, *status().read_only);
    for (const Waiting& each : entries) each.done(failure);
    return;
  }
  if (!stage(entries, false)) (void)stage(entries, true);
  if (pending_->batch.applied().empty()) {
    pending_.reset();
    return;
  }
  if (store()) return;
  const auto failure = failed(LogFailure::Kind::unwritable, *status().read_only);
  for (const Done& each : std::exchange(pending_->done, {})) each(failure);
}

bool LocalLog::stage(std::vector<Waiting>& entries, bool careful) {
  const auto now = std::chrono::duration_cast<std::chrono::milliseconds>(clock_.wall().time_since_epoch());
  pending_.emplace(state_, now.count());
  const EditState::Reading& reading = pending_->reading;
  for (Waiting& each : entries) {
    const auto* const edit = std::get_if<edits::EditEntry>(&each.entry);
    if (careful && edit != nullptr) {
      if (const auto fault = reading.fault_of(chunks_read_by(*edit))) {
        std::exchange(each.done, nullptr)(failed(LogFailure::Kind::unreadable, *fault));
        continue;
      }
    }
    std::visit([&](const auto& entry) { pending_->batch.apply(entry); }, each.entry);
    if (reading.error() && !careful) return false;
  }
  for (Waiting& each : entries) {
    if (each.done != nullptr) pending_->done.push_back(std::move(each.done));
  }
  return true;
}

bool LocalLog::store() {
  if (auto written = database_.append(pending_->batch); !written) {
    refuse(std::move(written.error()));
    return false;
  }
  const std::vector<ChunkChange> changed = state_.commit(std::move(pending_->batch));
  publish();
  const std::vector<edits::Applied>& applied = pending_->batch.applied();
  for (std::size_t i = 0; i < pending_->done.size(); ++i) pending_->done[i](&applied[i]);
  if (!changed.empty() && on_changed_) on_changed_(changed);
  pending_.reset();
  return true;
}

void LocalLog::flush_some() {
  const TimePoint now = std::chrono::steady_clock::now();
  if (!flusher_.is_running()) {
    if (now < next_flush_ && state_.dirty_bytes() < settings_.flush_bytes) return;
    next_flush_ = now + settings_.flush_interval;
    if (state_.head().position == database_.meta().flushed) return;
    flusher_.start();
  }
  if (auto stepped = flusher_.step(); !stepped) refuse(std::move(stepped.error()));
}

void LocalLog::flush_all() {
  while (flusher_.is_running() || state_.head().position != database_.meta().flushed) {
    if (!flusher_.is_running()) flusher_.start();
    // What cannot be written is in the log's records, and read by the next start.
    if (!flusher_.step()) return;
  }
  (void)database_.settle();
}

void LocalLog::check_disk() {
  const std::uint64_t free = database_.free_bytes();
  disk_full_ = free < settings_.free_bytes;
  if (disk_full_ && !broken_) {
    const std::lock_guard lock{mutex_};
    status_.read_only = fmt::format("edits {}: the disk has {} bytes free; edits are taken again from {} on",
                                    database_.path().string(), free, settings_.free_bytes);
  }
}

void LocalLog::refuse(std::string reason) {
  broken_ = true;
  next_check_ = std::chrono::steady_clock::now() + settings_.retry_interval;
  const std::lock_guard lock{mutex_};
  status_.read_only = std::move(reason);
}

void LocalLog::retry() {
  if (auto recovered = database_.recover(); !recovered) {
    refuse(std::move(recovered.error()));
    return;
  }
  broken_ = false;
  // What was put and not synced may have gone with the fault.
  if (flusher_.is_running()) flusher_.abandon();
  if (pending_ && !store()) return;
  publish();
}

void LocalLog::publish() {
  const std::lock_guard lock{mutex_};
  status_.head = state_.head();
  if (!broken_ && !disk_full_) status_.read_only.reset();
}

}  // namespace talus::server
