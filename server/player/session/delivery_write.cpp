// Writes of Delivery: its loop over the outbox, and updates of chunks that the client holds.
#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "player/session/delivery.h"

namespace talus::server {

using wire::ErrorCode;

Delivery::WrittenChunks Delivery::write(const Outbox::WriteLimits& limits, Output& output) {
  resume_updates();
  Outbox::Write write{outbox_, limits, credit_, output};
  for (;;) {
    switch (write.next()) {
      case Outbox::Write::Turn::none:
        return {write.chunks(), write.chunk_bytes()};
      case Outbox::Write::Turn::broadcasts:
        write_update(write);
        break;
      case Outbox::Write::Turn::resends:
        write_resend(write);
        break;
      case Outbox::Write::Turn::requests:
      case Outbox::Write::Turn::view:
        write_chunk(write);
        break;
    }
  }
}

void Delivery::write_chunk(Outbox::Write& write) {
  Outbox::Entry entry = write.take_chunk();
  std::uint64_t newest = context_.chunks.revision(entry.key);
  if (newest > entry.chunk->revision()) {
    if (EncodedChunkPtr newer = context_.chunks.newer(entry.key, entry.chunk->revision())) {
      entry.chunk = std::move(newer);
      newest = context_.chunks.revision(entry.key);
    }
  }
  const EncodedChunk& chunk = *entry.chunk;
  if (is_held(entry)) {
    write.append(unchanged_frame(entry.request_id, entry.key, chunk));
    context_.metrics.unchanged_sent.add();
  } else {
    write.append(entry.chunk, entry.request_id, entry.key);
  }
  if (entry.request_id != 0) {
    requests_.erase(entry.request_id);
  } else {
    sent_to_view(entry.key, chunk.revision(), newest);
  }
}

bool Delivery::is_held(const Outbox::Entry& entry) const {
  const EncodedChunk& chunk = *entry.chunk;
  if (chunk.revision() == kBaseRevision) return false;  // it was compared before it was queued
  return entry.request_id != 0 ? requests_.chunk(entry.request_id)->known == chunk.hash()
                               : view_.knows(entry.key, chunk.hash());
}

void Delivery::sent_to_view(ChunkKey key, std::uint64_t revision, std::uint64_t newest) {
  view_.done(key);
  if (newest > revision) add_update(key, revision);
}

void Delivery::write_update(Outbox::Write& write) {
  const ChunkKey key = write.take_update();
  const std::uint64_t has = updates_.at(key).has;
  if (context_.chunks.revision(key) <= has) return updates_.erase(key);
  const EncodedChunkPtr chunk = newest_of_update(key);
  const auto changed = context_.chunks.changes_since(key, has, kMaxBroadcastVoxels);
  if (changed) {
    const protocol::Frame frame = edit_broadcast_frame(key, has, *changed);
    if (chunk == nullptr || frame.size() < chunk->frame_bytes()) {
      context_.metrics.broadcasts_sent.add();
      write.append(frame);
      return updated(key, changed->revision);
    }
  }
  if (chunk != nullptr && (changed || chunk->frame_bytes() <= kMaxSmallUpdateBytes)) {
    write.append(chunk, 0, key);
    return updated(key, chunk->revision());
  }
  if (pauses_.holds(key, context_.clock.now())) return;
  if (chunk == nullptr) {
    updates_.want(key);
  } else {
    outbox_.push_resend(key);
  }
}

void Delivery::write_resend(Outbox::Write& write) {
  const ChunkKey key = write.take_resend();
  const EncodedChunkPtr chunk = newest_of_update(key);
  if (chunk != nullptr) {
    write.append(chunk, 0, key);
    pauses_.resent(key, context_.clock.now());
    updated(key, chunk->revision());
  } else if (context_.chunks.revision(key) > updates_.at(key).has) {
    updates_.want(key);  // it was in memory when it took its turn as an update
  } else {
    updates_.erase(key);
  }
}

EncodedChunkPtr Delivery::newest_of_update(ChunkKey key) {
  const PendingUpdates::Update& update = updates_.at(key);
  EncodedChunkPtr chunk = context_.chunks.newer(key, update.has);
  const EncodedChunkPtr& given = update.chunk;
  if (given != nullptr && (chunk == nullptr || chunk->revision() < given->revision())) chunk = given;
  return chunk;
}

void Delivery::resume_updates() {
  if (pauses_.next() == Clock::time_point::max()) return;
  const Clock::time_point now = context_.clock.now();
  while (const auto key = pauses_.take_ended(now)) outbox_.push_update(*key);
}

void Delivery::updated(ChunkKey key, std::uint64_t revision) {
  updates_.erase(key);
  if (context_.chunks.revision(key) > revision) add_update(key, revision);
}

void Delivery::ask_for_updates() {
  while (const auto key = updates_.next_wanted()) {
    if (context_.chunks.newer(*key, updates_.at(*key).has) != nullptr) {
      outbox_.push_update(*key);
      updates_.found();
      continue;
    }
    const bool half = updates_.under_way() >= kMaxUpdatesUnderWay ||
                      updates_.chunk_bytes() > context_.limits.queued_bytes / 2;
    if (half || queue_full_ || !has_room()) {
      return;
    }
    // The first that a client is sent is as urgent as in a View without a base.
    const bool soon = !updates_.at(*key).first || view_.stream().is_near(*key);
    if (ChunkWaits::Waiters* const waiters = waits_.find(*key)) {
      waiters->update = true;
      if (soon && !std::exchange(waiters->soon, true)) context_.chunks.hasten(mailbox_->owner(), {&*key, 1});
    } else if (context_.chunks.submit(mailbox_, {&*key, 1}, soon ? Urgency::soon : Urgency::later,
                                      Version::edited) == 1) {
      ChunkWaits::Waiters& added = waits_.add(*key, context_.clock.now());
      added.update = true;
      added.soon = soon;
    } else {
      queue_full_ = true;
      return;
    }
    updates_.asked();
  }
}

void Delivery::answer_update(ChunkKey key, ChunkAnswer answer) {
  if (!answer) {
    replies_.error(
        about_view_chunk(view_.number(), key), ErrorCode::internal,
        fmt::format("chunk {} of the View was edited, and failed: {}", to_string(key), answer.error().reason),
        retry_after::kFailed);
    updates_.erase(key);
  } else if ((*answer)->revision() > updates_.at(key).has) {
    updates_.give(key, *std::move(answer));
    outbox_.push_update(key);
  } else {
    updates_.want(key);  // it was made before the edit
  }
}

void Delivery::drop_updates() {
  const auto gone = [this](ChunkKey key) { return !view_.stream().is_done(key); };
  const std::vector<ChunkKey> unwanted = waits_.leave_updates_where(gone);
  if (!unwanted.empty()) context_.chunks.cancel(mailbox_->owner(), unwanted);
  outbox_.drop_updates(gone);
  pauses_.drop(gone);
  updates_.drop(gone);
}

}  // namespace talus::server
