#include "generation/refused_clients.h"

namespace talus::server {

void RefusedClients::remember(const MailboxPtr& mailbox) {
  if (clients_.contains(mailbox->owner())) return;
  if (clients_.size() >= look_at_size_) forget_dead();
  auto& refused = by_flow_[mailbox->flow()];
  if (refused.empty()) order_.push_back(mailbox->flow());
  refused.push_back({mailbox->owner(), mailbox});
  clients_.insert(mailbox->owner());
}

MailboxPtr RefusedClients::take_first(FlowId flow) {
  const auto found = by_flow_.find(flow);
  MailboxPtr taken;
  while (taken == nullptr && !found->second.empty()) {
    taken = found->second.front().mailbox.lock();
    clients_.erase(found->second.front().client);
    found->second.pop_front();
  }
  if (found->second.empty()) by_flow_.erase(found);
  return taken;
}

std::vector<MailboxPtr> RefusedClients::take_all() {
  std::vector<MailboxPtr> taken;
  while (!order_.empty()) {
    for (MailboxPtr& mailbox : take(order_.size(), [](FlowId) { return true; })) {
      taken.push_back(std::move(mailbox));
    }
  }
  return taken;
}

void RefusedClients::forget_dead() {
  for (auto& [flow, refused] : by_flow_) {
    std::erase_if(refused, [&](const Refused& each) {
      if (!each.mailbox.expired()) return false;
      clients_.erase(each.client);
      return true;
    });
  }
  std::erase_if(by_flow_, [](const auto& each) { return each.second.empty(); });
  std::erase_if(order_, [&](FlowId flow) { return !by_flow_.contains(flow); });
  look_at_size_ = std::max<std::size_t>(64, 2 * clients_.size());
}

}  // namespace talus::server
