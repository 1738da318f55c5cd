// SessionRunner's functions: for session_runner.cpp, and for tests that run it over their own stream.
#pragma once

#include "net/session_runner.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <asio/buffer.hpp>
#include <asio/co_spawn.hpp>
#include <asio/post.hpp>
#include <asio/redirect_error.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>

#include "runtime/log/escape.h"

namespace talus::server {

// Time to find a chunk in memory and put it into the outbox: a few cache misses.
inline constexpr std::chrono::nanoseconds kFoundChunk{2000};

// Maximum size of output that is written at once by the code that produced it.
inline constexpr std::size_t kMaxImmediateBytes = 4096;

inline constexpr std::string_view kClosedByClient = "closed by the client";

/// The mailbox is made before the runner and refers to it weakly.
template <Stream S>
struct SessionRunner<S>::Owner {
  explicit Owner(asio::any_io_executor of)
      : executor{std::move(of)},
        rounds{asio::use_service<Rounds<Owner>>(asio::query(executor, asio::execution::context))} {}

  void read() {
    if (const auto alive = runner.lock()) {
      alive->dispatch([](Session& session) { session.take_mail(); });
    }
  }
  static MailboxPtr mailbox(ConnectionId id, FlowUsePtr flow, const std::shared_ptr<Owner>& owner) {
    const auto wake = [owner] { owner->rounds.enter(owner, owner->executor); };
    return std::make_shared<Mailbox>(ClientId{id}, wake, std::move(flow));
  }

