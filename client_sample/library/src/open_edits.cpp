#include "open_edits.h"

#include <algorithm>
#include <utility>

namespace talus::client {

std::vector<OpenEdit> OpenEdits::take_sent() {
  std::vector<OpenEdit> sent;
  for (auto& [sequence, edit] : std::exchange(again_, {})) sent.push_back(std::move(edit));
  return sent;
}

std::vector<OpenEdit> OpenEdits::attached(edits::EditorId editor, bool known, std::uint64_t last_sequence,
                                          std::uint64_t revision, std::uint32_t unanswered) {
  std::vector<OpenEdit> lost;
  if (!known) {
    lost = take_sent();  // by an earlier connection; edits in flight on this one are answered
    last_sequence_ = 0;
    for (OpenEdit& edit : waiting_) edit.sequence = 0;
  }
  attach_ = Attach::done;
  editor_ = editor;
  last_sequence_ = std::max(last_sequence_, last_sequence);
  unanswered_ = std::max(1U, unanswered);
  saw(revision);
  return lost;
}

std::vector<OpenEdit> OpenEdits::forget_editor() {
  editor_ = {};
  last_sequence_ = 0;
  seen_revision_ = 0;
  for (OpenEdit& edit : waiting_) edit.sequence = 0;
  connection_ended();
  return take_sent();
}

std::uint32_t OpenEdits::send_next() {
  OpenEdit next;
  if (!again_.empty()) {
    next = std::move(again_.extract(again_.begin()).mapped());
  } else {
    next = std::move(waiting_.front());
    waiting_.pop_front();
    next.sequence = ++last_sequence_;
  }
  do {
    last_id_ = (last_id_ + 1) & ~kIdBit;
  } while (in_flight_.contains(kIdBit | last_id_));
  in_flight_.emplace(kIdBit | last_id_, std::move(next));
  return kIdBit | last_id_;
}

const OpenEdit* OpenEdits::in_flight(std::uint32_t id) const {
  const auto at = in_flight_.find(id);
  return at == in_flight_.end() ? nullptr : &at->second;
}

OpenEdit OpenEdits::take(std::uint32_t id) {
  return std::move(in_flight_.extract(id).mapped());
}

void OpenEdits::put_back(std::uint32_t id) {
  OpenEdit edit = take(id);
  const std::uint64_t sequence = edit.sequence;
  edit.sent_before = true;
  again_.emplace(sequence, std::move(edit));
}

void OpenEdits::send_as_new(std::uint32_t id) {
  OpenEdit edit = take(id);
  edit.sent_before = false;
  const auto after = std::ranges::find_if(
      waiting_, [&](const OpenEdit& each) { return each.sequence == 0 || each.sequence > edit.sequence; });
  waiting_.insert(after, std::move(edit));
}

void OpenEdits::connection_ended() {
  attach_ = Attach::none;
  for (auto& [id, edit] : std::exchange(in_flight_, {})) {
    const std::uint64_t sequence = edit.sequence;
    edit.sent_before = true;
    again_.emplace(sequence, std::move(edit));
  }
}

OpenEdits::All OpenEdits::take_all() {
  connection_ended();
  All all{take_sent(), {}};
  for (OpenEdit& edit : std::exchange(waiting_, {})) all.unsent.push_back(std::move(edit));
  return all;
}

}  // namespace talus::client
