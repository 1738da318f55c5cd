#include "player/session/delivery.h"

#include <algorithm>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <variant>

#include <fmt/format.h>

namespace talus::server {

using wire::ErrorCode;

void Delivery::request_heights(std::uint32_t id, HeightsQuery query) {
  constexpr std::size_t kTaskBytes = 256;
  const std::uint64_t ticket = (++heights_asked_ << 32) | id;
  const std::size_t column_bytes = sizeof(terrain::BaseColumn) + 2 * sizeof(std::int32_t) +
                                   sizeof(std::uint8_t) + query.fields.size() * sizeof(float);
  requests_.add_heights(id, ticket, kTaskBytes + query.columns.size() * column_bytes);
  context_.chunks.submit_heights(mailbox_, ticket, std::move(query));
}

void Delivery::cancel(const std::vector<std::uint32_t>& ids) {
  std::unordered_set<std::uint32_t> cancelled;
  for (const std::uint32_t id : ids) {
    if (const auto* request = requests_.chunk(id)) {
      if (waits_.leave(request->key, id)) {
        context_.chunks.cancel(mailbox_->owner(), {&request->key, 1});
        queue_full_ = false;  // it may have been the last chunk for which mail would come
      }
    } else if (const auto ticket = requests_.heights_ticket(id)) {
      context_.chunks.cancel_heights(mailbox_->owner(), *ticket);
    } else if (requests_.file(id) == nullptr) {
      continue;  // answered already, or never asked
    }
    requests_.erase(id);
    cancelled.insert(id);
    replies_.error(about_request(id), ErrorCode::cancelled, "cancelled");
  }
  if (cancelled.empty()) return;
  outbox_.drop_chunks([&](const Outbox::Entry& entry) { return cancelled.contains(entry.request_id); });
}

std::size_t Delivery::apply_view() {
  if (!view_.waits()) return 0;
  queue_full_ = false;  // the new View may need no place in the queue
  view_.apply();
  const std::size_t dropped = drop_what_left_view();
  const auto is_near = [this](ChunkKey key) { return view_.stream().is_near(key); };
  outbox_.move_first(is_near);
  const auto came_near = waits_.hasten_where(is_near);
  if (!came_near.empty()) context_.chunks.hasten(mailbox_->owner(), came_near);
  if (view_.has_base()) {
    context_.chunks.set_watched(mailbox_, view_.ahead());
    find_edited();  // now that later edits are reported
  } else {
    context_.chunks.set_wanted(mailbox_, view_.ahead());
  }
  count_view(view_.has_base());
  return dropped;
}

void Delivery::find_edited() {
  const ViewStream& stream = view_.stream();
  std::vector<ChunkKey> edited;
  for (const LevelBox& box : stream.boxes()) {
    context_.chunks.edited_chunks(
        box, [&](ChunkKey column) { return stream.is_undecided(column); }, edited);
  }
  view_.mark_edited(edited);
}

void Delivery::count_view(std::optional<bool> has_base) {
  const auto gauge = [&](bool base) -> Gauge& {
    return base ? context_.metrics.views_local : context_.metrics.views_stream;
  };
  if (counted_view_) gauge(*counted_view_).fall();
  if (has_base) gauge(*has_base).rise();
  counted_view_ = has_base;
}

void Delivery::end_view() {
  view_.clear();
  count_view(std::nullopt);
  drop_what_left_view();
  context_.chunks.set_wanted(mailbox_, {});
}

std::size_t Delivery::drop_what_left_view() {
  const auto left = [this](ChunkKey key) { return !view_.stream().in_flight(key); };
  const std::vector<ChunkKey> unwanted = waits_.leave_view_where(left);
  if (!unwanted.empty()) context_.chunks.cancel(mailbox_->owner(), unwanted);
  drop_updates();
  return outbox_.drop_chunks(
      [&](const Outbox::Entry& entry) { return entry.request_id == 0 && left(entry.key); });
}

void Delivery::take_mail(SessionEdits& session_edits) {
  constexpr std::size_t kKept = 8;
  std::vector<Mail> mail = mailbox_->take(std::move(read_mail_));
  for (Mail& each : mail) {
    std::visit(
        [&]<typename Letter>(Letter& letter) {
          if constexpr (std::is_same_v<Letter, AttachAnswer> || std::is_same_v<Letter, EditAnswer>) {
            session_edits.receive(std::move(letter));
          } else {
            // Any mail from the generators shows that their queue moves.
            if constexpr (!std::is_same_v<Letter, ChunksChanged>) queue_full_ = false;
            receive(std::move(letter));
          }
        },
        each);
  }
  mail.clear();
  if (mail.capacity() <= kKept) read_mail_ = std::move(mail);
}

void Delivery::receive(ChunkReady&& mail) {
  auto& [key, answer] = mail;
  if (answer) expected_chunk_bytes_ = std::max(expected_chunk_bytes_, Outbox::cost(**answer));
  const auto waiters = waits_.take(key);
  if (!waiters) return;  // the last one left while the answer came
  context_.metrics.cold_latency.add(context_.clock.now() - waiters->since);
  for (const std::uint32_t id : waiters->requests) {
    answer ? answer_request(id, *requests_.chunk(id), *answer) : fail_request(id, answer.error());
  }
  if (waiters->update) answer_update(key, answer);
  if (waiters->view) answer_view(key, std::move(answer));
}

void Delivery::receive(ChunksChanged&& mail) {
  const ViewStream& stream = view_.stream();
  if (mail.changes == nullptr) {
    // The client's revision of each is not known any more, but it has at least the chunk as generated.
    stream.for_each_done([this](ChunkKey key) {
      if (context_.chunks.revision(key) != kBaseRevision) add_update(key, kBaseRevision);
    });
    return;
  }
  for (const ChunkChange& change : *mail.changes) {
    if (stream.is_done(change.key)) add_update(change.key, change.previous);
  }
}

void Delivery::receive(HeightsReady&& mail) {
  const auto id = static_cast<std::uint32_t>(mail.ticket);
  if (requests_.heights_ticket(id) != mail.ticket) return;  // cancelled while the answer came
  if (mail.answer) {
    replies_.heights(id, *mail.answer);
  } else {
    replies_.error(about_request(id), ErrorCode::internal,
                   fmt::format("the heights failed: {}", mail.answer.error().reason), retry_after::kFailed);
  }
  requests_.erase(id);
}

std::size_t Delivery::start_work() {
  found_ = 0;
  // Between the two bounds held_back_ stays as it is.
  const std::size_t unsent = outbox_.chunks(Outbox::Lane::view);
  held_back_ = unsent >= kMaxViewInFlight || (held_back_ && unsent > 0);
  ask_for_updates();
  send_file_parts();
  while (has_room()) {
    if (requests_.has_unstarted() && (!view_may_start() || requests_hold_less())) {
      start_request(*requests_.next_unstarted());
    } else if (view_may_start()) {
      start_view_chunk();
    } else {
      break;
    }
  }
  if (!credit_.may_send() && !view_.has_base()) send_columns();
  if (updates_.first() == 0) {
    if (const auto number = view_.completed()) replies_.view_complete(*number);
  }
  return found_;
}

void Delivery::send_file_parts() {
  while (outbox_.control_bytes() < kMaxColumnBytes) {
    const auto id = requests_.next_file();
    if (!id) return;
    const PendingRequests::FileRequest& request = *requests_.file(*id);
    replies_.file_part(*id, request.size, request.part);
    requests_.erase(*id);
  }
}

bool Delivery::requests_hold_less() const {
  using Lane = Outbox::Lane;
  const std::size_t view_waits = view_.stream().in_flight_count() - outbox_.chunks(Lane::view);
  const std::size_t request_waits = waits_.size() - view_waits;  // without chunks for which both wait
  return outbox_.chunk_bytes(Lane::requests) + request_waits * expected_chunk_bytes_ <=
         outbox_.chunk_bytes(Lane::view) + view_waits * expected_chunk_bytes_;
}

void Delivery::send_columns() {
  while (view_.stream().to_send() > 0 && outbox_.control_bytes() < kMaxColumnBytes) {
    const auto column = view_.stream().next_column();
    if (!column) return;
    send_column(*column, context_.chunks.column(*column, Version::edited), nullptr);
  }
}

bool Delivery::has_room() const {
  const std::size_t waits = waits_.size() + to_submit_.size();
  const std::size_t to_come = waits * expected_chunk_bytes_;
  const std::size_t queued = outbox_.chunk_bytes() + updates_.chunk_bytes();
  return waits < kMaxWaits && queued + to_come < context_.limits.queued_bytes;
}

EncodedChunkPtr Delivery::find(ChunkKey key) {
  EncodedChunkPtr chunk = context_.chunks.find(key, Version::edited);
  if (chunk != nullptr) ++found_;
  return chunk;
}

void Delivery::start_request(std::uint32_t id) {
  const PendingRequests::ChunkRequest& request = *requests_.chunk(id);
  if (EncodedChunkPtr chunk = find(request.key)) {
    answer_request(id, request, std::move(chunk));
  } else if (ChunkWaits::Waiters* const waiters = waits_.find(request.key)) {
    waiters->requests.push_back(id);
  } else if (context_.chunks.submit(mailbox_, {&request.key, 1}, Urgency::later, Version::edited) == 1) {
    waits_.add(request.key, context_.clock.now()).requests.push_back(id);
  } else {
    replies_.error(about_request(id), ErrorCode::overloaded,
                   context_.memory.takes_jobs() ? "too many chunks wait to be generated" : kNoMemory,
                   retry_after::kBusy);
    requests_.erase(id);
  }
}

void Delivery::start_view_chunk() {
  const ChunkKey nearest = *view_.stream().nearest();
  if (view_.has_base() ? update_base(nearest) : answer_by_column(nearest)) return;
  view_.stream().start(nearest);
  if (EncodedChunkPtr chunk = find(nearest)) {
    send_view_chunk(nearest, std::move(chunk));
  } else {
    to_submit_ = {nearest};
    if (!view_.has_base()) start_column_neighbours(nearest);
    wait_for_view();
    to_submit_.clear();
  }
}

bool Delivery::update_base(ChunkKey key) {
  if (view_.is_known(key)) return false;
  view_.stream().start(key);
  view_.done(key);
  updates_.add_first(key);
  outbox_.push_update(key);
  return true;
}

void Delivery::start_column_neighbours(ChunkKey nearest) {
  ViewStream& stream = view_.stream();
  const int edge = context_.chunks.columns_together();
  const std::size_t most = goes_ahead() ? kMaxViewAlone : kMaxViewWaits;
  stream.for_each_column_beside(nearest, edge, [&](ChunkKey column) {
    send_column(column, context_.chunks.column(column, Version::edited), nullptr);
    stream.for_each_to_send(column, nearest, edge, [&](ChunkKey key) {
      if (!has_room() || waits_.size() + to_submit_.size() >= most) return;
      stream.start(key);
      to_submit_.push_back(key);
    });
  });
}

void Delivery::wait_for_view() {
  const bool soon = view_.stream().is_near(to_submit_.front());
  // Chunks for which a request waits are submitted already; and a UniformColumn sent meanwhile may have
  // answered some.
  const auto submitted = [&](ChunkKey key) {
    if (!view_.stream().in_flight(key)) return true;
    ChunkWaits::Waiters* const waiters = waits_.find(key);
    if (waiters == nullptr) return false;
    waiters->view = true;
    if (soon && !std::exchange(waiters->soon, true)) context_.chunks.hasten(mailbox_->owner(), {&key, 1});
    return true;
  };
  const auto news = std::remove_if(to_submit_.begin(), to_submit_.end(), submitted);
  to_submit_.erase(news, to_submit_.end());
  const std::size_t accepted =
      context_.chunks.submit(mailbox_, to_submit_, soon ? Urgency::soon : Urgency::later, Version::edited);
  for (std::size_t i = 0; i < to_submit_.size(); ++i) {
    if (i < accepted) {
      ChunkWaits::Waiters& waiters = waits_.add(to_submit_[i], context_.clock.now());
      waiters.view = true;
      waiters.soon = soon;
    } else {
      view_.stream().put_back(to_submit_[i]);
    }
  }
  queue_full_ = accepted < to_submit_.size();
}

void Delivery::answer_request(std::uint32_t id, const PendingRequests::ChunkRequest& request,
                              EncodedChunkPtr chunk) {
  if (confirm_request(id, request, *chunk)) return;
  if (request.known && chunk->revision() == kBaseRevision && view_.has_base()) {
    context_.metrics.proofs_failed.add();  // the client makes other chunks
  }
  if (chunk->uniform()) {
    credit_.sent(chunk->frame_bytes());  // the client counts every Chunk that comes
    replies_.small_chunk(id, request.key, *chunk);
    requests_.erase(id);
    return;
  }
  outbox_.push_chunk({id, request.key, std::move(chunk)});  // pending until it is written
}

void Delivery::fail_request(std::uint32_t id, const GenerationError& failure) {
  replies_.error(about_request(id), ErrorCode::internal, fmt::format("the chunk failed: {}", failure.reason),
                 retry_after::kFailed);
  requests_.erase(id);
}

void Delivery::answer_view(ChunkKey key, ChunkAnswer answer) {
  if (!answer) {
    replies_.error(about_view_chunk(view_.number(), key), ErrorCode::internal,
                   fmt::format("chunk {} of the View failed: {}", to_string(key), answer.error().reason),
                   retry_after::kFailed);
    view_.done(key);
    return;
  }
  // The column may be known only since the chunk was submitted.
  if (view_.has_base() || !answer_by_column(key)) send_view_chunk(key, *std::move(answer));
}

void Delivery::send_view_chunk(ChunkKey key, EncodedChunkPtr chunk) {
  if (confirm_view(key, *chunk)) return;
  outbox_.push_chunk({0, key, std::move(chunk)});
  // Far chunks that the client is slow to take do not delay it.
  if (view_.stream().is_near(key)) {
    outbox_.move_first([this](ChunkKey queued) { return view_.stream().is_near(queued); });
  }
}

bool Delivery::confirm_request(std::uint32_t id, const PendingRequests::ChunkRequest& request,
                               const EncodedChunk& chunk) {
  if (chunk.revision() != kBaseRevision || request.known != chunk.hash()) return false;
  replies_.unchanged(id, request.key, chunk);
  requests_.erase(id);
  return true;
}

bool Delivery::confirm_view(ChunkKey key, const EncodedChunk& chunk) {
  if (chunk.revision() != kBaseRevision || !view_.knows(key, chunk.hash())) return false;
  replies_.unchanged(0, key, chunk);
  sent_to_view(key, kBaseRevision, context_.chunks.revision(key));
  return true;
}

bool Delivery::answer_by_column(ChunkKey key) {
  const MixedRows rows = context_.chunks.column(key, Version::edited);
  if (!rows.uniform_at(key.coord.y)) return false;
  send_column(key, rows, &key);
  return true;
}

void Delivery::send_column(ChunkKey column, const MixedRows& rows, const ChunkKey* answered) {
  std::vector<wire::UniformRun> runs;
  view_.stream().done_in_column(column, [&](ChunkKey chunk, bool in_flight) {
    const std::int32_t y = chunk.coord.y;
    const auto uniform = rows.uniform_at(y);
    if (!uniform) return false;
    const bool here = answered != nullptr && chunk == *answered;
    if (in_flight && !here && !waits_.end_view(chunk)) return false;  // it waits for the client
    const auto material = to_integer(*uniform);
    const bool goes_on = !runs.empty() && runs.back().last_y() == y - 1 && runs.back().material() == material;
    const std::int32_t first = goes_on ? runs.back().first_y() : y;
    if (goes_on) runs.pop_back();
    runs.emplace_back(first, y, material);
    return true;
  });
  if (!runs.empty()) replies_.column(column, runs);
}

void Delivery::abandon() {
  context_.chunks.cancel(mailbox_->owner(), waits_.clear());
  for (const std::uint32_t id : requests_.ids()) {
    if (const auto ticket = requests_.heights_ticket(id)) {
      context_.chunks.cancel_heights(mailbox_->owner(), *ticket);
    }
  }
  requests_.clear();
  view_.clear();
  count_view(std::nullopt);
  context_.chunks.set_wanted(mailbox_, {});
  outbox_.drop_chunks([](const Outbox::Entry&) { return true; });
  drop_updates();
}

std::size_t Delivery::bytes() const {
  constexpr std::size_t kPerRequest = 128;  // in the source's queue
  return outbox_.chunk_bytes() + view_.bytes() + requests_.bytes() + updates_.bytes() + pauses_.bytes() +
         (requests_.size() + waits_.size()) * kPerRequest;
}

}  // namespace talus::server
