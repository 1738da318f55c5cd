// Whose turn it is among those who want something that is served piece by piece. For one thread.
//
// Weighted fair queuing (Demers, Keshav and Shenker, 1989) with all weights alike: everybody has a clock of
// his own that each of his pieces moves on by its cost; whose clock would be behind all others after his
// piece goes first. Who comes, or comes back, starts at the clock at which the piece began that went last
// (as in start-time fair queuing), so that nobody saves up turns. So all who want much
// get equal shares by cost, and a small piece of who wants little goes before the large ones of others, which
// with deficit round robin (deficit_round_robin.h) it may have to wait for, one of each.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>

namespace talus::server {

template <typename Id>
class FairOrder {
 public:
  /// `id` has a piece waiting, of this cost. Entered again: the piece in place of the one before.
  void enter(Id id, std::uint64_t cost) {
    Entrant& entrant = entrants_[id];
    if (entrant.waits) waiting_.erase({entrant.end, entrant.entry, id});
    entrant.waits = false;  // should the next line throw
    const std::uint64_t end = std::max(now_, entrant.clock) + cost;
    waiting_.emplace(end, ++entries_, id);
    entrant = {entrant.clock, end, entries_, cost, true};
  }

  /// Who goes now, and is entered no more; none where nobody is.
  [[nodiscard]] std::optional<Id> next() {
    if (waiting_.empty()) return std::nullopt;
    const Id id = std::get<2>(*waiting_.begin());
    waiting_.erase(waiting_.begin());
    Entrant& entrant = entrants_.at(id);
    now_ = std::max(now_, entrant.end - entrant.cost);
    entrant.clock = entrant.end;
    entrant.waits = false;
    if (entrants_.size() > 2 * waiting_.size() + 64) {
      std::erase_if(entrants_,
                    [&](const auto& each) { return !each.second.waits && each.second.clock <= now_; });
    }
    return id;
  }

  /// What the piece costs that goes next; none where nobody is entered.
  [[nodiscard]] std::optional<std::uint64_t> next_cost() const {
    if (waiting_.empty()) return std::nullopt;
    return entrants_.at(std::get<2>(*waiting_.begin())).cost;
  }

  /// How many are entered.
  [[nodiscard]] std::size_t size() const { return waiting_.size(); }

 private:
  struct Entrant {
    std::uint64_t clock = 0;
    std::uint64_t end = 0;  // its clock after the piece that waits
    std::uint64_t entry = 0;
    std::uint64_t cost = 0;
    bool waits = false;
  };

  std::uint64_t now_ = 0;
  std::uint64_t entries_ = 0;  // those of one end go in the order in which they entered
  std::set<std::tuple<std::uint64_t, std::uint64_t, Id>> waiting_;
  std::unordered_map<Id, Entrant> entrants_;  // those who wait, and some who went
};

}  // namespace talus::server
