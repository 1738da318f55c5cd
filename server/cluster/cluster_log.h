// The log of a world that several servers share: what it takes it publishes to a stream, and what comes from
// the stream, of whichever server, it applies in the stream's order. An entry is answered where it was taken,
// once it is applied there.
//
// Four threads: one publishes, one applies and writes the store, one syncs that, one asks the stream's leader
// where its end is.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "cluster/log_end.h"
#include "cluster/log_stream.h"
#include "cluster/publisher.h"
#include "cluster/state_comparison.h"
#include "edits/edit_log.h"
#include "edits/store_writer.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"

namespace talus::server::cluster {

/// Why this server's store cannot go on with the stream. Another server's store can take its place.
enum class Lost : std::uint8_t {
  too_old,      // the stream does not keep what comes next any more
  no_start,     // the store is empty, and the stream begins with a state that is not
  other,        // the stream was made anew, or is that of another state than the store's
  wrong_state,  // most other servers have another state, or this one cannot read its own
};

class ClusterLog final : public EditLog {
 public:
  /// Called on the applier's thread.
  using OnChanged = StoreWriter::OnChanged;

  struct Settings {
    StoreWriterSettings store{};
    edits::SettleRulesPtr settles{};  // by which this world's loose material slides; null: none does
    std::chrono::milliseconds look_interval{500};  // at the stream's end
    /// Who is stuck publishes nothing any more; what was on its way to the stream is there after that.
    std::chrono::milliseconds sure_of_stuck{10'000};
    /// So long every answer says that the stream has another message where this server's last one was.
    std::chrono::milliseconds sure_of_other{15'000};
  };
  /// All outlive this; `database` and `state` are changed by nobody else from here on. The database has its
  /// log elsewhere.
  struct Parts {
    LogStream& stream;
    store::EditDatabase& database;
    EditState& state;
    const Clock& clock;
    Logger log;
    OnChanged on_changed;
    /// takes_entries() has changed. Any thread; must not wait, nor call the log.
    std::function<void()> on_takes = [] {};
    /// The store is lost to the cluster, in one line: once, on a thread of the log's, which applies nothing
    /// any more. Whoever brings another server's store in its place does so after stop(), or in another
    /// process.
    std::function<void(Lost, const std::string&)> on_lost = [](Lost, const std::string&) {};
  };

  ClusterLog(Parts parts, Settings settings);
  ~ClusterLog() override { stop(); }
  ClusterLog(const ClusterLog&) = delete;
  ClusterLog& operator=(const ClusterLog&) = delete;

  /// Starts the threads; once.
  void start();
  /// Takes nothing any more, waits up to two seconds until what was taken is answered, writes all that is
  /// dirty, and ends the threads. Stops the stream. Not on a thread of the log's.
  void stop();

  [[nodiscard]] tl::expected<void, LogFailure> append(LogEntry entry, Done done) override;
  [[nodiscard]] bool takes_entries() const override;
  /// Whether one more may come to edit, before there is an entry; append() asks that too. Where this server
  /// is not at the log's end it does not know all who edit: then the failure is cut_off in place of
  /// editors_full, and soon over. Any thread.
  [[nodiscard]] tl::expected<void, LogFailure> room_for_editor() const;

  struct Status {
    edits::Head head;
    std::size_t waiting = 0;
    std::optional<std::string> read_only;  // why no entries are taken, in one line
    bool ready = false;                    // players may come here
    std::string not_ready;                 // why not, in one line
    bool connected = false;
    std::string late;     // why others' edits come late, up to a second; empty: they do not
    bool quorum = false;  // the stream has a leader that answers
    bool differs = false;
    std::uint64_t lag = 0;  // messages
    std::uint64_t sequence = 0;
    std::uint64_t gaps = 0;
    std::uint64_t republished = 0;
    std::uint64_t skipped = 0;         // messages that no talusd can apply
    std::uint64_t false_messages = 0;  // came altered, or of somebody else: the leader has others
    std::uint64_t bounded = 0;         // batches whose time did not count as they said
    bool stuck = false;                // the next message is for a newer talusd
  };
  /// Any thread.
  [[nodiscard]] Status status() const;
  [[nodiscard]] const LatencyHistogram& publish_latency() const { return publisher_.latency(); }

 private:
  using TimePoint = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::milliseconds kSoon{20};
  static constexpr std::chrono::milliseconds kRetryOfFault{1'000};

  // The applier's thread (cluster_log_applier.cpp).
  void apply_all();
  /// Whether the store's place in the stream is known, and what comes next is to be had; looks once
  /// (cluster_log_place.cpp).
  [[nodiscard]] bool find_place();
  [[nodiscard]] bool begin_at_genesis(const StreamState& stream);
  /// Whether the stream still has, as far as it keeps it, the message that was applied last. One that lost
  /// its end and went on has another there, however long ago that was.
  [[nodiscard]] bool is_as_applied(const StreamState& stream, const store::StreamPlace& place);
  void next_message();
  void cannot_get(const StreamFailure& failure);
  void apply(const StreamMessage& message);
  /// The time of the batch, and what the store is to remember of it; none: to be asked again.
  struct Time {
    std::int64_t ms = 0;
    std::int64_t looked_ms = 0;
  };
  [[nodiscard]] std::optional<Time> time_of(const BatchHead& head, const StreamMessage& message);
  /// Whether the message, which is none, came so by itself: then the leader is asked for it. It is not held
  /// any more.
  bool came_damaged(const StreamMessage& message, const std::string& reason);
  /// The message is one that all servers pass over.
  void skip(const StreamMessage& message, const std::string& reason);
  /// This talusd does not know it: passes over it, unless the stream may have such from there on.
  void meet_unknown(const StreamMessage& message, const MessageFault& fault);
  /// It is one that others may know. `reason`: and what would be right.
  void get_stuck(const StreamMessage& message, const std::string& reason);
  /// `said`: of the batch; null: it was none.
  void finish(std::vector<Done> done, const store::StreamPlace& place, const BatchHead* said);
  /// What the message changes is not to be had from the disk.
  void cannot_read(const std::string& reason);
  void can_read();
  void compare(const BatchHead& head);
  void applied(std::uint64_t sequence);
  /// False: stop() was called.
  bool pause(std::chrono::milliseconds time);

  // The watching thread.
  void watch();
  void look_at_end();

  // Any thread.
  /// What it is while this server is not at the log's end.
  [[nodiscard]] LogFailure unless_behind(LogFailure failure) const;
  /// Whether nothing had stopped it before.
  bool stop_applying(std::string reason);
  void lose(Lost how, const std::string& reason);
  void trouble(std::string reason);
  void tell_whether_it_takes();
  [[nodiscard]] bool stopping() const;
  /// Nobody goes on behind the message where this server is stuck, as far as is known: another would be no
  /// better, so that players may look on here. Under the mutex.
  [[nodiscard]] bool all_are_stuck() const;
  /// The leader did not answer at the start, and the store has its place: chunks are served as they are on
  /// the disk, as they would be if the leader had gone later, until it says where the end is. Under the
  /// mutex.
  [[nodiscard]] bool begins_without_log() const;

  const Parts parts_;
  const Settings settings_;
  const store::StoreIdentity identity_;
  StoreWriter writer_;
  Publisher publisher_;

  // The applier's thread alone.
  bool placed_ = false;
  std::optional<StreamMessage> held_;     // came, and could not be applied
  int unread_ = 0;                        // how often what it changes could not be read
  std::optional<TimePoint> other_since_;  // another message has been where the last one was
  StateComparison comparison_;
  std::uint64_t none_newer_to_ = 0;  // up to this message the stream has none for a newer talusd
  TimePoint skip_told_{};            // in the log
  TimePoint damage_told_{};
  TimePoint clock_told_{};

  std::mutex telling_;      // locked before mutex_
  bool was_taking_ = true;  // as on_takes was told; under that

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  LogEnd end_;
  std::uint64_t sequence_ = 0;  // of the last message that is applied
  std::int64_t created_ns_ = 0;
  bool shorter_ = false;                    // the stream seems to have less than was applied
  std::optional<TimePoint> shorter_since_;  // since when the leader has said so, without a silence
  bool heard_ = false;                      // it ever did, of where this server has its place
  bool began_silent_ = false;               // it did not when it was asked before that
  bool places_known_ = false;
  std::string fault_;                // why nothing is applied any more
  std::string trouble_;              // why nothing is applied just now
  bool trouble_is_silence_ = false;  // of the leader, when it is asked for the end
  std::string undecided_;            // as many say this as say that
  std::string unreadable_;           // what the next message changes, and the disk does not give
  bool differs_ = false;
  std::uint64_t skipped_ = 0;
  std::uint64_t bounded_ = 0;
  std::optional<TimePoint> stuck_since_;       // the next message is for a newer talusd
  bool was_ready_ = false;                     // then
  std::optional<std::uint64_t> stuck_at_end_;  // the last message that others had published by then
  bool others_go_on_ = false;                  // somebody published later
  bool stopping_ = false;                      // no entries are taken
  bool ending_ = false;                        // the threads end

  std::thread applier_;
  std::thread watcher_;
};

}  // namespace talus::server::cluster
