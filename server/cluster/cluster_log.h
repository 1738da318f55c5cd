// The log of a world shared by several servers. Accepted entries are published to a stream; messages of the
// stream, from any server, are applied in its order. An entry is answered on the server that accepted it,
// once it is applied there.
//
// Four threads: one publishes, one applies and writes the store, one syncs it, and one asks the stream's
// leader for the stream's end.
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

/// Reason why this server's store cannot continue with the stream. Another server's store can replace it.
enum class StoreLoss : std::uint8_t {
  too_old,      // the stream no longer keeps the next message
  no_start,     // the store is empty, but the stream begins with a non-empty state
  other,        // the stream was recreated, or belongs to a different state
  wrong_state,  // most other servers have another state, or this one cannot read its own
};

class ClusterLog final : public EditLog {
 public:
  /// Called on the applier's thread.
  using OnChanged = StoreWriter::OnChanged;

  struct Settings {
    StoreWriterSettings store{};
    edits::SettleRulesPtr settles{};  // the world's rules for sliding material; null: nothing slides
    std::chrono::milliseconds poll_interval{500};  // between requests for the stream's end
    /// Stuck servers stop publishing; after this time everything in flight is in the stream.
    std::chrono::milliseconds sure_of_stuck{10'000};
    /// Time during which every answer must report another message in place of this server's last one.
    std::chrono::milliseconds sure_of_other{15'000};
    std::chrono::milliseconds last_wait{2'000};  // of stop(), for answers
  };
  /// The referenced objects must outlive this; from here on only this changes `database` and `state`. The
  /// database must have log_elsewhere set.
  struct Parts {
    LogStream& stream;
    store::EditDatabase& database;
    EditState& state;
    const Clock& clock;
    Logger log;
    OnChanged on_changed;
    /// Called when takes_entries() changes, on any thread. Must not wait or call the log.
    std::function<void()> on_takes = [] {};
    /// Called once, with a one-line reason, on a thread of the log, if the store is lost to the cluster;
    /// nothing is applied any more. Another server's store may replace it only after stop(), or in another
    /// process.
    std::function<void(StoreLoss, const std::string&)> on_lost = [](StoreLoss, const std::string&) {};
  };

  ClusterLog(Parts parts, Settings settings);
  ~ClusterLog() override { stop(); }
  ClusterLog(const ClusterLog&) = delete;
  ClusterLog& operator=(const ClusterLog&) = delete;

  /// Starts the threads; call once.
  void start();
  /// Rejects new entries, waits up to `last_wait` for accepted ones to be answered, flushes, stops the
  /// stream, and ends the threads. Must not be called on a thread of the log.
  void stop();

  [[nodiscard]] tl::expected<void, EditError> append(LogEntry entry, Callback done) override;
  [[nodiscard]] bool takes_entries() const override;
  /// Checks for room for one more editor before there is an entry; append() checks that too. A server that is
  /// not at the log's end does not know all editors; its failure is cut_off instead of editors_full, and
  /// temporary. Callable from any thread.
  [[nodiscard]] tl::expected<void, EditError> room_for_editor() const;

  struct State {
    edits::Head head;
    std::size_t waiting = 0;
    std::optional<std::string> read_only;  // why entries are rejected, in one line
    bool ready = false;                    // players may come here
    std::string not_ready;                 // all reasons in one line, the gravest first
    bool connected = false;
    std::string disk_wait;  // that writes wait for the disk, in one line; empty if they do not
    std::string late;       // why edits of others are delayed by up to a second; empty if they are not
    bool quorum = false;    // the stream has a leader that answers
    bool differs = false;
    std::uint64_t lag = 0;  // messages
    std::uint64_t sequence = 0;
    std::uint64_t gaps = 0;
    std::uint64_t republished = 0;
    std::uint64_t skipped = 0;         // messages that no talusd can apply
    std::uint64_t false_messages = 0;  // altered or forged; the leader has others
    std::uint64_t bounded = 0;         // batches whose stated time was bounded
    bool stuck = false;                // the next message is for a newer talusd
  };
  /// Callable from any thread.
  [[nodiscard]] State status() const;
  [[nodiscard]] const LatencyHistogram& publish_latency() const { return publisher_.latency(); }

 private:
  using TimePoint = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::milliseconds kSoon{20};
  static constexpr std::chrono::milliseconds kRetryOfFault{1'000};

  // Called on the applier's thread (cluster_log_applier.cpp).
  void apply_all();
  /// True if the store's place in the stream is known and the next message is available; checks once
  /// (cluster_log_place.cpp).
  [[nodiscard]] bool find_place();
  [[nodiscard]] bool begin_at_genesis(const StreamState& stream);
  /// True if the stream, as far as it keeps it, still has the last applied message. A stream that lost its
  /// end and went on has another message there, no matter how long ago.
  [[nodiscard]] bool is_as_applied(const StreamState& stream, const store::StreamPlace& place);
  void next_message();
  void cannot_get(const StreamFailure& failure);
  void apply(const StreamMessage& message);
  /// The batch's time and the store's new asked_ms; nullopt: try again.
  struct Time {
    std::int64_t ms = 0;
    std::int64_t asked_ms = 0;
  };
  [[nodiscard]] std::optional<Time> time_of(const BatchHead& head, const StreamMessage& message);
  /// True if the message, which cannot be decoded, was pushed: then it is dropped and requested from the
  /// leader.
  bool came_damaged(const StreamMessage& message, const std::string& reason);
  /// Skips a message that all servers skip.
  void skip(const StreamMessage& message, const std::string& reason);
  /// Handles a message of unknown format: skips it, unless the stream may have newer formats from there on.
  void meet_unknown(const StreamMessage& message, const MessageFault& fault);
  /// Stops at a message that other servers may know. `reason` includes the remedy.
  void get_stuck(const StreamMessage& message, const std::string& reason);
  /// `said` is the batch's head; null if the message was not a batch.
  void finish(std::vector<Callback> done, const store::StreamPlace& place, const BatchHead* said);
  /// Handles a failure to read chunks that the message changes.
  void cannot_read(const std::string& reason);
  void can_read();
  void compare(const BatchHead& head);
  void applied(std::uint64_t sequence);
  /// Returns false if stop() was called.
  bool pause(std::chrono::milliseconds time);

  // Called on the watching thread.
  void watch();
  void poll_end();

  // Callable from any thread.
  /// Replaces editors_full by cut_off while this server is not at the log's end.
  [[nodiscard]] EditError unless_behind(EditError error) const;
  /// Returns true if applying was not stopped before.
  bool stop_applying(std::string reason);
  void lose(StoreLoss how, const std::string& reason);
  void trouble(std::string reason);
  void tell_whether_it_takes();
  [[nodiscard]] bool stopping() const;
  /// True if, as far as is known, no server passes the message at which this one is stuck: other servers are
  /// no better, so players may stay here. Requires the mutex.
  [[nodiscard]] bool all_are_stuck() const;
  /// Why this server is not ready, the gravest first; `read_only`: why entries are rejected. Requires the
  /// mutex.
  [[nodiscard]] std::string reasons(const StoreWriter::State& store, const std::string& read_only,
                                    bool is_behind) const;
  /// True if the leader did not answer at the start, but the store has its place: chunks are served from the
  /// disk, as if the leader had been lost later, until it reports the end. Requires the mutex.
  [[nodiscard]] bool begins_without_log() const;

  const Parts parts_;
  const Settings settings_;
  const store::StoreIdentity identity_;
  StoreWriter writer_;
  Publisher publisher_;

  // Used only by the applier's thread.
  bool placed_ = false;
  std::optional<StreamMessage> held_;     // received, but could not be applied yet
  int unread_ = 0;                        // failed attempts to read chunks that it changes
  std::optional<TimePoint> other_since_;  // another message is in place of the last applied one
  StateComparison comparison_;
  std::uint64_t none_newer_to_ = 0;  // no message up to this one is for a newer talusd
  TimePoint skip_told_{};            // last logged
  TimePoint damage_told_{};
  TimePoint clock_told_{};

  std::mutex telling_;      // locked before mutex_
  bool was_taking_ = true;  // last value reported by on_takes; guarded by telling_

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  LogEnd end_;
  std::uint64_t sequence_ = 0;  // last applied message
  std::int64_t created_ns_ = 0;
  bool shorter_ = false;                    // the stream seems shorter than what was applied
  std::optional<TimePoint> shorter_since_;  // the leader has kept reporting that since then
  bool heard_ = false;                      // the leader has answered since the place is known
  bool began_silent_ = false;               // it failed to answer before that
  bool places_known_ = false;
  std::string fault_;                // permanent reason for not applying
  std::string trouble_;              // temporary reason for not applying
  bool is_refused_ = false;          // trouble_ is what the leader said about the stream, and names the cause
  bool trouble_is_silence_ = false;  // trouble_ is that the leader did not report the end
  std::string undecided_;            // equal numbers of servers have each state
  std::string unreadable_;           // chunks of the next message that the disk cannot deliver
  bool differs_ = false;
  std::uint64_t skipped_ = 0;
  std::uint64_t bounded_ = 0;
  std::optional<TimePoint> stuck_since_;       // the next message is for a newer talusd
  bool was_ready_ = false;                     // at stuck_since_
  std::optional<std::uint64_t> stuck_at_end_;  // the stream's end once surely stuck
  bool others_go_on_ = false;                  // another server published later
  bool stopping_ = false;                      // entries are rejected
  bool ending_ = false;                        // the threads end

  std::thread applier_;
  std::thread watcher_;
};

}  // namespace talus::server::cluster
