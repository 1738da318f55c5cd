// One level of a FairQueue (fair_queue.h), which alone includes this.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace talus::server {

/// A level of the enumerators 0 to Count - 1. They live in the level itself, so entering one allocates
/// nothing. Of two that could go next, the lower goes. The first has `FirstShare`, the others 1.
template <typename Enum, std::size_t Count, unsigned FirstShare = 1>
struct Classes {};

struct FairEntry {
  /// Is added to the clock for the order alone, divided by the share. The cost of the piece, if it is known:
  /// small pieces then go before large ones. Negative: the cost by which this work may be ahead of its share;
  /// while it waits, the levels above it may be ahead by the same cost.
  double offset = 0;
};

/// What an entrant of a level gets when it comes, or comes back, and owes nothing. Both are cost / share.
struct FairRule {
  /// It goes before others for this cost. It gets no more by it in all.
  double lead = 0;
  /// It has saved up the share that it did not use, at most this much. An entrant that is not a class, and
  /// comes for the first time, has saved up all of it.
  double saved = 0;
};

/// ready: has a piece that may begin. blocked: has work, but no piece may begin now. idle: has no work.
enum class FairState : std::uint8_t { ready, blocked, idle };

/// A vector of at most Count values, in place.
template <typename Value, std::size_t Count>
class FixedList {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Value& operator[](std::size_t place) { return values_[place]; }
  [[nodiscard]] const Value& operator[](std::size_t place) const { return values_[place]; }
  void push_back(Value value) { values_[size_++] = value; }
  void pop_back() { --size_; }
  void clear() { size_ = 0; }

 private:
  std::array<Value, Count> values_{};
  std::size_t size_ = 0;
};

template <typename Level>
struct FairIds {
  using Id = Level;
  static constexpr bool kClasses = false;
  template <typename Entrant>
  using Entrants = std::unordered_map<Id, Entrant>;
  template <typename Entrant>
  using Order = std::vector<Entrant*>;
};
template <typename Enum, std::size_t Count, unsigned FirstShare>
struct FairIds<Classes<Enum, Count, FirstShare>> {
  using Id = Enum;
  static constexpr bool kClasses = true;
  static constexpr unsigned kFirstShare = FirstShare;
  template <typename Entrant>
  using Entrants = std::array<Entrant, Count>;
  template <typename Entrant>
  using Order = FixedList<Entrant*, Count>;
};
template <typename Level>
using FairId = typename FairIds<Level>::Id;

template <typename... Levels>
class FairLevel;

/// The end of a path: the entry that waits there.
template <>
class FairLevel<> {
 public:
  void enter(const FairRule* /*rules*/, const FairEntry& entry) {
    entry_ = entry;
    waits_ = true;
  }
  void leave() { waits_ = false; }
  void charge(double /*reserved*/, double /*done*/) {}
  [[nodiscard]] bool empty() const { return !waits_; }
  [[nodiscard]] double offset() const { return entry_.offset; }

  template <typename Ready, typename... Ids>
  [[nodiscard]] std::optional<std::tuple<>> next(const FairRule* /*rules*/, Ready& ready, Ids... ids) {
    const FairState readiness = ready(ids...);
    if (readiness == FairState::ready) return std::tuple{};
    if (readiness == FairState::idle) waits_ = false;
    return std::nullopt;
  }
  void clear() { waits_ = false; }

 private:
  FairEntry entry_;
  bool waits_ = false;
};

/// Queues the entrants of one level, and for each of them the levels below.
template <typename Level, typename... Below>
class FairLevel<Level, Below...> {
 public:
  using Id = FairId<Level>;
  using Path = std::tuple<Id, FairId<Below>...>;

  FairLevel() {
    if constexpr (FairIds<Level>::kClasses) known_[0].share = FairIds<Level>::kFirstShare;
  }
  FairLevel(const FairLevel&) = delete;  // order_ points into known_
  FairLevel& operator=(const FairLevel&) = delete;
  ~FairLevel() = default;

  template <typename... Ids>
  void set_share(double share, Id id, Ids... below) {
    Entrant& entrant = obtain(id);
    if constexpr (sizeof...(Ids) > 0) {
      entrant.below.set_share(share, below...);
    } else {
      if (entrant.waits()) shares_ += share - entrant.share;
      entrant.share = share;
    }
    if (entrant.waits()) settle(entrant);
  }

