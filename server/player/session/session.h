// One client's conversation: messages in, frames out. The state machine of PROTOCOL.md.
//
//   connected --Hello--> joined --go_away()------> leaving ---last request answered---> closed
//                          |                          ^                                   ^
//                          |                       go_away()                              |
//                          +------input_ended()--> finishing --requests and View served---+
//
// Any state becomes closed by an error that ends the connection, or by abandon().
//
// No socket, thread or timer: net/ feeds it, from one thread at a time. Chunks come from an injected source,
// answers from other threads through a mailbox, the time from an injected clock. Whatever the client sends,
// memory stays within the limits.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include <talus/protocol/frame.h>
#include <talus/protocol/message.h>

#include "chunks/mailbox.h"
#include "limits/memory/memory_budget.h"
#include "limits/memory/memory_reservation.h"
#include "limits/rates/rates.h"
#include "player/session/delivery.h"
#include "player/session/edit_cost.h"
#include "player/session/editing.h"
#include "player/session/handshake.h"
#include "player/session/id_map.h"
#include "player/session/replies.h"
#include "player/session/session_context.h"
#include "player/view/credit.h"
#include "player/view/outbox.h"
#include "runtime/clock.h"

namespace talus::server {

class Session {
 public:
  enum class State : std::uint8_t {
    connected,  // waits for Hello
    joined,
    finishing,  // the client sends no more; gets what it asked for, its View too
    leaving,    // GoAway was said; answers what is pending
    closed,     // what is sendable now is all that ever will be: write it and close
  };

  /// Memory of a session that asks for nothing, with its connection and coroutines.
  static constexpr std::size_t kIdleBytes = std::size_t{32} * 1024;
  /// A View that waits counts so much a chunk, at least what it takes when it is applied: by then the memory
  /// must be there.
  static constexpr std::size_t kViewBytesPerChunk = 12;
  /// Frames of a client that may grow to so much, however little memory there is: what an idle session does
  /// not need of kIdleBytes.
  static constexpr std::size_t kMaxFrameBytesAnyway = std::size_t{16} * 1024;

  /// `address` holds the rates that the session shares with others of its address; null: none.
  Session(const SessionContext& context, MailboxPtr mailbox, const AddressBucketsPtr& address);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // ---- events. After any of them call pump().
  /// A whole frame, as FrameReader gives it.
  void receive(std::span<const std::byte> frame);
  void broken_frame(const protocol::FrameError& error);
  /// A frame in progress, or the last one, takes so much memory. Ends the session where that is more than
  /// kMaxFrameBytesAnyway and the server has none to give.
  void holds_input(std::size_t bytes);
  /// The client was silent too long; `text` says for how long.
  void timed_out(std::string_view text);
  void token_expired();
  /// The lists of revoked tokens and of blocked flows were read again: ends the session where it is on one.
  /// `address_blocked`: its address is.
  void access_changed(bool address_blocked);
  /// The rates in the context may have changed, and `address` is what holds those of its address now. The
  /// client is not told: it keeps to those of Welcome, and is refused where they are lower now.
  void rates_changed(const AddressBucketsPtr& address);
  /// Handles all that waits in the mailbox.
  void take_mail();
  /// No frame comes any more, but the client still reads. It can give no credit: none is needed from here on.
  void input_ended();
  /// Says GoAway and ends the View; takes no more requests. Before Welcome an Error instead.
  void go_away(std::string_view reason, std::chrono::milliseconds retry_after);
  /// The connection is gone: leaves every queue.
  void abandon();

  /// Whether a View waits for apply_view(), which may cost milliseconds: the caller decides when.
  [[nodiscard]] bool view_waits() const { return delivery_.view().waits(); }
  /// Returns how many chunks it dropped that waited for the client.
  [[nodiscard]] std::size_t apply_view() { return delivery_.apply_view(); }
  /// Whether the client sends Views faster than they are applied. Each costs something, also one that is
  /// replaced: until apply_view() the caller reads no more.
  [[nodiscard]] bool views_pile_up() const { return delivery_.view().piles_up(); }
  /// Whether so many wait that not one more may be received before apply_view(), or chunks were sent twice.
  [[nodiscard]] bool views_full() const { return delivery_.view().is_full(); }

  /// Starts as much work as the bounds allow. Returns how many chunks it found in memory.
  std::size_t pump();

