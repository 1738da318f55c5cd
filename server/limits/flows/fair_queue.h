// The one queue for every resource that flows take turns at: generator threads, an io thread's time for
// Views, places in the edit log, a client's credit. For one thread; its users lock.
//
// Start-time fair queuing (Goyal, Vin and Cheng, 1996) on a tree of levels, such as flows and their clients.
// At each level an entrant has a clock, which every piece of its work advances by cost / share. The entrant
// with the earliest clock goes next. A cost may be known before the piece begins, or be charged afterwards.
//
// At each level:
//
// Share. Over any time in which two entrants have work that may begin, their costs / shares differ by at most
// one piece of each; if one of them came in that time, or work has an offset, also by FairRule and FairEntry.
// An entrant may open any number of clients below it: they share its share.
//
// Newcomers first. An entrant that comes, or comes back, starts where the others are, and goes before them
// for `lead`. What it owes it still owes, until the others' clocks have passed its own.
//
// No starvation. Newcomers go first while they take less than half of the time; beyond that they start later.
// So however many come, what waits goes after work of others of at most the sum of all shares times 5 pieces
// and 3 times FairRule.
//
// tests/server/fair_queue_test.cpp tests each.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

#include "limits/flows/fair_level.h"

namespace talus::server {

/// Each of `Levels`, from the top down, is a type of ids (hashable, and cheap to copy), or Classes. Calls
/// that take ids take one for each level, in that order.
template <typename... Levels>
class FairQueue {
 public:
  using Path = std::tuple<FairId<Levels>...>;
  /// One for each level.
  using Rules = std::array<FairRule, sizeof...(Levels)>;

  explicit FairQueue(Rules rules = {}) : rules_{rules} {}

  /// For entrants that come from now on.
  void set_rules(Rules rules) { rules_ = rules; }

  /// Gives the entrant of the level to which `ids` lead its share, which is positive; it is 1 until then.
  /// Classes keep it; other entrants until they have left and owe nothing. Throws std::bad_alloc, but not for
  /// classes.
  template <typename... Ids>
  void set_share(double share, Ids... ids) {
    top_.set_share(share, ids...);
  }

  /// `ids` have something waiting, until leave(). If they have entered already, `entry` replaces the one
  /// before. Throws std::bad_alloc, and then has no effect.
  void enter(const FairEntry& entry, FairId<Levels>... ids) { top_.enter(rules_.data(), entry, ids...); }

  /// No effect if they have not entered. What they owe is kept.
  void leave(FairId<Levels>... ids) noexcept { top_.leave(ids...); }

  /// Returns the ids that go next; nullopt if nothing may begin. They stay entered.
  ///
  /// `ready(ids...)` returns FairState: blocked entrants are passed over and, when they are ready, go on as
  /// if they had come back; idle ones leave. It may also take the first ids alone, and is then asked for
  /// these first. It must not call the queue, nor throw.
  template <typename Ready>
  [[nodiscard]] std::optional<Path> next(Ready&& ready) {
    return top_.next(rules_.data(), ready);
  }
  [[nodiscard]] std::optional<Path> next() {
    return next([](FairId<Levels>...) { return FairState::ready; });
  }

  /// Charges the cost of a piece that is done, also after leave().
  void charge(double cost, FairId<Levels>... ids) noexcept { top_.charge(0, cost, ids...); }
  /// Charges an estimate in advance. Before charge(), give it back by the same call with -cost.
  void reserve(double cost, FairId<Levels>... ids) noexcept { top_.charge(cost, 0, ids...); }

  /// True if nothing has entered.
  [[nodiscard]] bool empty() const { return top_.empty(); }

  /// Forgets all entrants and what they owe.
  void clear() noexcept { top_.clear(); }

 private:
  Rules rules_;
  FairLevel<Levels...> top_;
};

}  // namespace talus::server
