// The log of a world that only this server writes. One thread applies entries and writes them to the
// database; once they are durable it makes them the state and answers.
#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "edits/batch_dates.h"
#include "edits/edit_log.h"
#include "edits/entry_queue.h"
#include "edits/store_writer.h"
#include "runtime/clock.h"

namespace talus::server {

struct LocalLogSettings : StoreWriterSettings {
  EntryQueueLimits queue;
};

class LocalLog final : public EditLog {
 public:
  static constexpr std::size_t kBatchEntries = 1'024;
  static constexpr std::size_t kBatchBytes = std::size_t{512} << 10U;

  /// Called on the log's thread.
  using OnChanged = StoreWriter::OnChanged;

  /// `database`, `state`, which is of that database, and `clock` outlive this. From here on only the
  /// log changes them.
  LocalLog(store::EditDatabase& database, EditState& state, const Clock& clock,
           const LocalLogSettings& settings, OnChanged on_changed);
  /// Applies and answers accepted entries, writes all dirty chunks, and stops.
  ~LocalLog() override;

  [[nodiscard]] tl::expected<void, EditError> append(LogEntry entry, Callback done) override;

  struct State {
    edits::Head head;
    std::size_t waiting = 0;
    std::optional<std::string> read_only;  // why no entries are accepted, in one line
    bool gone = false;                     // the store's files were deleted or replaced
    BatchDates::Jumps clock_jumps;
    std::string disk_wait;  // that writes wait for the disk, in one line; empty if they do not
  };
  /// Any thread.
  [[nodiscard]] State status() const;

  /// Does what the destructor does, before it. Refuses further entries at once. Not on the log's thread.
  void stop();

 private:
  using Queue = EntryQueue<LogEntry>;

  void run();
  void watch_clock();
  /// Moves from `entries`.
  void apply(std::vector<Queue::Item>& entries);
  /// Stages the entries as a batch and moves their callbacks to `done`. Returns false if overrides that they
  /// need cannot be read. `careful` checks each edit for that first, answers it, and stages the others.
  [[nodiscard]] bool stage(std::vector<Queue::Item>& entries, bool careful, std::vector<Callback>& done);

  store::EditDatabase& database_;
  EditState& state_;
  const Clock& clock_;
  BatchDates dates_;  // used by the thread only
  mutable std::mutex mutex_;
  BatchDates::Jumps clock_jumps_;  // guarded by mutex_
  Queue queue_;
  StoreWriter writer_;  // used by the thread only
  std::thread thread_;
};

}  // namespace talus::server
