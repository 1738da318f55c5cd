// Answers to a session's edits, delivered by its mailbox.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include <talus/edits/editors.h>
#include <talus/protocol/message.h>

namespace talus::server {

/// The reason why an edit or an Attach did not happen: an Error for the client.
struct EditRefusal {
  wire::ErrorCode code{};
  std::string text;
  std::chrono::milliseconds retry_after{};
};

/// The session may edit as `editor` until another session attaches to it.
struct EditorSession {
  edits::EditorId editor;
  std::uint64_t epoch = 0;
  std::uint64_t last_sequence = 0;  // edits up to this one are decided
  bool known = false;               // it is the requested editor
  std::uint64_t revision = 0;       // the world's
};

struct AttachAnswer {
  tl::expected<EditorSession, EditRefusal> answer;
};

/// The edit was stored, or did not happen.
struct EditAnswer {
  std::uint32_t id = 0;
  tl::expected<edits::EditResult, EditRefusal> answer;
};

}  // namespace talus::server
