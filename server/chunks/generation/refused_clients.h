// Clients whose submission was refused, until there is room again. For one thread; GenerationPool locks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <list>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "chunks/mailbox.h"
#include "limits/flows/flow_ids.h"

namespace talus::server {

/// Keeps no mailbox alive. Holds each living client once, and never more dead ones than that. Flows are
/// looked at in turns; of each its clients come in the order in which they were refused.
class RefusedClients {
 public:
  /// No effect where the owner is remembered already. Throws std::bad_alloc, and then has changed nothing.
  void remember(const MailboxPtr& mailbox);

  /// Looks at the next `flows` flows, and takes one client of each for which has_room(flow) is true.
  template <typename HasRoom>
  [[nodiscard]] std::vector<MailboxPtr> take(std::size_t flows, HasRoom&& has_room) {
    std::vector<MailboxPtr> taken;
    taken.reserve(std::min(flows, order_.size()));  // who was taken is not lost
    for (std::size_t left = std::min(flows, order_.size()); left > 0; --left) {
      const FlowId flow = order_.front();
      if (has_room(flow)) {
        if (MailboxPtr mailbox = take_first(flow)) taken.push_back(std::move(mailbox));
      }
      if (by_flow_.contains(flow)) {
        order_.splice(order_.end(), order_, order_.begin());
      } else {
        order_.pop_front();
      }
    }
    return taken;
  }
  [[nodiscard]] std::vector<MailboxPtr> take_all();

  [[nodiscard]] bool empty() const { return clients_.empty(); }
  /// With those that died meanwhile.
  [[nodiscard]] std::size_t size() const { return clients_.size(); }

 private:
  struct Refused {
    ClientId client;
    std::weak_ptr<Mailbox> mailbox;
  };
  /// The flow's first living client, and forgets it; null where none is left.
  [[nodiscard]] MailboxPtr take_first(FlowId flow);
  void forget_dead();

  std::unordered_map<FlowId, std::deque<Refused>> by_flow_;  // none is empty
  std::list<FlowId> order_;                                  // of by_flow_, the next first
  std::unordered_set<ClientId> clients_;                     // of by_flow_
  std::size_t look_at_size_ = 64;                            // when to look for dead ones again
};

}  // namespace talus::server
