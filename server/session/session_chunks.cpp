// How chunks are asked for, arrive and leave.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "session/replies.h"
#include "session/session.h"

namespace talus::server {
namespace {

constexpr std::uint32_t kRetryAfterMs = 1000;

}  // namespace

void Session::apply_view() {
  if (!next_view_) return;
  const View view = *std::exchange(next_view_, std::nullopt);
  drop_from_view(view_.replace(AreaOfInterest{view}, std::exchange(unseen_views_, {})));
  std::erase_if(known_, [&](const auto& chunk) { return !view_.wants(chunk.first); });
}

void Session::drop_from_view(const std::vector<ChunkKey>& keys) {
  for (const ChunkKey key : keys) (void)give_up_for_view(key);
  outbox_.drop_chunks(
      [&](const Outbox::Entry& entry) { return entry.request_id == 0 && !view_.under_way(entry.key); });
}

void Session::pump() {
  const Clock::time_point began = Clock::now();
  take_up_work();
  const std::size_t found = std::exchange(found_, 0);
  if (found > 0) context_.metrics.hot_latency.add(Clock::now() - began, found);
  note_memory();
}

void Session::take_up_work() {
  refused_ = false;
  while (!closing() && !refused_ && has_room_for_chunk()) {
    if (const auto id = requests_.next_waiting()) {
      start_request(*id);
      continue;
    }
    if (view_.under_way_count() >= kViewWindow || outbox_.control_bytes() >= kColumnBytes) return;
    const auto key = view_.next();
    if (!key) return;
    refused_ = !start_view_chunk(*key);
  }
}

bool Session::has_room_for_chunk() const {
  const std::size_t to_come = awaited_.size() * expected_chunk_bytes_;
  return awaited_.size() < kServiceWindow &&
         outbox_.chunk_bytes() + to_come < context_.limits.queued_bytes_per_session;
}

void Session::start_request(std::uint32_t id) {
  const ChunkKey key = requests_.chunk(id)->key;
  if (EncodedChunkPtr chunk = find(key)) {
    answer_request(id, std::move(chunk));
  } else if (Awaited* awaited = await(key)) {
    awaited->requests.push_back(id);
  } else {
    refuse(id, wire::ErrorCode::overloaded,
           context_.chunks.memory().takes_work() ? "too many chunks wait to be generated" : kNoMemory,
           kRetryAfterMs);
    requests_.erase(id);
  }
}

bool Session::start_view_chunk(ChunkKey key) {
  if (answer_by_column(key)) return true;
  if (EncodedChunkPtr chunk = find(key)) {
    answer_view(key, std::move(chunk));
    return true;
  }
  if (Awaited* awaited = await(key)) {
    awaited->view = true;
    return true;
  }
  view_.put_back(key);
  return false;
}

bool Session::answer_by_column(ChunkKey key) {
  const terrain::MixedRange mixed = context_.chunks.rows(key);
  const auto uniform = [&](std::int32_t y) { return y < mixed.first || y > mixed.last; };
  if (!uniform(key.coord.y)) return false;
  std::vector<wire::UniformRun> runs;
  view_.done_in_column(key, [&](ChunkKey chunk, bool under_way) {
    const std::int32_t y = chunk.coord.y;
    if (!uniform(y)) return false;
    if (under_way && chunk != key && !give_up_for_view(chunk)) return false;
    const auto material = to_integer(y < mixed.first ? mixed.below : kAir);
    const bool goes_on = !runs.empty() && runs.back().last_y() == y - 1 && runs.back().material() == material;
    const std::int32_t first = goes_on ? runs.back().first_y() : y;
    if (goes_on) runs.pop_back();
    runs.emplace_back(first, y, material);
    return true;
  });
  outbox_.push_control(column_frame(key, runs));
  context_.metrics.columns_sent.add();
  return true;
}

bool Session::confirm_known(ChunkKey key, ContentHash hash) {
  const auto known = known_.find(key);
  if (known == known_.end()) return false;
  const bool same = known->second == hash;
  known_.erase(known);
  if (!same) return false;
  outbox_.push_control(unchanged_frame(0, key, hash));
  context_.metrics.unchanged_sent.add();
  view_.done(key);
  return true;
}

bool Session::give_up_for_view(ChunkKey key) {
  const auto found = awaited_.find(key);
  if (found == awaited_.end()) return false;  // it waits to be sent
  found->second.view = false;
  stop_awaiting(key, found->second);
  return true;
}

Session::Awaited* Session::await(ChunkKey key) {
  if (const auto found = awaited_.find(key); found != awaited_.end()) return &found->second;
  if (context_.chunks.submit(client_, key) == ChunkService::Submission::refused) return nullptr;
  return &awaited_[key];
}

void Session::stop_awaiting(ChunkKey key, const Awaited& awaited) {
  if (awaited.view || !awaited.requests.empty()) return;
  context_.chunks.cancel(*client_, key);
  awaited_.erase(key);
}

void Session::chunk_ready(ChunkKey key, const ChunkAnswer& answer) {
  if (answer) expected_chunk_bytes_ = std::max(expected_chunk_bytes_, Outbox::cost(**answer));
  // Nobody may wait any more: the last one left when the answer was on its way.
  const auto found = awaited_.extract(key);
  if (found.empty()) return;
  context_.metrics.cold_latency.add(Clock::now() - found.mapped().since);
  for (const std::uint32_t id : found.mapped().requests) answer_request(id, answer);
  if (found.mapped().view) answer_view(key, answer);
}

void Session::answer_request(std::uint32_t id, ChunkAnswer answer) {
  const RequestBook::ChunkRequest& request = *requests_.chunk(id);
  if (!answer) {
    refuse(id, wire::ErrorCode::internal, fmt::format("the chunk failed: {}", answer.error().reason),
           kRetryAfterMs);
  } else if (request.known == (*answer)->hash()) {
    outbox_.push_control(unchanged_frame(id, request.key, (*answer)->hash()));
    context_.metrics.unchanged_sent.add();
  } else {
    outbox_.push_chunk({id, request.key, *std::move(answer)});
    return;  // in flight until it is taken from the outbox
  }
  requests_.erase(id);
}

void Session::answer_view(ChunkKey key, ChunkAnswer answer) {
  // Its terrain is known now; it may not have been when the chunk was wished for.
  if (answer && answer_by_column(key)) return;
  if (answer && confirm_known(key, (*answer)->hash())) return;
  if (answer) return outbox_.push_chunk({0, key, *std::move(answer)});
  refuse(0, wire::ErrorCode::internal,
         fmt::format("chunk {} of the View failed: {}", to_string(key), answer.error().reason),
         kRetryAfterMs);
  view_.done(key);
}

void Session::heights_ready(std::uint64_t ticket, const HeightsAnswer& answer) {
  const auto id = static_cast<std::uint32_t>(ticket);
  if (requests_.heights_ticket(id) != ticket) return;  // cancelled when the answer was on its way
  if (answer) {
    outbox_.push_control(heights_frame(id, *answer));
  } else {
    refuse(id, wire::ErrorCode::internal, fmt::format("the heights failed: {}", answer.error().reason),
           kRetryAfterMs);
  }
  requests_.erase(id);
}

Session::Clock::time_point Session::sendable_at(Clock::time_point now) {
  if (outbox_.has_control()) return now;
  if (!outbox_.sendable(credit_)) return Clock::time_point::max();
  return rates_.chunks_due(now);
}

Output Session::take_output(std::size_t enough_bytes, Clock::time_point now, std::size_t shared_from) {
  Output output{shared_from};
  output.reserve(std::min(enough_bytes, outbox_.bytes_to_copy(shared_from)));
  std::size_t chunks = 0;
  std::size_t chunk_bytes = 0;
  const auto allowance = rates_.allowance(now);
  outbox_.take(enough_bytes, credit_, allowance, output,
               [&](const Outbox::Entry& entry, std::size_t frame_bytes) {
                 ++chunks;
                 chunk_bytes += frame_bytes;
                 if (entry.request_id != 0) {
                   requests_.erase(entry.request_id);
                 } else {
                   view_.done(entry.key);
                 }
               });
  rates_.sent(now, chunks, output.size());
  writing_bytes_ = output.size();
  context_.metrics.chunks_sent.add(chunks);
  context_.metrics.chunk_bytes_sent.add(chunk_bytes);
  return output;
}

EncodedChunkPtr Session::find(ChunkKey key) {
  EncodedChunkPtr chunk = context_.chunks.find(key);
  if (chunk != nullptr) ++found_;
  return chunk;
}

}  // namespace talus::server