  // ---- output
  /// When something may be written: the clock's zero at once, a time to come where a rate throttles chunks,
  /// max() where nothing waits or the client gave no credit. At once does not depend on when the caller
  /// looked at the clock.
  [[nodiscard]] Clock::time_point sendable_at();
  /// Whether there are answers or updates that credit allows, no chunks wait, and the answers are no more
  /// than about so many bytes.
  [[nodiscard]] bool has_little_to_write(std::size_t most_bytes) const {
    return outbox_.sendable(credit_) && outbox_.chunk_bytes() == 0 && outbox_.control_bytes() <= most_bytes;
  }
  /// Frames to write now: `enough_bytes` and at most one frame more. Chunks of `shared_from` bytes and more
  /// are not copied.
  [[nodiscard]] Output take_output(std::size_t enough_bytes, std::size_t shared_from = Output::kCopyAll);
  /// The last output was written; its memory is free.
  void written();
  /// Bytes that wait for the client without credit. Above limits.queued_bytes the caller reads no more.
  [[nodiscard]] std::size_t queued_bytes() const {
    return outbox_.control_bytes() + delivery_.requests().heights_bytes();
  }
  /// Bytes of edits that wait for their answer: for their ground, and their turn. Above a quarter of
  /// limits.queued_bytes the caller reads no more, so that few sessions do not take everybody's memory.
  [[nodiscard]] std::size_t edit_bytes() const { return editing_.unanswered_bytes(); }

  // ---- what it is
  /// Whom its work counts as, and to which it adds what it refuses; the caller adds what it writes.
  [[nodiscard]] FlowUse& flow() const { return delivery_.flow(); }
  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] bool closing() const { return state_ == State::closed; }
  /// None before Hello was accepted; stays when the session ends.
  [[nodiscard]] const std::optional<Greeting>& greeting() const { return greeting_; }
  /// What the client did wrong, for the log; empty: nothing.
  [[nodiscard]] const std::string& failure() const { return failure_; }
  /// The log has said the same already.
  [[nodiscard]] bool failure_is_known() const { return failure_is_known_; }

 private:
  void on(const wire::Hello& hello);
  void on(const wire::View& view);
  void on(const wire::GetChunks& get);
  /// Ids of one message whose Errors are said: the client could not know when it sent the message.
  using AnsweredIds = std::optional<IdMap<std::monostate>>;
  /// Whether the request is pending now.
  [[nodiscard]] bool on(const wire::ChunkRequest& request, const AnsweredIds& answered);
  void on(const wire::Cancel& cancel);
  void on(const wire::GetHeights& get);
  void on(const wire::Credit& credit);
  void on(const wire::Attach& attach);
  void on(const wire::Edit& edit);
  void on(const wire::Ping& ping);

  /// Counts one message. Where a rate refuses it, says so and returns false.
  [[nodiscard]] bool within_rates(const Subject& subject) {
    const auto refusal = rates_.refuse_request(received_at_);
    if (refusal) say_refusal(subject, *refusal);
    return !refusal;
  }
  void say_refusal(const Subject& subject, const SessionRates::Refusal& refusal);
  /// Counts a request, whose id no other that is not answered may have; if it may not be, says so.
  /// `repeated`: the id is another's of the same message.
  [[nodiscard]] bool admit_id(std::uint32_t id, bool repeated = false);
  /// Whether one more request may become pending; if not, it is answered here.
  [[nodiscard]] bool admit_pending(std::uint32_t id) {
    const bool room = delivery_.requests().size() < context_.limits.requests_in_flight;
    if (room && state_ != State::leaving) return true;
    refuse_pending(id);
    return false;
  }
  void refuse_pending(std::uint32_t id);
  /// Says the Error and closes. `why` is for the log alone.
  void fail(wire::ErrorCode code, std::string_view text,
            std::chrono::milliseconds retry_after = retry_after::kNever, std::string_view why = {});
  /// A session that leaves closes with its last answer, one that finishes when all is served.
  void close_if_served();
  void note_memory();
  /// Of the View that waits, beside what the one in force holds.
  [[nodiscard]] std::size_t view_bytes_to_come() const;

  const SessionContext context_;
  State state_ = State::connected;
  std::optional<Greeting> greeting_;
  Credit credit_{0};
  Outbox outbox_;
  Replies replies_;
  Delivery delivery_;
  Editing editing_;
  EditCosts edit_costs_;
  SessionRates rates_;
  MemoryReservation memory_;
  Clock::time_point received_at_{};  // the message that is handled
  std::uint64_t view_chunks_ = 0;    // of the last View that was right
  std::size_t writing_bytes_ = 0;    // of the last output
  std::size_t input_bytes_ = 0;
  std::string failure_;
  bool failure_is_known_ = false;
};

}  // namespace talus::server
