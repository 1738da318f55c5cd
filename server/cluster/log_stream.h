// The stream that the servers of one world share: opaque messages in one order, stored by a majority of
// hosts. Sequences begin with 1 and have no gaps: a number that has no message counts as an empty message.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "cluster/log_format.h"

namespace talus::server {

struct StreamMessage {
  std::uint64_t sequence = 0;
  std::vector<std::byte> bytes;
  /// Time at which the stream took it, as time_of() returns, if known.
  std::optional<std::int64_t> time_ms{};
  bool of_leader = true;  // false: it was pushed; ask_again() requests the leader's
};

/// State reported by the stream's leader. `enabled` is at least as new as `last`: the procedure for enabling
/// a format waits until every replica knows it (FORMAT.md).
struct StreamState {
  std::uint64_t first = 0;            // sequence of the oldest kept message; last + 1 if none is kept
  std::uint64_t last = 0;             // 0: the stream is empty
  std::int64_t created_ns = 0;        // since 1970; identifies the stream among streams of this name
  std::uint64_t bytes = 0;            // of all kept messages, including the stream's overhead
  cluster::EnabledFormats enabled{};  // formats that messages may have
};

struct StreamFailure {
  enum class Kind : std::uint8_t {
    unavailable,    // no connection or quorum; retries succeed eventually
    refused,        // missing permissions or different settings; an operator must act
    too_large,      // publish(): the stream does not take a message of this size, and has not stored this one
    rejected,       // publish(): the stream takes no message for now, and has not stored this one
    gone,           // the message is older than all kept ones
    other,          // the stream was recreated or lost messages; it is not the one that was read before
    false_message,  // next() returned a message that is not the stream's, so the applied state differs
  };
  Kind kind = Kind::unavailable;
  std::string reason;  // one line
};

/// Statistics since the stream was opened.
struct StreamFigures {
  bool connected = false;
  std::uint64_t gaps = 0;            // messages that had to be requested
  std::uint64_t false_messages = 0;  // forged messages received
  std::string late{};                // why messages are requested instead of pushed; may be empty
};

/// Used by two threads: one calls publish(), the other next(); other calls are thread-safe. After `other` or
/// `false_message` nothing is published any more.
class LogStream {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  virtual ~LogStream() = default;

  /// Returns the message's sequence once a majority has stored it. After a failure the message may be or
  /// become stored. Waits at most about half a second.
  [[nodiscard]] virtual tl::expected<std::uint64_t, StreamFailure> publish(
      std::span<const std::byte> message) = 0;

  /// Returns message `after` + 1; nullopt if there is none by `until`, or after wake(). `after` is 0 at
  /// first, then the previous result's sequence.
  [[nodiscard]] virtual tl::expected<std::optional<StreamMessage>, StreamFailure> next(std::uint64_t after,
                                                                                       TimePoint until) = 0;

  /// The last message of next() cannot be the stream's: unless the leader returned it, next() returns it
  /// again as the leader has it. Call on next()'s thread.
  virtual void ask_again() {}

  /// Asks the leader. Also `unavailable` if messages cannot be read. Waits at most about two seconds.
  [[nodiscard]] virtual tl::expected<StreamState, StreamFailure> state() = 0;

  /// Time at which the stream took a message, in ms since 1970 by the clock of its leader then; the same for
  /// every caller at any time. Waits at most about two seconds.
  [[nodiscard]] virtual tl::expected<std::int64_t, StreamFailure> time_of(std::uint64_t sequence) = 0;

  [[nodiscard]] virtual StreamFigures figures() const { return {}; }

  /// Makes the current or next call of next() return soon.
  virtual void wake() = 0;

  /// From now on all calls fail at once, including waiting ones.
  virtual void stop() = 0;
};

}  // namespace talus::server
