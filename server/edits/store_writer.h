// The part of a log that writes the store: stages a batch, writes it, makes it the state, answers, flushes
// dirty chunks, and checks the disk.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <talus/store/edit_database.h>
#include <talus/store/store_watch.h>

#include "edits/edit_log.h"
#include "edits/edit_state.h"
#include "edits/flusher.h"
#include "edits/log_syncer.h"
#include "edits/pending_write.h"
#include "runtime/clock.h"

namespace talus::server {

struct StoreWriterSettings {
  std::size_t flush_bytes = std::size_t{32} << 20U;  // of dirty chunks
  std::chrono::milliseconds flush_interval{4'000};
  std::chrono::milliseconds retry_interval{1'000};       // also between syncs, if batches are not synced
  std::uint64_t free_bytes = std::uint64_t{256} << 20U;  // free disk space below which edits are refused
};

/// For the log's thread, except status().
class StoreWriter {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  /// Called after the answers of a batch, with every chunk that it changed.
  using OnChanged = std::function<void(std::span<const ChunkChange>)>;

  /// A write that waits longer than this for the disk is reported.
  static constexpr std::chrono::seconds kDiskPatience{5};

  /// `database`, `state`, which is of that database, and `clock` outlive this, and from here on only this
  /// changes the first two. `wake`, for a shared log: called on any thread when poll() is due earlier than
  /// next_poll() returned.
  StoreWriter(store::EditDatabase& database, EditState& state, const Clock& clock,
              const StoreWriterSettings& settings, OnChanged on_changed, std::function<void()> wake = {});

  struct State {
    edits::Head head;
    store::StreamPlace stream;
    std::optional<std::string> read_only;  // why writes fail, in one line
    bool gone = false;                     // the store's files were deleted or replaced
    std::string disk_wait;                 // that writes wait for the disk, in one line; empty if they do not
  };
  /// Any thread.
  [[nodiscard]] State status() const;
  /// Any thread: true if status() has read_only; takes no lock.
  [[nodiscard]] bool is_read_only() const { return is_read_only_.load(std::memory_order_acquire); }
  [[nodiscard]] const std::optional<std::string>& read_only() const { return status_.read_only; }

  /// Begins a batch of that date on the current state. REQUIRES: !has_batch().
  [[nodiscard]] edits::Batch& begin(std::int64_t date_ms);
  [[nodiscard]] const EditState::Reader& reading() const { return pending_->reading; }
  [[nodiscard]] bool has_batch() const { return pending_.has_value(); }
  void drop() { pending_.reset(); }
  /// Writes the batch, makes it the state and calls `done`, which has the callbacks of its first entries.
  /// Returns false if the write failed: the outcome is unknown and only this batch may be written next;
  /// poll() retries it.
  bool store(std::vector<EditLog::Callback> done, const store::StreamPlace& place);
  /// Takes the callbacks of a batch whose write failed; they are not called here any more.
  [[nodiscard]] std::vector<EditLog::Callback> take_done();

  /// True if writes fail now. Any thread.
  [[nodiscard]] bool is_broken() const { return broken_; }
  /// True if edits must be refused.
  [[nodiscard]] bool refuses() const { return broken_ || disk_full_; }
  /// The store is at another place of the stream, without a batch; the place is on the disk.
  void entered() { publish(); }

  /// Flushes, checks the disk, and retries failed writes, each when it is due.
  void poll();
  /// When poll() is due next; TimePoint::min(): now.
  [[nodiscard]] TimePoint next_poll() const;
  /// Writes all dirty chunks and editors, unless writes fail.
  void flush_all();

 private:
  struct PendingBatch {
    PendingBatch(const EditState& state, const edits::Head& head, const edits::MaterialIds& materials)
        : reading{state}, batch{reading, state.editors(), head, head.time_ms, &materials} {}
    EditState::Reader reading;
    edits::Batch batch;
    std::vector<EditLog::Callback> done;
    store::StreamPlace place;
  };

  bool write();
  void flush_some();
  /// Begins a sync of the written batches.
  void sync();
  /// For a shared log: handles the result of the last sync.
  void hear_sync();
  /// True if the values that the flusher wrote are synced.
  [[nodiscard]] tl::expected<bool, std::string> is_put_synced();
  /// Blocks while the flusher waits for a sync.
  void wait_for_sync();
  /// Refuses writes while the store's files are gone from their place.
  void check_place();
  void check_disk();
  void refuse(std::string reason);
  void retry();
  void publish();
  [[nodiscard]] std::string disk_wait_text() const;

  store::EditDatabase& database_;
  EditState& state_;
  const StoreWriterSettings settings_;
  const OnChanged on_changed_;
  PendingWrite pending_write_;
  std::optional<LogSyncer> syncer_;  // for a shared log; otherwise each batch is synced at once
  std::uint64_t synced_to_ = 0;      // the last successful sync
  std::uint64_t flush_sync_ = 0;     // the sync that the flusher waits for; 0 if it does not wait
  Flusher flusher_;
  std::optional<PendingBatch> pending_;
  const store::StoreWatch watch_;
  std::atomic<bool> broken_{false};  // a write failed, or would be lost
  bool gone_ = false;                // broken_, because the store's files were deleted or replaced
  bool disk_full_ = false;
  TimePoint next_flush_;
  TimePoint next_check_;

  mutable std::mutex mutex_;
  State status_;
  std::atomic<bool> is_read_only_{false};  // changes with status_
};

}  // namespace talus::server
