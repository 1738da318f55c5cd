// The log of a world that one server has alone: one thread applies what comes, writes it to the database, and
// only when that is on the disk makes it the state and answers.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "clock/clock.h"
#include "edits/edit_log.h"
#include "edits/edit_state.h"
#include "edits/flusher.h"
#include "store/edit_database.h"

namespace talus::server {

struct LocalLogSettings {
  std::size_t queue_entries = 8'192;
  std::size_t queue_bytes = std::size_t{32} << 20U;
  std::size_t flush_bytes = std::size_t{8} << 20U;  // of what is not flushed
  std::chrono::milliseconds flush_interval{4'000};
  std::chrono::milliseconds retry_interval{1'000};
  std::uint64_t free_bytes = std::uint64_t{256} << 20U;  // of the disk: with less no edits are taken
};

class LocalLog final : public EditLog {
 public:
  static constexpr std::size_t kBatchEntries = 1'024;
  static constexpr std::size_t kBatchBytes = std::size_t{512} << 10U;

  /// Called on the log's thread, after the answers of a batch, with every chunk that it changed.
  using OnChanged = std::function<void(std::span<const ChunkChange>)>;

  /// `database`, `state`, which is of that database, and `clock` outlive this. From here on nobody else may
  /// change them.
  LocalLog(EditDatabase& database, EditState& state, const Clock& clock, const LocalLogSettings& settings,
           OnChanged on_changed);
  /// Applies and answers what was taken, writes all that is dirty, and stops.
  ~LocalLog() override;

  [[nodiscard]] tl::expected<void, LogFailure> append(LogEntry entry, Done done) override;

  struct Status {
    edits::Head head;
    std::size_t waiting = 0;
    std::optional<std::string> read_only;  // why no entries are taken, in one line
  };
  /// Any thread.
  [[nodiscard]] Status status() const;

  /// As the destructor, which then has nothing to do. Refuses further entries at once. Not on the log's
  /// thread.
  void stop();

 private:
  using TimePoint = std::chrono::steady_clock::time_point;

  struct Waiting {
    LogEntry entry;
    Done done;
    std::size_t bytes = 0;
  };
  /// A batch that is being written. Where that failed its outcome is open, so that it alone may be written
  /// next.
  struct Pending {
    Pending(const EditState& state, std::int64_t now_ms)
        : reading{state}, batch{reading, state.editors(), state.head(), now_ms} {}
    EditState::Reading reading;
    edits::Batch batch;
    std::vector<Done> done;  // of its entries; empty once they were told that it failed
  };

  /// Where the index is full: that the edit changes no chunk that was never edited. One that only might let
  /// material slide into such a chunk sets nothing loose.
  [[nodiscard]] tl::expected<void, LogFailure> keep_to_index(edits::EditEntry& edit) const;

  void run();
  /// What waits, as much as goes into a batch. Waits for it itself, until `until` at most.
  [[nodiscard]] std::vector<Waiting> take(TimePoint until);
  void apply(std::vector<Waiting> entries);
  /// Makes the pending batch of those that can be applied. Where some cannot, as what they are of is not
  /// readable, false; `careful` finds out which before anything is made of them, and answers them.
  [[nodiscard]] bool stage(std::vector<Waiting>& entries, bool careful);
  /// Whether the pending batch is stored now, and the state.
  bool store();
  void flush_some();
  void flush_all();
  void check_disk();
  void refuse(std::string reason);
  void retry();
  void publish();

  EditDatabase& database_;
  EditState& state_;
  const Clock& clock_;
  LocalLogSettings settings_;
  OnChanged on_changed_;

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Waiting> queue_;
  std::size_t queue_bytes_ = 0;
  bool stopping_ = false;
  Status status_;  // but for `waiting`

  // The log's thread alone.
  Flusher flusher_;
  std::optional<Pending> pending_;
  bool broken_ = false;  // a write failed
  bool disk_full_ = false;
  TimePoint next_flush_;
  TimePoint next_check_;

  std::thread thread_;
};

}  // namespace talus::server
