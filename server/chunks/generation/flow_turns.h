// Whose turn it is at the generators: flows take turns, and within a flow its clients. For one thread; its
// users lock.
//
// Both by deficit round robin. A flow that had nothing waiting goes first, for one quantum; a client that is
// new within its flow gains nothing by it.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "chunks/mailbox.h"
#include "limits/flows/deficit_round_robin.h"
#include "limits/flows/flow_ids.h"

namespace talus::server {

class FlowTurns {
 public:
  struct Turn {
    FlowId flow{};
    ClientId client{};
    bool operator==(const Turn&) const = default;
  };

  /// The client has something waiting. No effect where it is entered already.
  void enter(Turn turn) {
    flows_.enter(turn.flow);
    clients_.try_emplace(turn.flow, Newcomers::last).first->second.enter(turn.client);
  }

  /// Who may begin a piece now; none where nobody can. flow_can_begin(flow): whether its clients may begin
  /// anything; the others as of DeficitRoundRobin::next(), of clients.
  template <typename FlowCanBegin, typename CanBegin, typename Busy>
  [[nodiscard]] std::optional<Turn> next(std::int64_t quantum, FlowCanBegin&& flow_can_begin,
                                         CanBegin&& can_begin, Busy&& busy) {
    std::optional<ClientId> client;
    const auto flow = flows_.next(
        quantum,
        [&](FlowId id) {
          if (!flow_can_begin(id)) return false;
          const auto found = clients_.find(id);
          if (found == clients_.end()) return false;
          client = found->second.next(quantum, can_begin, busy);
          if (found->second.empty()) clients_.erase(found);
          return client.has_value();
        },
        [&](FlowId id) { return clients_.contains(id); });
    if (!flow) return std::nullopt;
    return Turn{*flow, *client};
  }

  /// Takes `cost` from what both may spend; a negative one gives back.
  void charge(Turn turn, std::int64_t cost) {
    flows_.charge(turn.flow, cost);
    if (const auto found = clients_.find(turn.flow); found != clients_.end()) {
      found->second.charge(turn.client, cost);
    }
  }

 private:
  DeficitRoundRobin<FlowId> flows_{Newcomers::first};
  std::unordered_map<FlowId, DeficitRoundRobin<ClientId>> clients_;  // of flows with something waiting
};

}  // namespace talus::server
