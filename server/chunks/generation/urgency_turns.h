// Whose turn it is where some is wanted soon: flows and clients take turns (flow_turns.h) at what is wanted
// soon and, apart from it, at what is wanted later. While there is work of both, what is wanted soon gets
// kShare times the time of the other: a crowd's nearest chunks go before its far ones, and nobody who wants
// much soon can keep all others' far ones from being made. For one thread; its users lock.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "chunks/chunk_source.h"
#include "chunks/generation/flow_turns.h"

namespace talus::server {

class UrgencyTurns {
 public:
  static constexpr std::int64_t kShare = 3;

  struct Turn {
    FlowId flow{};
    ClientId client{};
    Urgency urgency{};
  };

  /// The client has something of that urgency waiting. No effect where it is entered already.
  void enter(const Turn& turn) { of(turn.urgency).enter({turn.flow, turn.client}); }

  /// As FlowTurns::next(), with can_begin(client, urgency) and busy(client, urgency).
  template <typename FlowCanBegin, typename CanBegin, typename Busy>
  [[nodiscard]] std::optional<Turn> next(std::int64_t quantum, FlowCanBegin&& flow_can_begin,
                                         CanBegin&& can_begin, Busy&& busy) {
    // Who had the time alone for long owes little for it.
    lead_ = std::clamp(lead_, -kMemory * quantum, kMemory * quantum);
    const bool soon_first = lead_ <= 0;
    for (const bool soon : {soon_first, !soon_first}) {
      const Urgency urgency = soon ? Urgency::soon : Urgency::later;
      const auto turn = of(urgency).next(
          quantum, flow_can_begin, [&](ClientId id) { return can_begin(id, urgency); },
          [&](ClientId id) { return busy(id, urgency); });
      if (turn) return Turn{turn->flow, turn->client, urgency};
    }
    return std::nullopt;
  }

  /// Takes `cost` from what the flow and the client may spend; a negative one gives back.
  void charge(const Turn& turn, std::int64_t cost) {
    of(turn.urgency).charge({turn.flow, turn.client}, cost);
    lead_ += turn.urgency == Urgency::soon ? cost : -kShare * cost;
  }

 private:
  static constexpr std::int64_t kMemory = 64;  // quanta

  [[nodiscard]] FlowTurns& of(Urgency urgency) { return turns_[static_cast<std::size_t>(urgency)]; }

  std::array<FlowTurns, 2> turns_;
  std::int64_t lead_ = 0;  // of what is wanted soon: its time, less kShare times that of the other
};

}  // namespace talus::server
