// What the client asked for, from the request to the outbox: chunks for requests and for the View, and
// heights. Takes a chunk that is in memory at once, and waits for the others; decides whether a chunk is
// sent, confirmed (Unchanged), or told as part of its column.
//
// Edits: whenever the client has been sent a chunk of the View, by whatever message, and whenever it is told
// of a change, what the client has is held against the source's newest revision. The source raises that
// before it tells of the change, so of the two one comes second and finds the difference: no edit is lost,
// however mail, generators, credit and Views interleave. A chunk that is still on its way is left alone: it
// is looked at when it is written.
//
// No I/O. Bounded: kMaxWaits chunks wait for the source, and what waits for the client stays within
// limits.queued_bytes and one chunk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <talus/voxel/coords.h>

#include "chunks/mailbox.h"
#include "player/session/chunk_waits.h"
#include "player/session/editing.h"
#include "player/session/pending_requests.h"
#include "player/session/pending_updates.h"
#include "player/session/replies.h"
#include "player/session/resend_pauses.h"
#include "player/session/session_context.h"
#include "player/view/credit.h"
#include "player/view/outbox.h"
#include "player/view/view_subscription.h"
#include "runtime/clock.h"

namespace talus::server {

class Delivery {
 public:
  /// With so many chunks of the View in flight no more are begun but the nearest: few, so that a moved View
  /// soon counts. They are begun together with those beside them.
  static constexpr std::size_t kMaxViewInFlight = 64;
  /// Chunks of one session that wait for the source at once.
  static constexpr std::size_t kMaxWaits = 256;
  /// With so many no chunk of the View is begun beside the nearest: requests find room.
  static constexpr std::size_t kMaxViewWaits = 128;
  /// Both in place of those, while the source has little to do and the client takes what comes: more than a
  /// patch has whose rows are not known yet (some 200), so that a second generator has work.
  static constexpr std::size_t kMaxViewAlone = 224;
  /// Bytes of control frames above which no UniformColumn is added: control frames need no credit.
  static constexpr std::size_t kMaxColumnBytes = std::size_t{16} * 1024;
  /// What a chunk that waits for the source is expected to take in the outbox, until a larger one came.
  static constexpr std::size_t kExpectedChunkBytes = 4096;

  /// Chunks that are to be sent again, were asked for, and did not go yet. What is made earlier may be of no
  /// use when it is its turn.
  static constexpr std::size_t kMaxUpdatesUnderWay = 16;

  /// A chunk of so many bytes is sent again as if it were an EditBroadcast: at once, and however often.
  static constexpr std::size_t kMaxSmallUpdateBytes = 4096;

  /// An EditBroadcast has at most so many voxels; beyond, the whole chunk is sent again.
  static constexpr std::size_t kMaxBroadcastVoxels = 1024;

  /// All outlive it.
  Delivery(const SessionContext& context, MailboxPtr mailbox, Replies& replies, Outbox& outbox,
           Credit& credit)
      : context_{context},
        mailbox_{std::move(mailbox)},
        replies_{replies},
        outbox_{outbox},
        credit_{credit} {}

  /// In whose turns its chunks are generated from now on; before it asks for anything.
  void join(FlowUsePtr flow) { mailbox_->join(std::move(flow)); }

  [[nodiscard]] FlowUse& flow() const { return *mailbox_->flow_use(); }

  // ---- what the client asks for
  [[nodiscard]] const PendingRequests& requests() const { return requests_; }
  /// REQUIRES: no request `id` is pending.
  void request_chunk(std::uint32_t id, const PendingRequests::ChunkRequest& request) {
    requests_.add_chunk(id, request);
  }
  /// REQUIRES: no request `id` is pending.
  void request_heights(std::uint32_t id, HeightsQuery query);
  /// Answers those of `ids` that are pending by Error cancelled.
  void cancel(const std::vector<std::uint32_t>& ids);

  [[nodiscard]] ViewSubscription& view() { return view_; }
  [[nodiscard]] const ViewSubscription& view() const { return view_; }
  /// Returns how many chunks it dropped from the outbox.
  std::size_t apply_view();
  void end_view();
  /// Whether all that the client asked for is answered, the View too.
  [[nodiscard]] bool served() const { return requests_.empty() && view_.settled(); }

  // ---- mail
  void receive(ChunkReady&& mail);
  void receive(HeightsReady&& mail);
  [[nodiscard]] bool has_lost_mail() const { return mailbox_->has_lost(); }
  void receive(QueueHasRoom) {}  // it ends queue_full_, as any mail does that comes from the queue
  void receive(ChunksChanged&& mail);
  /// Of the session's own edits goes to `editing`.
  void take_mail(Editing& editing);

  // ---- work
  /// Starts requests and chunks of the View until a bound is reached: of both the one that holds less, so
  /// that both have chunks in the outbox. Says ViewComplete. Returns how many chunks were in memory.
  [[nodiscard]] std::size_t start_work();

