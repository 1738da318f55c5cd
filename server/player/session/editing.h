// A session's edits: as which editor it edits, and which of its edits are not answered yet. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "chunks/edit_answers.h"
#include "chunks/mailbox.h"
#include "edits/edit_taker.h"
#include "player/session/edit_check.h"
#include "player/session/id_map.h"
#include "player/session/replies.h"

namespace talus::server {

class Editing {
 public:
  /// `taker` null: nothing is stored, and edits are refused. It and `replies` outlive this.
  Editing(EditTaker* taker, MailboxPtr mailbox, Replies& replies)
      : taker_{taker}, mailbox_{std::move(mailbox)}, replies_{replies} {}
  Editing(const Editing&) = delete;
  Editing& operator=(const Editing&) = delete;

  [[nodiscard]] bool stored() const { return taker_ != nullptr; }
  [[nodiscard]] bool settles() const { return stored() && taker_->settles(); }
  /// Whether an Attach is not answered yet.
  [[nodiscard]] bool attaching() const { return attaching_; }
  [[nodiscard]] bool attached() const { return editor_.has_value(); }
  /// 0: none.
  [[nodiscard]] edits::EditorId editor() const { return editor_ ? editor_->editor : edits::EditorId{}; }
  [[nodiscard]] bool contains(std::uint32_t id) const { return unanswered_.find(id) != nullptr; }
  [[nodiscard]] std::size_t unanswered() const { return unanswered_.size(); }
  /// Whether nothing is to be answered.
  [[nodiscard]] bool served() const { return !attaching_ && unanswered_.empty(); }

  /// Whether an editor is made for who attaches so. REQUIRES: stored().
  [[nodiscard]] bool makes_editor(const AttachRequest& request) const {
    return !editor_ && !taker_->knows(request.editor, request.subject);
  }
  /// Why none may be made now; nothing: one may. REQUIRES: stored().
  [[nodiscard]] std::optional<EditRefusal> refuses_editors() const { return taker_->refuses_editors(); }
  /// REQUIRES: stored(), not attaching().
  void attach(AttachRequest request, std::uint64_t voxels_per_second);
  /// REQUIRES: attached(), no edit `id` is unanswered.
  void edit(std::uint32_t id, std::uint64_t sequence, CheckedEdit edit);

  void receive(AttachAnswer&& mail);
  void receive(EditAnswer&& mail);

  /// Voxels that edits changed beyond those that they named, since the last call.
  [[nodiscard]] std::uint64_t take_slid_voxels() { return std::exchange(slid_voxels_, 0); }

  /// The client sends no more, and may be gone.
  void input_ended();
  /// Forgets everything; what is logged already happens all the same.
  void abandon();

  /// Memory of the edits that are not answered.
  [[nodiscard]] std::size_t unanswered_bytes() const { return bytes_; }
  /// One edit at a time is prepared: the dearest counts.
  [[nodiscard]] std::size_t bytes() const {
    return bytes_ + (prepared_bytes_.empty() ? 0 : *prepared_bytes_.rbegin()) + unanswered_.bytes();
  }

 private:
  EditTaker* const taker_;
  const MailboxPtr mailbox_;
  Replies& replies_;
  bool is_known_ = false;  // to the taker, which keeps what it knows until it is told to forget
  bool attaching_ = false;
  std::uint64_t voxels_per_second_ = 0;
  std::optional<EditorSession> editor_;
  struct Unanswered {
    std::uint64_t voxels = 0;  // that it names
    std::size_t bytes = 0;
    std::size_t prepared_bytes = 0;
  };
  IdMap<Unanswered> unanswered_;
  std::size_t bytes_ = 0;                      // of them
  std::multiset<std::size_t> prepared_bytes_;  // likewise
  std::uint64_t slid_voxels_ = 0;
};

}  // namespace talus::server
