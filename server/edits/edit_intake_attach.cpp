// EditIntake: who attaches, and as which editor.
#include <algorithm>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "edits/edit_intake.h"
#include "edits/edit_outcome.h"
#include "edits/random_editor.h"

namespace talus::server {
namespace {

constexpr int kMaxAttachTries = 8;

}  // namespace

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

std::optional<EditRefusal> EditIntake::refuses_editors() const {
  if (!parts_.room_for_editor) return std::nullopt;
  auto room = parts_.room_for_editor();
  if (room) return std::nullopt;
  const EditRefused why = why_of(room.error().kind);
  parts_.metrics.edits_refused[why].add();
  return refusal_of(why, std::move(room.error().reason));
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
    if (++attaching.tries == kMaxAttachTries) {
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
    if (++attaching.tries < kMaxAttachTries) return again();
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
  tell(lane.session, AttachAnswer{tl::unexpected{refusal_of(why, std::move(text))}});
}

}  // namespace talus::server
