// Clients whose submission was refused, until there is room again. For one thread; GenerationPool locks.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <unordered_set>
#include <vector>

#include "chunks/mailbox.h"

namespace talus::server {

/// Keeps no mailbox alive. Holds each living client once, and never more dead ones than that.
class RefusedClients {
 public:
  /// No effect where the owner is remembered already.
  void remember(const MailboxPtr& mailbox);
  /// The `count` that were refused first, oldest first, and forgets them.
  [[nodiscard]] std::vector<MailboxPtr> take(std::size_t count);

  [[nodiscard]] bool empty() const { return order_.empty(); }
  /// With those that died meanwhile.
  [[nodiscard]] std::size_t size() const { return order_.size(); }

 private:
  struct Refused {
    ClientId client;
    std::weak_ptr<Mailbox> mailbox;
  };
  void forget_dead();

  std::deque<Refused> order_;
  std::unordered_set<ClientId> clients_;  // of order_
  std::size_t look_at_size_ = 64;         // when to look for dead ones again
};

}  // namespace talus::server
