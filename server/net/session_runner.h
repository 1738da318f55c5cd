// Drives a session over a stream: reads frames into it, writes its output, wakes it for its mail, and
// enforces its time-outs.
//
// Three coroutines on the stream's executor share it, so there are no locks. They end when the stream is
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
#include "net/registry.h"
#include "net/rounds.h"
#include "net/stream.h"
#include "net/timed_event.h"
#include "net/view_throttle.h"
#include "net/view_turns.h"
#include "net/watchdog.h"
#include "net/write_batch_size.h"
#include "player/session/session.h"
#include "runtime/log/logger.h"

namespace talus::server {

/// Limits of every session of a server.
struct RunnerLimits {
  std::uint32_t frame_bytes = 0;  // of one frame from the client
  std::size_t queued_bytes = 0;   // queued for the client; above this, reading pauses
  SessionTimeouts timeouts;
};

/// Shared by all runners. Objects that it refers to live as long as it does, or outlive all runners.
struct RunnerContext {
  SessionContext session;
  RunnerLimits limits;
  Registry& registry;
  Logger log;
};
using RunnerContextPtr = std::shared_ptr<const RunnerContext>;

/// Bytes that may be queued for each client even if the server is short of memory.
inline constexpr std::size_t kQueuedBytesAnyway = std::size_t{16} * 1024;

template <Stream S>
class SessionRunner final : public Peer, public std::enable_shared_from_this<SessionRunner<S>> {
 public:
  [[nodiscard]] static std::shared_ptr<SessionRunner> make(S stream, ConnectionInfo connection,
                                                           Admission::Slot slot, RunnerContextPtr context);

  /// Call once, from any thread.
  void start();
  [[nodiscard]] std::optional<Clock::time_point> session_since() const override {
    return connection_.accepted;
  }
  [[nodiscard]] std::optional<std::uint16_t> proxy_port() const override { return connection_.proxy_port; }
  void go_away(const std::string& reason, std::chrono::milliseconds retry_after) override;
  void access_changed() override;
  void rates_changed() override;
  /// Re-evaluates all timers. For tests that advance a ManualClock. On the stream's executor.
  void clock_moved();

 private:
  struct Owner;  // woken by the mailbox

 public:
  /// Called by make().
  SessionRunner(S stream, ConnectionInfo connection, Admission::Slot slot, RunnerContextPtr context,
                const std::shared_ptr<Owner>& owner);

 private:
  [[nodiscard]] asio::awaitable<void> read();
  [[nodiscard]] asio::awaitable<void> on_bytes(std::span<const std::byte> bytes);
  /// Time to apply the pending View; max() without one, or until its turn comes.
  [[nodiscard]] Clock::time_point view_due();
  void apply_view();
  /// Applies it now, or leaves it to watch() if it is not due.
  void apply_view_when_due();
  /// Pauses reading while too_much() returns true.
  [[nodiscard]] asio::awaitable<void> pause_reading(bool (SessionRunner::*too_much)() const);
  [[nodiscard]] asio::awaitable<void> write();
  /// Writes at once, without resuming a coroutine, if write() is idle and the output is a few bytes of
  /// answers and updates. The part that the stream does not accept is left to write(). Returns true if output
  /// was taken, so that the session may go on.
  bool write_little();
  [[nodiscard]] asio::awaitable<void> watch();
  void spawn(asio::awaitable<void> (SessionRunner::*loop)());

  /// Passes the session to `event` in a handler of its own. An exception ends only this connection.
  template <typename Event>
  void dispatch(Event&& event);
  /// Call after every change of the session. Returns the result of Session::pump().
  std::size_t pump();
  /// The client has closed its side, and may still read.
  void input_ended();
  void output_ended();
  void note_greeting();
  /// Lets the session give way to other flows that need its place or its memory.
  void share();
  void update_access();
  void update_rates();
  [[nodiscard]] std::string silence() const;
  [[nodiscard]] bool too_much_queued() const {
    const std::size_t queued = session_.queued_bytes();
    return queued > context_.limits.queued_bytes ||
           session_.edit_bytes() > context_.limits.queued_bytes / 4 ||
           (queued > kQueuedBytesAnyway && !context_.session.memory.takes_work());
  }
  [[nodiscard]] bool too_many_views() const { return session_.views_pile_up(); }
  /// Also stops frames that were already read, which may be dozens of Views from a client that was kept
  /// waiting.
  [[nodiscard]] bool takes_no_frame() const { return too_much_queued() || session_.views_full(); }
  void end(std::string_view reason);
  [[nodiscard]] Clock::time_point now() const { return clock_.now(); }

  S stream_;
  const ConnectionInfo connection_;
  const RunnerContextPtr kept_context_;
  const RunnerContext& context_;  // *kept_context_
  const Clock& clock_;
  std::optional<Admission::Slot> slot_;
  protocol::FrameReader frames_;
  Session session_;

  TimedEvent output_waits_;  // for output
  TimedEvent input_waits_;   // for room in the queue, or until the View is applied
  TimedEvent watch_waits_;   // for the next event of the watchdog or the next View

  Watchdog watchdog_;
  ViewThrottle view_throttle_;
  ViewTurns& view_turns_;  // of the stream's thread
  WriteBatchSize batch_size_;
  struct UnsentOutput {
    Output output;
    std::size_t from = 0;  // bytes already written
  };
  std::optional<UnsentOutput> unsent_;  // written before the session's next output
  bool reading_paused_ = false;
  bool input_ended_ = false;
  bool output_ended_ = false;
  bool greeted_ = false;
  bool started_ = false;
  bool open_ = true;
  std::array<std::byte, 8192> input_;
};

/// Creates the connection's session and starts it.
void start_session(AcceptedConnection accepted, const RunnerContextPtr& context);

}  // namespace talus::server
