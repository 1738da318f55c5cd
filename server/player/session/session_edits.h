// A session's editor, and its edits that are not answered yet. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "chunks/edit_answers.h"
#include "chunks/mailbox.h"
#include "edits/admission/edit_admission.h"
#include "edits/edit_taker.h"
#include "player/session/id_map.h"
#include "player/session/replies.h"

namespace talus::server {

class SessionEdits {
 public:
  /// `taker` is null if nothing is stored; edits are refused then. It and `replies` outlive this.
  SessionEdits(EditTaker* taker, MailboxPtr mailbox, Replies& replies)
      : taker_{taker}, mailbox_{std::move(mailbox)}, replies_{replies} {}
  SessionEdits(const SessionEdits&) = delete;
  SessionEdits& operator=(const SessionEdits&) = delete;

  /// True while an Attach is not answered.
  [[nodiscard]] bool attaching() const { return attaching_; }
  /// The session as EditAdmission needs it.
  [[nodiscard]] EditingSession session(const Grant& grant, FlowId flow, Clock::time_point now,
                                       bool leaving) const {
    return {grant,
            flow,
            now,
            leaving,
            editor_.has_value(),
            editor_ ? editor_->editor : edits::EditorId{},
            unanswered_.size()};
  }
  [[nodiscard]] bool contains(std::uint32_t id) const { return unanswered_.find(id) != nullptr; }
  /// True if nothing is left to answer.
  [[nodiscard]] bool served() const { return !attaching_ && unanswered_.empty(); }

  /// REQUIRES: admitted, not attaching().
  void attach(AttachRequest request, std::uint64_t voxels_per_second);
  /// REQUIRES: admitted, no edit `id` is unanswered.
  void edit(std::uint32_t id, std::uint64_t sequence, AdmittedEdit edit);

  void receive(AttachAnswer&& mail);
  void receive(EditAnswer&& mail);

  /// Voxels that edits changed in addition to the voxels that they named, since the last call.
  [[nodiscard]] std::uint64_t take_slid_voxels() { return std::exchange(slid_voxels_, 0); }

  /// The client sends no more, and may be gone.
  void input_ended();
  /// Forgets everything; logged edits are applied all the same.
  void abandon();

  /// Memory of unanswered edits.
  [[nodiscard]] std::size_t unanswered_bytes() const { return bytes_; }
  /// Only one edit at a time is prepared: counts the largest.
  [[nodiscard]] std::size_t bytes() const {
    return bytes_ + (prepared_bytes_.empty() ? 0 : *prepared_bytes_.rbegin()) + unanswered_.bytes();
  }

 private:
  EditTaker* const taker_;
  const MailboxPtr mailbox_;
  Replies& replies_;
  bool is_known_ = false;  // to the taker, until its forget()
  bool attaching_ = false;
  std::uint64_t voxels_per_second_ = 0;
  std::optional<EditorSession> editor_;
  struct UnansweredEdit {
    std::uint64_t voxels = 0;  // named by the edit
    std::size_t bytes = 0;
    std::size_t prepared_bytes = 0;
  };
  IdMap<UnansweredEdit> unanswered_;
  std::size_t bytes_ = 0;                      // in unanswered_
  std::multiset<std::size_t> prepared_bytes_;  // in unanswered_
  std::uint64_t slid_voxels_ = 0;
};

}  // namespace talus::server
