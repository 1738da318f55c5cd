#include "edits/local_log.h"

#include <utility>

#include "edits/admission/log_admission.h"

namespace talus::server {
namespace {

/// Chunks of all levels whose overrides the edit may read.
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

}  // namespace

LocalLog::LocalLog(store::EditDatabase& database, EditState& state, const Clock& clock,
                   const LocalLogSettings& settings, OnChanged on_changed)
    : database_{database},
      state_{state},
      clock_{clock},
      dates_{clock},
      queue_{settings.queue},
      writer_{database, state, clock, settings, std::move(on_changed)} {
  thread_ = std::thread{[this] { run(); }};
}

LocalLog::~LocalLog() {
  stop();
}

void LocalLog::stop() {
  queue_.stop();
  if (thread_.joinable()) thread_.join();
}

tl::expected<void, EditError> LocalLog::append(LogEntry entry, Callback done) {
  if (auto admitted = admit_to_log(entry, state_, clock_); !admitted) return admitted;
  if (writer_.is_read_only()) {
    if (auto read_only = writer_.status().read_only) {
      return edit_error(EditErrorCode::unwritable, *std::move(read_only));
    }
  }
  const std::size_t bytes = bytes_of(entry);
  return queue_.put({std::move(entry), std::move(done), bytes});
}

LocalLog::State LocalLog::status() const {
  StoreWriter::State status = writer_.status();
  const std::lock_guard lock{mutex_};
  return {status.head, queue_.size(), std::move(status.read_only),
          status.gone, clock_jumps_,  std::move(status.disk_wait)};
}

void LocalLog::run() {
  std::vector<Queue::Item> entries;
  while (!queue_.ended()) {
    entries = queue_.take(kBatchEntries, kBatchBytes, writer_.next_poll(), std::move(entries));
    if (!entries.empty()) apply(entries);
    entries.clear();
    writer_.poll();
    watch_clock();
  }
  writer_.flush_all();
}

void LocalLog::watch_clock() {
  (void)dates_.after(state_.head().time_ms);
  const std::lock_guard lock{mutex_};
  clock_jumps_ = dates_.jumps();
}

void LocalLog::apply(std::vector<Queue::Item>& entries) {
  if (writer_.refuses()) {
    const auto failure = edit_error(EditErrorCode::unwritable, *writer_.read_only());
    for (const Queue::Item& each : entries) each.done(failure);
    return;
  }
  std::vector<Callback> done;
  if (!stage(entries, false, done)) {
    writer_.drop();
    (void)stage(entries, true, done);
  }
  if (done.empty()) return writer_.drop();
  if (writer_.store(std::move(done), database_.meta().stream)) return;
  const auto failure = edit_error(EditErrorCode::unwritable, *writer_.read_only());
  for (const Callback& each : writer_.take_done()) each(failure);
}

bool LocalLog::stage(std::vector<Queue::Item>& entries, bool careful, std::vector<Callback>& done) {
  edits::Batch& batch = writer_.begin(dates_.after(state_.head().time_ms));
  batch.expect(entries.size());
  const EditState::Reader& reading = writer_.reading();
  for (Queue::Item& each : entries) {
    const auto* const edit = std::get_if<edits::EditEntry>(&each.entry);
    if (careful && edit != nullptr) {
      if (const auto fault = reading.fault_of(chunks_read_by(*edit))) {
        std::exchange(each.done, nullptr)(edit_error(EditErrorCode::unreadable, *fault));
        continue;
      }
    }
    std::visit([&](const auto& entry) { batch.apply(entry); }, each.entry);
    if (reading.error() && !careful) return false;
  }
  done.reserve(entries.size());
  for (Queue::Item& each : entries) {
    if (each.done != nullptr) done.push_back(std::move(each.done));
  }
  return true;
}

}  // namespace talus::server
