#include "generation/refused_clients.h"

#include <algorithm>
#include <utility>

namespace talus::server {

void RefusedClients::remember(const MailboxPtr& mailbox) {
  if (clients_.contains(mailbox->owner())) return;
  if (order_.size() >= look_at_size_) forget_dead();
  order_.push_back({mailbox->owner(), mailbox});
  clients_.insert(mailbox->owner());
}

std::vector<MailboxPtr> RefusedClients::take(std::size_t count) {
  std::vector<MailboxPtr> taken;
  while (taken.size() < count && !order_.empty()) {
    const Refused first = std::move(order_.front());
    order_.pop_front();
    clients_.erase(first.client);
    if (MailboxPtr mailbox = first.mailbox.lock()) taken.push_back(std::move(mailbox));
  }
  return taken;
}

void RefusedClients::forget_dead() {
  std::erase_if(order_, [&](const Refused& each) {
    if (!each.mailbox.expired()) return false;
    clients_.erase(each.client);
    return true;
  });
  look_at_size_ = std::max<std::size_t>(64, 2 * order_.size());
}

}  // namespace talus::server
