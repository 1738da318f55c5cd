#include "place/narrowed_cases.h"

#include <algorithm>
#include <limits>

namespace talus::terrain {

NarrowedCases::Holds NarrowedCases::holds(const Places::Condition& condition, const ValueRange& range) {
  if (range.low >= condition.limit) return condition.above ? Holds::everywhere : Holds::nowhere;
  if (range.high < condition.limit) return condition.above ? Holds::nowhere : Holds::everywhere;
  return Holds::somewhere;
}

bool NarrowedCases::as_before(std::span<const ValueRange> ranges) const {
  return !limits_.empty() && std::all_of(limits_.begin(), limits_.end(), [&](const Limits& limits) {
    const ValueRange& range = ranges[limits.quantity];
    return range.low >= limits.from.low && range.low < limits.to.low && range.high >= limits.from.high &&
           range.high < limits.to.high;
  });
}

void NarrowedCases::compared(const Places::Condition& condition, const ValueRange& range) {
  auto limits = std::find_if(limits_.begin(), limits_.end(),
                             [&](const Limits& known) { return known.quantity == condition.quantity; });
  if (limits == limits_.end()) {
    constexpr float kMaxValue = std::numeric_limits<float>::infinity();
    limits =
        limits_.insert(limits_.end(), {condition.quantity, {-kMaxValue, -kMaxValue}, {kMaxValue, kMaxValue}});
  }
  const auto narrow_end = [&](float end, float& from, float& to) {
    if (end >= condition.limit) {
      from = std::max(from, condition.limit);
    } else {
      to = std::min(to, condition.limit);
    }
  };
  narrow_end(range.low, limits->from.low, limits->to.low);
  narrow_end(range.high, limits->from.high, limits->to.high);
}

void NarrowedCases::narrow(std::span<const ValueRange> ranges) {
  count_ = 0;
  limits_.clear();
  for (const Places::Case& from : all_) {
    Places::Case& left = cases_[count_];
    left.look = from.look;
    left.conditions.clear();
    bool possible = true;
    for (const Places::Condition& condition : from.conditions) {
      compared(condition, ranges[condition.quantity]);
      const Holds where = holds(condition, ranges[condition.quantity]);
      possible = where != Holds::nowhere;
      if (!possible) break;
      if (where == Holds::somewhere) left.conditions.push_back(condition);
    }
    if (!possible) continue;
    ++count_;
    if (left.conditions.empty()) break;
  }
}

std::span<const Places::Case> NarrowedCases::in(std::span<const ValueRange> ranges) {
  if (!as_before(ranges)) narrow(ranges);
  return {cases_.data(), count_};
}

}  // namespace talus::terrain
