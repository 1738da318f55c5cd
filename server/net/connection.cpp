#include "net/connection.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <asio/buffer.hpp>
#include <asio/co_spawn.hpp>
#include <asio/post.hpp>
#include <asio/redirect_error.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>

#include "access/signed_token.h"
#include "log/escape.h"
#include "metrics/thread_time.h"

namespace talus::server {
namespace {

using std::chrono::milliseconds;

constexpr int kUnsentLowWaterBytes = 16 * 1024;
constexpr milliseconds kTimeToClose{2000};  // to write the last frames and to read the client's end

// A piece more for the system costs as much as copying some 2 KiB that lie far away. Below 64 pieces a write
// of the most that is gathered stays one call.
constexpr std::size_t kSharedFrom = 2560;

asio::const_buffer buffer_of(std::span<const std::byte> piece) {
  return {piece.data(), piece.size()};
}

milliseconds from_config(std::uint64_t ms) {
  return milliseconds{static_cast<milliseconds::rep>(ms)};
}

void tune(asio::ip::tcp::socket& socket) {
  std::error_code ignored;
  socket.set_option(asio::ip::tcp::no_delay{true}, ignored);
  // What the kernel holds cannot be overtaken, so it holds little and the outbox decides late.
  ::setsockopt(socket.native_handle(), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &kUnsentLowWaterBytes,
               sizeof(kUnsentLowWaterBytes));
}

/// How long a session may last by its token. A timer cannot count as far as a token can: a century is for
/// ever.
std::chrono::nanoseconds left_of(std::chrono::sys_seconds expires) {
  constexpr std::chrono::seconds kCentury{std::int64_t{36'525} * 86'400};
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  return std::clamp(expires - now, -kClockSkew, kCentury) + kClockSkew;
}

std::string described(const Grant& grant) {
  const std::string whose = grant.subject.empty() ? "" : fmt::format(" of \"{}\"", escaped(grant.subject));
  return fmt::format("rights{} {}", whose, to_string(grant.rights));
}

}  // namespace

struct Connection::Self {
  asio::any_io_executor executor;
  std::weak_ptr<Connection> connection;  // set by start()

