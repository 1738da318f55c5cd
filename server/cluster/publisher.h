// One server's writing end of the shared log: a thread with one message in flight. All that comes meanwhile
// waits for the next, which is sent when its pace allows (message_pace.h). A message is published again, with
// the same bytes, until the stream acknowledges it or it is seen in the stream: applying takes it once.
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
  /// After it without an acknowledgement no further entries are taken.
  static constexpr std::chrono::milliseconds kPatience{2'000};
  static constexpr std::chrono::milliseconds kRetry{20};
  /// Of memory that the entries of one message take, but for one alone.
  static constexpr std::size_t kBatchBytes = kMaxMessageBytes;

  /// Where a server stands.
  struct Stand {
    std::uint64_t revision = 0;
    edits::StateHash hash;
  };
  /// All outlive this.
  struct Parts {
    LogStream& stream;
    const Clock& clock;
    store::StoreIdentity identity;
    std::uint32_t server_number = 0;
    edits::SettleRulesPtr settles;    // of all entries that settle; null: none does
    std::function<Stand()> stand;     // now; any thread
    std::function<void()> on_change;  // takes() has changed; any thread. Must not wait
  };

  explicit Publisher(Parts parts);
  ~Publisher() { stop(); }
  Publisher(const Publisher&) = delete;
  Publisher& operator=(const Publisher&) = delete;

  void start();
  /// Ends the thread. What is queued or in flight is not answered. The stream must have been stopped.
  void stop();
  /// Publishes nothing any more, for good. What is in no message is refused as cut_off; of what is in one it
  /// is open whether the stream has it, and it is answered as unwritable. Any thread.
  void give_up(const std::string& why);

  [[nodiscard]] std::uint64_t id() const { return id_; }

  /// Any thread. Refused as cut_off while the stream does not take anything; as too_large where no message
  /// has room for it.
  [[nodiscard]] tl::expected<void, LogFailure> append(LogEntry entry, EditLog::Done done);
  /// The next message says that this server stood there. Any thread.
  void say(const Stand& stand);

  /// Whether append() takes entries, as far as the stream goes. Any thread.
  [[nodiscard]] bool takes() const { return takes_.load(std::memory_order_acquire); }
  /// Why the stream took nothing last; empty: it takes what comes. Any thread.
  [[nodiscard]] std::string trouble() const;

  /// A batch is in the stream: whom to answer, one for each of its entries, the first time; else nobody. Any
  /// thread.
  [[nodiscard]] std::vector<EditLog::Done> seen(const BatchHead& head, std::span<const std::byte> message);

  /// Whether it is a batch of this server's that was not seen before. Any thread.
  [[nodiscard]] bool is_open(const BatchHead& head, std::span<const std::byte> message) const;
  /// This machine's clock is wrong, and `time_ms` is the right time: batches are dated from there on, by the
  /// time that passes. Any thread.
  void go_by(std::int64_t time_ms);

  /// Entries that are not answered.
  [[nodiscard]] std::size_t open() const;
  [[nodiscard]] const LatencyHistogram& latency() const { return latency_; }
  [[nodiscard]] std::uint64_t republished() const { return republished_.total(); }

 private:
  struct Encoded {
    store::Bytes bytes;
  };
  using Queue = EntryQueue<Encoded>;
  /// A message that was not seen in the stream yet.
  struct Open {
    std::vector<EditLog::Done> done;
    std::vector<std::byte> seal;  // its last bytes
    bool seen = false;
  };

  void run();
  [[nodiscard]] std::int64_t time_ms() const;
  void publish(std::uint64_t number, std::span<const std::byte> message);
  /// Whether the message need not be published any more.
  [[nodiscard]] bool wait_for_retry(std::uint64_t number);
  void set_takes(bool takes);
  void refuse(const std::vector<Queue::Waiting>& waiting) const;
  void refuse_all();
  void answer_open();
  [[nodiscard]] LogFailure cut_off() const;

  const Parts parts_;
  const std::uint64_t id_;
  Queue queue_;
  std::atomic<bool> takes_{true};
  LatencyHistogram latency_;
  Counter republished_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::uint64_t, Open> open_;  // by number
  std::optional<Stand> to_say_;
  std::string trouble_;
  struct RightTime {
    std::int64_t ms = 0;
    std::chrono::steady_clock::time_point at;
  };
  std::optional<RightTime> right_time_;
  bool stopping_ = false;
  bool gave_up_ = false;

  // Of the thread.
  std::uint64_t number_ = 0;  // of the last batch
  MessagePace pace_;
  std::thread thread_;
};

}  // namespace talus::server::cluster
