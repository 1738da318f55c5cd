#include "limits/flows/flow_shares.h"

#include <algorithm>
#include <utility>

namespace talus::server {

FlowShares::Part::Part(FlowShares& shares, FlowId flow, std::uint64_t amount, Clock::time_point progress)
    : shares_{shares}, amount_{amount}, progress_{progress} {
  const std::lock_guard lock{shares_.mutex_};
  flow_ = &shares_.enter(flow);
  place_ = shares_.parts_.size();
  try {
    shares_.parts_.push_back(this);
  } catch (...) {
    shares_.leave(*flow_);
    throw;
  }
}

FlowShares::Part::~Part() {
  const std::lock_guard lock{shares_.mutex_};
  shares_.remove(*this);
  shares_.leaving_.fetch_sub(leaving_, std::memory_order_relaxed);
}

void FlowShares::Part::set_give_way(GiveWay give_way) {
  {
    const std::lock_guard lock{shares_.mutex_};
    if (place_ != kGone) {
      give_way_ = std::move(give_way);
      return;
    }
  }
  give_way();
}

void FlowShares::Part::move_to(FlowId flow) {
  const std::lock_guard lock{shares_.mutex_};
  if (place_ == kGone) return;
  Flow& joined = shares_.enter(flow);
  shares_.leave(*std::exchange(flow_, &joined));
}

FlowShares::Flow& FlowShares::enter(FlowId flow) {
  Flow& joined = flows_[flow];
  joined.id = flow;
  ++joined.parts;
  return joined;
}

void FlowShares::leave(Flow& flow) noexcept {
  if (--flow.parts == 0) flows_.erase(flow.id);
}

void FlowShares::remove(Part& part) noexcept {
  if (part.place_ == kGone) return;
  leave(*part.flow_);
  parts_.back()->place_ = part.place_;
  parts_[part.place_] = parts_.back();
  parts_.pop_back();
  part.place_ = kGone;
}

std::size_t FlowShares::size() const {
  const std::lock_guard lock{mutex_};
  return parts_.size();
}

bool FlowShares::is_still(const Part& part, Clock::time_point now, Clock::duration patience) {
  const auto progress = part.progress_.load(std::memory_order_relaxed);
  return part.give_way_ && progress < now && now - progress > patience;
}

FlowShares::Part* FlowShares::choose(FlowId flow, std::uint64_t amount, std::uint64_t sure,
                                     Clock::time_point now) {
  for (auto& [id, each] : flows_) each.held = each.yielding = 0;
  // True if `a` gives way before `b`: it has made no progress for longer, or holds more.
  const auto before = [](const Part* a, const Part* b) {
    const auto of_a = a->progress_.load(std::memory_order_relaxed);
    const auto of_b = b->progress_.load(std::memory_order_relaxed);
    return of_a != of_b ? of_a < of_b : a->amount_.load() > b->amount_.load();
  };
  Part* chosen = nullptr;
  for (Part* const part : parts_) {
    part->flow_->held += part->amount_.load(std::memory_order_relaxed);
    part->flow_->yielding += part->give_way_ ? 1 : 0;
    if (is_still(*part, now, patience_) && (chosen == nullptr || before(part, chosen))) chosen = part;
  }
  if (chosen != nullptr) return chosen;
  const auto asking = flows_.find(flow);
  const std::uint64_t wanted = amount + (asking == flows_.end() ? 0 : asking->second.held);
  std::uint64_t most = std::max(sure, wanted);
  const Flow* gives = nullptr;
  for (const auto& [id, each] : flows_) {
    if (each.parts < 2 || each.yielding == 0 || each.held <= most) continue;
    gives = &each;
    most = each.held;
  }
  for (Part* const part : parts_) {
    const bool may = gives == nullptr
                         ? part->flow_->held > wanted && is_still(*part, now, patience_ / kLastResort)
                         : part->flow_ == gives && part->give_way_;
    if (may && (chosen == nullptr || before(part, chosen))) chosen = part;
  }
  return chosen;
}

FlowShares::GiveWay FlowShares::let_go(Part& part) noexcept {
  part.leaving_ = part.amount_.load(std::memory_order_relaxed);
  leaving_.fetch_add(part.leaving_, std::memory_order_relaxed);
  remove(part);
  return std::move(part.give_way_);
}

std::optional<std::uint64_t> FlowShares::make_room(FlowId flow, std::uint64_t amount, std::uint64_t sure,
                                                   Clock::time_point now) {
  GiveWay give_way;
  std::uint64_t held = 0;
  {
    const std::lock_guard lock{mutex_};
    Part* const chosen = choose(flow, amount, sure, now);
    if (chosen == nullptr) return std::nullopt;
    give_way = let_go(*chosen);
    held = chosen->leaving_;
  }
  give_way();
  return held;
}

void FlowShares::end_still(std::uint64_t amount, Clock::time_point now) {
  std::vector<GiveWay> ended;
  {
    const std::lock_guard lock{mutex_};
    for (std::size_t place = parts_.size(); place-- > 0 && amount > 0;) {
      Part& part = *parts_[place];
      if (!is_still(part, now, patience_)) continue;
      ended.push_back(let_go(part));
      amount -= std::min(amount, part.leaving_);
    }
  }
  for (const GiveWay& give_way : ended) give_way();
}

}  // namespace talus::server
