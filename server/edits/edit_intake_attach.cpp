// EditIntake: Attaches.
#include <algorithm>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "edits/edit_intake.h"
#include "edits/random_editor.h"

namespace talus::server {
namespace {

using Code = EditErrorCode;

constexpr int kMaxAttachTries = 8;

}  // namespace

void EditIntake::begin_attach(Lane& lane, AttachRequest request) {
  if (lane.attaching) end_attach(lane);  // never: a session has one at a time
  lane.attaching = PendingAttach{std::move(request), {}, false, false, 0};
  // If two connections attach as one editor the later one wins, whichever has its turn first.
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
  PendingAttach& attaching = *lane.attaching;
  if (attaching.overtaken) {
    return refuse_attach(lane, {Code::overtaken, "another connection is attaching as this editor"});
  }
  const edits::EditorId wanted =
      attaching.editor == edits::EditorId{} ? attaching.request.editor : attaching.editor;
  const auto of_subject = [&](edits::EditorId id) { return editor_of(id, attaching.request.subject); };
  auto before = of_subject(wanted);
  attaching.known = before && wanted == attaching.request.editor;
  attaching.editor = wanted;
  // Each session is one editor, whatever ids it sends, so that none fills the editor table.
  if (!before) before = of_subject(attaching.editor = attaching.request.own);
  if (!before) attaching.editor = random_editor();
  const edits::AttachEntry entry{attaching.editor, (before ? before->epoch : 0) + 1,
                                 attaching.request.subject};
  // Reads the editor on the log's thread, before another entry can change it.
  auto done = [this, session = lane.session, editor = entry.editor,
               epoch = entry.epoch](const tl::expected<const edits::EntryResult*, EditError>& outcome) {
    try {
      AttachOutcome answered{
          session->owner(), outcome.map([](const auto* applied) { return applied->kind; }), {}};
      if (outcome) {
        const auto now = parts_.editor(editor);
        answered.as = {editor, epoch, now ? now->last_sequence : 0, false, (*outcome)->revision};
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
    refuse_attach(lane, taken.error());
  }
}

tl::expected<void, EditError> EditIntake::room_for_editor() const {
  if (!parts_.room_for_editor) return {};
  auto room = parts_.room_for_editor();
  if (!room) parts_.metrics.edits_refused[room.error().code].add();
  return room;
}

std::optional<edits::Editor> EditIntake::editor_of(edits::EditorId id, const std::string& subject) const {
  auto editor = id == edits::EditorId{} ? std::nullopt : parts_.editor(id);
  return editor && editor->subject == subject ? editor : std::nullopt;
}

void EditIntake::attached(const AttachOutcome& answered) {
  using Kind = edits::EntryResult::Kind;
  Lane* const lane = find_lane(answered.client);
  if (lane == nullptr || !lane->attaching) return;  // the session is gone
  PendingAttach& attaching = *lane->attaching;
  if (!answered.outcome) return refuse_attach(*lane, answered.outcome.error());
  if (*answered.outcome == Kind::editors_full) {
    return refuse_attach(
        *lane, {Code::editors_full,
                fmt::format("the editor table is full (limit {} editors); retry later", edits::kMaxEditors)});
  }
  const auto again = [&] {
    lane->attach_waits = true;
    ++waiting_;
    enter(*lane);
  };
  if (*answered.outcome != Kind::attached) {  // another session attached as the same editor at the same time
    if (++attaching.tries == kMaxAttachTries) {
      return refuse_attach(*lane, {Code::overtaken, "other connections keep attaching as this editor"});
    }
    return again();
  }
  // With a shared log the client may come from a server that was ahead of this one. The revisions it received
  // there precede its Attach in the log, and are applied here by now.
  const std::uint64_t seen = attaching.request.seen_revision;
  if (seen > answered.as.revision) {
    return refuse_attach(*lane,
                         {Code::behind, fmt::format("this server is at revision {}, behind the client's {}",
                                                    answered.as.revision, seen)});
  }
  if (!attaching.known && editor_of(attaching.request.editor, attaching.request.subject)) {
    // The requested editor exists after all; this server did not know it yet. The new one never edited and is
    // removed when its place is needed.
    attaching.editor = attaching.request.editor;
    if (++attaching.tries < kMaxAttachTries) return again();
  }
  EditorSession session = answered.as;
  session.known = attaching.known;
  end_attach(*lane);
  send(lane->session, AttachAnswer{session});
}

void EditIntake::end_attach(Lane& lane) {
  const auto [first, last] = attaching_as_.equal_range(lane.attaching->request.editor);
  const auto own =
      std::find_if(first, last, [&](const auto& each) { return each.second == lane.session->owner(); });
  if (own != last) attaching_as_.erase(own);
  lane.attaching.reset();
}

void EditIntake::refuse_attach(Lane& lane, EditError error) {
  parts_.metrics.edits_refused[error.code].add();
  end_attach(lane);
  send(lane.session, AttachAnswer{tl::unexpected{std::move(error)}});
}

}  // namespace talus::server
