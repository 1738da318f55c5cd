#include "cluster/state_comparison.h"

#include <algorithm>

#include <fmt/format.h>

namespace talus::server::cluster {

void StateComparison::stands(std::uint64_t revision, edits::StateHash hash) {
  if (!states_.empty() && states_.back().revision >= revision) return;
  states_.push_back({revision, hash});
  if (states_.size() > kRemembered) states_.pop_front();
}

const edits::StateHash* StateComparison::own_at(std::uint64_t revision) const {
  const auto at = std::ranges::lower_bound(states_, revision, {}, &State::revision);
  return at == states_.end() || at->revision != revision ? nullptr : &at->hash;
}

std::optional<StateComparison::Claim> StateComparison::heard(const Claim& claim, TimePoint now) {
  const edits::StateHash* const own = own_at(claim.revision);
  if (own == nullptr || is_wrong_ || wrong_.contains(claim.publisher)) return std::nullopt;
  const bool same = *own == claim.hash;
  if (!dispute_) {
    if (same) return std::nullopt;
    what_ = fmt::format("at revision {} this server has state {}, and another has {}", claim.revision,
                        edits::to_string(*own), edits::to_string(claim.hash));
    dispute_ = Dispute{claim.revision, *own, now, {{self_, *own}, {claim.publisher, claim.hash}}};
    return Claim{self_, claim.revision, *own};
  }
  if (dispute_->votes.size() >= kMostVoters && !dispute_->votes.contains(claim.publisher)) {
    return std::nullopt;
  }
  if (claim.revision == dispute_->revision) {
    dispute_->votes.insert_or_assign(claim.publisher, claim.hash);
  } else if (same && claim.revision > dispute_->revision) {
    // Who has the same later had the same then.
    dispute_->votes.insert_or_assign(claim.publisher, dispute_->own);
  }
  return std::nullopt;
}

StateComparison::Verdict StateComparison::judge(TimePoint now) {
  if (is_wrong_) return Verdict::wrong;
  if (!dispute_) return Verdict::same;
  if (now - dispute_->since < kVoting) return Verdict::voting;
  std::map<edits::StateHash, std::size_t> groups;
  for (const auto& [publisher, hash] : dispute_->votes) ++groups[hash];
  const std::size_t own = groups[dispute_->own];
  std::size_t others = 0;
  for (const auto& [hash, size] : groups) {
    if (hash != dispute_->own) others = std::max(others, size);
  }
  if (own == others) return Verdict::undecided;
  if (own < others) {
    is_wrong_ = true;
    return Verdict::wrong;
  }
  for (const auto& [publisher, hash] : dispute_->votes) {
    if (hash != dispute_->own && wrong_.size() < kMostVoters) wrong_.insert(publisher);
  }
  dispute_.reset();
  return Verdict::same;
}

}  // namespace talus::server::cluster
