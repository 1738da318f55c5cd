// One client's conversation: messages in, frames out. The state machine of PROTOCOL.md.
//
//   connected --Hello--> joined --go_away()------> leaving ---last request answered---> closed
//                          |                          ^                                   ^
//                          |                       go_away()                              |
//                          +------input_ended()--> finishing --requests and View served---+
//
// Any state becomes closed by an error that ends the connection, or by abandon().
//
// No socket, thread or timer: net/ drives it, from one thread at a time. Chunks come from an injected source,
// answers of other threads through a mailbox, the time from an injected clock. Whatever the client sends,
// memory stays within the limits.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <talus/protocol/frame.h>
#include <talus/protocol/message.h>

#include "chunks/mailbox.h"
#include "limits/flows/flow_shares.h"
#include "limits/memory/memory_budget.h"
#include "limits/memory/memory_reservation.h"
#include "limits/rates/rates.h"
#include "player/session/delivery.h"
#include "player/session/handshake.h"
#include "player/session/id_map.h"
#include "player/session/replies.h"
#include "player/session/session_context.h"
#include "player/session/session_edits.h"
#include "player/view/output.h"
#include "runtime/clock.h"

namespace talus::server {

class Session {
 public:
  enum class State : std::uint8_t {
    connected,  // waits for Hello
    joined,
    finishing,  // the client sends no more; its requests and View are still served
    leaving,    // GoAway was sent; pending requests are still answered
    closed,     // no further output follows: write what is sendable and close
  };

  /// Memory of an idle session, with its connection and coroutines.
  static constexpr std::size_t kIdleBytes = std::size_t{32} * 1024;
  /// A pending View is charged this much per chunk, at least its cost when applied: the memory must be
  /// available by then.
  static constexpr std::size_t kViewBytesPerChunk = 12;
  /// A client's frame may grow to this size however little memory there is: an idle session leaves this much
  /// of kIdleBytes unused.
  static constexpr std::size_t kMaxFrameBytesAnyway = std::size_t{16} * 1024;

  /// `address` holds the rates shared by all sessions of the address; may be null.
  Session(const SessionContext& context, MailboxPtr mailbox, const AddressBucketsPtr& address);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // ---- events. After any of them call pump().
  /// A whole frame from FrameReader.
  void receive(std::span<const std::byte> frame);
  void broken_frame(const protocol::FrameError& error);
  /// Ends a session whose client speaks another protocol; `answer` is in that protocol; if empty,
  /// the client gets an Error.
  void refuse_foreign(std::vector<std::byte> answer, std::string_view protocol);
  /// The current or last frame holds `bytes` of memory. Ends the session if that is more than
  /// kMaxFrameBytesAnyway and the server is short of memory.
  void holds_input(std::size_t bytes);
  /// The client was silent too long; `text` includes the time.
  void timed_out(std::string_view text);
  void token_expired();
  /// The lists of revoked tokens and blocked flows were reloaded: ends the session if it is on one of them.
  /// `address_blocked`: its address is.
  void access_changed(bool address_blocked);
  /// The rates in the context may have changed; `address` now holds the rates of its address. The client is
  /// not notified: it keeps to the rates of Welcome, and is refused if they are lower now.
  void rates_changed(const AddressBucketsPtr& address);
  /// Handles all mail in the mailbox.
  void take_mail();
  /// The client sends no more frames but still reads. It can no longer give credit, so credit is not required
  /// from here on.
  void input_ended();
  /// Sends a ViewComplete of no View, while the client waits for an answer.
  void ask_whether_gone();
  /// Sends GoAway and ends the View; accepts no more requests. Before Welcome it sends an Error instead.
  void go_away(std::string_view reason, std::chrono::milliseconds retry_after);
  /// Ends the session, as another flow needs a part of what it holds. `text`: the Error's.
  void give_way(std::string_view text);
  /// From here on the session's memory is shared with other flows': `give_way` makes the caller call
  /// give_way().
  void share_memory(FlowShares::GiveWay give_way) { memory_.share(flow().id(), std::move(give_way)); }
  /// The connection is gone: leaves every queue.
  void abandon();

  /// True if a View is pending. apply_view() may take milliseconds: the caller decides when.
  [[nodiscard]] bool view_waits() const { return delivery_.view().waits(); }
  /// Returns the number of dropped chunks that were waiting for the client.
  [[nodiscard]] std::size_t apply_view() { return delivery_.apply_view(); }
  /// True if the client sends Views faster than they are applied. Even a replaced View has a cost: the caller
  /// stops reading until apply_view().
  [[nodiscard]] bool views_pile_up() const { return delivery_.view().piles_up(); }
  /// True if the queue of pending Views is full: call apply_view() before receive(), or chunks may be sent
  /// twice.
  [[nodiscard]] bool views_full() const { return delivery_.view().is_full(); }

  /// Starts as much work as the bounds allow. Returns the number of chunks found in memory.
  std::size_t pump();

