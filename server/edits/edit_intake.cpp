#include "edits/edit_intake.h"

#include <algorithm>
#include <exception>
#include <random>
#include <utility>

#include <fmt/format.h>

#include <talus/protocol/message.h>

namespace talus::server {
namespace {

using std::chrono::milliseconds;
using wire::ErrorCode;

constexpr milliseconds kBusy{1000};
constexpr int kMaxTries = 8;
/// Look-ups are a client of their own, so that their chunks are not the session's. No session has so high an
/// id.
constexpr std::uint64_t kLookUps = std::uint64_t{1} << 63;

std::uint64_t number(ClientId client) {
  return static_cast<std::uint64_t>(client);
}

edits::EditorId random_editor() {
  std::random_device device;
  const auto half = [&] { return (std::uint64_t{device()} << 32) | device(); };
  return {half(), half()};
}

/// Where there is no memory for it the session ends, and its client asks again.
void tell(const MailboxPtr& mailbox, Mail mail) noexcept {
  try {
    mailbox->put(std::move(mail));
    mailbox->wake();
  } catch (const std::exception&) {
    mailbox->lose();
  }
}

void refuse(const MailboxPtr& mailbox, std::uint32_t id, ErrorCode code, std::string text,
            milliseconds retry_after = {}) {
  tell(mailbox, EditAnswer{id, tl::unexpected{EditRefusal{code, std::move(text), retry_after}}});
}

/// What a session is told of its edit.
EditAnswer answer_of(std::uint32_t id, const tl::expected<const edits::Applied*, LogFailure>& outcome) {
  const auto refused = [&](ErrorCode code, std::string text, milliseconds retry_after = {}) {
    return EditAnswer{id, tl::unexpected{EditRefusal{code, std::move(text), retry_after}}};
  };
  if (!outcome) return refused(ErrorCode::overloaded, outcome.error().reason, kBusy);
  using Kind = edits::Applied::Kind;
  const edits::Applied& applied = **outcome;
  switch (applied.kind) {
    case Kind::done:
    case Kind::conflict:
    case Kind::repeat:
      if (!applied.result.conflict) return {id, applied.result};
      return refused(ErrorCode::conflict,
                     fmt::format("guard {} does not hold; nothing happened", *applied.result.conflict));
    case Kind::not_applied:
      return refused(ErrorCode::not_applied,
                     "the edit did not happen before later ones of its editor, or its result is not kept "
                     "any more; sequences must rise");
    case Kind::expired:
      return refused(ErrorCode::expired,
                     "another connection has attached as this editor, or it was idle for too long; Attach "
                     "again");
    default:
      return refused(ErrorCode::internal, "the log holds an entry that cannot be applied");
  }
}

}  // namespace

EditIntake::EditIntake(Parts parts, Rules rules, Logger log)
    : parts_{std::move(parts)}, rules_{std::move(rules)}, log_{std::move(log)} {}

void EditIntake::stop() {
  {
    const std::lock_guard lock{mutex_};
    stopping_ = true;
  }
  comes_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void EditIntake::start() {
  thread_ = std::thread{[this] { work(); }};
}

// ---- from other threads

void EditIntake::attach(const MailboxPtr& mailbox, AttachRequest request) {
  {
    const std::lock_guard lock{mutex_};
    attaching_.push_back({mailbox, std::move(request), {}, false, 0});
  }
  comes_.notify_one();
}

void EditIntake::edit(const MailboxPtr& mailbox, EditRequest request) {
  {
    const std::lock_guard lock{mutex_};
    edits_.emplace_back(mailbox, std::move(request));
  }
  comes_.notify_one();
}

void EditIntake::forget(ClientId client) {
  {
    const std::lock_guard lock{mutex_};
    forgotten_.push_back(client);
  }
  comes_.notify_one();
}

// ---- the thread

void EditIntake::work() {
  for (;;) {
    {
      std::unique_lock lock{mutex_};
      comes_.wait(lock, [&] {
        return stopping_ || !attaching_.empty() || !edits_.empty() || !forgotten_.empty() ||
               !looked_up_.empty();
      });
      if (stopping_) return;
    }
    try {
      do_what_waits();
    } catch (const std::exception& error) {
      // No memory. Sessions whose edits may be among what was taken in end, and their clients send them
      // again.
      log_->error("edits: {}", error.what());
      for (const auto& [client, lane] : lanes_) lane.session->lose();
      lanes_.clear();
    }
  }
}

void EditIntake::do_what_waits() {
  std::vector<Attaching> attaching;
  std::vector<std::pair<MailboxPtr, EditRequest>> edits;
  std::vector<ClientId> forgotten;
  std::unordered_set<std::uint64_t> looked_up;
  {
    const std::lock_guard lock{mutex_};
    attaching.swap(attaching_);
    edits.swap(edits_);
    forgotten.swap(forgotten_);
    looked_up.swap(looked_up_);
  }
  for (Attaching& each : attaching) attach_now(std::move(each));
  std::unordered_set<std::uint64_t> moved;
  for (auto& [mailbox, request] : edits) {
    const std::uint64_t client = number(mailbox->owner());
    Lane& lane = lanes_[client];
    if (lane.session == nullptr) {
      lane.session = mailbox;
      lane.look_ups = std::make_shared<Mailbox>(
          ClientId{kLookUps | client},
          [this, client] {
            {
              const std::lock_guard lock{mutex_};
              looked_up_.insert(client);
            }
            comes_.notify_one();
          },
          mailbox->flow_use());
    }
    lane.waiting.push_back(std::move(request));
    moved.insert(client);
  }
  for (const std::uint64_t client : looked_up) {
    const auto lane = lanes_.find(client);
    if (lane == lanes_.end()) continue;
    take_look_ups(lane->second);
    if (lane->second.look_ups->has_lost()) lane->second.session->lose();
    moved.insert(client);
  }
  for (const ClientId client : forgotten) {
    const auto lane = lanes_.find(number(client));
    if (lane == lanes_.end()) continue;
    if (const auto& first = lane->second.first) {
      std::vector<ChunkKey> keys;
      for (const ChunkCoord chunk : first->asked) keys.push_back({chunk, Lod{}});
      parts_.base.cancel(lane->second.look_ups->owner(), keys);
    }
    lanes_.erase(lane);
  }
  for (const std::uint64_t client : moved) {
    const auto lane = lanes_.find(client);
    if (lane != lanes_.end()) advance(lane->second);
  }
}

void EditIntake::attach_now(Attaching attaching) {
  const std::uint64_t revision = parts_.revision();
  if (attaching.request.seen_revision > revision) {
    return tell(attaching.mailbox,
                AttachAnswer{tl::unexpected{
                    EditRefusal{ErrorCode::overloaded,
                                fmt::format("this server is at revision {}, and the client has seen {}",
                                            revision, attaching.request.seen_revision),
                                kBusy}}});
  }
  std::uint64_t epoch = 0;
  if (attaching.editor == edits::EditorId{}) attaching.editor = attaching.request.editor;
  const auto before = attaching.editor == edits::EditorId{} ? std::nullopt : parts_.editor(attaching.editor);
  attaching.known = before && before->subject == attaching.request.subject;
  if (attaching.known) {
    epoch = before->epoch;
  } else {
    attaching.editor = random_editor();
  }
  const edits::AttachEntry entry{attaching.editor, epoch + 1, attaching.request.subject};
  const bool taken = parts_.log.append(
      entry, [this, attaching](const tl::expected<const edits::Applied*, LogFailure>& outcome) {
        attached(attaching, outcome);
      });
  if (taken) return;
  tell(attaching.mailbox, AttachAnswer{tl::unexpected{
                              EditRefusal{ErrorCode::overloaded, "this server takes no edits now", kBusy}}});
}

void EditIntake::attached(const Attaching& attaching,
                          const tl::expected<const edits::Applied*, LogFailure>& outcome) {
  using Kind = edits::Applied::Kind;
  const auto refused = [&](std::string text) {
    tell(attaching.mailbox,
         AttachAnswer{tl::unexpected{EditRefusal{ErrorCode::overloaded, std::move(text), kBusy}}});
  };
  if (!outcome) return refused(outcome.error().reason);
  const edits::Applied& applied = **outcome;
  if (applied.kind == Kind::editors_full) return refused("as many edit this world as may");
  if (applied.kind != Kind::attached) {  // another attached as the same editor at the same time
    Attaching again = attaching;
    if (++again.tries == kMaxTries) return refused("others attach as this editor all the time");
    {
      const std::lock_guard lock{mutex_};
      attaching_.push_back(std::move(again));
    }
    comes_.notify_one();
    return;
  }
  const auto editor = parts_.editor(attaching.editor);
  tell(attaching.mailbox,
       AttachAnswer{EditorSession{attaching.editor, editor ? editor->epoch : 0,
                                  editor ? editor->last_sequence : 0, attaching.known, applied.revision}});
}

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
      refuse(lane.session, edit.request.id, ErrorCode::internal,
             fmt::format("the ground under the edit failed: {}", ready->answer.error().reason), kBusy);
      lane.first.reset();
    }
  }
}

