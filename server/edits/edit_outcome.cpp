#include "edits/edit_outcome.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include <talus/protocol/message.h>

namespace talus::server {

using wire::ErrorCode;

namespace {

constexpr std::chrono::milliseconds kComeAgain{1000};
constexpr std::chrono::milliseconds kComeAgainCutOff{2000};
/// Editors are forgotten after a day, one after the other.
constexpr std::chrono::milliseconds kComeAgainEditorsFull = std::chrono::minutes{2};

}  // namespace

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
    case LogFailure::Kind::editors_full:
      return EditRefused::editors_full;
    case LogFailure::Kind::too_large:
      return EditRefused::out_of_range;
  }
  return EditRefused::invalid;
}

EditRefusal refusal_of(EditRefused why, std::string text) {
  switch (why) {
    case EditRefused::out_of_range:
    case EditRefused::index_full:
      return {ErrorCode::out_of_range, std::move(text), {}};
    case EditRefused::ground:
    case EditRefused::unreadable:
      return {ErrorCode::internal, std::move(text), kComeAgain};
    case EditRefused::conflict:
      return {ErrorCode::conflict, std::move(text), {}};
    case EditRefused::not_applied:
      return {ErrorCode::not_applied, std::move(text), {}};
    case EditRefused::expired:
      return {ErrorCode::expired, std::move(text), {}};
    case EditRefused::invalid:
      return {ErrorCode::internal, std::move(text), {}};
    case EditRefused::cut_off:
      return {ErrorCode::overloaded, std::move(text), kComeAgainCutOff};
    case EditRefused::editors_full:
      return {ErrorCode::overloaded, std::move(text), kComeAgainEditorsFull};
    default:
      return {ErrorCode::overloaded, std::move(text), kComeAgain};
  }
}

tl::expected<edits::EditResult, RefusedEdit> outcome_of(
    const tl::expected<const edits::Applied*, LogFailure>& outcome) {
  using Kind = edits::Applied::Kind;
  const auto refused = [](EditRefused why, std::string text) {
    return tl::make_unexpected(RefusedEdit{why, std::move(text)});
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

}  // namespace talus::server
