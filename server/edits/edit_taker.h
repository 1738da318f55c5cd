// Accepts edits of sessions.
#pragma once

#include <cstdint>
#include <string>

#include <talus/edits/edit.h>
#include <talus/edits/editors.h>

#include "chunks/edit_answers.h"
#include "chunks/mailbox.h"

namespace talus::server {

struct AttachRequest {
  edits::EditorId editor;           // the editor to resume; 0: a new one
  std::string subject;              // the client's token's; may be empty
  std::uint64_t seen_revision = 0;  // the last revision the client received
  edits::EditorId own{};            // the session's current editor; 0 before its first Attach
};

struct EditRequest {
  std::uint32_t id = 0;  // the client's
  edits::EditorId editor;
  std::uint64_t epoch = 0;
  std::uint64_t sequence = 0;
  edits::Edit edit;
  std::string subject{};  // the player it is made for; empty: the subject that attached
  bool settles = true;    // loose material may slide, if the world lets any
  edits::Extent extent{};
};

/// Callable from any thread. Calls do no I/O and never block on any; each is answered by one mail, and edits
/// of one mailbox are logged in order of arrival.
class EditTaker {
 public:
  virtual ~EditTaker() = default;
  virtual void attach(const MailboxPtr& mailbox, AttachRequest request) = 0;
  virtual void edit(const MailboxPtr& mailbox, EditRequest request) = 0;
  /// The session's client sends no more, and may be gone. No chunks are generated for its edits from here on:
  /// edits that need some are refused, the others continue.
  virtual void input_ended(ClientId client) = 0;
  /// The session is gone: drops its edits that are not logged yet.
  virtual void forget(ClientId client) = 0;
  /// True if `editor` exists and belongs to `subject`, so that an Attach resumes it instead of creating one.
  [[nodiscard]] virtual bool knows(edits::EditorId editor, const std::string& subject) const = 0;
  /// Fails if no editor can be created now, as admit_to_log() does for the Attach, when it may be otherwise.
  [[nodiscard]] virtual tl::expected<void, EditError> room_for_editor() const { return {}; }
  /// True if edits may change more voxels than they name, because loose material slides.
  [[nodiscard]] virtual bool settles() const = 0;
  /// True if edits may change voxels beside their own, because they reveal secret ore.
  [[nodiscard]] virtual bool reveals() const { return false; }
};

}  // namespace talus::server
