// A server's writing end of the shared log: a thread with one message in flight. Entries that arrive
// meanwhile wait for the next message, sent when the pace allows (message_pace.h). A message is republished
// with the same bytes until the stream acknowledges it or it appears there; it is applied only once.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "cluster/log_stream.h"
#include "cluster/message.h"
#include "cluster/message_pace.h"
#include "edits/edit_log.h"
#include "edits/entry_queue.h"
#include "runtime/clock.h"
#include "runtime/metrics/instruments.h"

namespace talus::server::cluster {

class Publisher {
 public:
  /// After this time without an acknowledgement entries are rejected.
  static constexpr std::chrono::milliseconds kPatience{2'000};
  static constexpr std::chrono::milliseconds kRetry{20};
  static constexpr std::chrono::milliseconds kRetryRejected{500};
  /// Memory limit for the entries of one message, except a single entry.
  static constexpr std::size_t kBatchBytes = kMaxMessageBytes;

  /// A server's state.
  struct Stand {
    std::uint64_t revision = 0;
    edits::StateHash hash;
  };
  /// The referenced objects must outlive this.
  struct Parts {
    LogStream& stream;
    const Clock& clock;
    store::StoreIdentity identity;
    std::uint32_t server_number = 0;
    edits::SettleRulesPtr settles;    // for entries that settle; null: none does
    std::function<Stand()> stand;     // current state; called on any thread
    std::function<void()> on_change;  // takes() has changed; on any thread. Must not wait
  };

  explicit Publisher(Parts parts);
  ~Publisher() { stop(); }
  Publisher(const Publisher&) = delete;
  Publisher& operator=(const Publisher&) = delete;

  void start();
  /// Ends the thread without answering queued or pending entries. The stream must have been stopped.
  void stop();
  /// Stops publishing for good. Entries not in a message yet are rejected as cut_off; entries in a message,
  /// whose outcome is unknown, are answered as unwritable. Callable from any thread.
  void give_up(const std::string& why);

  [[nodiscard]] std::uint64_t id() const { return id_; }

  /// Fails with cut_off while the stream accepts nothing, and with out_of_range if the entry does not fit
  /// into a message; one that does not fit with its secrets reveals none. Callable from any thread.
  [[nodiscard]] tl::expected<void, EditError> append(LogEntry entry, EditLog::Callback done);
  /// The next message will report the state `stand`. Callable from any thread.
  void say(const Stand& stand);

  /// True if the stream lets append() accept entries. Callable from any thread.
  [[nodiscard]] bool takes() const { return takes_.load(std::memory_order_acquire); }
  /// Why the stream last rejected messages; empty if it accepts them. Callable from any thread.
  [[nodiscard]] std::string trouble() const;

  /// Called for a batch seen in the stream. Returns the callbacks of its entries if it is this server's and
  /// seen first; otherwise empty. Callable from any thread.
  [[nodiscard]] std::vector<EditLog::Callback> seen(const BatchHead& head,
                                                    std::span<const std::byte> message);

  /// True if it is this server's batch and was not seen before. Callable from any thread.
  [[nodiscard]] bool is_open(const BatchHead& head, std::span<const std::byte> message) const;
  /// This machine's clock is wrong, and `time_ms` is the current time: batches are dated from it, by elapsed
  /// time. Callable from any thread.
  void go_by(std::int64_t time_ms);

  /// Number of unanswered entries.
  [[nodiscard]] std::size_t open() const;
  [[nodiscard]] const LatencyHistogram& latency() const { return latency_; }
  [[nodiscard]] std::uint64_t republished() const { return republished_.total(); }

 private:
  struct EncodedMessage {
    store::Bytes bytes;
  };
  using Queue = EntryQueue<EncodedMessage>;
  /// A message not seen in the stream yet.
  struct OpenMessage {
    std::vector<EditLog::Callback> done;
    std::vector<std::byte> seal;  // the message's checksum
    bool seen = false;
  };

  /// A message that is not published again: the stream takes none of this size, or none for now.
  struct NotStored {
    StreamFailure::Kind kind{};  // too_large or rejected
    std::string reason{};
    bool may_be_stored = false;  // by an earlier attempt, whose outcome is unknown
  };

  void run();
  [[nodiscard]] std::int64_t time_ms() const;
  /// Publishes the entries in one message, or in halves if the stream takes no message of that size. An
  /// entry that is too large by itself is rejected as out_of_range. If the stream takes no message for now,
  /// all are rejected as cut_off, and a message without entries is published until it does.
  void send(const Stand& stand, std::span<const store::Bytes> entries, std::vector<EditLog::Callback> done);
  /// Publishes until the message is stored, unless it `may_give_up`.
  [[nodiscard]] std::optional<NotStored> publish(std::uint64_t number, std::span<const std::byte> message,
                                                 bool may_give_up);
  /// True if the message need not be published again.
  [[nodiscard]] bool wait_for_retry(std::uint64_t number, std::chrono::milliseconds pause);
  void set_takes(bool takes);
  void refuse(const std::vector<Queue::Item>& waiting) const;
  void refuse_all();
  void answer_open();
  static void answer(const std::vector<EditLog::Callback>& done, EditError error);
  static void answer_unknown(const std::vector<EditLog::Callback>& done, std::string_view why);
  [[nodiscard]] EditError cut_off() const;

  const Parts parts_;
  const std::uint64_t id_;
  Queue queue_;
  std::atomic<bool> takes_{true};
  LatencyHistogram latency_;
  Counter republished_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::uint64_t, OpenMessage> open_;  // by batch number
  std::optional<Stand> to_say_;
  std::string trouble_;
  struct RightTime {
    std::int64_t ms = 0;
    std::chrono::steady_clock::time_point at;
  };
  std::optional<RightTime> right_time_;
  bool stopping_ = false;
  bool gave_up_ = false;

  // Used by the publishing thread.
  std::uint64_t number_ = 0;  // last batch
  MessagePace pace_;
  std::thread thread_;
};

}  // namespace talus::server::cluster
