// Answers to a session's edits, delivered by its mailbox.
#pragma once

#include <cstdint>

#include <tl/expected.hpp>

#include <talus/edits/editors.h>

#include "chunks/edit_error.h"

namespace talus::server {

/// The session may edit as `editor` until another session attaches to it.
struct EditorSession {
  edits::EditorId editor;
  std::uint64_t epoch = 0;
  std::uint64_t last_sequence = 0;  // edits up to this one are decided
  bool known = false;               // it is the requested editor
  std::uint64_t revision = 0;       // the world's
};

struct AttachAnswer {
  tl::expected<EditorSession, EditError> answer;
};

/// The edit was stored, or did not happen.
struct EditAnswer {
  std::uint32_t id = 0;
  tl::expected<edits::EditResult, EditError> answer;
};

}  // namespace talus::server
