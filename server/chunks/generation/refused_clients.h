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

/// Keeps no mailbox alive. Holds each living client once, and never more dead ones than living ones. Flows
/// are visited in turns; the clients of each come in the order in which they were refused.
class RefusedClients {
 public:
  /// No effect if the owner is there already. Throws std::bad_alloc, and then has changed nothing.
  void remember(const MailboxPtr& mailbox);

  /// Visits the next `flows` flows, and takes one client of each for which has_room(flow) returns true.
  template <typename HasRoom>
  [[nodiscard]] std::vector<MailboxPtr> take(std::size_t flows, HasRoom&& has_room) {
    std::vector<MailboxPtr> taken;
    taken.reserve(std::min(flows, order_.size()));  // so that a client that is taken is not lost
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
  /// Returns the number of clients, including dead ones.
  [[nodiscard]] std::size_t size() const { return clients_.size(); }

 private:
  struct RefusedClient {
    ClientId client;
    std::weak_ptr<Mailbox> mailbox;
  };
  /// Removes and returns the flow's first living client; null if the flow has no more.
  [[nodiscard]] MailboxPtr take_first(FlowId flow);
  void forget_dead();

  std::unordered_map<FlowId, std::deque<RefusedClient>> by_flow_;  // no deque is empty
  std::list<FlowId> order_;                                        // keys of by_flow_, the next first
  std::unordered_set<ClientId> clients_;                           // clients in by_flow_
  std::size_t check_at_size_ = 64;  // size at which dead clients are searched for again
};

}  // namespace talus::server
