#include "chunks/generation/refused_clients.h"

namespace talus::server {

void RefusedClients::remember(const MailboxPtr& mailbox) {
  if (clients_.contains(mailbox->owner())) return;
  if (clients_.size() >= check_at_size_) forget_dead();
  std::list<FlowId> place{mailbox->flow()};
  clients_.insert(mailbox->owner());
  try {
    auto& refused = by_flow_[mailbox->flow()];
    refused.push_back({mailbox->owner(), mailbox});
    if (refused.size() == 1) order_.splice(order_.end(), place);
  } catch (...) {
    clients_.erase(mailbox->owner());
    if (const auto flow = by_flow_.find(mailbox->flow()); flow != by_flow_.end() && flow->second.empty()) {
      by_flow_.erase(flow);
    }
    throw;
  }
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
  taken.reserve(clients_.size());
  while (!order_.empty()) {
    while (by_flow_.contains(order_.front())) {
      if (MailboxPtr mailbox = take_first(order_.front())) taken.push_back(std::move(mailbox));
    }
    order_.pop_front();
  }
  return taken;
}

void RefusedClients::forget_dead() {
  for (auto& [flow, refused] : by_flow_) {
    std::erase_if(refused, [&](const RefusedClient& each) {
      if (!each.mailbox.expired()) return false;
      clients_.erase(each.client);
      return true;
    });
  }
  std::erase_if(by_flow_, [](const auto& each) { return each.second.empty(); });
  std::erase_if(order_, [&](FlowId flow) { return !by_flow_.contains(flow); });
  check_at_size_ = std::max<std::size_t>(64, 2 * clients_.size());
}

}  // namespace talus::server
