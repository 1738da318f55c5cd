// What every log does with its store: stages a batch, writes it, makes it the state, answers, flushes what is
// dirty, and minds the disk.
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

#include "edits/edit_log.h"
#include "edits/edit_state.h"
#include "edits/flusher.h"
#include "edits/log_syncer.h"

namespace talus::server {

struct StoreWriterSettings {
  std::size_t flush_bytes = std::size_t{32} << 20U;  // of what is not flushed
  std::chrono::milliseconds flush_interval{4'000};
  std::chrono::milliseconds retry_interval{1'000};       // between syncs, too, where batches are not
  std::uint64_t free_bytes = std::uint64_t{256} << 20U;  // of the disk: with less no edits are taken
};

/// Of the log's thread, but for status().
class StoreWriter {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  /// Called after the answers of a batch, with every chunk that it changed.
  using OnChanged = std::function<void(std::span<const ChunkChange>)>;

  /// `database` and `state`, which is of that database, outlive this. From here on nobody else may change
  /// them. `wake`, of a log that is elsewhere: any thread, when look() is due before next_look() said.
  StoreWriter(store::EditDatabase& database, EditState& state, const StoreWriterSettings& settings,
              OnChanged on_changed, std::function<void()> wake = {});

  struct Status {
    edits::Head head;
    store::StreamPlace stream;
    std::optional<std::string> read_only;  // why nothing can be written, in one line
  };
  /// Any thread.
  [[nodiscard]] Status status() const;
  /// Any thread: whether status() says why, without a lock.
  [[nodiscard]] bool is_read_only() const { return is_read_only_.load(std::memory_order_acquire); }
  [[nodiscard]] const std::optional<std::string>& read_only() const { return status_.read_only; }

  /// A batch on the state as it is. REQUIRES: there is none.
  [[nodiscard]] edits::Batch& begin(std::int64_t now_ms);
  [[nodiscard]] const EditState::Reading& reading() const { return pending_->reading; }
  [[nodiscard]] bool has_batch() const { return pending_.has_value(); }
  void drop() { pending_.reset(); }
  /// Whether the batch is stored now, and the state; then each of `done`, those of its first entries, was
  /// called. Else its outcome is open, so that it alone may be written next: look() tries that.
  bool store(std::vector<EditLog::Done> done, const store::StreamPlace& place);
  /// Of a batch whose write failed: nobody is called for it any more.
  [[nodiscard]] std::vector<EditLog::Done> take_done();

  /// Whether nothing can be written now.
  [[nodiscard]] bool is_broken() const { return broken_; }
  /// Whether no edits may be taken.
  [[nodiscard]] bool refuses() const { return broken_ || disk_full_; }
  /// The store stands at another place of the stream, without a batch: `place` is on the disk.
  void entered() { publish(); }

  /// Flushes, looks at the disk, and tries again what failed, each when it is due.
  void look();
  /// When that is due next; TimePoint::min(): now.
  [[nodiscard]] TimePoint next_look() const;
  /// Writes all that is dirty, where anything can be written.
  void flush_all();

 private:
  struct Pending {
    Pending(const EditState& state, std::int64_t now_ms, const edits::MaterialIds& materials)
        : reading{state}, batch{reading, state.editors(), state.head(), now_ms, &materials} {}
    EditState::Reading reading;
    edits::Batch batch;
    std::vector<EditLog::Done> done;
    store::StreamPlace place;
  };

  bool write();
  void flush_some();
  /// Begins a sync of what was written.
  void sync();
  /// Of a log that is elsewhere: what became of the last sync.
  void hear_sync();
  /// Whether what the flusher has put is synced.
  [[nodiscard]] tl::expected<bool, std::string> is_put_synced();
  /// Waits, where the flusher waits for a sync.
  void wait_for_sync();
  void check_disk();
  void refuse(std::string reason);
  void retry();
  void publish();

  store::EditDatabase& database_;
  EditState& state_;
  const StoreWriterSettings settings_;
  const OnChanged on_changed_;
  std::optional<LogSyncer> syncer_;  // where the log is elsewhere: else each batch is synced, which waits
  std::uint64_t synced_to_ = 0;      // the sync that ended well last
  std::uint64_t flush_sync_ = 0;     // that the flusher waits for; 0: none
  Flusher flusher_;
  std::optional<Pending> pending_;
  bool broken_ = false;  // a write failed
  bool disk_full_ = false;
  TimePoint next_flush_;
  TimePoint next_check_;

  mutable std::mutex mutex_;
  Status status_;
  std::atomic<bool> is_read_only_{false};  // changes with status_
};

}  // namespace talus::server