  static void take_mail(const std::shared_ptr<Self>& self) {
    asio::post(self->executor, [self] {
      if (const auto connection = self->connection.lock()) {
        connection->react([](Session& session) { session.take_mail(); });
      }
    });
  }
};

Connection::Connection(Guest guest, const ConnectionContext& context)
    : wire_{std::move(guest.wire)},
      remote_{std::move(guest.address)},
      id_{guest.id},
      context_{context},
      place_{std::move(guest.place)},
      frames_{context.session.limits.frame_bytes},
      self_{std::make_shared<Self>(Self{wire_.get_executor(), {}})},
      session_{context.session,
               std::make_shared<Mailbox>(ClientId{id_}, [self = self_] { Self::take_mail(self); }),
               place_->rates()},
      output_waits_{wire_.get_executor()},
      room_{wire_.get_executor()},
      watch_timer_{wire_.get_executor()},
      opened_{guest.came},
      last_frame_{opened_} {
  tune(wire_.socket());
  context_.session.metrics.accepted.add();
  context_.session.metrics.open.rise();
}

void Connection::start() {
  asio::post(wire_.get_executor(), [self = shared_from_this()] {
    self->react([&](Session&) {
      self->self_->connection = self;
      self->spawn(&Connection::read);
      self->spawn(&Connection::write);
      self->spawn(&Connection::watch);
    });
  });
}

void Connection::go_away(std::string reason, std::chrono::milliseconds retry_after) {
  asio::post(wire_.get_executor(), [self = shared_from_this(), reason = std::move(reason), retry_after] {
    self->react([&](Session& session) { session.go_away(reason, retry_after); });
  });
}

void Connection::spawn(asio::awaitable<void> (Connection::*loop)()) {
  asio::co_spawn(
      wire_.get_executor(), [self = shared_from_this(), loop] { return ((*self).*loop)(); },
      [self = shared_from_this()](const std::exception_ptr& thrown) {
        if (!thrown) return;
        try {
          std::rethrow_exception(thrown);
        } catch (const std::exception& error) {
          self->end(fmt::format("failed: {}", error.what()));
        }
      });
}

asio::awaitable<void> Connection::read() {
  while (open_) {
    std::error_code failed;
    const std::size_t bytes = co_await wire_.async_read_some(
        asio::buffer(input_), asio::redirect_error(asio::use_awaitable, failed));
    if (failed) {
      end(failed == asio::error::eof
              ? (frames_.mid_frame() ? "closed by the client inside a frame" : "closed by the client")
              : failed.message());
      co_return;
    }
    context_.session.metrics.received_bytes.add(bytes);
    // What comes after the last word is read and dropped, so that closing does not reset the connection.
    if (session_.closing()) continue;
    co_await take_in(std::span{input_}.first(bytes));
    work();
    co_await take_up_view();
  }
}

asio::awaitable<void> Connection::take_in(std::span<const std::byte> bytes) {
  while (!bytes.empty() && open_ && !session_.closing()) {
    const auto taken = frames_.feed(bytes);
    if (!taken) {
      session_.broken_frame(taken.error());
      co_return;
    }
    bytes = bytes.subspan(*taken);
    if (!frames_.has_frame()) continue;
    last_frame_ = Clock::now();
    session_.receive(frames_.frame());
    frames_.pop();
    note_greeting();
    if (session_.queued_bytes() > context_.session.limits.queued_bytes) {
      work();
      co_await wait_for_room();
    }
  }
}

asio::awaitable<void> Connection::take_up_view() {
  if (!open_ || !session_.view_waits()) co_return;
  if (view_pace_.due() > Clock::now()) {
    room_.expires_at(view_pace_.due());
    co_await wait(room_);
  }
  if (!open_) co_return;
  const auto began = Clock::now();
  const auto spent_before = thread_time();
  session_.apply_view();
  work();
  view_pace_.taken_up(began, thread_time() - spent_before);
}

asio::awaitable<void> Connection::wait_for_room() {
  reading_paused_ = true;
  while (open_ && !session_.closing() && session_.queued_bytes() > context_.session.limits.queued_bytes) {
    room_.expires_at(Clock::time_point::max());
    co_await wait(room_);
  }
  reading_paused_ = false;
  last_frame_ = Clock::now();
}

asio::awaitable<void> Connection::write() {
  while (open_) {
    const auto now = Clock::now();
    if (const auto due = session_.sendable_at(); due > now) {
      if (session_.closing() && due == Clock::time_point::max()) break;
      output_waits_.expires_at(due);
      co_await wait(output_waits_);
      continue;
    }
    const Output output =
        session_.take_output(gather_.bytes(), wire_.by_tls() ? Output::kCopyAll : kSharedFrom);
    const std::vector<std::span<const std::byte>> pieces = output.pieces();
    work();

    write_progress_ = Clock::now();
    bool in_one_piece = true;
    const std::size_t waits = wire_.write_waits();
    const auto progress = [&](const std::error_code& error, std::size_t bytes) -> std::size_t {
      write_progress_ = Clock::now();
      in_one_piece = in_one_piece && (bytes == 0 || bytes == output.size());
      return error ? 0 : output.size();
    };
    std::error_code failed;
    auto token = asio::redirect_error(asio::use_awaitable, failed);
    std::size_t written = 0;
    if (pieces.size() == 1) {  // a cheaper call of the system
      written = co_await asio::async_write(wire_, buffer_of(pieces.front()), progress, token);
    } else {
      std::vector<asio::const_buffer> buffers;
      std::transform(pieces.begin(), pieces.end(), std::back_inserter(buffers), buffer_of);
      written = co_await asio::async_write(wire_, buffers, progress, token);
    }
    context_.session.metrics.sent_bytes.add(written);
    write_progress_.reset();
    session_.written();
    // TLS writes record by record, however much the kernel takes.
    gather_.wrote(output.size(), wire_.by_tls() ? wire_.write_waits() == waits : in_one_piece);
    if (failed) {
      end(failed.message());
      co_return;
    }
  }
  std::error_code ignored;
  if (open_ && wire_.by_tls())
    co_await wire_.async_say_end(asio::redirect_error(asio::use_awaitable, ignored));
  if (open_) wire_.shutdown();
}

asio::awaitable<void> Connection::watch() {
  while (open_) {
    const auto now = Clock::now();
    if (closing_since_ && now >= *closing_since_ + kTimeToClose) {
      end("closed");
    } else if (write_stalled(now)) {
      end(fmt::format("timeout: the client read nothing for {} ms", context_.limits.write_timeout_ms));
    } else if (!closing_since_ && token_ends_ && now >= *token_ends_) {
      react([](Session& session) { session.token_expired(); });
    } else if (now >= next_deadline(now)) {
      time_out();
    } else {
      watch_timer_.expires_at(next_deadline(now));
      co_await wait(watch_timer_);
    }
  }
}

asio::awaitable<void> Connection::wait(asio::steady_timer& timer) {
  std::error_code cancelled;
  co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, cancelled));
}

