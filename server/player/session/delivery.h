// Delivers what the client asked for, from the request to the write: chunks for requests and for the View,
// and heights. A chunk that is in memory is queued at once; for the others it waits. It decides if a chunk is
// sent, confirmed (Unchanged), or sent as part of its column (UniformColumn). It owns the outbox.
//
// Edits: whenever the client has been sent a chunk of the View, by any message, and whenever ChunksChanged
// comes, the client's revision is compared with the source's newest. The source raises that before it sends
// ChunksChanged, so the later of the two finds the difference: no edit is lost, in whatever order mail,
// generators, credit and Views come. A queued chunk is not compared: it is when it is written.
//
// A client whose View has a base makes chunks by itself. It already holds every chunk as generated, so an
// edited chunk first reaches it as an update.
//
// No I/O. Bounded: kMaxWaits chunks wait for the source, and queued chunks stay within limits.queued_bytes
// and one chunk.
//
// delivery.cpp has requests, the View and mail; delivery_write.cpp has writes and updates.
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
#include "player/session/pending_requests.h"
#include "player/session/pending_updates.h"
#include "player/session/replies.h"
#include "player/session/resend_pauses.h"
#include "player/session/session_context.h"
#include "player/session/session_edits.h"
#include "player/view/credit.h"
#include "player/view/outbox.h"
#include "player/view/output.h"
#include "player/view/view_subscription.h"
#include "runtime/clock.h"

namespace talus::server {

class Delivery {
 public:
  /// Maximum chunks of the View in flight, except the nearest: few, so that a moved View soon takes effect.
  /// Chunks of neighbouring columns are started together.
  static constexpr std::size_t kMaxViewInFlight = 64;
  /// Maximum chunks of one session that wait for the source.
  static constexpr std::size_t kMaxWaits = 256;
  /// With this number waiting, only the View's nearest chunk is started, without its neighbours: requests
  /// find room.
  static constexpr std::size_t kMaxViewWaits = 128;
  /// Replaces kMaxViewInFlight and kMaxViewWaits while the source is nearly idle and the client keeps up:
  /// more than the chunks of a patch whose rows are not known yet (some 200), so that a second generator has
  /// work.
  static constexpr std::size_t kMaxViewAlone = 224;
  /// Bytes of control frames above which no UniformColumn or FilePart is added: control frames need no
  /// credit.
  static constexpr std::size_t kMaxColumnBytes = std::size_t{16} * 1024;
  /// Expected bytes in the outbox of a chunk that waits for the source, until a larger one came.
  static constexpr std::size_t kExpectedChunkBytes = 4096;

  /// Maximum chunks to be sent again that were submitted and not sent yet. A chunk made earlier may be
  /// outdated when it has its turn.
  static constexpr std::size_t kMaxUpdatesUnderWay = 16;

  /// A chunk of at most this size is sent again like an EditBroadcast: at once, and however often.
  static constexpr std::size_t kMaxSmallUpdateBytes = 4096;

  /// Maximum chunks of a View with a base that wait to be sent first as an update.
  static constexpr std::size_t kMaxFirstUpdates = 64;

  /// Maximum voxels of an EditBroadcast; beyond, the whole chunk is sent again.
  static constexpr std::size_t kMaxBroadcastVoxels = 1024;

  /// Chunks that one write() appended.
  struct WrittenChunks {
    std::size_t chunks = 0;
    std::size_t chunk_bytes = 0;  // of their frames
  };

  /// `context` outlives it.
  Delivery(const SessionContext& context, MailboxPtr mailbox)
      : context_{context}, mailbox_{std::move(mailbox)}, replies_{outbox_, context.metrics} {}
  Delivery(const Delivery&) = delete;
  Delivery& operator=(const Delivery&) = delete;

  /// Chunks are generated in this flow's turns from now on. Call it before any request.
  void join(FlowUsePtr flow) { mailbox_->join(std::move(flow)); }

  [[nodiscard]] FlowUse& flow() const { return *mailbox_->flow_use(); }
  [[nodiscard]] const Outbox& outbox() const { return outbox_; }
  /// They go into the outbox.
  [[nodiscard]] Replies& replies() { return replies_; }
  /// The client's, for chunks and updates.
  [[nodiscard]] Credit& credit() { return credit_; }

