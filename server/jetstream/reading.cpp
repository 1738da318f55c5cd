#include "jetstream/reading.h"

#include <algorithm>
#include <iterator>

#include <xxhash.h>

namespace talus::server::jetstream {

Reading::Digest Reading::digest(std::span<const std::byte> bytes) const {
  const XXH128_hash_t hash = XXH3_128bits_withSeed(bytes.data(), bytes.size(), seed_);
  return {hash.low64, hash.high64};
}

void Reading::drop(std::map<std::uint64_t, Held>::iterator at) {
  held_bytes_ -= at->second.bytes.size();
  held_.erase(at);
}

void Reading::progressed(TimePoint now) {
  news_ = now;
  retry_ = {};
  pause_ = kFirstRetry;
}

void Reading::move_to(std::uint64_t after, TimePoint now) {
  if (after == after_) return;
  if (after < after_) {
    // What was given out is to be read again.
    held_.clear();
    held_bytes_ = 0;
    given_.clear();
    doubted_.clear();
  }
  after_ = after;
  known_ = std::max(known_, after);
  if (altered_ && altered_->sequence <= after_) altered_.reset();
  while (!held_.empty() && held_.begin()->first <= after_) drop(held_.begin());
  asked_.clear();
  progressed(now);
}

const Reading::Given* Reading::remembered(std::uint64_t sequence) const {
  const auto found =
      std::lower_bound(given_.begin(), given_.end(), sequence,
                       [](const auto& each, std::uint64_t wanted) { return each.sequence < wanted; });
  return found != given_.end() && found->sequence == sequence ? &*found : nullptr;
}

void Reading::hold(std::uint64_t sequence, std::span<const std::byte> bytes, bool answered) {
  if (sequence <= after_ || sequence - after_ > kWindow) return;
  if (const auto found = held_.find(sequence); found != held_.end()) drop(found);
  // The next message has room whatever others came before it.
  while (sequence == after_ + 1 && !held_.empty() && held_bytes_ + bytes.size() > kWindowBytes) {
    drop(std::prev(held_.end()));
  }
  if (sequence != after_ + 1 && held_bytes_ + bytes.size() > kWindowBytes) return;
  held_.emplace(sequence, Held{{bytes.begin(), bytes.end()}, answered});
  held_bytes_ += bytes.size();
}

void Reading::heard(std::uint64_t sequence, std::span<const std::byte> bytes, TimePoint now) {
  if (sequence == 0 || doubted_.contains(sequence)) return;
  if (altered_ && altered_->sequence == sequence) return;
  const auto doubt = [&] {
    if (doubted_.size() < kMostDoubts) doubted_.insert(sequence);
  };
  if (sequence <= after_) {
    const Given* const given = remembered(sequence);
    if (given == nullptr || given->digest == digest(bytes)) return;
    if (given->answered) {
      ++false_messages_;
    } else {
      doubt();
    }
    return;
  }
  if (const auto found = held_.find(sequence); found != held_.end()) {
    if (std::equal(bytes.begin(), bytes.end(), found->second.bytes.begin(), found->second.bytes.end()))
      return;
    if (found->second.answered) {
      ++false_messages_;
      return;
    }
    drop(found);
    doubt();
    return;
  }
  if (sequence > after_ + 1 && known_ <= after_ && sequence > gap_up_to_) {
    ++gaps_;
    gap_up_to_ = sequence;
  }
  known_ = std::max(known_, sequence);
  hold(sequence, bytes, false);
  ask_from_ = now;
  if (sequence == after_ + 1) {
    progressed(now);
    ask_from_ = now + kOnItsWay;
  }
}

void Reading::answered(std::uint64_t sequence, std::span<const std::byte> bytes, TimePoint now) {
  asked_.erase(sequence);
  const bool doubted = doubted_.erase(sequence) > 0;
  if (doubted) ++false_messages_;
  if (altered_ && altered_->sequence == sequence) {
    if (altered_->digest != digest(bytes)) ++false_messages_;
    altered_.reset();
  }
  if (sequence <= after_) {
    const Given* const given = remembered(sequence);
    if (doubted && given != nullptr && given->digest != digest(bytes)) forged_ = sequence;
    return;
  }
  known_ = std::max(known_, sequence);
  hold(sequence, bytes, true);
  progressed(now);
}

void Reading::not_found(std::uint64_t sequence, TimePoint now) {
  asked_.erase(sequence);
  if (sequence > known_) {
    news_ = now;  // nothing new is an answer too
    return;
  }
  retry_ = now + pause_;
  pause_ = std::min(pause_ * 2, kLastRetry);
}

bool Reading::learned(std::uint64_t sequence, TimePoint now) {
  if (sequence <= known_) return false;
  if (known_ <= after_) ask_from_ = now + kOnItsWay;
  known_ = sequence;
  return true;
}

void Reading::ends_at(std::uint64_t last) {
  // What came after the leader was asked is more than it said; that is there when it is asked for.
  if (known_ <= last || pause_ < kSureOfNone) return;
  known_ = std::max(last, after_);
  if (altered_ && altered_->sequence > known_) {
    ++false_messages_;
    altered_.reset();
  }
  doubted_.erase(doubted_.upper_bound(known_), doubted_.end());
}

void Reading::starts_at(std::uint64_t first) {
  doubted_.erase(doubted_.begin(), doubted_.lower_bound(first));
}

std::optional<StreamMessage> Reading::take() {
  const auto next = held_.find(after_ + 1);
  if (next == held_.end()) return std::nullopt;
  StreamMessage message{next->first, std::move(next->second.bytes)};
  held_bytes_ -= message.bytes.size();
  message.of_leader = next->second.answered;
  given_.push_back({message.sequence, digest(message.bytes), message.of_leader});
  if (given_.size() > kRemembered) given_.pop_front();
  held_.erase(next);
  after_ = message.sequence;
  known_ = std::max(known_, after_);
  return message;
}

void Reading::ask_again(TimePoint now) {
  if (given_.empty() || given_.back().sequence != after_ || given_.back().answered) return;
  altered_ = given_.back();
  given_.pop_back();
  --after_;
  progressed(now);
  ask_from_ = now;
}

std::vector<std::uint64_t> Reading::wanted(TimePoint now) {
  looked_ = now;
  std::erase_if(asked_, [&](const auto& each) { return each.second <= now; });
  std::vector<std::uint64_t> wanted;
  if (now < retry_) return wanted;
  const auto ask = [&](std::uint64_t sequence) {
    asked_[sequence] = now + kAnswerIn;
    wanted.push_back(sequence);
  };
  for (const std::uint64_t sequence : doubted_) {
    if (!asked_.contains(sequence)) ask(sequence);
  }
  if (known_ > after_) {
    if (now < ask_from_) return wanted;
    const std::uint64_t end = std::min(known_, after_ + kWindow);
    for (std::uint64_t sequence = after_ + 1; sequence <= end && asked_.size() < kMostRequests; ++sequence) {
      if (sequence > after_ + 1 && held_bytes_ >= kWindowBytes) break;
      if (!asked_or_held(sequence)) ask(sequence);
    }
  } else if (now - news_ >= kSilence && !asked_or_held(after_ + 1)) {
    ask(after_ + 1);
  }
  return wanted;
}

Reading::TimePoint Reading::next_look() const {
  TimePoint look = TimePoint::max();
  for (const auto& [sequence, due] : asked_) look = std::min(look, due);
  if (retry_ > looked_) look = std::min(look, retry_);
  if (known_ > after_ && ask_from_ > looked_) look = std::min(look, ask_from_);
  if (known_ <= after_ && asked_.empty()) look = std::min(look, std::max(news_ + kSilence, looked_));
  return look;
}

}  // namespace talus::server::jetstream
