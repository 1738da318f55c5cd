#include "edits/edit_intake.h"

#include <algorithm>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include <talus/protocol/message.h>

#include "chunks/client_ids.h"
#include "edits/random_editor.h"

namespace talus::server {
namespace {

using std::chrono::milliseconds;
using wire::ErrorCode;

constexpr milliseconds kBusy{1000};
constexpr milliseconds kCutOff{2000};
constexpr int kMaxTries = 8;
/// In voxels: what it costs to decode a chunk, if it comes to that.
constexpr std::size_t kChunkCost = 256;

std::uint64_t number(ClientId client) {
  return static_cast<std::uint64_t>(client);
}

/// Where there is no memory for it the session ends, and its client asks again.
void tell(const MailboxPtr& mailbox, Mail mail) noexcept {
  try {
    mailbox->put(std::move(mail));
    mailbox->wake();
  } catch (const std::exception&) {
    mailbox->lose_mail();
  }
}

EditRefused why_of(LogFailure::Kind kind) {
  switch (kind) {
    case LogFailure::Kind::busy:
      return EditRefused::busy;
    case LogFailure::Kind::unwritable:
      return EditRefused::unwritable;
    case LogFailure::Kind::index_full:
      return EditRefused::index_full;
    case LogFailure::Kind::unreadable:
      return EditRefused::unreadable;
    case LogFailure::Kind::cut_off:
      return EditRefused::cut_off;
    case LogFailure::Kind::too_large:
      return EditRefused::out_of_range;
  }
  return EditRefused::invalid;
}

/// What a client is told: whether to come again, and when.
EditRefusal refusal(EditRefused why, std::string text) {
  switch (why) {
    case EditRefused::out_of_range:
    case EditRefused::index_full:
      return {ErrorCode::out_of_range, std::move(text), {}};
    case EditRefused::ground:
    case EditRefused::unreadable:
      return {ErrorCode::internal, std::move(text), kBusy};
    case EditRefused::conflict:
      return {ErrorCode::conflict, std::move(text), {}};
    case EditRefused::not_applied:
      return {ErrorCode::not_applied, std::move(text), {}};
    case EditRefused::expired:
      return {ErrorCode::expired, std::move(text), {}};
    case EditRefused::invalid:
      return {ErrorCode::internal, std::move(text), {}};
    case EditRefused::cut_off:
      return {ErrorCode::overloaded, std::move(text), kCutOff};
    default:
      return {ErrorCode::overloaded, std::move(text), kBusy};
  }
}

struct Refused {
  EditRefused why{};
  std::string text;
};

/// What became of an edit in the log, as its session is told.
tl::expected<edits::EditResult, Refused> outcome_of(
    const tl::expected<const edits::Applied*, LogFailure>& outcome) {
  using Kind = edits::Applied::Kind;
  const auto refused = [](EditRefused why, std::string text) {
    return tl::make_unexpected(Refused{why, std::move(text)});
  };
  if (!outcome) return refused(why_of(outcome.error().kind), outcome.error().reason);
  const edits::Applied& applied = **outcome;
  switch (applied.kind) {
    case Kind::done:
    case Kind::conflict:
    case Kind::repeat:
      if (!applied.result.conflict) return applied.result;
      return refused(EditRefused::conflict,
                     fmt::format("guard {} does not hold; nothing happened", *applied.result.conflict));
    case Kind::not_applied:
      return refused(EditRefused::not_applied,
                     "the edit did not happen before later ones of its editor, or its result is not kept "
                     "any more; sequences must rise");
    case Kind::expired:
      return refused(EditRefused::expired,
                     "another connection has attached as this editor, or it was idle for too long; Attach "
                     "again");
    default:
      return refused(EditRefused::invalid, "the log holds an entry that cannot be applied");
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
  started_ = true;
}

// ---- from other threads

void EditIntake::attach(const MailboxPtr& mailbox, AttachRequest request) {
  {
    const std::lock_guard lock{mutex_};
    came_.emplace_back(mailbox, std::move(request));
    ++waiting_;  // before the thread can take it and count it off
    called_ = true;
  }
  comes_.notify_one();
}

void EditIntake::edit(const MailboxPtr& mailbox, EditRequest request) {
  if (log_at_once(mailbox, request)) return;
  {
    const std::lock_guard lock{mutex_};
    came_.emplace_back(mailbox, Editing{std::move(request), parts_.clock.now()});
    ++waiting_;
    called_ = true;
  }
  comes_.notify_one();
}

bool EditIntake::log_at_once(const MailboxPtr& session, EditRequest& request) {
  if (!started_ || named_voxels(request.edit) > kSmallVoxels || (settles() && request.settles)) return false;
  // Another thread that brings an edit is done sooner than the intake's could be woken.
  constexpr int kTries = 100;
  std::unique_lock working{work_, std::try_to_lock};
  for (int tries = 1; !working && !thread_works_ && tries < kTries; ++tries) (void)working.try_lock();
  if (!working) return false;
  {
    const std::lock_guard lock{mutex_};
    if (called_ || stopping_) return false;  // something came before it
  }
  const Lane* const lane = find_lane(session->owner());
  if (lane == nullptr || lane->attaching || lane->first || !lane->waiting.empty() || *lane->in_log != 0) {
    return false;
  }
  auto touched = edits::touched_voxels(request.edit);
  if (!touched || !edits::check(request.edit, {rules_.rows, rules_.materials})) return false;
  edits::BaseVoxels base;
  for (const edits::TouchedChunk& each : *touched) {
    const DecodedChunkPtr chunk = bases_.find(each.chunk);
    if (chunk == nullptr) return false;
    base.emplace(each.chunk, voxels_at(*chunk, each.voxels));
  }
  log_edit(*lane,
           Prepared{{std::move(request), parts_.clock.now()}, *std::move(touched), std::move(base), {}, {}});
  return true;
}

bool EditIntake::knows(edits::EditorId id, const std::string& subject) const {
  const auto editor = id == edits::EditorId{} ? std::nullopt : parts_.editor(id);
  return editor && editor->subject == subject;
}

void EditIntake::forget(ClientId client) {
  {
    const std::lock_guard lock{mutex_};
    forgotten_.push_back(client);
    called_ = true;
  }
  comes_.notify_one();
}

void EditIntake::call() {
  {
    const std::lock_guard lock{mutex_};
    called_ = true;
  }
  comes_.notify_one();
}

// ---- the thread

void EditIntake::work() {
  for (;;) {
    {
      std::unique_lock lock{mutex_};
      comes_.wait(lock, [&] { return stopping_ || called_; });
      if (stopping_) return;
    }
    try {
      do_what_waits();
    } catch (const std::exception& error) {
      // No memory. Sessions whose edits may be among what was taken in end, and their clients send them
      // again.
      log_->error("edits: {}", error.what());
      const std::lock_guard working{work_};
      thread_works_ = false;
      for (const auto& [client, lane] : lanes_) lane.session->lose_mail();
      for (const auto& [session, what] : taken_in_) session->lose_mail();
      lanes_.clear();
      taken_in_.clear();
      attaching_as_.clear();
      small_ = {};
      large_ = {};
      const std::lock_guard lock{mutex_};
      waiting_ = came_.size();
    }
  }
}

void EditIntake::do_what_waits() {
  thread_works_ = true;
  const std::lock_guard working{work_};
  // What comes is taken in before each turn: the turn may be that of who came.
  while (take_in() && take_turn()) {
  }
  thread_works_ = false;
}

bool EditIntake::take_in() {
  decltype(attached_) attached_now;
  decltype(forgotten_) forgotten;
  decltype(looked_up_) looked_up;
  {
    const std::lock_guard lock{mutex_};
    if (stopping_) return false;
    if (!std::exchange(called_, false)) return true;
    taken_in_.swap(came_);
    attached_now.swap(attached_);
    forgotten.swap(forgotten_);
    looked_up.swap(looked_up_);
  }
  for (auto& [mailbox, what] : taken_in_) {
    Lane& lane = lane_of(mailbox);
    if (auto* const edit = std::get_if<Editing>(&what)) {
      lane.waiting.push_back(std::move(*edit));
      if (!lane.first) enter(lane);
    } else {
      begin_attach(lane, std::get<AttachRequest>(std::move(what)));
    }
  }
  taken_in_.clear();
  for (const Attached& each : attached_now) attached(each);
  for (const std::uint64_t client : looked_up) {
    Lane* const lane = find_lane(ClientId{client});
    if (lane == nullptr) continue;
    take_look_ups(*lane);
    if (lane->look_ups->has_lost()) lane->session->lose_mail();
    enter(*lane);
  }
  for (const ClientId client : forgotten) forget_lane(client);
  return true;
}

bool EditIntake::log_has_room() const {
  // Where it takes none, those that wait are told now.
  return (log_entries_ < kLogEntries && log_bytes_ < kLogBytes) || !parts_.log.takes_entries();
}

std::optional<ClientId> EditIntake::next() {
  const bool has_small = small_.entered() > 0;
  if (!has_small && large_.entered() == 0) {
    small_.rest();
    large_.rest();
    return std::nullopt;
  }
  // By turns, so that neither kind starves the other; but the small ones do not wait for room in the log.
  small_went_ = has_small && (!small_went_ || large_.entered() == 0 || !log_has_room());
  if (small_went_) return small_.next();
  if (!log_has_room()) {
    wants_room_ = true;
    if (!log_has_room()) return std::nullopt;  // else it came just now, and who made it need not call
  }
  return large_.next();
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
  if (lane->first ? attaches : !lane->waiting.empty()) enter(*lane);
  return true;
}

EditIntake::Lane& EditIntake::lane_of(const MailboxPtr& session) {
  Lane& lane = lanes_[session->owner()];
  if (lane.session != nullptr) return lane;
  const std::uint64_t client = number(session->owner());
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
  std::size_t voxels = 0;
  std::size_t chunks = 0;
  if (!lane.attach_waits && !lane.first && !lane.waiting.empty()) {
    const EditRequest& request = lane.waiting.front().request;
    voxels = named_voxels(request.edit) + (settles() && request.settles ? edits::kSettleVoxels : 0);
    chunks = named_chunks(request.edit);
  }
  const bool is_small = *lane.in_log == 0 && voxels <= kSmallVoxels && chunks <= kSmallChunks;
  EditTurns& turns = is_small ? small_ : large_;
  turns.enter(lane.session->flow(), lane.session->owner(), voxels + kChunkCost * chunks);
  lane.entered = true;
}

void EditIntake::forget_lane(ClientId client) {
  Lane* const lane = find_lane(client);
  if (lane == nullptr) return;
  if (const auto& first = lane->first) {
    std::vector<ChunkKey> keys;
    for (const ChunkCoord chunk : first->asked) keys.push_back({chunk, Lod{}});
    parts_.base.cancel(lane->look_ups->owner(), keys);
  }
  waiting_ -= lane->waiting.size() + (lane->first ? 1 : 0) + (lane->attach_waits ? 1 : 0);
  if (lane->attaching) end_attach(*lane);
  lanes_.erase(client);
}

// ---- Attach

void EditIntake::begin_attach(Lane& lane, AttachRequest request) {
  if (lane.attaching) end_attach(lane);  // never: a session has one at a time
  lane.attaching = Attaching{std::move(request), {}, false, false, 0};
  // Of two connections that attach as one editor the later one edits, whose turn ever is first.
  const auto [first, last] = attaching_as_.equal_range(lane.attaching->request.editor);
  for (auto other = first; other != last; ++other) lanes_.at(other->second).attaching->overtaken = true;
  if (lane.attaching->request.editor != edits::EditorId{}) {
    attaching_as_.emplace(lane.attaching->request.editor, lane.session->owner());
  }
  lane.attach_waits = true;
  enter(lane);
}

void EditIntake::log_attach(Lane& lane) {
  lane.attach_waits = false;
  --waiting_;
  Attaching& attaching = *lane.attaching;
  if (attaching.overtaken) {
    return refuse_attach(lane, EditRefused::overtaken, "another connection attaches as this editor");
  }
  const edits::EditorId wanted =
      attaching.editor == edits::EditorId{} ? attaching.request.editor : attaching.editor;
  const auto of_subject = [&](edits::EditorId id) { return editor_of(id, attaching.request.subject); };
  auto before = of_subject(wanted);
  attaching.known = before && wanted == attaching.request.editor;
  attaching.editor = wanted;
  // A session is one editor, whatever it calls itself: nobody takes the places of all others.
  if (!before) before = of_subject(attaching.editor = attaching.request.own);
  if (!before) attaching.editor = random_editor();
  const edits::AttachEntry entry{attaching.editor, (before ? before->epoch : 0) + 1,
                                 attaching.request.subject};
  // What the editor is then, before anybody else can change it.
  auto done = [this, session = lane.session, editor = entry.editor,
               epoch = entry.epoch](const tl::expected<const edits::Applied*, LogFailure>& outcome) {
    try {
      Attached answered{session->owner(), tl::unexpected{LogFailure{}}, {}};
      if (outcome) {
        const auto now = parts_.editor(editor);
        answered.outcome = (*outcome)->kind;
        answered.as = {editor, epoch, now ? now->last_sequence : 0, false, (*outcome)->revision};
      } else {
        answered.outcome = tl::unexpected{outcome.error()};
      }
      const std::lock_guard lock{mutex_};
      attached_.push_back(std::move(answered));
      called_ = true;
    } catch (const std::exception&) {
      session->lose_mail();  // no memory
    }
    comes_.notify_one();
  };
  if (const auto taken = append(entry, std::move(done)); !taken) {
    refuse_attach(lane, why_of(taken.error().kind), taken.error().reason);
  }
}

std::optional<edits::Editor> EditIntake::editor_of(edits::EditorId id, const std::string& subject) const {
  auto editor = id == edits::EditorId{} ? std::nullopt : parts_.editor(id);
  return editor && editor->subject == subject ? editor : std::nullopt;
}

void EditIntake::attached(const Attached& answered) {
  using Kind = edits::Applied::Kind;
  Lane* const lane = find_lane(answered.client);
  if (lane == nullptr || !lane->attaching) return;  // the session is gone
  Attaching& attaching = *lane->attaching;
  if (!answered.outcome) {
    const LogFailure& failure = answered.outcome.error();
    return refuse_attach(*lane, why_of(failure.kind), failure.reason);
  }
  if (*answered.outcome == Kind::editors_full) {
    return refuse_attach(*lane, EditRefused::editors_full, "as many edit this world as may");
  }
  const auto again = [&] {
    lane->attach_waits = true;
    ++waiting_;
    enter(*lane);
  };
  if (*answered.outcome != Kind::attached) {  // another attached as the same editor at the same time
    if (++attaching.tries == kMaxTries) {
      return refuse_attach(*lane, EditRefused::overtaken, "others attach as this editor all the time");
    }
    return again();
  }
  // Where servers share the log the client comes from one that may have been ahead of this one. What it has
  // seen there is before its Attach in the log, and so applied here by now.
  const std::uint64_t seen = attaching.request.seen_revision;
  if (seen > answered.as.revision) {
    return refuse_attach(
        *lane, EditRefused::behind,
        fmt::format("this server is at revision {}, and the client has seen {}", answered.as.revision, seen));
  }
  if (!attaching.known && editor_of(attaching.request.editor, attaching.request.subject)) {
    // So it is with its editor, which this server did not know yet. The other one goes when place is needed:
    // it never edited.
    attaching.editor = attaching.request.editor;
    if (++attaching.tries < kMaxTries) return again();
  }
  EditorSession session = answered.as;
  session.known = attaching.known;
  end_attach(*lane);
  tell(lane->session, AttachAnswer{session});
}

void EditIntake::end_attach(Lane& lane) {
  const auto [first, last] = attaching_as_.equal_range(lane.attaching->request.editor);
  const auto own =
      std::find_if(first, last, [&](const auto& each) { return each.second == lane.session->owner(); });
  if (own != last) attaching_as_.erase(own);
  lane.attaching.reset();
}

void EditIntake::refuse_attach(Lane& lane, EditRefused why, std::string text) {
  parts_.metrics.edits_refused[why].add();
  end_attach(lane);
  tell(lane.session, AttachAnswer{tl::unexpected{refusal(why, std::move(text))}});
}

// ---- edits

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
      --waiting_;
      refuse(lane.session, edit.edit.request.id, EditRefused::ground,
             fmt::format("the ground under the edit failed: {}", ready->answer.error().reason));
      lane.first.reset();
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
  look_up(lane, *lane.first);
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

void EditIntake::refuse(const MailboxPtr& session, std::uint32_t id, EditRefused why, std::string text) {
  parts_.metrics.edits_refused[why].add();
  tell(session, EditAnswer{id, tl::unexpected{refusal(why, std::move(text))}});
}

template <typename Done>
tl::expected<void, LogFailure> EditIntake::append(LogEntry entry, Done done) {
  const std::size_t bytes = bytes_of(entry);
  const auto leaves = [this, bytes] {
    --log_entries_;
    log_bytes_ -= bytes;
  };
  ++log_entries_;
  log_bytes_ += bytes;
  auto taken =
      parts_.log.append(std::move(entry), [this, leaves, done = std::move(done)](const auto& outcome) {
        done(outcome);
        leaves();
        if (wants_room_.exchange(false)) call();
      });
  if (!taken) leaves();
  return taken;
}

}  // namespace talus::server
