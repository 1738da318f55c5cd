#include "net/io_turns.h"

#include <algorithm>
#include <utility>

#include <asio/post.hpp>

namespace talus::server {

bool IoTurns::go_on(FlowId flow, std::uint64_t cost) {
  Flow& of = settled(flow);
  if (of.used >= kTurn || (of.queued && flow != has_turn_)) return false;
  of.used += cost;
  return true;
}

void IoTurns::wait(FlowId flow, std::shared_ptr<Waiter> waiter, const asio::any_io_executor& executor) {
  Flow& of = settled(flow);
  if (!posted_) post(executor);
  of.waiters.push_back(std::move(waiter));
  if (of.queued) return;
  try {
    next_round_.push_back(flow);
  } catch (...) {
    of.waiters.clear();
    throw;
  }
  of.queued = true;
}

void IoTurns::post(const asio::any_io_executor& executor) {
  asio::post(executor, [this, executor] {
    posted_ = false;
    has_turn_.reset();
    give_turn(executor);
  });
  posted_ = true;
}

void IoTurns::give_turn(const asio::any_io_executor& executor) {
  if (this_round_.empty()) {
    if (next_round_.empty()) return;
    ++round_;
    this_round_.swap(next_round_);
  }
  post(executor);
  const auto place = this_round_.begin();
  next_round_.splice(next_round_.end(), this_round_, place);
  Flow& flow = settled(*place);
  has_turn_ = *place;
  while (!flow.waiters.empty() && flow.used < kTurn) {
    const std::shared_ptr<Waiter> first = std::move(flow.waiters.front());
    flow.waiters.pop_front();
    first->take_turn();
  }
  has_turn_.reset();
  if (!flow.waiters.empty()) return;
  flow.queued = false;
  next_round_.erase(place);
}

IoTurns::Flow& IoTurns::settled(FlowId flow) {
  if (const auto known = flows_.find(flow); known != flows_.end()) {
    settle(known->second);
    return known->second;
  }
  if (flows_.size() >= forget_at_) forget();
  Flow& added = flows_[flow];
  added.round = round_;
  return added;
}

void IoTurns::settle(Flow& flow) const {
  flow.used -= std::min(flow.used, (round_ - flow.round) * kTurn);
  flow.round = round_;
}

void IoTurns::forget() {
  if (this_round_.empty() && next_round_.empty()) ++round_;
  std::erase_if(flows_, [this](const auto& each) {
    const Flow& flow = each.second;
    return !flow.queued && flow.used <= (round_ - flow.round) * kTurn;
  });
  forget_at_ = std::max(kKept, 2 * flows_.size());
}

void IoTurns::shutdown() noexcept {
  std::unordered_map<FlowId, Flow> flows;  // whose waiters may enter when they go
  flows_.swap(flows);
}

}  // namespace talus::server
