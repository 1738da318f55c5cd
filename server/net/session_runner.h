// Drives a session over a stream: reads frames into it, writes what it has to say, wakes it for its mail, and
// watches the clock.
//
// Three coroutines on the stream's executor share it, so nothing here is locked. They end when the stream is
// closed; the runner lives as long as the last of them.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <asio/awaitable.hpp>

#include <talus/protocol/frame.h>

#include "net/accepted_connection.h"
#include "net/mail_rounds.h"
#include "net/registry.h"
#include "net/stream.h"
#include "net/timed_event.h"
#include "net/view_throttle.h"
#include "net/view_turns.h"
#include "net/watchdog.h"
#include "net/write_batch_size.h"
#include "player/session/session.h"
#include "runtime/log/logger.h"

namespace talus::server {

/// What every session of a server is run by.
struct RunnerLimits {
  std::uint32_t frame_bytes = 0;  // of one frame of the client
  std::size_t queued_bytes = 0;   // that wait for the client, above which nothing more is read
  SessionTimeouts timeouts;
};

/// What runners share. What it refers to lives as long as it, or outlives all runners.
struct RunnerContext {
  SessionContext session;
  RunnerLimits limits;
  Registry& registry;
  Logger log;
};
using RunnerContextPtr = std::shared_ptr<const RunnerContext>;

/// So much may wait for each client even where the server has no memory to spare.
inline constexpr std::size_t kQueuedBytesAnyway = std::size_t{16} * 1024;

template <Stream S>
class SessionRunner final : public Peer, public std::enable_shared_from_this<SessionRunner<S>> {
 public:
  [[nodiscard]] static std::shared_ptr<SessionRunner> make(S stream, ConnectionInfo connection,
                                                           Admission::Slot slot, RunnerContextPtr context);

  /// Once, from any thread.
  void start();
  [[nodiscard]] std::optional<Clock::time_point> session_since() const override {
    return connection_.accepted;
  }
  [[nodiscard]] std::optional<std::uint16_t> proxy_port() const override { return connection_.proxy_port; }
  void go_away(const std::string& reason, std::chrono::milliseconds retry_after) override;
  void access_changed() override;
  void rates_changed() override;
  /// Lets every coroutine look at the clock again: for who moves a ManualClock. On the stream's executor.
  void clock_moved();

 private:
  struct Owner;  // whom the mailbox wakes

 public:
  /// make() calls it.
  SessionRunner(S stream, ConnectionInfo connection, Admission::Slot slot, RunnerContextPtr context,
                const std::shared_ptr<Owner>& owner);

 private:
  [[nodiscard]] asio::awaitable<void> read();
  [[nodiscard]] asio::awaitable<void> on_bytes(std::span<const std::byte> bytes);
  /// When the View that waits is to be applied; max() where none does, or it is not its turn.
  [[nodiscard]] Clock::time_point view_due();
  void apply_view();
  /// Now, or, where that is not its turn, by watch() in time.
  void apply_view_when_due();
  /// Reads nothing while too_much() is true.
  [[nodiscard]] asio::awaitable<void> pause_reading(bool (SessionRunner::*too_much)() const);
  [[nodiscard]] asio::awaitable<void> write();
  /// Where write() waits and there are answers and updates alone, few bytes of them: writes them without a
  /// coroutine's turn. What the stream does not take at once is left to write(). Whether anything was taken,
  /// so that the session may go on.
  bool write_little();
  [[nodiscard]] asio::awaitable<void> watch();
  void spawn(asio::awaitable<void> (SessionRunner::*loop)());

  /// Lets `event` change the session, in a handler of its own; what that throws ends this connection and no
  /// other.
  template <typename Event>
  void dispatch(Event&& event);
  /// After anything that happened to the session. Returns as Session::pump().
  std::size_t pump();
  /// The client has shut its side, and may still read.
  void input_ended();
  void output_ended();
  void note_greeting();
  void look_at_access();
  void look_at_rates();
  [[nodiscard]] std::string silence() const;
  [[nodiscard]] bool too_much_queued() const {
    const std::size_t queued = session_.queued_bytes();
    return queued > context_.limits.queued_bytes ||
           session_.edit_bytes() > context_.limits.queued_bytes / 4 ||
           (queued > kQueuedBytesAnyway && !context_.session.memory.takes_work());
  }
  [[nodiscard]] bool too_many_views() const { return session_.views_pile_up(); }
  /// Also what was read already waits, which may be dozens of Views of a client that this server kept
  /// waiting.
  [[nodiscard]] bool takes_no_frame() const { return too_much_queued() || session_.views_full(); }
  void end(std::string_view reason);
  [[nodiscard]] Clock::time_point now() const { return clock_.now(); }

  S stream_;
  const ConnectionInfo connection_;
  const RunnerContextPtr kept_context_;
  const RunnerContext& context_;  // that one
  const Clock& clock_;
  std::optional<Admission::Slot> slot_;
  protocol::FrameReader frames_;
  Session session_;

  TimedEvent output_waits_;  // for something to write
  TimedEvent input_waits_;   // for room in the queue, or for the View to be applied
  TimedEvent watch_waits_;   // for the times of the watchdog and of the next View

  Watchdog watchdog_;
  ViewThrottle view_throttle_;
  ViewTurns& view_turns_;  // of the stream's thread
  WriteBatchSize batch_size_;
  struct Unsent {
    Output output;
    std::size_t from = 0;  // so much of it was written
  };
  std::optional<Unsent> unsent_;  // goes before all that the session has to say
  bool reading_paused_ = false;
  bool input_ended_ = false;
  bool output_ended_ = false;
  bool greeted_ = false;
  bool started_ = false;
  bool open_ = true;
  std::array<std::byte, 8192> input_;
};

/// Makes the connection's session and starts it.
void start_session(AcceptedConnection accepted, const RunnerContextPtr& context);

}  // namespace talus::server