  void enter(const FairRule* rules, const FairEntry& entry, Id id, FairId<Below>... below) {
    Entrant& entrant = obtain(id);
    entrant.below.enter(rules + 1, entry, below...);  // from here on nothing throws
    if (entrant.waits()) return settle(entrant);
    arrive(entrant, *rules);
    shares_ += entrant.share;
    entrant.place = order_.size();
    order_.push_back(&entrant);
    set_order(entrant);
    rise(entrant.place);
  }

  void leave(Id id, FairId<Below>... below) noexcept {
    Entrant* const entrant = find(id);
    if (entrant == nullptr || !entrant->waits()) return;
    entrant->below.leave(below...);
    if (!entrant->below.empty()) return settle(*entrant);
    const std::size_t place = entrant->place;
    remove(*entrant);
    if (place == order_.size()) return;
    rise(place);
    sink(place, order_.size());
  }

  template <typename Ready, typename... Above>
  [[nodiscard]] std::optional<Path> next(const FairRule* rules, Ready& ready, Above... above) {
    std::optional<Path> path;
    std::size_t left = order_.size();  // entrants from here on were asked and cannot go
    while (left > 0) {
      Entrant& first = *order_[0];
      if (may_ask_below(ready, above..., first.id)) {
        if (const auto below = first.below.next(rules + 1, ready, above..., first.id)) {
          path = std::tuple_cat(std::tuple{first.id}, *below);
          advance(first.clock - first.ahead() + std::min(0.0, first.offset()));
          break;
        }
      }
      swap(0, --left);
      sink(0, left);
    }
    Entrant* const goes = path ? order_[0] : nullptr;
    while (left < order_.size()) {
      Entrant& entrant = *order_[left];
      if (entrant.below.empty()) {
        remove(entrant);
        continue;
      }
      if (path) arrive(entrant, *rules);
      if (order_of(entrant) != entrant.order) set_order(entrant);
      rise(left++);
    }
    if (goes != nullptr) settle(*goes);
    return path;
  }

  void charge(double reserved, double done, Id id, FairId<Below>... below) noexcept {
    Entrant* const entrant = find(id);
    if (entrant == nullptr) return;
    entrant->below.charge(reserved, done, below...);
    entrant->clock += (reserved + done) / entrant->share;
    overtaking_ += done / (entrant->waits() ? shares_ : shares_ + entrant->share);
    dearest_ = std::max(dearest_, done / entrant->share);
    if (entrant->waits()) settle(*entrant);
  }

  [[nodiscard]] bool empty() const { return order_.size() == 0; }
  /// Returns the offset of the entry that goes next; of classes the least, so that one that is ahead of its
  /// class does not hold the level back.
  [[nodiscard]] double offset() const {
    if (empty()) return 0;
    double least = order_[0]->below.offset();
    if constexpr (FairIds<Level>::kClasses) {
      for (std::size_t place = 1; place < order_.size(); ++place) {
        least = std::min(least, order_[place]->below.offset());
      }
    }
    return least;
  }

  void clear() noexcept {
    if constexpr (FairIds<Level>::kClasses) {
      for (Entrant& entrant : known_) {
        entrant.clock = 0;
        entrant.ahead_until = 0;
        entrant.place = kAway;
        entrant.below.clear();
      }
    } else if (!known_.empty()) {
      known_.clear();
    }
    order_.clear();
    now_ = 0;
    overtaking_ = 0;
    dearest_ = 0;
    shares_ = 0;
  }

 private:
  static constexpr std::size_t kAway = SIZE_MAX;
  static constexpr std::size_t kMinSweep = 64;

  struct Entrant {
    [[nodiscard]] bool waits() const { return place != kAway; }
    Id id{};
    /// Returns by how much it goes before its clock.
    [[nodiscard]] double ahead() const { return clock < ahead_until ? lead : 0; }
    [[nodiscard]] double offset() const { return below.offset() / share; }
    double order = 0;  // the least goes first; of equal ones the one with the least `entry`
    double clock = 0;
    double share = 1;
    double lead = 0;
    double ahead_until = 0;
    std::uint64_t entry = 0;
    std::size_t place = kAway;  // in order_
    FairLevel<Below...> below;
  };

  template <typename Ready, typename... Ids>
  [[nodiscard]] static bool may_ask_below(Ready& ready, Ids... ids) {
    if constexpr (sizeof...(Below) > 0 && std::is_invocable_v<Ready&, Ids...>) {
      return ready(ids...) == FairState::ready;
    }
    return true;
  }

