// A session's socket: reads frames into the session, writes what it has to say, and watches the clock.
//
// Three coroutines on one io_context share it, so nothing here is locked. They end when the socket is
// closed; the connection lives as long as the last of them.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <asio/awaitable.hpp>
#include <asio/steady_timer.hpp>

#include "config/config.h"
#include "log/logger.h"
#include "net/door.h"
#include "net/gather_size.h"
#include "net/registry.h"
#include "net/view_pace.h"
#include "net/wire.h"
#include "session/session.h"

namespace talus::server {

/// What connections share; outlives them.
struct ConnectionContext {
  SessionContext session;
  const Limits& limits;
  Registry& registry;
  Logger log;
};

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(Guest guest, const ConnectionContext& context);

  /// Once, from any thread.
  void start();
  /// From any thread: says GoAway and closes when what was asked is answered.
  void go_away(std::string reason, std::chrono::milliseconds retry_after);

 private:
  using Clock = std::chrono::steady_clock;
  /// Where the mailbox finds the connection.
  struct Self;

  [[nodiscard]] asio::awaitable<void> read();
  [[nodiscard]] asio::awaitable<void> take_in(std::span<const std::byte> bytes);
  [[nodiscard]] asio::awaitable<void> take_up_view();
  [[nodiscard]] asio::awaitable<void> wait_for_room();
  [[nodiscard]] asio::awaitable<void> write();
  [[nodiscard]] asio::awaitable<void> watch();
  [[nodiscard]] asio::awaitable<void> wait(asio::steady_timer& timer);
  void spawn(asio::awaitable<void> (Connection::*loop)());

  /// Lets `happening` change the session, in a handler of its own; what that throws ends this connection
  /// and no other.
  template <typename Happening>
  void react(Happening&& happening);
  /// After anything that happened to the session.
  void work();
  void time_out();
  [[nodiscard]] Clock::time_point next_deadline(Clock::time_point now) const;
  [[nodiscard]] bool write_stalled(Clock::time_point now) const;
  void note_greeting();
  void end(std::string_view reason);

  Wire wire_;
  std::string remote_;
  ConnectionId id_;
  ConnectionContext context_;
  std::optional<Admission::Place> place_;
  protocol::FrameReader frames_;
  std::shared_ptr<Self> self_;
  Session session_;

  // Signals: a waiting coroutine goes on when its timer is cancelled.
  asio::steady_timer output_waits_;
  asio::steady_timer room_;
  asio::steady_timer watch_timer_;

  Clock::time_point opened_;
  Clock::time_point last_frame_;
  std::optional<Clock::time_point> token_ends_;
  ViewPace view_pace_;
  GatherSize gather_;
  std::optional<Clock::time_point> write_progress_;  // while a write is under way
  std::optional<Clock::time_point> closing_since_;
  bool reading_paused_ = false;
  bool greeting_noted_ = false;
  bool open_ = true;
  std::array<std::byte, 8192> input_;
};

}  // namespace talus::server
