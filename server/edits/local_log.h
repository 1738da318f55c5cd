// The log of a world that one server has alone: one thread applies what comes, writes it to the database, and
// only when that is on the disk makes it the state and answers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <thread>
#include <vector>

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

  /// `database`, `state`, which is of that database, and `clock` outlive this. From here on nobody else may
  /// change them.
  LocalLog(store::EditDatabase& database, EditState& state, const Clock& clock,
           const LocalLogSettings& settings, OnChanged on_changed);
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
  using Queue = EntryQueue<LogEntry>;

  void run();
  /// Moves from `entries`.
  void apply(std::vector<Queue::Waiting>& entries);
  /// Makes a batch of those that can be applied, and moves their answers to `done`. Where some cannot, as
  /// what they are of is not readable, false; `careful` finds out which before anything is made of them, and
  /// answers them.
  [[nodiscard]] bool stage(std::vector<Queue::Waiting>& entries, bool careful, std::vector<Done>& done);

  store::EditDatabase& database_;
  EditState& state_;
  const Clock& clock_;
  Queue queue_;
  StoreWriter writer_;  // of the thread
  std::thread thread_;
};

}  // namespace talus::server
