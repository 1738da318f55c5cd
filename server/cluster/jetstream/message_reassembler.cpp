#include "cluster/jetstream/message_reassembler.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <xxhash.h>

namespace talus::server::jetstream {

MessageReassembler::Digest MessageReassembler::digest(std::span<const std::byte> bytes) const {
  const XXH128_hash_t hash = XXH3_128bits_withSeed(bytes.data(), bytes.size(), seed_);
  return {hash.low64, hash.high64};
}

void MessageReassembler::drop(std::map<std::uint64_t, HeldMessage>::iterator at) {
  held_bytes_ -= at->second.bytes.size();
  held_.erase(at);
}

void MessageReassembler::progressed(TimePoint now) {
  news_ = now;
  retry_ = {};
  paused_ = {};
  pause_ = kFirstRetry;
}

void MessageReassembler::claim_held() {
  claim_retry_ = {};
  claim_pause_ = kFirstRetry;
}

void MessageReassembler::doubt(std::uint64_t sequence) {
  doubted_.insert(sequence);
  // Keeps the lowest numbers, which matter first, however many are forged.
  if (doubted_.size() > kMaxDoubts) doubted_.erase(std::prev(doubted_.end()));
}

void MessageReassembler::disputed() {
  retry_ = std::min(retry_, paused_ + kDisputed);
}

void MessageReassembler::move_to(std::uint64_t after, TimePoint now) {
  if (after == after_) return;
  if (after < after_) {
    // Messages already returned are read again.
    held_.clear();
    held_bytes_ = 0;
    given_.clear();
    doubted_.clear();
    unconfirmed_.clear();
  }
  after_ = after;
  known_ = std::max(known_, after);
  if (altered_ && altered_->sequence <= after_) altered_.reset();
  while (!held_.empty() && held_.begin()->first <= after_) drop(held_.begin());
  asked_.clear();
  progressed(now);
}

const MessageReassembler::ReturnedMessage* MessageReassembler::remembered(std::uint64_t sequence) const {
  const auto found =
      std::lower_bound(given_.begin(), given_.end(), sequence,
                       [](const auto& each, std::uint64_t wanted) { return each.sequence < wanted; });
  return found != given_.end() && found->sequence == sequence ? &*found : nullptr;
}

void MessageReassembler::hold(std::uint64_t sequence, std::span<const std::byte> bytes, From from,
                              std::optional<std::int64_t> time_ms) {
  if (sequence <= after_ || sequence - after_ > kWindow) return;
  if (const auto found = held_.find(sequence); found != held_.end()) drop(found);
  // The next message always has room.
  while (sequence == after_ + 1 && !held_.empty() && held_bytes_ + bytes.size() > kWindowBytes) {
    drop(std::prev(held_.end()));
  }
  if (sequence != after_ + 1 && held_bytes_ + bytes.size() > kWindowBytes) return;
  held_.emplace(sequence, HeldMessage{{bytes.begin(), bytes.end()}, from, time_ms});
  held_bytes_ += bytes.size();
}

bool MessageReassembler::differs_from_leaders(std::uint64_t sequence, std::span<const std::byte> bytes) {
  const auto found = held_.find(sequence);
  if (std::equal(bytes.begin(), bytes.end(), found->second.bytes.begin(), found->second.bytes.end()))
    return false;
  if (found->second.from == From::leader) return true;
  drop(found);
  doubt(sequence);
  return false;
}

void MessageReassembler::heard(std::uint64_t sequence, std::span<const std::byte> bytes, TimePoint now) {
  if (sequence == 0) return;
  if (doubted_.contains(sequence)) {
    if (sequence == after_ + 1) disputed();
    return;
  }
  if (altered_ && altered_->sequence == sequence) {
    if (altered_->digest != digest(bytes)) disputed();
    return;
  }
  if (sequence <= after_) {
    const ReturnedMessage* const given = remembered(sequence);
    if (given == nullptr || given->digest == digest(bytes)) return;
    if (given->answered) {
      ++false_messages_;
    } else {
      doubt(sequence);
    }
    return;
  }
  if (held_.contains(sequence)) {
    if (differs_from_leaders(sequence, bytes)) ++false_messages_;
    return;
  }
  if (sequence > after_ + 1 && std::max(known_, claimed_) <= after_ && sequence > gap_up_to_) {
    ++gaps_;
    gap_up_to_ = sequence;
  }
  claimed_ = std::max(claimed_, sequence);
  hold(sequence, bytes, From::tail);
  ask_from_ = now;
  if (sequence == after_ + 1) {
    progressed(now);
    ask_from_ = now + kOnItsWay;
  }
}

void MessageReassembler::answered(std::uint64_t sequence, std::span<const std::byte> bytes, TimePoint now,
                                  std::optional<std::int64_t> time_ms) {
  asked_.erase(sequence);
  const bool doubted = doubted_.erase(sequence) > 0;
  if (doubted) ++false_messages_;
  if (altered_ && altered_->sequence == sequence) {
    if (altered_->digest != digest(bytes)) ++false_messages_;
    altered_.reset();
  }
  if (const auto found = unconfirmed_.find(sequence); found != unconfirmed_.end()) {
    if (found->second != UnconfirmedMessage{digest(bytes), time_ms}) forged_ = sequence;
    unconfirmed_.erase(found);
    progressed(now);
    return;
  }
  if (sequence <= after_) {
    const ReturnedMessage* const given = remembered(sequence);
    if (doubted && given != nullptr && given->digest != digest(bytes)) forged_ = sequence;
    return;
  }
  if (sequence > known_) {
    claim_held();
    claim_requests_ = std::min(2 * claim_requests_, kMaxRequests);
  }
  known_ = std::max(known_, sequence);
  hold(sequence, bytes, From::leader, time_ms);
  progressed(now);
}

void MessageReassembler::answered_by_replica(std::uint64_t sequence, std::span<const std::byte> bytes,
                                             TimePoint now, std::optional<std::int64_t> time_ms) {
  // Only the leader can decide disputes.
  if (doubted_.contains(sequence) || (altered_ && altered_->sequence == sequence)) {
    return not_found(sequence, now);
  }
  asked_.erase(sequence);
  if (sequence <= after_) return;
  if (held_.contains(sequence)) {
    (void)differs_from_leaders(sequence, bytes);
    return;
  }
  // More messages may follow.
  claim_held();
  claim_requests_ = std::min(2 * claim_requests_, kMaxRequests);
  claimed_ = std::max(claimed_, sequence + claim_requests_);
  hold(sequence, bytes, From::replica, time_ms);
  progressed(now);
}

void MessageReassembler::not_found(std::uint64_t sequence, TimePoint now) {
  const auto asked = asked_.find(sequence);
  const TimePoint asked_at = asked == asked_.end() ? now : asked->second - kAnswerIn;
  asked_.erase(sequence);
  if (sequence > known_ && !doubted_.contains(sequence)) {
    news_ = now;  // a negative answer is news too
    claim_requests_ = 1;
    if (claimed_ > after_) {
      claim_retry_ = now + claim_pause_;
      claim_pause_ = std::min(claim_pause_ * 2, kLastRetry);
    }
    return;
  }
  // Misses of simultaneous requests cause one pause.
  if (asked_at <= paused_) return;
  paused_ = now;
  retry_ = now + pause_;
  pause_ = std::min(pause_ * 2, kLastRetry);
}

bool MessageReassembler::learned(std::uint64_t sequence, TimePoint now) {
  if (sequence <= known_) return false;
  if (std::max(known_, claimed_) <= after_) ask_from_ = now + kOnItsWay;
  known_ = sequence;
  if (claimed_ > after_ && claimed_ <= known_) claim_held();
  return true;
}

void MessageReassembler::ends_at(std::uint64_t last) {
  // Messages that arrived after the request may exceed `last`; if they exist a request will return them.
  const std::uint64_t end = std::max(last, after_);
  if (claimed_ > end && claim_pause_ >= kSureOfNone) claimed_ = end;
  if (pause_ < kSureOfNone) return;
  known_ = std::min(known_, end);
  if (altered_ && altered_->sequence > end) {
    ++false_messages_;
    altered_.reset();
  }
  doubted_.erase(doubted_.upper_bound(end), doubted_.end());
}

void MessageReassembler::starts_at(std::uint64_t first) {
  doubted_.erase(doubted_.begin(), doubted_.lower_bound(first));
  unconfirmed_.erase(unconfirmed_.begin(), unconfirmed_.lower_bound(first));
}

void MessageReassembler::leader_answers(bool does) {
  if (std::exchange(led_, does) == does || !does) return;
  for (auto at = held_.begin(); at != held_.end();) {
    const auto next = std::next(at);
    if (at->second.from == From::replica) drop(at);
    at = next;
  }
  asked_.clear();  // requests to replicas
}

std::optional<std::uint64_t> MessageReassembler::unconfirmed() const {
  return unconfirmed_.empty() ? std::nullopt : std::optional{unconfirmed_.rbegin()->first};
}

bool MessageReassembler::is_unconfirmed_after(std::uint64_t last) const {
  const auto number = std::distance(unconfirmed_.upper_bound(last), unconfirmed_.end());
  return last < after_ && static_cast<std::uint64_t>(number) == after_ - last;
}

std::optional<StreamMessage> MessageReassembler::take() {
  if (led_ && !unconfirmed_.empty()) return std::nullopt;
  const auto next = held_.find(after_ + 1);
  if (next == held_.end()) return std::nullopt;
  StreamMessage message{next->first, std::move(next->second.bytes), next->second.time_ms};
  held_bytes_ -= message.bytes.size();
  message.of_leader = next->second.from == From::leader;
  given_.push_back({message.sequence, digest(message.bytes), message.of_leader});
  if (next->second.from == From::replica)
    unconfirmed_[message.sequence] = {given_.back().digest, message.time_ms};
  if (given_.size() > kRemembered) given_.pop_front();
  held_.erase(next);
  after_ = message.sequence;
  known_ = std::max(known_, after_);
  return message;
}

void MessageReassembler::ask_again(TimePoint now) {
  if (given_.empty() || given_.back().sequence != after_ || given_.back().answered) return;
  altered_ = given_.back();
  given_.pop_back();
  --after_;
  unconfirmed_.erase(altered_->sequence);
  progressed(now);
  ask_from_ = now;
}

std::vector<std::uint64_t> MessageReassembler::wanted(TimePoint now) {
  polled_ = now;
  std::erase_if(asked_, [&](const auto& each) { return each.second <= now; });
  std::vector<std::uint64_t> wanted;
  const auto ask = [&](std::uint64_t sequence) {
    asked_[sequence] = now + kAnswerIn;
    wanted.push_back(sequence);
  };
  if (now < retry_) return wanted;
  if (led_ && !unconfirmed_.empty()) {
    for (const auto& [sequence, digest] : unconfirmed_) {
      if (asked_.size() >= kMaxRequests) break;
      if (!asked_.contains(sequence)) ask(sequence);
    }
    return wanted;
  }
  if (unconfirmed_.size() >= kMaxUnconfirmedMessages) return wanted;
  for (const std::uint64_t sequence : doubted_) {
    if (!led_ || sequence > std::max(known_, after_ + 1)) break;  // only the leader can decide these
    if (!asked_.contains(sequence)) ask(sequence);
  }
  if (known_ > after_) {
    if (now < ask_from_) return wanted;
    const std::uint64_t end = std::min(known_, after_ + kWindow);
    for (std::uint64_t sequence = after_ + 1; sequence <= end && asked_.size() < kMaxRequests; ++sequence) {
      if (sequence > after_ + 1 && held_bytes_ >= kWindowBytes) break;
      if (!asked_or_held(sequence)) ask(sequence);
    }
  } else if (!asked_or_held(after_ + 1)) {
    const bool claimed = claimed_ > after_ && now >= std::max(ask_from_, claim_retry_);
    if (claimed || now - news_ >= silence()) ask(after_ + 1);
    const std::uint64_t end = claimed ? std::min(claimed_, after_ + claim_requests_) : 0;
    for (std::uint64_t sequence = after_ + 2; sequence <= end && asked_.size() < kMaxRequests; ++sequence) {
      if (held_bytes_ >= kWindowBytes) break;
      if (!asked_or_held(sequence)) ask(sequence);
    }
  }
  return wanted;
}

MessageReassembler::TimePoint MessageReassembler::next_poll() const {
  TimePoint next = TimePoint::max();
  for (const auto& [sequence, due] : asked_) next = std::min(next, due);
  if (retry_ > polled_) next = std::min(next, retry_);
  if (known_ > after_ && ask_from_ > polled_) next = std::min(next, ask_from_);
  if (claims_more() && known_ <= after_) {
    const TimePoint due = std::max(ask_from_, claim_retry_);
    if (due > polled_) next = std::min(next, due);
  }
  if (known_ <= after_ && asked_.empty()) next = std::min(next, std::max(news_ + silence(), polled_));
  return next;
}

}  // namespace talus::server::jetstream
