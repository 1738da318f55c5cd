#include "edits/edit_intake.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace talus::server {

EditIntake::EditIntake(Parts parts, Rules rules, Logger log)
    : parts_{std::move(parts)},
      rules_{std::move(rules)},
      log_{std::move(log)},
      bases_{kBaseBytes, rules_.hidden} {}

void EditIntake::stop() {
  {
    const std::lock_guard lock{mutex_};
    stopping_ = true;
  }
  comes_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void EditIntake::start() {
  thread_ = std::thread{[this] { work(); }};
  started_ = true;
}

// ---- from other threads

void EditIntake::attach(const MailboxPtr& mailbox, AttachRequest request) {
  {
    const std::lock_guard lock{mutex_};
    arrivals_.emplace_back(mailbox, std::move(request));
    ++waiting_;  // before the thread can take it and count it off
    called_ = true;
  }
  comes_.notify_one();
}

void EditIntake::edit(const MailboxPtr& mailbox, EditRequest request) {
  if (log_at_once(mailbox, request)) return;
  {
    const std::lock_guard lock{mutex_};
    arrivals_.emplace_back(mailbox, WaitingEdit{std::move(request), parts_.clock.now()});
    ++waiting_;
    called_ = true;
  }
  comes_.notify_one();
}

bool EditIntake::log_at_once(const MailboxPtr& session, EditRequest& request) {
  if (!started_ || request.extent.voxels > kSmallVoxels || (settles() && request.settles)) return false;
  // Another calling thread finishes sooner than the intake's could be woken.
  constexpr int kTries = 100;
  std::unique_lock working{work_, std::try_to_lock};
  for (int tries = 1; !working && !thread_works_ && tries < kTries; ++tries) (void)working.try_lock();
  if (!working) return false;
  {
    const std::lock_guard lock{mutex_};
    if (called_ || stopping_) return false;  // another arrival is before it
  }
  const Lane* const lane = find_lane(session->owner());
  if (lane == nullptr || lane->attaching || lane->first || !lane->waiting.empty() || *lane->in_log != 0) {
    return false;
  }
  auto touched = admit(request.edit);
  if (!touched) {
    refuse(session, request.id, std::move(touched.error()));
    return true;
  }
  Preparation edit{{}, *std::move(touched), {}, {}, {}, {}};
  if (!look_around(edit)) return false;
  for (const edits::TouchedChunk& each : edit.looked_up()) {
    const DecodedBasePtr base = bases_.find(each.chunk);
    if (base == nullptr) return false;
    edit.take(each.chunk, *base);
  }
  edit.edit = {std::move(request), parts_.clock.now()};
  log_edit(*lane, std::move(edit));
  return true;
}

bool EditIntake::knows(edits::EditorId id, const std::string& subject) const {
  const auto editor = id == edits::EditorId{} ? std::nullopt : parts_.editor(id);
  return editor && editor->subject == subject;
}

void EditIntake::input_ended(ClientId client) {
  {
    const std::lock_guard lock{mutex_};
    input_ended_.push_back(client);
    called_ = true;
  }
  comes_.notify_one();
}

void EditIntake::forget(ClientId client) {
  {
    const std::lock_guard lock{mutex_};
    forgotten_.push_back(client);
    called_ = true;
  }
  comes_.notify_one();
}

void EditIntake::limit_bases(std::size_t bytes) {
  base_limit_ = std::min(bytes, kBaseBytes);
  if (base_bytes_ > bytes) call();
}

void EditIntake::call() {
  {
    const std::lock_guard lock{mutex_};
    called_ = true;
  }
  comes_.notify_one();
}

// ---- the thread

void EditIntake::work() {
  for (;;) {
    {
      std::unique_lock lock{mutex_};
      comes_.wait(lock, [&] { return stopping_ || called_; });
      if (stopping_) return;
    }
    try {
      do_what_waits();
    } catch (const std::exception& error) {
      // No memory. All sessions whose edits may be affected end, and their clients send the edits again.
      log_->error("edits: {}", error.what());
      const std::lock_guard working{work_};
      thread_works_ = false;
      for (const auto& [client, lane] : lanes_) lane.session->lose_mail();
      for (const auto& [session, what] : taken_in_) session->lose_mail();
      lanes_.clear();
      taken_in_.clear();
      attaching_as_.clear();
      small_.clear();
      large_.clear();
      const std::lock_guard lock{mutex_};
      waiting_ = arrivals_.size();
    }
  }
}

void EditIntake::do_what_waits() {
  thread_works_ = true;
  const std::lock_guard working{work_};
  bool goes_on = true;
  while (goes_on) {
    // Arrivals are taken in before each turn, which may then be theirs.
    goes_on = take_in() && take_turn();
    // Chunks may also arrive while no lane has a turn.
    base_bytes_ = bases_.bytes();
  }
  thread_works_ = false;
}

bool EditIntake::take_in() {
  bases_.set_capacity(base_limit_);
  decltype(attached_) attached_now;
  decltype(input_ended_) input_ended;
  decltype(forgotten_) forgotten;
  decltype(looked_up_) looked_up;
  {
    const std::lock_guard lock{mutex_};
    if (stopping_) return false;
    if (!std::exchange(called_, false)) return true;
    taken_in_.swap(arrivals_);
    attached_now.swap(attached_);
    input_ended.swap(input_ended_);
    forgotten.swap(forgotten_);
    looked_up.swap(looked_up_);
  }
  for (auto& [mailbox, what] : taken_in_) {
    Lane& lane = lane_of(mailbox);
    if (auto* const edit = std::get_if<WaitingEdit>(&what)) {
      lane.waiting.push_back(std::move(*edit));
      if (!lane.first) enter(lane);
    } else {
      begin_attach(lane, std::get<AttachRequest>(std::move(what)));
    }
  }
  taken_in_.clear();
  for (const AttachOutcome& each : attached_now) attached(each);
  for (const std::uint64_t client : looked_up) {
    if (Lane* const lane = find_lane(ClientId{client})) enter(*lane);
  }
  for (const ClientId client : input_ended) {
    if (Lane* const lane = find_lane(client)) end_input(*lane);
  }
  for (const ClientId client : forgotten) forget_lane(client);
  return true;
}

void EditIntake::send(const MailboxPtr& mailbox, Mail mail) noexcept {
  try {
    mailbox->put(std::move(mail));
    mailbox->wake();
  } catch (const std::exception&) {
    mailbox->lose_mail();
  }
}

}  // namespace talus::server