void EditIntake::advance(Lane& lane) {
  for (;;) {
    if (!lane.first) {
      if (lane.waiting.empty()) return;
      EditRequest next = std::move(lane.waiting.front());
      lane.waiting.pop_front();
      lane.first = prepare(lane, std::move(next));
      if (!lane.first) continue;
    }
    look_up(lane, *lane.first);
    if (!lane.first->missing.empty()) return;
    log_edit(lane, *std::exchange(lane.first, std::nullopt));
  }
}

std::optional<EditIntake::Prepared> EditIntake::prepare(const Lane& lane, EditRequest request) {
  auto touched = edits::touched_voxels(request.edit);
  if (!touched) {
    refuse(lane.session, request.id, ErrorCode::out_of_range, touched.error().message);
    return std::nullopt;
  }
  if (const auto good = edits::check(request.edit, {rules_.rows, rules_.materials}); !good) {
    refuse(lane.session, request.id, ErrorCode::out_of_range, good.error().message);
    return std::nullopt;
  }
  Prepared edit{std::move(request), *std::move(touched), {}, {}, {}};
  for (const edits::TouchedChunk& each : edit.touched) edit.missing.insert(each.chunk);
  return edit;
}

void EditIntake::look_up(const Lane& lane, Prepared& edit) {
  std::vector<ChunkKey> to_ask;
  for (const edits::TouchedChunk& each : edit.touched) {
    if (!edit.missing.contains(each.chunk)) continue;
    DecodedChunkPtr chunk = bases_.find(each.chunk);
    if (chunk == nullptr) {
      const EncodedChunkPtr encoded = parts_.base.find({each.chunk, Lod{}});
      if (encoded != nullptr) chunk = bases_.put(each.chunk, *encoded);
    }
    if (chunk != nullptr) {
      edit.base.emplace(each.chunk, voxels_at(*chunk, each.voxels));
      edit.missing.erase(each.chunk);
    } else if (!edit.asked.contains(each.chunk)) {
      to_ask.push_back({each.chunk, Lod{}});
    }
  }
  if (to_ask.empty()) return;
  // The others are asked for when an answer comes, or room does.
  const std::size_t accepted = parts_.base.submit(lane.look_ups, to_ask, Urgency::soon);
  for (std::size_t i = 0; i < accepted; ++i) edit.asked.insert(to_ask[i].coord);
}

void EditIntake::log_edit(const Lane& lane, Prepared edit) {
  const std::uint32_t id = edit.request.id;
  edits::EditEntry entry{edit.request.editor,          edit.request.epoch,   edit.request.sequence,
                         std::move(edit.request.edit), std::move(edit.base), std::move(edit.request.subject)};
  const bool taken = parts_.log.append(
      std::move(entry),
      [session = lane.session, id](const tl::expected<const edits::Applied*, LogFailure>& outcome) {
        tell(session, answer_of(id, outcome));
      });
  if (!taken) {
    refuse(lane.session, id, ErrorCode::overloaded, "this server takes no edits now", kBusy);
  }
}

}  // namespace talus::server
