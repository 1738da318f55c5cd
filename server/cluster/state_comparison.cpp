#include "cluster/state_comparison.h"

#include <algorithm>

#include <fmt/format.h>

#include "cluster/message.h"

namespace talus::server::cluster {
namespace {

/// Modulo 2^128.
edits::StateHash difference_of(const edits::StateHash& a, const edits::StateHash& b) {
  return {a.low - b.low, a.high - b.high - (a.low < b.low ? 1U : 0U)};
}

}  // namespace

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
  if (states_.empty() || claim.revision < states_.front().revision) return std::nullopt;
  if (is_wrong_ || wrong_.contains(claim.publisher)) return std::nullopt;
  const edits::StateHash* const own = own_at(claim.revision);
  const auto difference = own ? std::optional{difference_of(claim.hash, *own)} : std::nullopt;
  const Vote vote{difference, claim.publisher, claim.revision};
  const std::uint32_t server = server_of(claim.publisher);
  if (!dispute_) {
    if (difference == edits::StateHash{}) return std::nullopt;
    const State said = own ? State{claim.revision, *own} : states_.back();
    what_ = own ? fmt::format("at revision {} this server has state {}, and another has {}", said.revision,
                              edits::to_string(said.hash), edits::to_string(claim.hash))
                : fmt::format("another server stood at revision {}, and this one never did; it stands at {}",
                              claim.revision, said.revision);
    dispute_ = Dispute{std::min(claim.revision, said.revision), now, {{server, vote}}};
    dispute_->votes.insert_or_assign(server_of(self_), Vote{edits::StateHash{}, self_, said.revision});
    return Claim{self_, said.revision, said.hash};
  }
  if (server == server_of(self_) || claim.revision < dispute_->revision) return std::nullopt;
  const auto before = dispute_->votes.find(server);
  if (before == dispute_->votes.end()) {
    if (dispute_->votes.size() < kMaxVoters) dispute_->votes.emplace(server, vote);
  } else if (before->second.publisher != vote.publisher || before->second.revision <= vote.revision) {
    before->second = vote;
  }
  return std::nullopt;
}

StateComparison::Verdict StateComparison::judge(TimePoint now) {
  if (is_wrong_) return Verdict::wrong;
  if (!dispute_) return Verdict::same;
  if (now - dispute_->since < kVoting) return Verdict::voting;
  std::map<std::optional<edits::StateHash>, std::size_t> groups;
  for (const auto& [server, vote] : dispute_->votes) ++groups[vote.difference];
  constexpr std::optional kNone{edits::StateHash{}};
  const std::size_t own = groups[kNone];
  std::size_t others = 0;
  for (const auto& [difference, size] : groups) {
    if (difference != kNone) others = std::max(others, size);
  }
  if (own == others) return Verdict::undecided;
  if (own < others) {
    is_wrong_ = true;
    return Verdict::wrong;
  }
  for (const auto& [server, vote] : dispute_->votes) {
    if (vote.difference != kNone && wrong_.size() < kMaxVoters) wrong_.insert(vote.publisher);
  }
  dispute_.reset();
  return Verdict::same;
}

}  // namespace talus::server::cluster
