#include "limits/flows/flow_uses.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace talus::server {
namespace {

constexpr std::size_t kMinCheckSize = 4096;

}  // namespace

FlowUses::FlowUses()
    : check_at_size_{kMinCheckSize},
      heaviest_{HeavyHitters{kListed}, HeavyHitters{kListed}, HeavyHitters{kListed}} {}

FlowUsePtr FlowUses::of_address(std::span<const unsigned char> counted, std::string_view text) {
  return join(ids_.of_address(counted), FlowName::Kind::address, text);
}

FlowUsePtr FlowUses::of_subject(std::string_view subject) {
  return join(ids_.of_subject(subject), FlowName::Kind::subject, subject);
}

FlowUsePtr FlowUses::join(FlowId id, FlowName::Kind kind, std::string_view text) {
  const std::lock_guard lock{mutex_};
  if (const auto found = known_.find(id); found != known_.end()) {
    found->second.left = false;
    return found->second.use;
  }
  if (known_.size() >= check_at_size_) {
    check_all();  // finds flows that left,
    check_all();  // and forgets them
    check_at_size_ = std::max(kMinCheckSize, 2 * known_.size());
  }
  auto use = std::make_shared<FlowUse>(id, FlowName{kind, std::string{text.substr(0, FlowName::kMaxBytes)},
                                                    text.size() > FlowName::kMaxBytes});
  known_.emplace(id, KnownFlow{use});
  return use;
}

void FlowUses::check_all() {
  for (auto at = known_.begin(); at != known_.end();) {
    KnownFlow& known = at->second;
    // A session adds its use before it goes. The second check sees for sure what it added.
    const bool left = known.use.use_count() == 1;
    const bool forgotten = std::exchange(known.left, left) && left;
    for (std::size_t i = 0; i < kFlowMeasures; ++i) {
      const std::uint64_t used = known.use->used(static_cast<FlowMeasure>(i));
      const std::uint64_t more = used - known.collected[i];
      if (more > 0) heaviest_[i].add(*known.use, more);
      known.collected[i] = used;  // now that nothing has failed
    }
    at = forgotten ? known_.erase(at) : std::next(at);
  }
  for (HeavyHitters& heaviest : heaviest_) heaviest.cut();
}

void FlowUses::collect(Clock::time_point now) {
  const std::lock_guard lock{mutex_};
  for (HeavyHitters& heaviest : heaviest_) heaviest.pass(now - collected_);
  collected_ = now;
  check_all();
}

std::array<TopFlows, kFlowMeasures> FlowUses::top(std::size_t count) const {
  std::array<TopFlows, kFlowMeasures> top;
  const std::lock_guard lock{mutex_};
  for (std::size_t i = 0; i < kFlowMeasures; ++i) top[i] = {heaviest_[i].top(count), heaviest_[i].all()};
  return top;
}

std::uint64_t FlowUses::refusals() const {
  const std::lock_guard lock{mutex_};
  return heaviest_[static_cast<std::size_t>(FlowMeasure::refusals)].all().total;
}

std::size_t FlowUses::flows() const {
  const std::lock_guard lock{mutex_};
  return known_.size();
}

}  // namespace talus::server
