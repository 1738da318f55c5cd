// The stream that the servers of one world share: messages of opaque bytes, in one order, held by a majority
// of hosts. A message's sequence is its place: 1 for the first that ever was, then without gaps.
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
  /// When the stream took it, as time_of() says, where that came with it.
  std::optional<std::int64_t> time_ms{};
  bool of_leader = true;  // else it came by itself, and ask_again() says what the leader has
};

/// What the stream's leader says. `enabled` is not older than `last`: whoever enables another format waits
/// until every replica knows it (FORMAT.md).
struct StreamState {
  std::uint64_t first = 0;            // sequence of the oldest message that is kept; last + 1 where none is
  std::uint64_t last = 0;             // 0: there was none yet
  std::int64_t created_ns = 0;        // since 1970: another number is another stream of the same name
  std::uint64_t bytes = 0;            // of all messages that are kept, with what the stream adds to each
  cluster::EnabledFormats enabled{};  // that its messages may have
};

struct StreamFailure {
  enum class Kind : std::uint8_t {
    unavailable,  // no connection, or no quorum: whoever tries again comes through some time
    refused,      // the credentials do not allow it, or the stream has other settings: a person has to act
    gone,         // the message is older than all that is kept
    other,        // the stream was made anew, or has less than it had: it is not the one that was read before
    false_message,  // one that next() gave is not the stream's: what was applied is not what others have
  };
  Kind kind = Kind::unavailable;
  std::string reason;  // one line
};

/// Of the stream's life so far.
struct StreamFigures {
  bool connected = false;
  std::uint64_t gaps = 0;            // where messages had to be asked for
  std::uint64_t false_messages = 0;  // that somebody else sent as if they were the stream's
  std::string late{};                // why messages do not come by themselves, and are asked for; else empty
};

/// Two threads use it: one calls publish(), the other next(); the others are for any. After `other` or
/// `false_message` nothing is published any more.
class LogStream {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  virtual ~LogStream() = default;

  /// Returns the message's sequence once a majority holds it. After a failure it is open whether the stream
  /// has the message, or comes to have it. Waits about half a second at most.
  [[nodiscard]] virtual tl::expected<std::uint64_t, StreamFailure> publish(
      std::span<const std::byte> message) = 0;

  /// The message of sequence `after` + 1; nothing where there is none until `until`, or once wake() was
  /// called. `after` is 0 at first, or what the call before returned.
  [[nodiscard]] virtual tl::expected<std::optional<StreamMessage>, StreamFailure> next(std::uint64_t after,
                                                                                       TimePoint until) = 0;

  /// The message that next() gave last cannot be the stream's: where it is not of the leader next() gives
  /// that place again, as the leader has it. Of the thread that calls next().
  virtual void ask_again() {}

  /// Asks the leader. `unavailable` also where its messages cannot be read. Waits some two seconds at most.
  [[nodiscard]] virtual tl::expected<StreamState, StreamFailure> state() = 0;

  /// When the stream took a message, in milliseconds since 1970 by the clock of who led it then: the same
  /// whoever asks, and whenever. Waits some two seconds at most.
  [[nodiscard]] virtual tl::expected<std::int64_t, StreamFailure> time_of(std::uint64_t sequence) = 0;

  [[nodiscard]] virtual StreamFigures figures() const { return {}; }

  /// next() returns soon, this time or the next.
  virtual void wake() = 0;

  /// From now on all calls fail at once, those that wait too.
  virtual void stop() = 0;
};

}  // namespace talus::server