template <typename Happening>
void Connection::react(Happening&& happening) {
  if (!open_) return;
  try {
    happening(session_);
    work();
  } catch (const std::exception& error) {
    end(fmt::format("failed: {}", error.what()));
  }
}

void Connection::work() {
  if (!open_) return;
  session_.pump();
  if (session_.closing() && !closing_since_) {
    closing_since_ = Clock::now();
    watch_timer_.cancel();
  }
  // Also for what a rate still holds: write() may wait for nothing at all, and must learn until when.
  if (session_.sendable_at() < output_waits_.expiry() || session_.closing()) output_waits_.cancel();
  if (reading_paused_) room_.cancel();
}

void Connection::time_out() {
  const Limits& limits = context_.limits;
  session_.timed_out(session_.greeting()
                         ? fmt::format("no whole frame for {} ms; send Ping when there is nothing to say",
                                       limits.idle_timeout_ms)
                         : fmt::format("no whole Hello within {} ms", limits.handshake_timeout_ms));
  work();
}

bool Connection::write_stalled(Clock::time_point now) const {
  return write_progress_ && now >= *write_progress_ + from_config(context_.limits.write_timeout_ms);
}

Connection::Clock::time_point Connection::next_deadline(Clock::time_point now) const {
  const Limits& limits = context_.limits;
  if (closing_since_) return *closing_since_ + kTimeToClose;
  const auto silent = !session_.greeting() ? opened_ + from_config(limits.handshake_timeout_ms)
                      : reading_paused_    ? now + from_config(limits.idle_timeout_ms)
                                           : last_frame_ + from_config(limits.idle_timeout_ms);
  // Without a write under way one may begin before the next look.
  return std::min({silent, token_ends_.value_or(silent),
                   write_progress_.value_or(now) + from_config(limits.write_timeout_ms)});
}

void Connection::note_greeting() {
  if (greeting_noted_ || !session_.greeting()) return;
  greeting_noted_ = true;
  context_.session.metrics.greeted.rise();
  watch_timer_.cancel();  // from here on it is the idle time that counts
  const Greeting& greeting = *session_.greeting();
  if (greeting.grant.expires) token_ends_ = Clock::now() + left_of(*greeting.grant.expires);
  context_.log->info("conn {} {}: hello from \"{}\", protocol {}, {}", id_, remote_, escaped(greeting.client),
                     greeting.protocol, described(greeting.grant));
}

void Connection::end(std::string_view reason) {
  if (!std::exchange(open_, false)) return;
  // Before the socket closes: who sees the end finds the place free.
  place_.reset();
  context_.registry.remove(id_);
  context_.session.metrics.open.fall();
  if (greeting_noted_) context_.session.metrics.greeted.fall();
  wire_.close();
  output_waits_.cancel();
  room_.cancel();
  watch_timer_.cancel();
  const std::string& failure = session_.failure();
  context_.log->info("conn {} {}: ended: {}", id_, remote_,
                     failure.empty() ? std::string{reason} : escaped(failure, 300));
  session_.abandon();
}

}  // namespace talus::server
