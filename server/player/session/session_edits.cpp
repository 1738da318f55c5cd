#include "player/session/session_edits.h"

#include <utility>

namespace talus::server {

void SessionEdits::attach(AttachRequest request, std::uint64_t voxels_per_second) {
  attaching_ = true;
  is_known_ = true;
  voxels_per_second_ = voxels_per_second;
  taker_->attach(mailbox_, std::move(request));
}

void SessionEdits::edit(std::uint32_t id, std::uint64_t sequence, AdmittedEdit edit) {
  unanswered_.insert(id, {edit.extent.voxels, edit.bytes, edit.prepared_bytes});
  bytes_ += edit.bytes;
  prepared_bytes_.insert(edit.prepared_bytes);
  mailbox_->expect_answer(true);
  taker_->edit(mailbox_, {id, editor_->editor, editor_->epoch, sequence, std::move(edit.edit),
                          std::move(edit.subject), edit.settles, std::move(edit.extent)});
}

void SessionEdits::receive(AttachAnswer&& mail) {
  if (!attaching_) return;  // abandoned
  attaching_ = false;
  if (mail.answer) {
    editor_ = *mail.answer;
    replies_.attached(*editor_, voxels_per_second_);
  } else {
    replies_.error(about_attach(), mail.answer.error());
  }
}

void SessionEdits::receive(EditAnswer&& mail) {
  const UnansweredEdit* const edit = unanswered_.find(mail.id);
  if (edit == nullptr) return;  // abandoned
  bytes_ -= edit->bytes;
  prepared_bytes_.erase(prepared_bytes_.find(edit->prepared_bytes));
  if (mail.answer && mail.answer->changed > edit->voxels) slid_voxels_ += mail.answer->changed - edit->voxels;
  unanswered_.erase(mail.id);
  mailbox_->expect_answer(unanswered_.size() > 0);
  if (mail.answer) {
    replies_.edit_result(mail.id, *mail.answer);
  } else {
    replies_.error(about_request(mail.id), mail.answer.error());
  }
}

void SessionEdits::input_ended() {
  if (unanswered_.size() > 0) taker_->input_ended(mailbox_->owner());
}

void SessionEdits::abandon() {
  if (std::exchange(is_known_, false)) taker_->forget(mailbox_->owner());
  attaching_ = false;
  editor_.reset();
  unanswered_.clear();
  mailbox_->expect_answer(false);
  bytes_ = 0;
  prepared_bytes_.clear();
}

}  // namespace talus::server
