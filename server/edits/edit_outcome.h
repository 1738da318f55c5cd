// What sessions are told of what the log did with their entries. Pure functions, for any thread.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include <talus/edits/batch.h>

#include "chunks/edit_answers.h"
#include "edits/edit_log.h"
#include "edits/edit_refusals.h"

namespace talus::server {

[[nodiscard]] EditRefused why_of(LogFailure::Kind kind);

/// What a client is told: whether to come again, and when.
[[nodiscard]] EditRefusal refusal_of(EditRefused why, std::string text);

struct RefusedEdit {
  EditRefused why{};
  std::string text;
};

/// What became of an edit in the log, as its session is told.
[[nodiscard]] tl::expected<edits::EditResult, RefusedEdit> outcome_of(
    const tl::expected<const edits::Applied*, LogFailure>& outcome);

}  // namespace talus::server
