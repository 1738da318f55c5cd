// Whose turn it is among those who want time of a shared resource. For one thread; its users lock.
//
// Deficit round robin (Shreedhar and Varghese, 1995): a turn brings an entrant one quantum, which it spends
// on pieces of its own until nothing is left. The last piece may overdraw; the next turns pay that off, also
// if the entrant has left meanwhile. Where newcomers are first, whoever had nothing waiting goes before all
// others, once in a round, as new flows do in FQ-CoDel (RFC 8290). So entrants get equal time, whatever their
// pieces cost.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <utility>

namespace talus::server {

enum class Newcomers : std::uint8_t { first, last };

template <typename Id>
class DeficitRoundRobin {
 public:
  explicit DeficitRoundRobin(Newcomers newcomers) : newcomers_{newcomers} {}

  /// `id` has something waiting. No effect where it is entered already.
  void enter(Id id) {
    if (entrants_.contains(id)) return;
    std::deque<Id>& order = newcomers_ == Newcomers::first ? new_ : old_;
    order.push_back(id);
    try {
      entrants_.try_emplace(id);
    } catch (...) {
      order.pop_back();
      throw;
    }
  }

  /// Nobody is entered, or owes anything.
  [[nodiscard]] bool empty() const { return entrants_.empty(); }

  /// Who may begin a piece now; none where nobody can. The turn goes on until its quantum is spent.
  /// can_begin(id): whether it has a piece that may be begun. busy(id): whether it has pieces waiting or in
  /// flight; an entrant that is not, and owes nothing, is forgotten after two rounds. `quantum` is positive.
  template <typename CanBegin, typename Busy>
  [[nodiscard]] std::optional<Id> next(std::int64_t quantum, CanBegin&& can_begin, Busy&& busy) {
    for (;;) {
      std::optional<std::int64_t> least_debt;  // of those who could begin something
      for (std::size_t turns = entrants_.size(); turns > 0; --turns) {
        const Id id = order().front();
        Entrant& entrant = entrants_.at(id);
        if (!std::exchange(entrant.in_turn, true)) {
          entrant.balance = std::min(entrant.balance + quantum, quantum);
        }
        if (can_begin(id)) {
          if (entrant.balance > 0) return id;
          least_debt = std::min(least_debt.value_or(-entrant.balance), -entrant.balance);
        }
        end_turn(busy(id));
      }
      if (!least_debt) {
        // Where nobody waits, nobody is owed anything.
        if (std::none_of(entrants_.begin(), entrants_.end(),
                         [&](const auto& each) { return busy(each.first); }))
          clear();
        return std::nullopt;
      }
      // All who could go on owe something: so many rounds would pass before the first may.
      for (auto& [id, entrant] : entrants_) entrant.balance += *least_debt / quantum * quantum;
    }
  }

  /// Takes `cost` from what `id` may spend; a negative one gives back.
  void charge(Id id, std::int64_t cost) {
    if (const auto found = entrants_.find(id); found != entrants_.end()) found->second.balance -= cost;
  }

 private:
  struct Entrant {
    std::int64_t balance = 0;  // what it may spend; negative: what it owes
    bool in_turn = false;
    bool idle_once = false;  // had nothing waiting when its turn ended; forgotten if so again
  };

  [[nodiscard]] std::deque<Id>& order() { return new_.empty() ? old_ : new_; }

  void end_turn(bool busy) {
    std::deque<Id>& from = order();
    const Id id = from.front();
    const auto found = entrants_.find(id);
    Entrant& entrant = found->second;
    const bool idle = !busy && entrant.balance >= 0;
    const bool forgotten = idle && entrant.idle_once;
    if (!forgotten) old_.push_back(id);  // from here on nothing throws
    from.pop_front();
    entrant.in_turn = false;
    entrant.idle_once = idle;
    if (forgotten) entrants_.erase(found);
  }

  void clear() {
    entrants_.clear();
    new_.clear();
    old_.clear();
  }

  Newcomers newcomers_;
  std::unordered_map<Id, Entrant> entrants_;
  // Exactly the keys of entrants_ between them, in the order of their turns; the new go first.
  std::deque<Id> new_;
  std::deque<Id> old_;
};

}  // namespace talus::server
