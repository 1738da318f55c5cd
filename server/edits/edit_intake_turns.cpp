// EditIntake: whose turn it is, and what each session has there.
#include <utility>

#include "chunks/client_ids.h"
#include "edits/edit_intake.h"

namespace talus::server {
namespace {

/// In voxels: the cost of an edit in addition to its voxels, and of decoding a chunk, if it comes to that.
constexpr std::size_t kEditCost = 64;
constexpr std::size_t kDecodeCost = 256;

}  // namespace

bool EditIntake::log_has_room() const {
  // If the log accepts no entries, waiting edits are refused now.
  return (log_entries_ < kLogEntries && log_bytes_ < kLogBytes) || !parts_.log.takes_entries();
}

std::optional<ClientId> EditIntake::next() {
  if (small_.empty() && large_.empty()) {
    // Only here: the session that goes mostly enters again, and meanwhile others would lose what they owe.
    small_.clear();
    large_.clear();
    return std::nullopt;
  }
  // By turns, so that neither kind starves the other; but small edits do not wait for room in the log.
  small_went_ = !small_.empty() && (!small_went_ || large_.empty() || !log_has_room());
  if (small_went_) return next(small_);
  if (!log_has_room()) {
    wants_room_ = true;
    if (!log_has_room()) return std::nullopt;  // else it came just now, and who made it need not call
  }
  return next(large_);
}

std::optional<ClientId> EditIntake::next(Turns& turns) {
  const auto path = turns.next();
  if (!path) return std::nullopt;
  const auto [flow, client] = *path;
  turns.leave(flow, client);
  if (const Lane* const lane = find_lane(client)) turns.charge(static_cast<double>(lane->cost), flow, client);
  return client;
}

bool EditIntake::take_turn() {
  const auto client = next();
  if (!client) return false;
  Lane* const lane = find_lane(*client);
  if (lane == nullptr) return true;  // the session is gone
  lane->entered = false;
  const bool attaches = lane->attach_waits;
  if (attaches) {
    log_attach(*lane);
  } else {
    advance(*lane);
  }
  const bool goes_on = lane->first ? attaches || lane->first->missing.empty() : !lane->waiting.empty();
  if (goes_on) enter(*lane);
  return true;
}

EditIntake::Lane& EditIntake::lane_of(const MailboxPtr& session) {
  Lane& lane = lanes_[session->owner()];
  if (lane.session != nullptr) return lane;
  const std::uint64_t client = static_cast<std::uint64_t>(session->owner());
  lane.session = session;
  lane.look_ups = std::make_shared<Mailbox>(
      client_id(ClientKind::look_ups, client),  // their chunks are not the session's
      [this, client] {
        {
          const std::lock_guard lock{mutex_};
          looked_up_.insert(client);
          called_ = true;
        }
        comes_.notify_one();
      },
      session->flow_use());
  return lane;
}

EditIntake::Lane* EditIntake::find_lane(ClientId client) {
  const auto lane = lanes_.find(client);
  return lane == lanes_.end() ? nullptr : &lane->second;
}

void EditIntake::enter(Lane& lane) {
  if (lane.entered) return;
  const bool looks_up = !lane.attach_waits && lane.first && !lane.first->missing.empty();
  std::size_t voxels = 0;
  std::size_t chunks = 0;
  if (!lane.attach_waits && (lane.first || !lane.waiting.empty())) {
    const EditRequest& request = lane.first ? lane.first->edit.request : lane.waiting.front().request;
    voxels = request.extent.voxels + (settles() && request.settles ? edits::kSettleVoxels : 0);
    chunks = request.extent.chunks.size() + request.extent.beside_chunks.size();
  }
  const bool is_small = *lane.in_log == 0 && voxels <= kSmallVoxels && chunks <= kSmallChunks;
  // Decoding ground needs no room in the log. Its edit needs room afterwards: the edit has paid by then, but
  // goes behind smaller ones.
  lane.may_log = is_small || !looks_up;
  std::size_t cost = kEditCost + voxels + kDecodeCost * chunks;
  if (looks_up) cost = kEditCost + kDecodeCost * lane.first->asked.size();
  lane.cost = lane.first && !looks_up ? kEditCost : cost;
  Turns& turns = is_small || looks_up ? small_ : large_;
  turns.enter({.offset = static_cast<double>(cost)}, lane.session->flow(), lane.session->owner());
  lane.entered = true;
}

void EditIntake::cancel_look_ups(const Lane& lane) {
  if (!lane.first) return;
  std::vector<ChunkKey> keys;
  for (const ChunkCoord chunk : lane.first->asked) keys.push_back({chunk, Lod{}});
  parts_.base.cancel(lane.look_ups->owner(), keys);
}

void EditIntake::end_input(Lane& lane) {
  lane.input_ended = true;
  take_look_ups(lane);
  if (!lane.first || lane.first->missing.empty()) return;
  refuse_half_closed(lane);
  enter(lane);
}

void EditIntake::forget_lane(ClientId client) {
  Lane* const lane = find_lane(client);
  if (lane == nullptr) return;
  cancel_look_ups(*lane);
  waiting_ -= lane->waiting.size() + (lane->first ? 1 : 0) + (lane->attach_waits ? 1 : 0);
  if (lane->attaching) end_attach(*lane);
  lanes_.erase(client);
}

}  // namespace talus::server