  asio::any_io_executor executor;
  Rounds<Owner>& rounds;
  std::weak_ptr<SessionRunner> runner;
};

template <Stream S>
std::shared_ptr<SessionRunner<S>> SessionRunner<S>::make(S stream, ConnectionInfo connection,
                                                         Admission::Slot slot, RunnerContextPtr context) {
  const auto owner = std::make_shared<Owner>(stream.get_executor());
  const auto runner = std::make_shared<SessionRunner>(std::move(stream), std::move(connection),
                                                      std::move(slot), std::move(context), owner);
  owner->runner = runner;
  return runner;
}

template <Stream S>
SessionRunner<S>::SessionRunner(S stream, ConnectionInfo connection, Admission::Slot slot,
                                RunnerContextPtr context, const std::shared_ptr<Owner>& owner)
    : stream_{std::move(stream)},
      connection_{std::move(connection)},
      kept_context_{std::move(context)},
      context_{*kept_context_},
      clock_{context_.session.clock},
      slot_{std::move(slot)},
      frames_{std::min(context_.limits.frame_bytes, protocol::kHelloFrameBytes)},
      session_{context_.session,
               Owner::mailbox(connection_.id, flow_of(slot_->counted(), context_.session.flows), owner),
               slot_->rates()},
      output_waits_{stream_.get_executor(), clock_},
      input_waits_{stream_.get_executor(), clock_},
      watch_waits_{stream_.get_executor(), clock_},
      watchdog_{context_.limits.timeouts, connection_.accepted},
      view_turns_{
          asio::use_service<ViewTurns>(asio::query(stream_.get_executor(), asio::execution::context))} {}

template <Stream S>
void SessionRunner<S>::start() {
  asio::post(stream_.get_executor(), [self = this->shared_from_this()] {
    if (!self->open_) return;  // it was sent away and ended before it began
    self->started_ = true;
    self->context_.session.metrics.accepted.add();
    self->context_.session.metrics.open.rise();
    self->share();
    self->dispatch([&](Session&) {
      self->spawn(&SessionRunner::read);
      self->spawn(&SessionRunner::write);
      self->spawn(&SessionRunner::watch);
    });
    // Either may have changed between its admission and its registration.
    self->update_access();
    self->update_rates();
  });
}

template <Stream S>
void SessionRunner<S>::go_away(const std::string& reason, std::chrono::milliseconds retry_after) {
  asio::post(stream_.get_executor(), [self = this->shared_from_this(), reason, retry_after] {
    self->dispatch([&](Session& session) { session.go_away(reason, retry_after); });
  });
}

template <Stream S>
void SessionRunner<S>::share() {
  const auto gives_way = [this](std::string_view text) {
    return [weak = this->weak_from_this(), executor = stream_.get_executor(), text] {
      asio::post(executor, [weak, text] {
        if (const auto alive = weak.lock())
          alive->dispatch([&](Session& session) { session.give_way(text); });
      });
    };
  };
  slot_->set_give_way(gives_way(kNoPlace));
  session_.share_memory(gives_way(kNoMemory));
}

template <Stream S>
void SessionRunner<S>::access_changed() {
  asio::post(stream_.get_executor(), [self = this->shared_from_this()] { self->update_access(); });
}

template <Stream S>
void SessionRunner<S>::rates_changed() {
  asio::post(stream_.get_executor(), [self = this->shared_from_this()] { self->update_rates(); });
}

template <Stream S>
void SessionRunner<S>::update_rates() {
  if (!open_) return;
  dispatch([&](Session& session) { session.rates_changed(slot_->rates()); });
}

template <Stream S>
void SessionRunner<S>::update_access() {
  if (!open_) return;
  const bool blocked = context_.session.access.blocks(slot_->address());
  dispatch([&](Session& session) { session.access_changed(blocked); });
}

template <Stream S>
void SessionRunner<S>::clock_moved() {
  output_waits_.notify();
  input_waits_.notify();
  watch_waits_.notify();
}

template <Stream S>
void SessionRunner<S>::spawn(asio::awaitable<void> (SessionRunner::*loop)()) {
  asio::co_spawn(
      stream_.get_executor(), [self = this->shared_from_this(), loop] { return ((*self).*loop)(); },
      [self = this->shared_from_this()](const std::exception_ptr& thrown) {
        if (!thrown) return;
        try {
          std::rethrow_exception(thrown);
        } catch (const std::exception& error) {
          self->end(fmt::format("failed: {}", error.what()));
        }
      });
}

template <Stream S>
asio::awaitable<void> SessionRunner<S>::read() {
  while (open_) {
    std::error_code failed;
    const std::size_t bytes = co_await stream_.async_read_some(
        asio::buffer(input_), asio::redirect_error(asio::use_awaitable, failed));
    if (failed) {
      if (failed != asio::error::eof) {
        end(failed.message());
      } else if (frames_.mid_frame()) {
        end("closed by the client inside a frame");
      } else {
        input_ended();
      }
      co_return;
    }
    context_.session.metrics.received_bytes.add(bytes);
    // Input after the last frame is read and dropped, so that closing does not reset the connection.
    if (session_.closing()) continue;
    co_await on_bytes(std::span{input_}.first(bytes));
    pump();
    apply_view_when_due();
    if (too_many_views()) co_await pause_reading(&SessionRunner::too_many_views);
  }
}

template <Stream S>
void SessionRunner<S>::input_ended() {
  input_ended_ = true;
  watchdog_.reading_pauses();  // it has promised to be silent
  if (output_ended_) return end(kClosedByClient);
  session_.input_ended();
  pump();
}

template <Stream S>
void SessionRunner<S>::output_ended() {
  output_ended_ = true;
  stream_.shutdown();
  if (input_ended_) end(kClosedByClient);
}

template <Stream S>
asio::awaitable<void> SessionRunner<S>::on_bytes(std::span<const std::byte> bytes) {
  while (!bytes.empty() && open_ && !session_.closing()) {
    const auto taken = frames_.feed(bytes);
    if (!taken) {
      session_.broken_frame(taken.error());
      co_return;
    }
    bytes = bytes.subspan(*taken);
    session_.holds_input(frames_.held_bytes());
    if (!frames_.has_frame()) continue;
    const Clock::time_point came = now();
    watchdog_.frame_came(came);
    slot_->progress(came);
    session_.receive(frames_.frame());
    frames_.pop();
    session_.holds_input(frames_.held_bytes());
    note_greeting();
    if (takes_no_frame()) {
      pump();
      apply_view_when_due();
      co_await pause_reading(&SessionRunner::takes_no_frame);
    }
  }
}

template <Stream S>
Clock::time_point SessionRunner<S>::view_due() {
  if (!session_.view_waits()) {
    view_turns_.leave(watch_waits_);
    return Clock::time_point::max();
  }
  if (view_throttle_.due() > now()) return view_throttle_.due();
  view_turns_.enter(session_.flow().id(), watch_waits_);
  return view_turns_.due(watch_waits_);
}

template <Stream S>
void SessionRunner<S>::apply_view() {
  const auto began = now();
  const auto used_before = clock_.thread_cpu();
  const auto dropped = static_cast<std::int64_t>(session_.apply_view());
  const auto found = static_cast<std::int64_t>(pump());
  // Sending chunks found in memory is a delivery's cost and not the View's, unless the next View drops them.
  const auto used = clock_.thread_cpu() - used_before;
  const auto cost = std::max(used - found * kFoundChunk, used / 8) + dropped * kFoundChunk;
  view_throttle_.applied(began, cost);
  view_turns_.applied(watch_waits_, began, cost);
}

template <Stream S>
void SessionRunner<S>::apply_view_when_due() {
  if (!session_.view_waits()) return;
  if (view_due() <= now()) {
    apply_view();
  } else {
    watch_waits_.notify();  // other messages of the client are handled meanwhile
  }
}

template <Stream S>
asio::awaitable<void> SessionRunner<S>::pause_reading(bool (SessionRunner::*too_much)() const) {
  reading_paused_ = true;
  watchdog_.reading_pauses();
  while (open_ && !session_.closing() && (this->*too_much)()) {
    co_await input_waits_.wait_until(Clock::time_point::max());
  }
  reading_paused_ = false;
  watchdog_.reading_resumes(now());
}

template <Stream S>
asio::awaitable<void> SessionRunner<S>::write() {
  const auto buffer_of = [](std::span<const std::byte> piece) {
    return asio::const_buffer{piece.data(), piece.size()};
  };
  while (open_) {
    if (const auto due = unsent_ ? now() : session_.sendable_at(); due > now()) {
      if (session_.closing() && due == Clock::time_point::max()) break;
      co_await output_waits_.wait_until(due);
      continue;
    }
    const UnsentOutput unsent =
        unsent_ ? *std::exchange(unsent_, std::nullopt)
                : UnsentOutput{session_.take_output(batch_size_.bytes(), S::kGatherFrom), 0};
    const Output& output = unsent.output;
    if (output.size() == 0) {  // another session of the address took the credit
      session_.written();
      pump();
      continue;
    }
    std::vector<std::span<const std::byte>> pieces = output.pieces();
    pieces.front() = pieces.front().subspan(unsent.from);
    const std::size_t left = output.size() - unsent.from;
    pump();

    watchdog_.writing(now());
    bool in_one_piece = unsent.from == 0;
    const std::size_t waits = stream_.write_waits();
    const auto progress = [&](const std::error_code& error, std::size_t bytes) -> std::size_t {
      watchdog_.writing(now());
      in_one_piece = in_one_piece && (bytes == 0 || bytes == left);
      return error ? 0 : left;
    };
    std::error_code failed;
    auto token = asio::redirect_error(asio::use_awaitable, failed);
    std::size_t written = 0;
    if (pieces.size() == 1) {  // a cheaper system call
      written = co_await asio::async_write(stream_, buffer_of(pieces.front()), progress, token);
    } else {
      std::vector<asio::const_buffer> buffers;
      std::transform(pieces.begin(), pieces.end(), std::back_inserter(buffers), buffer_of);
      written = co_await asio::async_write(stream_, buffers, progress, token);
    }
    context_.session.metrics.sent_bytes.add(written);
    session_.flow().add(FlowMeasure::sent, written);
    watchdog_.written();
    session_.written();
    batch_size_.wrote(output.size(), S::kWritesWhole ? in_one_piece : stream_.write_waits() == waits);
    if (failed) {
      end(failed.message());
      co_return;
    }
  }
  if (open_) co_await stream_.say_end();
  if (open_) output_ended();
}

template <Stream S>
bool SessionRunner<S>::write_little() {
  if constexpr (requires { stream_.write_now(asio::const_buffer{}); }) {
    // No write is in flight or pending.
    const bool idle = output_waits_.deadline() != Clock::time_point::min() && !unsent_;
    if (!idle || session_.closing() || !session_.has_little_to_write(kMaxImmediateBytes)) return false;
    Output output = session_.take_output(batch_size_.bytes(), S::kGatherFrom);
    const auto pieces = output.pieces();
    std::size_t sent = 0;
    if (output.size() > 0 && pieces.size() == 1)
      sent = stream_.write_now({pieces.front().data(), pieces.front().size()});
    context_.session.metrics.sent_bytes.add(sent);
    session_.flow().add(FlowMeasure::sent, sent);
    if (sent == output.size()) {
      session_.written();
    } else {
      unsent_.emplace(UnsentOutput{std::move(output), sent});
    }
    return true;
  }
  return false;
}

template <Stream S>
asio::awaitable<void> SessionRunner<S>::watch() {
  using Verdict = Watchdog::Verdict;
  while (open_) {
    if (view_due() <= now()) apply_view();
    switch (watchdog_.check(now())) {
      case Verdict::closed:
        end("closed");
        break;
      case Verdict::write_stalled:
        end(fmt::format("timeout: the client read nothing for {} ms",
                        context_.limits.timeouts.write.count()));
        break;
      case Verdict::token_expired:
        dispatch([](Session& session) { session.token_expired(); });
        break;
      case Verdict::silent:
        dispatch([&](Session& session) { session.timed_out(silence()); });
        break;
      case Verdict::wait:
        co_await watch_waits_.wait_until(std::min(watchdog_.next(now()), view_due()));
        break;
    }
  }
}

template <Stream S>
template <typename Event>
void SessionRunner<S>::dispatch(Event&& event) {
  if (!open_) return;
  try {
    event(session_);
    pump();
  } catch (const std::exception& error) {
    end(fmt::format("failed: {}", error.what()));
  }
}

template <Stream S>
std::size_t SessionRunner<S>::pump() {
  if (!open_) return 0;
  std::size_t found = session_.pump();
  if (write_little()) found += session_.pump();
  if (session_.closing() && watchdog_.closes(now())) watch_waits_.notify();
  // Also for output held back by a rate: write() may be waiting without a deadline and needs this one.
  if (session_.closing() || unsent_ || session_.sendable_at() < output_waits_.deadline()) {
    output_waits_.notify();
  }
  if (reading_paused_) input_waits_.notify();
  return found;
}

template <Stream S>
std::string SessionRunner<S>::silence() const {
  const SessionTimeouts& timeouts = context_.limits.timeouts;
  return greeted_
             ? fmt::format("no whole frame for {} ms; an idle client must send Ping", timeouts.idle.count())
             : fmt::format("no whole Hello within {} ms", timeouts.handshake.count());
}

template <Stream S>
void SessionRunner<S>::note_greeting() {
  if (greeted_ || !session_.greeting()) return;
  greeted_ = true;
  if (!session_.greeting()->grant.subject.empty()) slot_->move_to(session_.greeting()->grant.subject);
  context_.session.metrics.greeted.rise();
  watchdog_.greeted();
  frames_.set_limit(context_.limits.frame_bytes);
  watch_waits_.notify();  // from here on the idle time-out applies
  const Greeting& greeting = *session_.greeting();
  const Grant& grant = greeting.grant;
  if (grant.expires) watchdog_.token_ends(now() + token_lifetime(*grant.expires, clock_.wall()));
  std::string whose = grant.subject.empty() ? "" : fmt::format(" of \"{}\"", escaped(grant.subject));
  if (!grant.token_id.empty()) whose += fmt::format(", jti \"{}\"", escaped(grant.token_id, 100));
  context_.log->info("conn {} {}: hello from \"{}\", protocol {}, rights{} {}", connection_.id,
                     connection_.address, escaped(greeting.client), greeting.protocol, whose,
                     to_string(grant.rights));
}

template <Stream S>
void SessionRunner<S>::end(std::string_view reason) {
  if (!std::exchange(open_, false)) return;
  view_turns_.leave(watch_waits_);
  // Before the stream closes, so that a client that sees the end finds the slot free.
  slot_.reset();
  context_.registry.remove(connection_.id);
  if (started_) context_.session.metrics.open.fall();
  if (greeted_) context_.session.metrics.greeted.fall();
  stream_.close();
  clock_moved();
  session_.abandon();
  const std::string& failure = session_.failure();
  context_.log->log(session_.failure_is_known() ? LogLevel::debug : LogLevel::info, "conn {} {}: ended: {}",
                    connection_.id, connection_.address,
                    failure.empty() ? std::string{reason} : escaped(failure, 300));
}

}  // namespace talus::server
