#include "spec/places_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "spec/angles.h"
#include "spec/regions_section.h"
#include "spec/units.h"

namespace talus::terrain {
namespace {

constexpr double kMinRamp = 0.001;  // so that its steepness is a finite float

constexpr Range kDegrees{0, 89};
constexpr Range kQuantityValues{-kMaxHeight, kMaxHeight};

// Rounded like the slopes of LooseSpec.
double slope_fx(double degrees) {
  return static_cast<double>(rounded(kSubvoxels * tangent_of_degrees(degrees)));
}

bool decided_after_looks(QuantityNumber quantity) {
  return quantity == number_of(Quantity::slope) || quantity == number_of(Quantity::cliff);
}

bool of_all_surfaces(QuantityNumber quantity) {
  return quantity == number_of(Quantity::height) || decided_after_looks(quantity);
}

}  // namespace

PlacesReader::PlacesReader(const WorldSpec& world, std::vector<FieldSpec> fields, PlacesSpec& places)
    : world_{world}, fields_{std::move(fields)}, places_{places} {}

std::optional<QuantityNumber> PlacesReader::quantity(TableReader& table, const std::string& name,
                                                     bool of_looks) {
  const auto number = static_cast<QuantityNumber>(
      std::distance(kQuantityNames.begin(), std::find(kQuantityNames.begin(), kQuantityNames.end(), name)));
  if (number < kQuantityNames.size()) {
    if (world_.surface.regions || of_all_surfaces(number)) return number;
    table.fail(name, "only a surface of kind \"regions\" has it; this one has height, slope and cliff");
    return std::nullopt;
  }
  const auto named = [&](const FieldSpec& field) { return field.name == name; };
  const auto asked = std::find_if(places_.fields.begin(), places_.fields.end(), named);
  if (asked != places_.fields.end()) {
    return kQuantities + static_cast<std::size_t>(asked - places_.fields.begin());
  }
  const auto field = std::find_if(fields_.begin(), fields_.end(), named);
  if (world_.surface.regions && field != fields_.end()) {
    places_.fields.push_back(*field);
    return kQuantities + places_.fields.size() - 1;
  }
  std::string names;
  for (QuantityNumber i = 0; i < kQuantityNames.size(); ++i) {
    if (!of_looks || !decided_after_looks(i)) names += std::string{kQuantityNames[i]} + ", ";
  }
  table.fail(name, "no quantity and no [[field]] has this name; known are " + names + "and fields by name");
  return std::nullopt;
}

void PlacesReader::add_ramps(TableReader& table, std::vector<PlaceRamp>& ramps) {
  for (const std::string& name : table.keys()) {
    const auto number = quantity(table, name, false);
    if (!number) continue;
    const bool slope = *number == number_of(Quantity::slope);
    std::vector<double> points = table.numbers(name, slope ? kDegrees : kQuantityValues, {2, 4});
    if (points.empty()) continue;
    if (slope) std::transform(points.begin(), points.end(), points.begin(), slope_fx);
    for (std::size_t i = 0; i < points.size(); i += 2) {
      // Of four points the last two are [all, none]: the quantity falls again.
      const double none = i == 0 ? points[0] : points[3];
      const double all = i == 0 ? points[1] : points[2];
      if (std::abs(none - all) < kMinRamp) {
        table.fail(name, text_of("the values for nothing and all are the same, or nearly; ", kMinRamp,
                                 " between them is needed"));
        continue;
      }
      ramps.push_back({*number, none, all});
    }
  }
  // Sorted, so that rounding does not depend on the order in the file.
  std::stable_sort(ramps.begin(), ramps.end(),
                   [](const PlaceRamp& a, const PlaceRamp& b) { return a.quantity < b.quantity; });
}

std::optional<std::size_t> PlacesReader::share(TableReader& table) {
  return share(table, {});
}

std::optional<std::size_t> PlacesReader::share(TableReader& table, std::span<const std::string> look_names) {
  if (!table.has("where") && !table.has("looks")) return std::nullopt;
  ShareRule rule;
  if (auto where = table.has("where") ? table.table("where") : std::nullopt) add_ramps(*where, rule.ramps);
  if (table.has("looks")) {
    rule.looks = 0;
    for (const std::string& name : table.texts("looks", kMaxNameBytes, kMaxLooks)) {
      const auto known = std::find(look_names.begin(), look_names.end(), name);
      if (name.empty() || known == look_names.end()) {
        table.fail("looks", "no look is named '" + name + "'; a [[look]] of that name is needed");
        break;
      }
      rule.looks |= std::uint64_t{1} << (known - look_names.begin());
    }
  }
  places_.shares.push_back(std::move(rule));
  return places_.shares.size() - 1;
}

void PlacesReader::add_conditions(TableReader& table, bool above, std::vector<PlaceCondition>& conditions) {
  for (const std::string& name : table.keys()) {
    const auto number = quantity(table, name, true);
    if (!number) continue;
    if (decided_after_looks(*number)) {
      table.fail(name, "what a place looks like may not depend on it; use it in `where`");
      continue;
    }
    conditions.push_back({*number, above, table.real(name, kQuantityValues)});
  }
}

std::vector<PlaceCondition> PlacesReader::conditions(TableReader& table) {
  std::vector<PlaceCondition> conditions;
  for (const bool above : {false, true}) {
    const std::string key = above ? "above" : "below";
    if (!table.has(key)) continue;
    if (auto limits = table.table(key)) add_conditions(*limits, above, conditions);
  }
  return conditions;
}

}  // namespace talus::terrain
