// EditIntake: edits, from the bounds that they keep to their answers.
#include <algorithm>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "edits/edit_intake.h"
#include "edits/edit_outcome.h"

namespace talus::server {

void EditIntake::take_look_ups(Lane& lane) {
  for (Mail& mail : lane.look_ups->take()) {
    const auto* const ready = std::get_if<ChunkReady>(&mail);
    if (ready == nullptr || !lane.first) continue;  // room: advance() asks again
    Prepared& edit = *lane.first;
    if (edit.asked.erase(ready->key.coord) == 0) continue;
    if (ready->answer) {
      const DecodedChunkPtr chunk = bases_.put(ready->key.coord, **ready->answer);
      const auto touched =
          std::ranges::lower_bound(edit.touched, ready->key.coord, {}, &edits::TouchedChunk::chunk);
      edit.base.emplace(ready->key.coord, voxels_at(*chunk, touched->voxels));
      edit.missing.erase(ready->key.coord);
    } else {
      refuse_first(lane, EditRefused::ground,
                   fmt::format("the ground under the edit failed: {}", ready->answer.error().reason));
    }
  }
}

void EditIntake::advance(Lane& lane) {
  if (!lane.first) {
    if (lane.waiting.empty()) return;
    Editing next = std::move(lane.waiting.front());
    lane.waiting.pop_front();
    lane.first = prepare(lane, std::move(next));
    if (!lane.first) {
      --waiting_;
      return;
    }
  }
  if (!look_up(lane, *lane.first)) return refuse_half_closed(lane);
  if (!lane.first->missing.empty()) return;
  --waiting_;
  log_edit(lane, *std::exchange(lane.first, std::nullopt));
}

std::optional<EditIntake::Prepared> EditIntake::prepare(const Lane& lane, Editing edit) {
  const std::uint32_t id = edit.request.id;
  auto touched = edits::touched_voxels(edit.request.edit, settles() && edit.request.settles);
  if (!touched) {
    refuse(lane.session, id, EditRefused::out_of_range, touched.error().message);
    return std::nullopt;
  }
  if (const auto good = edits::check(edit.request.edit, {rules_.rows, rules_.materials}); !good) {
    refuse(lane.session, id, EditRefused::out_of_range, good.error().message);
    return std::nullopt;
  }
  Prepared prepared{std::move(edit), *std::move(touched), {}, {}, {}};
  for (const edits::TouchedChunk& each : prepared.touched) prepared.missing.insert(each.chunk);
  return prepared;
}

bool EditIntake::look_up(const Lane& lane, Prepared& edit) {
  std::vector<ChunkKey> to_ask;
  for (const edits::TouchedChunk& each : edit.touched) {
    if (!edit.missing.contains(each.chunk)) continue;
    DecodedChunkPtr chunk = bases_.find(each.chunk);
    if (chunk == nullptr) {
      const EncodedChunkPtr encoded = parts_.base.find({each.chunk, Lod{}}, Version::generated);
      if (encoded != nullptr) chunk = bases_.put(each.chunk, *encoded);
    }
    if (chunk != nullptr) {
      edit.base.emplace(each.chunk, voxels_at(*chunk, each.voxels));
      edit.missing.erase(each.chunk);
    } else if (!edit.asked.contains(each.chunk)) {
      to_ask.push_back({each.chunk, Lod{}});
    }
  }
  if (lane.input_ended && !edit.missing.empty()) return false;
  if (to_ask.empty()) return true;
  // The others are asked for when an answer comes, or room does.
  const std::size_t accepted = parts_.base.submit(lane.look_ups, to_ask, Urgency::soon, Version::generated);
  for (std::size_t i = 0; i < accepted; ++i) edit.asked.insert(to_ask[i].coord);
  return true;
}

void EditIntake::log_edit(const Lane& lane, Prepared edit) {
  EditRequest& request = edit.edit.request;
  const std::uint32_t id = request.id;
  edits::EditEntry entry{request.editor,
                         request.epoch,
                         request.sequence,
                         std::move(request.edit),
                         std::move(edit.base),
                         request.settles ? rules_.settles : nullptr,
                         std::move(request.subject),
                         {}};
  // Else they are with those that settle.
  if (entry.settles == nullptr) entry.touched = std::move(edit.touched);
  ++*lane.in_log;
  auto done = [this, session = lane.session, id, came = edit.edit.came,
               in_log = lane.in_log](const tl::expected<const edits::Applied*, LogFailure>& outcome) {
    --*in_log;
    try {
      auto result = outcome_of(outcome);
      if (!result) return refuse(session, id, result.error().why, std::move(result.error().text));
      parts_.metrics.edit_latency.add(parts_.clock.now() - came);
      tell(session, EditAnswer{id, *result});
    } catch (const std::exception&) {
      session->lose_mail();  // no memory
    }
  };
  if (const auto taken = append(std::move(entry), std::move(done)); !taken) {
    --*lane.in_log;
    refuse(lane.session, id, why_of(taken.error().kind), taken.error().reason);
  }
}

void EditIntake::refuse_half_closed(Lane& lane) {
  refuse_first(lane, EditRefused::half_closed,
               "the client shut its sending side before the ground under the edit was generated; send the "
               "edit on a connection that stays open");
}

void EditIntake::refuse_first(Lane& lane, EditRefused why, std::string text) {
  --waiting_;
  cancel_look_ups(lane);
  refuse(lane.session, lane.first->edit.request.id, why, std::move(text));
  lane.first.reset();
}

void EditIntake::refuse(const MailboxPtr& session, std::uint32_t id, EditRefused why, std::string text) {
  parts_.metrics.edits_refused[why].add();
  tell(session, EditAnswer{id, tl::unexpected{refusal_of(why, std::move(text))}});
}

}  // namespace talus::server