  [[nodiscard]] Entrant* find(Id id) {
    if constexpr (FairIds<Level>::kClasses) {
      return &known_[static_cast<std::size_t>(id)];
    } else {
      const auto found = known_.find(id);
      return found == known_.end() ? nullptr : &found->second;
    }
  }

  /// Returns the entrant, with room for it in order_.
  [[nodiscard]] Entrant& obtain(Id id) {
    Entrant* found = find(id);
    if constexpr (!FairIds<Level>::kClasses) {
      if (order_.size() == order_.capacity()) order_.reserve(2 * order_.size() + 1);
      if (found == nullptr) {
        sweep();
        found = &known_.try_emplace(id).first->second;
      }
    }
    found->id = id;
    return *found;
  }

  /// Newcomers start at now_, unless they alone have gone for long. All work adds to overtaking_, and now_
  /// takes off twice what it advances. So without newcomers, and while they take less than half of the time,
  /// overtaking_ stays below what they may go ahead and the dearest piece; otherwise they start later, and
  /// now_ advances by at least half of all work.
  void arrive(Entrant& entrant, const FairRule& rule) {
    const double start = now_ + std::max(0.0, overtaking_ - dearest_ - rule.lead - rule.saved);
    if (entrant.clock > start) return;
    entrant.clock = std::max(entrant.clock, start - rule.saved);
    entrant.lead = rule.lead;
    entrant.ahead_until = entrant.clock + rule.lead;
  }
  void advance(double clock) {
    if (clock <= now_) return;
    overtaking_ = std::max(0.0, overtaking_ - 2 * (clock - now_));
    now_ = clock;
  }

  /// Forgets entrants that left and owe nothing. Amortised, an entrant costs constant time.
  void sweep() {
    if (known_.size() < sweep_at_) return;
    std::erase_if(known_,
                  [&](const auto& each) { return !each.second.waits() && each.second.clock <= now_; });
    sweep_at_ = std::max(kMinSweep, 2 * known_.size());
  }

  [[nodiscard]] static double order_of(const Entrant& entrant) {
    return entrant.clock - entrant.ahead() + entrant.offset();
  }
  void set_order(Entrant& entrant) {
    entrant.order = order_of(entrant);
    if constexpr (FairIds<Level>::kClasses) {
      entrant.entry = static_cast<std::uint64_t>(entrant.id);
    } else {
      entrant.entry = ++entries_;
    }
  }
  /// Moves an entrant to its place after its clock or its offset has changed.
  void settle(Entrant& entrant) {
    if (order_of(entrant) == entrant.order) return;
    set_order(entrant);
    rise(entrant.place);
    sink(entrant.place, order_.size());
  }
  /// Removes an entrant from order_. The last one takes its place, and may be out of order there.
  void remove(Entrant& entrant) {
    swap(entrant.place, order_.size() - 1);
    order_.pop_back();
    entrant.place = kAway;
    shares_ = empty() ? 0 : shares_ - entrant.share;
  }

  // order_ is a binary heap.
  [[nodiscard]] bool before(std::size_t a, std::size_t b) const {
    const Entrant& left = *order_[a];
    const Entrant& right = *order_[b];
    return left.order < right.order || (left.order == right.order && left.entry < right.entry);
  }
  void swap(std::size_t a, std::size_t b) {
    std::swap(order_[a], order_[b]);
    order_[a]->place = a;
    order_[b]->place = b;
  }
  void rise(std::size_t place) {
    for (; place > 0 && before(place, (place - 1) / 2); place = (place - 1) / 2) swap(place, (place - 1) / 2);
  }
  /// Sinks among the first `size`.
  void sink(std::size_t place, std::size_t size) {
    for (std::size_t child = 2 * place + 1; child < size; child = 2 * place + 1) {
      if (child + 1 < size && before(child + 1, child)) ++child;
      if (!before(child, place)) return;
      swap(place, child);
      place = child;
    }
  }

  typename FairIds<Level>::template Entrants<Entrant> known_;
  typename FairIds<Level>::template Order<Entrant> order_;  // entrants that wait
  double now_ = 0;         // clock of what went last, when it went; never falls
  double overtaking_ = 0;  // cost / shares_
  double dearest_ = 0;     // piece, cost / share
  double shares_ = 0;      // of entrants that wait
  std::uint64_t entries_ = 0;
  std::size_t sweep_at_ = kMinSweep;
};

}  // namespace talus::server
