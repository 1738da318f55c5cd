// Where sessions bring edits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <talus/edits/edit.h>
#include <talus/edits/editors.h>

#include "chunks/edit_answers.h"
#include "chunks/mailbox.h"

namespace talus::server {

struct AttachRequest {
  edits::EditorId editor;           // whose edits the client goes on with; 0: none
  std::string subject;              // of its token; empty: none
  std::uint64_t seen_revision = 0;  // the client was told of this one
  edits::EditorId own{};            // as which the session edits already; 0: it does not yet
};

struct EditRequest {
  std::uint32_t id = 0;  // the client's
  edits::EditorId editor;
  std::uint64_t epoch = 0;
  std::uint64_t sequence = 0;
  edits::Edit edit;
  std::string subject{};  // whose edit it is; empty: of the subject that attached
  bool settles = true;    // loose material may slide, where any does
};

/// Callable from any thread. No call looks anything up, writes, or waits for who does; each is answered by
/// one mail, and edits of one mailbox are logged in the order in which they came.
class EditTaker {
 public:
  virtual ~EditTaker() = default;
  virtual void attach(const MailboxPtr& mailbox, AttachRequest request) = 0;
  virtual void edit(const MailboxPtr& mailbox, EditRequest request) = 0;
  /// The session's client sends no more, and may be gone: no ground is generated for its edits from here on.
  /// Those that need some are refused, the others go on.
  virtual void input_ended(ClientId client) = 0;
  /// The session is gone: what of its edits is not logged yet will not be.
  virtual void forget(ClientId client) = 0;
  /// Whether who attaches as `editor` with a token of that subject goes on as it, or is another from then on.
  [[nodiscard]] virtual bool knows(edits::EditorId editor, const std::string& subject) const = 0;
  /// Why nobody new may edit now, and when to come again; nothing: they may. It may change until the Attach.
  [[nodiscard]] virtual std::optional<EditRefusal> refuses_editors() const { return std::nullopt; }
  /// Whether edits may change more voxels than they name, as loose material slides.
  [[nodiscard]] virtual bool settles() const = 0;
};

}  // namespace talus::server
