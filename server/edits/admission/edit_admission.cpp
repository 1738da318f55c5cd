#include "edits/admission/edit_admission.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <talus/edits/editors.h>

#include "runtime/log/escape.h"

namespace talus::server {
namespace {

using Code = EditErrorCode;

constexpr std::string_view kOperatorsOnly =
    "the subject \"talusd store rollback\" is reserved for this server's operators; give another";

tl::expected<void, EditError> admit_subject(const std::string& subject) {
  if (subject.size() > edits::kMaxSubjectBytes) {
    return edit_error(Code::forbidden,
                      fmt::format("the token's subject has {} bytes; the limit for an editor is {}",
                                  subject.size(), edits::kMaxSubjectBytes));
  }
  if (on_one_line(subject) != subject) {
    return edit_error(Code::forbidden,
                      "the token's subject has control characters; an editor's subject must be printable");
  }
  if (subject == edits::kOperatorSubject) return edit_error(Code::forbidden, std::string{kOperatorsOnly});
  return {};
}

}  // namespace

tl::expected<void, EditError> EditAdmission::admit(const EditingSession& session) const {
  if (auto why = edits_forbidden(session.grant, parts_.rules))
    return edit_error(Code::forbidden, *std::move(why));
  if (parts_.taker == nullptr) {
    return edit_error(Code::unsupported, "this server stores no edits");
  }
  return {};
}

tl::expected<AdmittedAttach, EditError> EditAdmission::admit(const wire::Attach& attach,
                                                             const EditingSession& session) const {
  if (auto may = admit(session); !may) return tl::unexpected{std::move(may.error())};
  if (session.leaving) return edit_error(Code::leaving, "this server is shutting down");
  if (auto may = admit_subject(session.grant.subject); !may) return tl::unexpected{std::move(may.error())};
  AttachRequest request{{}, session.grant.subject, attach.seen_revision(), session.editor};
  if (attach.editor() != nullptr) request.editor = {attach.editor()->low(), attach.editor()->high()};
  if (request.editor == edits::EditorId{}) request.editor = request.own;
  const bool makes_editor = !session.attached && !parts_.taker->knows(request.editor, request.subject);
  // Before the rates: a client that cannot get an editor must not use up the rates of its address.
  if (makes_editor) {
    if (auto room = parts_.taker->room_for_editor(); !room) return tl::unexpected{std::move(room.error())};
  }
  return AdmittedAttach{std::move(request), makes_editor};
}

tl::expected<AdmittedEdit, EditError> EditAdmission::admit(const wire::Edit& wire,
                                                           const EditingSession& session) const {
  if (auto may = admit(session); !may) return tl::unexpected{std::move(may.error())};
  if (!session.attached) return edit_error(Code::expired, "an Attach must be answered before the first Edit");
  if (session.leaving) return edit_error(Code::leaving, "this server is shutting down");
  if (session.unanswered >= edits::kKeptResults) {
    return edit_error(Code::too_many_unanswered,
                      fmt::format("{} edits are unanswered, the limit", session.unanswered));
  }
  if (!parts_.memory.takes_work_of(session.flow, 0, session.now)) {
    return edit_error(Code::busy, std::string{kNoMemory});
  }
  auto edit = read_edit(wire, parts_.taker->settles(), parts_.taker->reveals());
  if (!edit) return edit;
  if (!edit->subject.empty() && !session.grant.rights.has(Right::gateway)) {
    return edit_error(Code::forbidden,
                      "Edit.subject needs the right \"gateway\" of a game server, which this session's token "
                      "does not give");
  }
  if (edit->subject == edits::kOperatorSubject)
    return edit_error(Code::forbidden, std::string{kOperatorsOnly});
  if (auto why = edit_forbidden(edit->edit, session.grant, parts_.rules)) {
    return edit_error(Code::forbidden, *std::move(why));
  }
  edits::Extent& extent = edit->extent;
  edit->settles = !extent.loose || may_settle(*extent.loose, session.grant, parts_.rules);
  if (!edit->settles) {
    extent.loose.reset();
    extent.loose_chunks.clear();
  }
  if (parts_.taker->reveals()) {
    extent.beside_chunks = edits::chunks_beside(edit->edit, extent);
    edit->bytes += extent.beside_chunks.size() * sizeof(ChunkCoord);
  }
  return edit;
}

std::optional<SessionRates::Refusal> EditAdmission::charge(const AdmittedEdit& edit, SessionRates& rates,
                                                           SessionRates::Time now) {
  std::vector<ChunkCoord> to_pay;
  for (const auto* const chunks :
       {&edit.extent.chunks, &edit.extent.loose_chunks, &edit.extent.beside_chunks}) {
    std::ranges::copy_if(*chunks, std::back_inserter(to_pay), [&](ChunkCoord chunk) {
      return parts_.chunks.revision({chunk, Lod{}}) == kBaseRevision &&
             std::ranges::find(paid_, chunk) == paid_.end();
    });
  }
  if (auto refusal = rates.refuse_edit(now, {edit.extent.voxels, to_pay.size()})) return refusal;
  for (const ChunkCoord chunk : to_pay) {
    if (paid_.size() < kMaxPaid) {
      paid_.push_back(chunk);
    } else {
      paid_[oldest_] = chunk;
      oldest_ = (oldest_ + 1) % kMaxPaid;
    }
  }
  return std::nullopt;
}

}  // namespace talus::server
