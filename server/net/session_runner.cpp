#include "net/session_runner.h"

#include <algorithm>
#include <exception>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <asio/post.hpp>

#include "net/foreign_protocols.h"
#include "net/rounds.h"
#include "runtime/log/escape.h"

namespace talus::server {
namespace {

// Time to find a chunk in memory and put it into the outbox: a few cache misses.
constexpr std::chrono::nanoseconds kFoundChunk{2000};

// Maximum size of output that is written at once by the code that produced it.
constexpr std::size_t kMaxImmediateBytes = 4096;

// Interval of polls for a reset while nothing is read; each poll doubles it.
constexpr std::chrono::milliseconds kFirstResetCheck{50};
constexpr std::chrono::milliseconds kLastResetCheck{400};

// From the last read to the first question whether a client that sends no more is gone.
constexpr std::chrono::milliseconds kFirstQuestion{300};

constexpr std::string_view kClosedByClient = "closed by the client";

}  // namespace

template <typename Call>
void SessionRunner::guard(Call&& call) {
  try {
    call();
  } catch (const std::exception& error) {
    end(fmt::format("failed: {}", error.what()));
  }
}

auto SessionRunner::guarded(void (SessionRunner::*call)()) {
  return [self = shared_from_this(), call] { self->guard([&] { ((*self).*call)(); }); };
}

template <typename Event>
void SessionRunner::dispatch(Event&& event) {
  if (!open_) return;
  guard([&] {
    event(session_);
    pump();
  });
}

/// The mailbox is made before the runner and refers to it weakly.
struct SessionRunner::Owner {
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

std::shared_ptr<SessionRunner> SessionRunner::make(std::unique_ptr<SessionStream> stream,
                                                   ConnectionInfo connection, Admission::Slot slot,
                                                   RunnerContextPtr context) {
  const auto owner = std::make_shared<Owner>(stream->get_executor());
  const auto runner = std::make_shared<SessionRunner>(std::move(stream), std::move(connection),
                                                      std::move(slot), std::move(context), owner);
  owner->runner = runner;
  return runner;
}

SessionRunner::SessionRunner(std::unique_ptr<SessionStream> stream, ConnectionInfo connection,
                             Admission::Slot slot, RunnerContextPtr context,
                             const std::shared_ptr<Owner>& owner)
    : stream_{std::move(stream)},
      traits_{stream_->traits()},
      connection_{std::move(connection)},
      kept_context_{std::move(context)},
      context_{*kept_context_},
      clock_{context_.session.clock},
      slot_{std::move(slot)},
      frames_{std::min(context_.limits.frame_bytes, protocol::kHelloFrameBytes)},
      session_{context_.session,
               Owner::mailbox(connection_.id, flow_of(slot_->counted(), context_.session.flows), owner),
               slot_->rates()},
      output_waits_{owner->executor, clock_},
      watch_waits_{owner->executor, clock_},
      watchdog_{context_.limits.timeouts, connection_.accepted},
      view_turns_{asio::use_service<ViewTurns>(asio::query(owner->executor, asio::execution::context))},
      io_turns_{asio::use_service<IoTurns>(asio::query(owner->executor, asio::execution::context))},
      reset_check_{kFirstResetCheck} {}

void SessionRunner::start() {
  asio::post(stream_->get_executor(), [self = shared_from_this()] {
    if (!self->open_) return;  // it was sent away and ended before it began
    self->started_ = true;
    self->context_.session.metrics.accepted.add();
    self->context_.session.metrics.open.rise();
    self->dispatch([&](Session&) {
      self->share();
      self->read();
      self->write();
      self->watch();
    });
    // Either may have changed between its admission and its registration.
    self->update_access();
    self->update_rates();
  });
}

void SessionRunner::go_away(const std::string& reason, std::chrono::milliseconds retry_after) {
  asio::post(stream_->get_executor(), [self = shared_from_this(), reason, retry_after] {
    self->dispatch([&](Session& session) { session.go_away(reason, retry_after); });
  });
}

void SessionRunner::share() {
  const auto gives_way = [this](std::string_view text) {
    return [weak = weak_from_this(), executor = stream_->get_executor(), text] {
      asio::post(executor, [weak, text] {
        if (const auto alive = weak.lock())
          alive->dispatch([&](Session& session) { session.give_way(text); });
      });
    };
  };
  slot_->set_give_way(gives_way(kNoPlace));
  session_.share_memory(gives_way(kNoMemory));
}

void SessionRunner::access_changed() {
  asio::post(stream_->get_executor(), [self = shared_from_this()] { self->update_access(); });
}

void SessionRunner::rates_changed() {
  asio::post(stream_->get_executor(), [self = shared_from_this()] { self->update_rates(); });
}

void SessionRunner::update_rates() {
  if (!open_) return;
  dispatch([&](Session& session) { session.rates_changed(slot_->rates()); });
}

void SessionRunner::update_access() {
  if (!open_) return;
  const bool blocked = context_.session.access.blocks(slot_->address());
  dispatch([&](Session& session) { session.access_changed(blocked); });
}

void SessionRunner::clock_moved() {
  output_waits_.notify();
  watch_waits_.notify();
}

// ---- turns

void SessionRunner::Turn::take_turn() {
  waits = false;
  runner.guard([&] { (runner.*call)(); });
}

bool SessionRunner::may_go_on(Turn& turn, std::uint64_t cost) {
  if (turn.waits) return false;
  const FlowId flow = session_.flow().id();
  if (io_turns_.go_on(flow, cost)) return true;
  io_turns_.wait(flow, {shared_from_this(), &turn}, stream_->get_executor());
  turn.waits = true;
  return false;
}

// ---- input

void SessionRunner::read() {
  if (!open_ || reading_) return;
  std::copy(input_.begin() + static_cast<std::ptrdiff_t>(taken_),
            input_.begin() + static_cast<std::ptrdiff_t>(filled_), input_.begin());
  filled_ -= std::exchange(taken_, 0);
  if (!end_came_ && filled_ < input_.size()) {
    unread_ = 0;
    reading_ = true;
    stream_->read_some(asio::buffer(input_) + filled_, shared_from_this());
    return;
  }
  if (end_came_) watchdog_.expects_no_more();
  reset_check_ = kFirstResetCheck;
  ask_at_ = now() + kFirstQuestion;
  if (watch_waits_.deadline() > now() + reset_check_) watch_waits_.notify();
}

void SessionRunner::on_read(std::error_code failed, std::size_t bytes) {
  reading_ = false;
  guard([&] {
    if (!open_) return;
    if (failed && failed != asio::error::eof) return input_broke(failed);
    end_came_ = static_cast<bool>(failed);
    context_.session.metrics.received_bytes.add(bytes);
    filled_ += bytes;
    if (paused_while_ != nullptr && bytes > 0) watchdog_.frame_came(now());  // maybe a Ping
    read_cost_ += IoTurns::input_cost(stream_->own_bytes());
    go_on_with_input();
  });
}

void SessionRunner::go_on_with_input() {
  if (!open_) return;
  if (read_cost_ > 0 && !may_go_on(input_turn_, read_cost_)) return;
  read_cost_ = 0;
  if (paused_while_ == nullptr) take_input();
  read();
}

void SessionRunner::input_broke(std::error_code failed) {
  end_reason_ = failed.message();
  if (!stream_->answers(failed) || output_ended_) return end(end_reason_);
  end_came_ = input_ended_ = true;
  session_.abandon();
  pump();
}

void SessionRunner::take_input() {
  // Input after the last frame is read and dropped, so that closing does not reset the connection.
  if (!session_.closing()) {
    take_frames();
    if (!open_ || paused_while_ != nullptr) return;
    pump();
    apply_view_when_due();
    pause_while(&SessionRunner::too_many_views);
  }
  if (session_.closing()) taken_ = filled_;
  if (!open_ || paused_while_ != nullptr || input_turn_.waits || !end_came_) return;
  if (frames_.mid_frame()) {
    end("closed by the client inside a frame");
  } else {
    input_ended();
  }
}

void SessionRunner::take_frames() {
  while ((taken_ < filled_ || frames_.has_frame()) && open_ && !session_.closing() &&
         paused_while_ == nullptr) {
    if (!frames_.has_frame()) {
      const auto taken = frames_.feed(std::span{input_}.subspan(taken_, filled_ - taken_));
      if (!taken) return on_broken_frame(taken.error());
      taken_ += *taken;
      session_.holds_input(frames_.held_bytes());
      if (!frames_.has_frame()) continue;
    }
    if (!may_go_on(input_turn_, IoTurns::input_cost(frames_.frame().size()))) return;
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
      pause_while(&SessionRunner::takes_no_frame);
    }
  }
}

void SessionRunner::on_broken_frame(const protocol::FrameError& error) {
  if (!greeted_ && is_http_request(error)) {
    session_.refuse_foreign(http_refusal(context_.http_place, clock_.wall()), "an HTTP request");
  } else if (!greeted_ && is_tls_hello(error)) {
    session_.refuse_foreign({}, "TLS, and this server has no certificate: set tls.certificate and tls.key");
  } else {
    session_.broken_frame(error);
  }
}

void SessionRunner::pause_while(bool (SessionRunner::*too_much)() const) {
  if (!open_ || session_.closing() || !(this->*too_much)()) return;
  paused_while_ = too_much;
}

bool SessionRunner::stays_paused() const {
  return !session_.closing() && (this->*paused_while_)();
}

void SessionRunner::resume() {
  resuming_ = false;
  if (!open_ || stays_paused()) return;
  paused_while_ = nullptr;
  watchdog_.frame_came(now());
  take_input();
  read();
}

void SessionRunner::input_ended() {
  input_ended_ = true;
  if (output_ended_) return end(kClosedByClient);
  session_.input_ended();
  pump();
}

bool SessionRunner::too_much_queued() const {
  const std::size_t queued = session_.queued_bytes();
  return queued > context_.limits.queued_bytes || session_.edit_bytes() > context_.limits.queued_bytes / 4 ||
         (queued > kQueuedBytesAnyway && !context_.session.memory.takes_work());
}

Clock::time_point SessionRunner::view_due() {
  if (!session_.view_waits()) {
    view_turns_.leave(watch_waits_);
    return Clock::time_point::max();
  }
  if (view_throttle_.due() > now()) return view_throttle_.due();
  view_turns_.enter(session_.flow().id(), watch_waits_);
  return view_turns_.due(watch_waits_);
}

void SessionRunner::apply_view() {
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

void SessionRunner::apply_view_when_due() {
  if (!session_.view_waits()) return;
  if (view_due() <= now()) {
    apply_view();
  } else {
    watch_waits_.notify();  // other messages of the client are handled meanwhile
  }
}

// ---- output

void SessionRunner::write() {
  while (open_ && !outgoing_) {
    if (const auto due = session_.sendable_at(); due > now()) {
      if (session_.closing() && due == Clock::time_point::max()) return stream_->say_end(shared_from_this());
      return output_waits_.wait_until(due, guarded(&SessionRunner::write));
    }
    if (!session_.has_little_to_write(kMaxImmediateBytes) && !may_go_on(output_turn_)) return;
    outgoing_.emplace(Outgoing{session_.take_output(batch_size_.bytes(), traits_.gather_from)});
    if (outgoing_->output.size() > 0) break;
    outgoing_.reset();  // another session of the address took the credit
    session_.written();
    pump();
  }
  if (!open_) return;
  Outgoing& out = *outgoing_;
  for (const std::span<const std::byte> piece : out.output.pieces()) {
    out.pieces.emplace_back(piece.data(), piece.size());
  }
  out.pieces.front() += out.sent;
  out.write_waits = stream_->write_waits();
  io_turns_.charge(session_.flow().id(), out.output.size() / IoTurns::kAnswerBytes);
  pump();
  watchdog_.writing(now());
  stream_->write_some(out.pieces, shared_from_this());
}

void SessionRunner::on_written(std::error_code failed, std::size_t bytes) {
  guard([&] {
    Outgoing& out = *outgoing_;
    const bool in_one_piece = out.sent == 0 && bytes == out.output.size();
    watchdog_.writing(now());
    out.sent += bytes;
    context_.session.metrics.sent_bytes.add(bytes);
    session_.flow().add(FlowMeasure::sent, bytes);
    if (!failed && out.sent < out.output.size()) {
      while (bytes >= out.pieces[out.next].size()) bytes -= out.pieces[out.next++].size();
      out.pieces[out.next] += bytes;
      return stream_->write_some(std::span{out.pieces}.subspan(out.next), shared_from_this());
    }
    watchdog_.written();
    batch_size_.wrote(out.output.size(),
                      traits_.writes_whole ? in_one_piece : stream_->write_waits() == out.write_waits);
    outgoing_.reset();
    session_.written();
    if (failed) return end(failed.message());
    write();
  });
}

void SessionRunner::on_end_said() {
  guard([&] {
    if (!open_) return;
    output_ended_ = true;
    stream_->shutdown();
    if (input_ended_) end(end_reason_.empty() ? kClosedByClient : end_reason_);
  });
}

bool SessionRunner::write_little() {
  // No write is in flight or pending.
  const bool idle = output_waits_.deadline() != Clock::time_point::min() && !outgoing_;
  if (!traits_.writes_now || !idle || session_.closing() ||
      !session_.has_little_to_write(kMaxImmediateBytes)) {
    return false;
  }
  Output output = session_.take_output(batch_size_.bytes(), traits_.gather_from);
  const auto pieces = output.pieces();
  std::size_t sent = 0;
  if (output.size() > 0 && pieces.size() == 1)
    sent = stream_->write_now({pieces.front().data(), pieces.front().size()});
  context_.session.metrics.sent_bytes.add(sent);
  session_.flow().add(FlowMeasure::sent, sent);
  if (sent == output.size()) {
    session_.written();
  } else {
    outgoing_.emplace(Outgoing{std::move(output), sent});
  }
  return true;
}

// ---- both

void SessionRunner::watch() {
  using Verdict = Watchdog::Verdict;
  while (open_) {
    if (view_due() <= now()) apply_view();
    if (!reading_) {
      if (stream_->peer_reset()) return end("the client reset the connection");
      ask_whether_gone();
      look_at_unread();
    }
    switch (watchdog_.check(now())) {
      case Verdict::closed:
        end(end_reason_.empty() ? "closed" : end_reason_);
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
        Clock::time_point next = std::min(watchdog_.next(now()), view_due());
        if (!reading_) {
          next = std::min(next, now() + reset_check_);
          reset_check_ = std::min<Clock::duration>(2 * reset_check_, kLastResetCheck);
        }
        return watch_waits_.wait_until(next, guarded(&SessionRunner::watch));
    }
  }
}

void SessionRunner::ask_whether_gone() {
  if (now() < ask_at_ || outgoing_ || output_turn_.waits) return;
  if (!input_ended_ && !stream_->peer_hung_up()) return;
  ask_at_ = now() + kLastResetCheck;
  dispatch([](Session& session) { session.ask_whether_gone(); });
}

void SessionRunner::look_at_unread() {
  const std::size_t unread = stream_->unread();
  // It may be a Ping. A client that has shut its sending side is not silent: its end lies behind unread
  // input.
  if (unread > unread_ || stream_->peer_hung_up()) watchdog_.frame_came(now());
  unread_ = unread;
}

std::size_t SessionRunner::pump() {
  if (!open_) return 0;
  std::size_t found = session_.pump();
  if (write_little()) found += session_.pump();
  if (session_.closing() && watchdog_.closes(now())) watch_waits_.notify();
  // Also for output held back by a rate: write() may be waiting without a deadline and needs this one.
  if (session_.closing() || outgoing_ || session_.sendable_at() < output_waits_.deadline()) {
    output_waits_.notify();
  }
  if (paused_while_ != nullptr && !resuming_ && !stays_paused()) {
    asio::post(stream_->get_executor(), guarded(&SessionRunner::resume));
    resuming_ = true;
  }
  return found;
}

std::string SessionRunner::silence() const {
  const SessionTimeouts& timeouts = context_.limits.timeouts;
  return greeted_
             ? fmt::format("no whole frame for {} ms; an idle client must send Ping", timeouts.idle.count())
             : fmt::format("no whole Hello within {} ms", timeouts.handshake.count());
}

void SessionRunner::note_greeting() {
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

void SessionRunner::end(std::string_view reason) {
  if (!std::exchange(open_, false)) return;
  view_turns_.leave(watch_waits_);
  // Before the stream closes, so that a client that sees the end finds the slot free.
  slot_.reset();
  context_.registry.remove(connection_.id);
  if (started_) context_.session.metrics.open.fall();
  if (greeted_) context_.session.metrics.greeted.fall();
  stream_->close();
  clock_moved();
  session_.abandon();
  const std::string& failure = session_.failure();
  context_.log->log(session_.failure_is_known() ? LogLevel::debug : LogLevel::info, "conn {} {}: ended: {}",
                    connection_.id, connection_.address,
                    failure.empty() ? std::string{reason} : escaped(failure, 300));
}

void start_session(std::unique_ptr<SessionStream> stream, ConnectionInfo info, Admission::Slot slot,
                   const RunnerContextPtr& context) {
  const ConnectionId id = info.id;
  const auto runner = SessionRunner::make(std::move(stream), std::move(info), std::move(slot), context);
  try {
    context->registry.add(id, runner);
    runner->start();
  } catch (...) {
    context->registry.remove(id);
    throw;
  }
}

void start_session(AcceptedConnection accepted, const RunnerContextPtr& context) {
  auto stream = std::visit(
      [](auto& taken) -> std::unique_ptr<SessionStream> {
        return std::make_unique<SessionStreamOf<std::remove_reference_t<decltype(taken)>>>(std::move(taken));
      },
      accepted.stream);
  start_session(std::move(stream), std::move(accepted.info), std::move(accepted.slot), context);
}

}  // namespace talus::server