  // ---- output
  /// Time of the next write: the clock's zero for at once, a later time if a rate throttles chunks, max() if
  /// there is no output or the client gave no credit. "At once" does not depend on when the caller read the
  /// clock.
  [[nodiscard]] Clock::time_point sendable_at();
  /// True if there are answers or updates that credit allows, no chunks are queued, and the answers have at
  /// most about `max_bytes`.
  [[nodiscard]] bool has_little_to_write(std::size_t max_bytes) const {
    const Outbox& outbox = delivery_.outbox();
    return delivery_.sendable() && outbox.chunk_bytes() == 0 && outbox.control_bytes() <= max_bytes;
  }
  /// Takes the frames to write now: `enough_bytes` and at most one frame more. Chunks of at least
  /// `shared_from` bytes are not copied.
  [[nodiscard]] Output take_output(std::size_t enough_bytes, std::size_t shared_from = Output::kCopyAll);
  /// The last output was written; frees its memory.
  void written();
  /// Bytes queued for the client that need no credit. Above limits.queued_bytes the caller stops reading.
  [[nodiscard]] std::size_t queued_bytes() const {
    return delivery_.outbox().control_bytes() + delivery_.requests().heights_bytes();
  }
  /// Bytes of unanswered edits, which wait for their ground or their turn. Above a quarter of
  /// limits.queued_bytes the caller stops reading, so that a few sessions cannot take the memory of all.
  [[nodiscard]] std::size_t edit_bytes() const { return edits_.unanswered_bytes(); }

  // ---- state
  /// The flow charged for this session's work. The session records refusals; the caller records bytes
  /// written.
  [[nodiscard]] FlowUse& flow() const { return delivery_.flow(); }
  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] bool closing() const { return state_ == State::closed; }
  /// Empty until Hello is accepted; kept after the session ends.
  [[nodiscard]] const std::optional<Greeting>& greeting() const { return greeting_; }
  /// The client's fault, for the log; empty without a fault.
  [[nodiscard]] const std::string& failure() const { return failure_; }
  /// True if the log already has this failure.
  [[nodiscard]] bool failure_is_known() const { return failure_is_known_; }

 private:
  void on(const wire::Hello& hello);
  void on(const wire::View& view);
  void on(const wire::GetChunks& get);
  /// Ids of one message that were answered with Errors. They count as repeated, as the client could not know
  /// of the Errors when it sent the message.
  using AnsweredIds = std::optional<IdMap<std::monostate>>;
  /// Returns true if the request is pending now.
  [[nodiscard]] bool on(const wire::ChunkRequest& request, const AnsweredIds& answered);
  void on(const wire::Cancel& cancel);
  void on(const wire::GetHeights& get);
  void on(const wire::GetFile& get);
  void on(const wire::Credit& credit);
  void on(const wire::Attach& attach);
  void on(const wire::Edit& edit);
  void on(const wire::Ping& ping);

  /// Counts one message. If a rate refuses it, sends the refusal and returns false.
  [[nodiscard]] bool within_rates(const Subject& subject) {
    const auto refusal = rates_.refuse_request(received_at_);
    if (refusal) say_refusal(subject, *refusal);
    return !refusal;
  }
  void say_refusal(const Subject& subject, const SessionRates::Refusal& refusal);
  /// Counts a request and checks that its id is not an unanswered request's; otherwise sends an Error.
  /// `repeated`: the id occurred before in the same message.
  [[nodiscard]] bool admit_id(std::uint32_t id, bool repeated = false);
  /// Returns true if one more request may become pending; otherwise answers it.
  [[nodiscard]] bool admit_pending(std::uint32_t id) {
    const bool room = delivery_.requests().size() < context_.limits.requests_in_flight;
    if (room && state_ != State::leaving) return true;
    refuse_pending(id);
    return false;
  }
  void refuse_pending(std::uint32_t id);
  [[nodiscard]] EditingSession editing_session() const;
  /// Sends the Error and closes. `why` is only for the log.
  void fail(wire::ErrorCode code, std::string_view text,
            std::chrono::milliseconds retry_after = retry_after::kNever, std::string_view why = {});
  /// A leaving session closes after its last answer, a finishing one when everything is served.
  void close_if_served();
  void note_memory();
  /// Notes if it is the client's turn to drain what is queued for it.
  void note_client();
  /// Returns true if the flow may have `bytes` more for work.
  [[nodiscard]] bool takes_work(std::uint64_t bytes) {
    return context_.memory.takes_work_of(flow().id(), bytes, context_.clock.now());
  }
  /// Memory that the pending View needs in addition to the current one's.
  [[nodiscard]] std::size_t view_bytes_to_come() const;

  const SessionContext context_;
  State state_ = State::connected;
  std::optional<Greeting> greeting_;
  Delivery delivery_;
  Replies& replies_ = delivery_.replies();
  SessionEdits edits_;
  EditAdmission edit_admission_;
  SessionRates rates_;
  MemoryReservation memory_;
  Clock::time_point received_at_{};  // the current message's time
  std::uint64_t view_chunks_ = 0;    // in the last valid View
  std::size_t writing_bytes_ = 0;    // memory of the last output
  std::size_t input_bytes_ = 0;
  bool client_drains_ = false;  // it is the client's turn
  std::string failure_;
  bool failure_is_known_ = false;
};

}  // namespace talus::server
