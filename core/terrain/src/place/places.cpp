#include "place/places.h"

namespace talus::terrain {
namespace {

bool known_late(QuantityNumber quantity) {
  return quantity == number_of(Quantity::slope) || quantity == number_of(Quantity::cliff);
}

}  // namespace

Places places_of(const PlacesSpec& spec) {
  Places places;
  for (const LookRules& rules : spec.looks) {
    std::vector<Places::Case>& cases = places.looks.emplace_back();
    for (const LookCase& from : rules.cases) {
      Places::Case& one = cases.emplace_back();
      one.look = from.look;
      for (const PlaceCondition& condition : from.conditions) {
        one.conditions.push_back({condition.quantity, condition.above, static_cast<float>(condition.limit)});
      }
    }
  }
  for (const ShareRule& rule : spec.shares) {
    Places::Share& share = places.shares.emplace_back();
    share.looks = rule.looks;
    for (const PlaceRamp& ramp : rule.ramps) {
      auto& ramps = known_late(ramp.quantity) ? share.late : share.early;
      // `cliff` is an integer.
      const double unit = ramp.quantity == number_of(Quantity::cliff) ? kWholeShare : 1;
      ramps.push_back({ramp.quantity, static_cast<float>(ramp.none * unit),
                       static_cast<float>(1 / ((ramp.all - ramp.none) * unit))});
    }
  }
  places.reciprocal_lapse = static_cast<float>(1 / spec.lapse);
  places.quantities = kQuantities + spec.fields.size();
  return places;
}

}  // namespace talus::terrain
