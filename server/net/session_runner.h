// Drives a session over a stream: reads frames into it, writes its output, wakes it for its mail, enforces
// its time-outs, and ends it when its client is gone.
//
// Everything runs on the stream's executor, so there are no locks. A read, a write and a timer may be in
// flight; the runner lives as long as the last of them.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <asio/buffer.hpp>

#include <talus/protocol/frame.h>

#include "net/io_turns.h"
#include "net/registry.h"
#include "net/runner_context.h"
#include "net/session_stream.h"
#include "net/timed_event.h"
#include "net/view_throttle.h"
#include "net/view_turns.h"
#include "net/watchdog.h"
#include "net/write_batch_size.h"
#include "player/session/session.h"

namespace talus::server {

/// Bytes that may be queued for each client even if the server is short of memory.
inline constexpr std::size_t kQueuedBytesAnyway = std::size_t{16} * 1024;

class SessionRunner final : public Peer,
                            public SessionStream::User,
                            public std::enable_shared_from_this<SessionRunner> {
 public:
  [[nodiscard]] static std::shared_ptr<SessionRunner> make(std::unique_ptr<SessionStream> stream,
                                                           ConnectionInfo connection, Admission::Slot slot,
                                                           RunnerContextPtr context);

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
  SessionRunner(std::unique_ptr<SessionStream> stream, ConnectionInfo connection, Admission::Slot slot,
                RunnerContextPtr context, const std::shared_ptr<Owner>& owner);

 private:
  /// A part of the session's work that waits for a turn of its flow.
  struct Turn final : IoTurns::Waiter {
    Turn(SessionRunner& of, void (SessionRunner::*goes_on)()) : runner{of}, call{goes_on} {}
    void take_turn() override;
    SessionRunner& runner;
    void (SessionRunner::*const call)();
    bool waits = false;
  };
  /// Returns true if the flow may go on with a piece of this cost; else `turn` waits.
  [[nodiscard]] bool may_go_on(Turn& turn, std::uint64_t cost = 1);

  /// Reads on if input_ has room, even while frames wait in it, so that most ends are noticed.
  void read();
  void on_read(std::error_code failed, std::size_t bytes) override;
  /// Handles what was read, and reads on.
  void go_on_with_input();
  void input_broke(std::error_code failed);
  /// Passes input to the session until it is taken or reading pauses.
  void take_input();
  void take_frames();
  void on_broken_frame(const protocol::FrameError& error);
  /// Pauses reading while too_much() returns true.
  void pause_while(bool (SessionRunner::*too_much)() const);
  [[nodiscard]] bool stays_paused() const;
  void resume();
  /// The client has closed its side, and may still read.
  void input_ended();
  [[nodiscard]] bool too_much_queued() const;
  [[nodiscard]] bool too_many_views() const { return session_.views_pile_up(); }
  /// Also stops frames that were already read, which may be dozens of Views from a client that was kept
  /// waiting.
  [[nodiscard]] bool takes_no_frame() const { return too_much_queued() || session_.views_full(); }

  /// Time to apply the pending View; max() without one, or until its turn comes.
  [[nodiscard]] Clock::time_point view_due();
  void apply_view();
  /// Applies it now, or leaves it to watch() if it is not due.
  void apply_view_when_due();

  /// Begins the next write, or waits for output. Call it if no write is in flight and no wait in
  /// output_waits_ or output_turn_.
  void write();
  void on_written(std::error_code failed, std::size_t bytes) override;
  void on_end_said() override;
  /// Writes at once, without another handler, if write() is idle and the output is a few bytes of answers and
  /// updates. The part that the stream does not accept is left to write(). Returns true if output was taken,
  /// so that the session may go on.
  bool write_little();

  /// Enforces time-outs, applies Views, and polls for a reset while nothing is read.
  void watch();
  /// If the client has shut its sending side, and is sent nothing: sends it a frame without meaning. If it
  /// has closed the connection, its system resets it as an answer.
  void ask_whether_gone();
  /// While nothing is read, a client that sends more is not silent.
  void look_at_unread();
  /// Calls `call`. An exception ends only this connection.
  template <typename Call>
  void guard(Call&& call);
  /// Returns a handler that keeps this object alive and guards `call`.
  [[nodiscard]] auto guarded(void (SessionRunner::*call)());
  /// Passes the session to `event` in a handler of its own, guarded.
  template <typename Event>
  void dispatch(Event&& event);
  /// Call after every change of the session. Returns the result of Session::pump().
  std::size_t pump();
  void note_greeting();
  /// Lets the session give way to other flows that need its place or its memory.
  void share();
  void update_access();
  void update_rates();
  [[nodiscard]] std::string silence() const;
  void end(std::string_view reason);
  [[nodiscard]] Clock::time_point now() const { return clock_.now(); }

  const std::unique_ptr<SessionStream> stream_;
  const SessionStream::Traits traits_;
  const ConnectionInfo connection_;
  const RunnerContextPtr kept_context_;
  const RunnerContext& context_;  // *kept_context_
  const Clock& clock_;
  std::optional<Admission::Slot> slot_;
  protocol::FrameReader frames_;
  Session session_;

  TimedEvent output_waits_;  // for output
  TimedEvent watch_waits_;   // for the next event of the watchdog, the next View, the next poll for a reset

  Watchdog watchdog_;
  ViewThrottle view_throttle_;
  ViewTurns& view_turns_;  // of the stream's thread
  IoTurns& io_turns_;      // of the stream's thread
  Turn input_turn_{*this, &SessionRunner::go_on_with_input};
  Turn output_turn_{*this, &SessionRunner::write};
  WriteBatchSize batch_size_;
  struct Outgoing {
    Output output;
    std::size_t sent = 0;
    std::vector<asio::const_buffer> pieces{};
    std::size_t next = 0;         // piece, of those that are left
    std::size_t write_waits = 0;  // SessionStream::write_waits() at its beginning
  };
  std::optional<Outgoing> outgoing_;  // written before the session's next output
  bool (SessionRunner::*paused_while_)() const = nullptr;
  bool resuming_ = false;
  bool reading_ = false;   // a read is in flight
  bool end_came_ = false;  // behind the input
  bool input_ended_ = false;
  bool output_ended_ = false;
  bool greeted_ = false;
  bool started_ = false;
  bool open_ = true;
  std::size_t unread_ = 0;       // bytes, as last seen while nothing is read
  std::uint64_t read_cost_ = 0;  // of the last read; 0: charged to the flow
  Clock::duration reset_check_;  // interval of polls for a reset
  Clock::time_point ask_at_{};   // whether the client is gone
  std::string end_reason_;       // if reading failed
  std::size_t taken_ = 0;        // bytes of input_ that were passed on
  std::size_t filled_ = 0;
  std::array<std::byte, 8192> input_;
};

}  // namespace talus::server