  // ---- requests and the View
  [[nodiscard]] const PendingRequests& requests() const { return requests_; }
  /// REQUIRES: no request `id` is pending.
  void request_chunk(std::uint32_t id, const PendingRequests::ChunkRequest& request) {
    requests_.add_chunk(id, request);
  }
  /// REQUIRES: no request `id` is pending.
  void request_heights(std::uint32_t id, HeightsQuery query);
  /// REQUIRES: no request `id` is pending.
  void request_file(std::uint32_t id, PendingRequests::FileRequest request) {
    requests_.add_file(id, request);
  }
  /// Answers the pending requests among `ids` by Error cancelled.
  void cancel(const std::vector<std::uint32_t>& ids);

  [[nodiscard]] ViewSubscription& view() { return view_; }
  [[nodiscard]] const ViewSubscription& view() const { return view_; }
  /// Returns how many chunks it dropped from the outbox.
  std::size_t apply_view();
  void end_view();
  /// True if all requests are answered, and the View is complete.
  [[nodiscard]] bool served() const { return requests_.empty() && view_.settled() && updates_.first() == 0; }

  // ---- mail
  void receive(ChunkReady&& mail);
  void receive(HeightsReady&& mail);
  [[nodiscard]] bool has_lost_mail() const { return mailbox_->has_lost(); }
  void receive(QueueHasRoom) {}  // take_mail() resets queue_full_
  void receive(ChunksChanged&& mail);
  /// Takes all mail. Answers to the session's own edits go to `session_edits`.
  void take_mail(SessionEdits& session_edits);

  // ---- work
  /// Starts requests and chunks of the View until a bound is reached, always of the one that holds less, so
  /// that both have chunks in the outbox. Sends ViewComplete. Returns how many chunks were in memory.
  [[nodiscard]] std::size_t start_work();

  // ---- output
  [[nodiscard]] bool sendable() const { return outbox_.sendable(credit_); }
  /// Returns when the next paused update may leave; max() if none is paused.
  [[nodiscard]] Clock::time_point updates_resume() const { return pauses_.next(); }
  /// Appends frames to `output` until a limit is reached or nothing is sendable.
  WrittenChunks write(const Outbox::WriteLimits& limits, Output& output);

  /// Drops everything, and cancels it at the source.
  void abandon();

  /// Memory held, roughly, without control frames.
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] EncodedChunkPtr find(ChunkKey key);
  /// True if one more chunk may be queued for the client; chunks that wait for the source count as queued.
  [[nodiscard]] bool has_room() const;
  [[nodiscard]] bool view_may_start() const {
    // In a crowd far chunks wait long: the nearest do not wait for them.
    return view_.stream().to_send() > 0 && !queue_full_ && outbox_.control_bytes() < kMaxColumnBytes &&
           updates_.first() < kMaxFirstUpdates &&
           (view_.stream().in_flight_count() < (goes_ahead() ? kMaxViewAlone : kMaxViewInFlight) ||
            view_.stream().near_to_send());
  }
  /// True if far chunks may be started that delay neither other clients nor this one's nearest chunks.
  [[nodiscard]] bool goes_ahead() const { return !held_back_ && context_.chunks.has_little_to_do(); }
  /// True if requests hold no more bytes than the View, of chunks that wait for the source or the client.
  [[nodiscard]] bool requests_hold_less() const;

  void start_request(std::uint32_t id);
  void send_file_parts();
  /// Tells a View with a base which of its chunks were edited.
  void find_edited();
  /// Sends an edited chunk of a View with a base as an update. Returns false if the client says that it holds
  /// an edited version: the chunk's hash decides then what it is sent.
  [[nodiscard]] bool update_base(ChunkKey key);
  /// The View that counts in the metrics is now one with a base, one without, or none.
  void count_view(std::optional<bool> has_base);
  /// Starts the nearest chunk of the View. If it is not in memory, also chunks that are made together with it
  /// and are hardly farther away.
  void start_view_chunk();
  void start_column_neighbours(ChunkKey nearest);
  /// Submits the chunks in to_submit_, which are in flight. All are wanted soon if the first is.
  void wait_for_view();