  /// A chunk leaves: replaces it by a newer version that is in memory. Where the client holds that version,
  /// returns an Unchanged, which goes in its place.
  [[nodiscard]] std::optional<protocol::Frame> write(Outbox::Entry& entry);
  /// An update leaves: an EditBroadcast where the client knows it and it is smaller than the chunk, or else
  /// the chunk, at once where it is small, and when it has its turn where it is not. Nothing where that
  /// pauses, or is to be asked for first, or where the client has it already.
  [[nodiscard]] Outbox::Update write_update(ChunkKey key);
  /// The newest version of a chunk that is sent again; null where it is to be asked for first, or the client
  /// has it already.
  [[nodiscard]] EncodedChunkPtr write_resend(ChunkKey key);
  /// When updates that pause may leave; none do: max(). From then on resume_updates() has some.
  [[nodiscard]] Clock::time_point updates_resume() const { return pauses_.next(); }
  void resume_updates();

  /// Forgets everything, and cancels it at the source.
  void abandon();

  /// Memory held, roughly, beside the outbox.
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] EncodedChunkPtr find(ChunkKey key);
  /// Whether one more chunk may come to wait for the client; those that wait for the source will, too.
  [[nodiscard]] bool has_room() const;
  [[nodiscard]] bool view_may_start() const {
    // In a crowd far chunks wait long: they do not keep the nearest waiting.
    return view_.stream().to_send() > 0 && !queue_full_ && outbox_.control_bytes() < kMaxColumnBytes &&
           (view_.stream().in_flight_count() < (goes_ahead() ? kMaxViewAlone : kMaxViewInFlight) ||
            view_.stream().near_to_send());
  }
  /// Whether far chunks may be begun that neither other clients nor this one's nearest have to wait for.
  [[nodiscard]] bool goes_ahead() const { return !held_back_ && context_.chunks.has_little_to_do(); }
  /// Whether requests hold no more than the View, of chunks that wait for the source or the client.
  [[nodiscard]] bool requests_hold_less() const;

  void start_request(std::uint32_t id);
  /// The nearest chunk of the View. Where it is to be made, those too that are made together with it and are
  /// hardly farther away.
  void start_view_chunk();
  void add_those_beside(ChunkKey nearest);
  /// For the chunks in to_submit_, which are in flight. All are wanted soon where the first is.
  void wait_for_view();

  /// `request` is the pending one of `id`.
  void answer_request(std::uint32_t id, const PendingRequests::ChunkRequest& request, EncodedChunkPtr chunk);
  void fail_request(std::uint32_t id, const GenerationFailed& failure);
  void answer_view(ChunkKey key, ChunkAnswer answer);
  void send_view_chunk(ChunkKey key, EncodedChunkPtr chunk);
  /// The client was sent, or is about to be sent, this revision of a chunk of the View. `newest`: as the
  /// source has it now.
  void sent_to_view(ChunkKey key, std::uint64_t revision, std::uint64_t newest);
  /// The client has this revision of a chunk of the View, and there is a newer one.
  void add_update(ChunkKey key, std::uint64_t has) {
    if (updates_.add(key, has)) outbox_.push_update(key);
  }
  /// The newest version in memory that is newer than what the client has; null: none is. REQUIRES: an update
  /// of it waits.
  [[nodiscard]] EncodedChunkPtr newest_of_update(ChunkKey key);
  /// The client has this revision now, by an update.
  void updated(ChunkKey key, std::uint64_t revision);
  /// Asks for chunks that are to be sent again. They take half of the room at most.
  void ask_for_updates();
  void answer_update(ChunkKey key, ChunkAnswer answer);

  /// Where the client holds this version of the chunk, and it is as generated: answers by Unchanged. Of an
  /// edited chunk that is said in its turn, by write().
  [[nodiscard]] bool confirm_request(std::uint32_t id, const PendingRequests::ChunkRequest& request,
                                     const EncodedChunk& chunk);
  [[nodiscard]] bool confirm_view(ChunkKey key, const EncodedChunk& chunk);
  /// Where the chunk is known to be uniform: answers by UniformColumn, for all uniform chunks of its column
  /// that the View still waits for.
  [[nodiscard]] bool answer_by_column(ChunkKey key);
  /// Without credit no chunk goes, but the View's columns do as far as they are known.
  void tell_columns();
  /// Tells those chunks of the column that are uniform, and not in the outbox. `answered` is being answered
  /// and is in neither; null: none is.
  void tell_column(ChunkKey column, const MixedRows& rows, const ChunkKey* answered);

  /// Of chunks that left the View none is waited for, and none is sent. Returns how many waited for the
  /// client.
  std::size_t drop_what_left_view();
  /// Of chunks that the View has not sent: what comes into it comes in its newest version.
  void drop_updates();

  const SessionContext& context_;
  const MailboxPtr mailbox_;
  Replies& replies_;
  Outbox& outbox_;
  Credit& credit_;
  PendingRequests requests_;
  ViewSubscription view_;
  ChunkWaits waits_;
  PendingUpdates updates_;
  ResendPauses pauses_;
  std::size_t expected_chunk_bytes_ = kExpectedChunkBytes;
  std::size_t found_ = 0;  // chunks that were in memory since start_work() began
  std::uint64_t heights_asked_ = 0;
  std::vector<ChunkKey> to_submit_;  // while start_view_chunk() runs
  std::vector<Mail> read_mail_;      // empty: the memory of a few letters, for the mailbox
  bool held_back_ = false;           // its chunks waited for the client, and some do still
  bool queue_full_ = false;          // the View waits for mail before it submits again
};

}  // namespace talus::server
