// EditIntake: edits, from their bounds to their answers.
#include <algorithm>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "edits/edit_intake.h"

namespace talus::server {
namespace {

using Code = EditErrorCode;

/// The answer to the client for the outcome in the log.
tl::expected<edits::EditResult, EditError> answer_of(
    const tl::expected<const edits::EntryResult*, EditError>& outcome) {
  using Kind = edits::EntryResult::Kind;
  if (!outcome) return tl::unexpected{outcome.error()};
  const edits::EntryResult& applied = **outcome;
  switch (applied.kind) {
    case Kind::done:
    case Kind::conflict:
    case Kind::repeat:
      if (!applied.result.conflict) return applied.result;
      return edit_error(Code::conflict,
                        fmt::format("guard {} does not hold; nothing was changed", *applied.result.conflict));
    case Kind::not_applied:
      if (applied.is_unknown) {
        return edit_error(
            Code::out_of_range,
            fmt::format("the sequence is below those of the editor's last {} results, so whether its edit "
                        "happened is not known any more; sequences must increase",
                        edits::kKeptResults));
      }
      return edit_error(
          Code::not_applied,
          "the sequence is not above the editor's last, and no edit had it; sequences must increase");
    case Kind::expired:
      return edit_error(
          Code::expired,
          "another connection has attached as this editor, or it was idle for too long; attach again");
    default:
      return edit_error(Code::invalid, "the entry in the log cannot be applied");
  }
}

}  // namespace

void EditIntake::take_look_ups(Lane& lane) {
  for (Mail& mail : lane.look_ups->take()) {
    const auto* const ready = std::get_if<ChunkReady>(&mail);
    if (ready == nullptr || !lane.first) continue;  // QueueHasRoom: advance() retries
    Preparation& edit = *lane.first;
    if (edit.asked.erase(ready->key.coord) == 0) continue;
    if (ready->answer) {
      edit.take(ready->key.coord, *bases_.put(ready->key.coord, **ready->answer));
    } else {
      refuse_first(lane, {Code::ground, fmt::format("a chunk of the edit could not be generated: {}",
                                                    ready->answer.error().reason)});
    }
  }
  if (lane.look_ups->has_lost()) lane.session->lose_mail();
}

void EditIntake::advance(Lane& lane) {
  const bool looks_up = lane.first.has_value();
  take_look_ups(lane);
  if (looks_up && !lane.first) return;  // it was refused
  if (!lane.first) {
    if (lane.waiting.empty()) return;
    WaitingEdit next = std::move(lane.waiting.front());
    lane.waiting.pop_front();
    lane.first = prepare(lane, std::move(next));
    if (!lane.first) {
      --waiting_;
      return;
    }
  }
  if (!look_up(lane, *lane.first)) return refuse_half_closed(lane);
  if (!lane.first->missing.empty() || !lane.may_log) return;
  --waiting_;
  log_edit(lane, *std::exchange(lane.first, std::nullopt));
}

tl::expected<std::vector<edits::TouchedChunk>, EditError> EditIntake::admit(const edits::Edit& edit) const {
  auto touched = edits::touched_voxels(edit);
  if (!touched) return edit_error(Code::out_of_range, std::move(touched.error().message));
  if (auto good = edits::check(edit, {rules_.rows, rules_.materials}); !good) {
    return edit_error(Code::out_of_range, std::move(good.error().message));
  }
  return *std::move(touched);
}

std::optional<EditIntake::Preparation> EditIntake::prepare(const Lane& lane, WaitingEdit edit) {
  auto touched = admit(edit.request.edit);
  if (!touched) {
    refuse(lane.session, edit.request.id, std::move(touched.error()));
    return std::nullopt;
  }
  Preparation prepared{std::move(edit), *std::move(touched), {}, {}, {}, {}};
  const EditRequest& request = prepared.edit.request;
  if (settles() && request.settles) {
    prepared.settling = edits::with_settling(prepared.touched, request.extent.loose);
  }
  if (auto good = look_around(prepared); !good) {
    refuse(lane.session, request.id, std::move(good.error()));
    return std::nullopt;
  }
  for (const edits::TouchedChunk& each : prepared.looked_up()) prepared.missing.insert(each.chunk);
  return prepared;
}

tl::expected<void, EditError> EditIntake::look_around(Preparation& edit) const {
  if (!rules_.hidden) return {};
  edit.around = edits::with_neighbours(edit.needed());
  // What it reveals is part of its record in the store, whose bound is the same. Independent of what is
  // there.
  if (edit.around.size() <= edits::kMaxChunks) return {};
  return edit_error(
      Code::out_of_range,
      fmt::format("edit: with the voxels beside its own it reaches more than {} chunks; it must "
                  "be divided",
                  edits::kMaxChunks));
}

void EditIntake::Preparation::take(ChunkCoord coord, const DecodedBase& decoded) {
  missing.erase(coord);
  const auto in = [&](const std::vector<edits::TouchedChunk>& chunks) {
    const auto at = std::ranges::lower_bound(chunks, coord, {}, &edits::TouchedChunk::chunk);
    return at == chunks.end() || at->chunk != coord ? std::span<const std::uint16_t>{}
                                                    : std::span{at->voxels};
  };
  if (const auto voxels = in(needed()); !voxels.empty())
    base.emplace(coord, voxels_at(decoded.chunk, voxels));
  std::vector<Override> hidden = among(decoded.hidden, in(around));
  if (hidden.empty()) return;
  std::vector<Override> shown;
  for (const Override& each : hidden) shown.push_back({each.index, decoded.chunk.at(local_of(each.index))});
  secrets.base.emplace(coord, std::move(shown));
  secrets.hidden.emplace(coord, std::move(hidden));
}

bool EditIntake::look_up(const Lane& lane, Preparation& edit) {
  std::vector<ChunkKey> to_ask;
  for (const edits::TouchedChunk& each : edit.looked_up()) {
    if (!edit.missing.contains(each.chunk)) continue;
    DecodedBasePtr base = bases_.find(each.chunk);
    if (base == nullptr) {
      const EncodedChunkPtr encoded = parts_.base.find({each.chunk, Lod{}}, Version::generated);
      if (encoded != nullptr) base = bases_.put(each.chunk, *encoded);
    }
    if (base != nullptr) {
      edit.take(each.chunk, *base);
    } else if (!edit.asked.contains(each.chunk)) {
      to_ask.push_back({each.chunk, Lod{}});
    }
  }
  if (lane.input_ended && !edit.missing.empty()) return false;
  if (to_ask.empty()) return true;
  // The rest follows when an answer or QueueHasRoom arrives.
  const std::size_t accepted = parts_.base.submit(lane.look_ups, to_ask, Urgency::soon, Version::generated);
  for (std::size_t i = 0; i < accepted; ++i) edit.asked.insert(to_ask[i].coord);
  return true;
}

void EditIntake::log_edit(const Lane& lane, Preparation edit) {
  EditRequest& request = edit.edit.request;
  const std::uint32_t id = request.id;
  edits::EditEntry entry{request.editor,
                         request.epoch,
                         request.sequence,
                         std::move(request.edit),
                         std::move(edit.base),
                         request.settles ? rules_.settles : nullptr,
                         std::move(request.subject),
                         std::move(edit.touched),
                         std::move(edit.secrets)};
  if (!entry.secrets.empty()) entry.secrets.see_through = rules_.see_through;
  ++*lane.in_log;
  auto done = [this, session = lane.session, id, received_at = edit.edit.received_at,
               in_log = lane.in_log](const tl::expected<const edits::EntryResult*, EditError>& outcome) {
    --*in_log;
    try {
      auto result = answer_of(outcome);
      if (!result) return refuse(session, id, std::move(result.error()));
      parts_.metrics.edit_latency.add(parts_.clock.now() - received_at);
      send(session, EditAnswer{id, *result});
    } catch (const std::exception&) {
      session->lose_mail();  // no memory
    }
  };
  if (const auto taken = append(std::move(entry), std::move(done)); !taken) {
    --*lane.in_log;
    refuse(lane.session, id, taken.error());
  }
}

void EditIntake::refuse_half_closed(Lane& lane) {
  refuse_first(
      lane, {Code::half_closed,
             "the client closed its sending side before the chunks of the edit were generated; send the edit "
             "on a connection that stays open"});
}

void EditIntake::refuse_first(Lane& lane, EditError error) {
  --waiting_;
  cancel_look_ups(lane);
  refuse(lane.session, lane.first->edit.request.id, std::move(error));
  lane.first.reset();
}

void EditIntake::refuse(const MailboxPtr& session, std::uint32_t id, EditError error) {
  parts_.metrics.edits_refused[error.code].add();
  if (error.code == Code::unreadable) log_->error("an edit is refused: {}", error.message);
  send(session, EditAnswer{id, tl::unexpected{std::move(error)}});
}

}  // namespace talus::server
