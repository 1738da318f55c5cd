#include "place/narrowed_cases.h"

namespace talus::terrain {

NarrowedCases::Holds NarrowedCases::holds(const Places::Condition& condition, const ValueRange& range) {
  if (range.low >= condition.limit) return condition.above ? Holds::everywhere : Holds::nowhere;
  if (range.high < condition.limit) return condition.above ? Holds::nowhere : Holds::everywhere;
  return Holds::somewhere;
}

std::span<const Places::Case> NarrowedCases::of(std::span<const Places::Case> cases,
                                                std::span<const ValueRange> ranges) {
  if (cases_.size() < cases.size()) cases_.resize(cases.size());
  std::size_t count = 0;
  for (const Places::Case& from : cases) {
    Places::Case& left = cases_[count];
    left.look = from.look;
    left.conditions.clear();
    bool possible = true;
    for (const Places::Condition& condition : from.conditions) {
      const Holds where = holds(condition, ranges[condition.quantity]);
      possible = possible && where != Holds::nowhere;
      if (!possible) break;
      if (where == Holds::somewhere) left.conditions.push_back(condition);
    }
    if (!possible) continue;
    ++count;
    if (left.conditions.empty()) break;
  }
  return {cases_.data(), count};
}

}  // namespace talus::terrain