  /// `request` is the pending request `id`.
  void answer_request(std::uint32_t id, const PendingRequests::ChunkRequest& request, EncodedChunkPtr chunk);
  void fail_request(std::uint32_t id, const GenerationError& failure);
  void answer_view(ChunkKey key, ChunkAnswer answer);
  void send_view_chunk(ChunkKey key, EncodedChunkPtr chunk);
  /// A chunk leaves: a newer version that is in memory replaces it. If the client holds that version, an
  /// Unchanged goes in its place.
  void write_chunk(Outbox::Write& write);
  /// True if the client said that it holds this version of an edited chunk.
  [[nodiscard]] bool is_held(const Outbox::Entry& entry) const;
  /// An update leaves: an EditBroadcast if it is smaller than the chunk; else the chunk, at once if it is
  /// small, and as a resend if it is not. Nothing if the update is paused, must be submitted first, or the
  /// client has it already.
  void write_update(Outbox::Write& write);
  /// The newest version of a chunk leaves. Nothing if it must be submitted first, or the client has it
  /// already.
  void write_resend(Outbox::Write& write);
  /// Queues the paused updates whose pause ended.
  void resume_updates();

  /// The client was sent, or is about to be sent, this revision of a chunk of the View. `newest`: the
  /// source's revision now.
  void sent_to_view(ChunkKey key, std::uint64_t revision, std::uint64_t newest);
  /// The client has this revision of a chunk of the View, and there is a newer one.
  void add_update(ChunkKey key, std::uint64_t has) {
    if (updates_.add(key, has)) outbox_.push_update(key);
  }
  /// Returns the newest version in memory if it is newer than the client's; else null. REQUIRES: updates_ has
  /// the chunk.
  [[nodiscard]] EncodedChunkPtr newest_of_update(ChunkKey key);
  /// An update gives the client this revision.
  void updated(ChunkKey key, std::uint64_t revision);
  /// Submits chunks that are to be sent again. They take half of the room at most.
  void ask_for_updates();
  void answer_update(ChunkKey key, ChunkAnswer answer);

  /// If the client holds this version of the chunk, and it is as generated, answers by Unchanged and returns
  /// true. An edited chunk is compared when it leaves, by write_chunk().
  [[nodiscard]] bool confirm_request(std::uint32_t id, const PendingRequests::ChunkRequest& request,
                                     const EncodedChunk& chunk);
  [[nodiscard]] bool confirm_view(ChunkKey key, const EncodedChunk& chunk);
  /// If the chunk is known to be uniform, answers by UniformColumn, for all uniform chunks of its column for
  /// which the View still waits, and returns true.
  [[nodiscard]] bool answer_by_column(ChunkKey key);
  /// Without credit no chunk leaves, but UniformColumns do: sends the View's columns that are known.
  void send_columns();
  /// Sends the chunks of the column that are uniform and not in the outbox. `answered` is the chunk that is
  /// being answered, which waits neither for the source nor for the client; null: there is none.
  void send_column(ChunkKey column, const MixedRows& rows, const ChunkKey* answered);

  /// Cancels and drops chunks that left the View. Returns how many were dropped from the outbox.
  std::size_t drop_what_left_view();
  /// Drops updates of chunks that the View has not sent: a chunk that comes back is sent in its newest
  /// version.
  void drop_updates();

  const SessionContext& context_;
  const MailboxPtr mailbox_;
  Outbox outbox_;
  Credit credit_{0};
  Replies replies_;
  PendingRequests requests_;
  ViewSubscription view_;
  ChunkWaits waits_;
  PendingUpdates updates_;
  ResendPauses pauses_;
  std::size_t expected_chunk_bytes_ = kExpectedChunkBytes;
  std::size_t found_ = 0;  // chunks that were in memory since start_work() began
  std::uint64_t heights_asked_ = 0;
  std::vector<ChunkKey> to_submit_;   // while start_view_chunk() runs
  std::vector<Mail> read_mail_;       // empty: memory that the mailbox reuses
  std::optional<bool> counted_view_;  // of count_view()
  bool held_back_ = false;            // the client does not keep up: by its link, its credit or its rates
  bool queue_full_ = false;           // the View waits for mail before it submits again
};

}  // namespace talus::server
