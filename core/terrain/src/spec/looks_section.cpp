#include "spec/looks_section.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace talus::terrain {
namespace {

// Each rock of a province has one of these borders, so that on a wall the borders of different rocks are not
// exactly above each other: the distances by which limits are moved, as large as the noise on borders. Height
// has no noise.
constexpr std::array<double, 3> kRockBorders{0, 0.06, -0.06};
constexpr double kBorderOfBase = 20;  // in terrain units, per 1 of other quantities
constexpr double kBorderOfHeight = 40;

std::vector<PlaceCondition> moved(std::vector<PlaceCondition> conditions, double by) {
  for (PlaceCondition& condition : conditions) {
    double scale = 1;
    if (condition.quantity == number_of(Quantity::base)) scale = kBorderOfBase;
    if (condition.quantity == number_of(Quantity::height)) scale = kBorderOfHeight;
    condition.limit += by * scale;
  }
  return conditions;
}

class LooksReader {
 public:
  LooksReader(TableReader& root, PlacesReader& places, std::vector<LookRules>& rules, const RockIds& rock,
              std::set<std::string>& names, std::vector<Material>& materials)
      : root_{root}, places_{places}, rules_{rules}, rock_{rock}, names_{names}, materials_{materials} {}

  LookTables read() {
    if (root_.has("look")) read_looks();
    if (root_.has("province")) read_provinces();
    return std::move(tables_);
  }

 private:
  struct Look {
    std::string name;
    std::size_t rules = 0;
    std::uint8_t number = 0;
    MaterialId of{};
  };

  void read_looks() {
    std::vector<TableReader> tables = root_.tables("look");
    for (TableReader& table : tables) read_look(table);
    // After all have their materials, because a look may show the material of a later one.
    for (auto& [look, table] : showing_) {
      const std::string name = table.text("shows", kMaxNameBytes);
      const Material* const material = material_named(name);
      if (material == nullptr || material->id == kWater) {
        table.fail("shows", "no material is named '" + name +
                                "'; the name of a look, layer or loose material is needed");
        continue;
      }
      tables_.shown_by[to_integer(looks_[look].of)]->by_look[looks_[look].number] = material->id;
    }
  }

  void read_look(TableReader& table) {
    table.only({"name", "of", "below", "above", "colour", "shows"});
    const std::string name = table.text("name", kMaxNameBytes);
    const Material* const of = replaced(table);
    LookCase one{places_.conditions(table), 0};
    if (of == nullptr) return;
    const auto known = std::find_if(looks_.begin(), looks_.end(),
                                    [&](const Look& look) { return look.name == name && look.of == of->id; });
    if (const Look* const whole = shown_everywhere(of->id)) {
      return table.fail("name", "'" + name + "' never shows, as '" + whole->name +
                                    "' before it has no conditions; put it before that");
    }
    const bool has_material = table.has("colour") || table.has("shows");
    if (known != looks_.end()) {
      if (has_material)
        table.fail(
            "name",
            "'" + name +
                "' names another look already; without colour and shows it is one more place for that");
      one.look = known->number;
      rules_[known->rules].cases.push_back(std::move(one));
      return;
    }
    if (!has_material)
      return table.fail("colour",
                        "missing; a colour of its own, or `shows` with another material's name, is needed");
    if (table.has("colour") && table.has("shows"))
      return table.fail("shows", "together with a colour; leave one of them out");
    add(name, *of, std::move(one), table);
  }

  /// Returns the look of a material that has no conditions, so that later looks never show.
  const Look* shown_everywhere(MaterialId of) const {
    const auto last =
        std::find_if(looks_.rbegin(), looks_.rend(), [&](const Look& look) { return look.of == of; });
    if (last == looks_.rend()) return nullptr;
    const LookCase& last_case = rules_[last->rules].cases.back();
    if (!last_case.conditions.empty()) return nullptr;
    return &*std::find_if(looks_.begin(), looks_.end(),
                          [&](const Look& look) { return look.of == of && look.number == last_case.look; });
  }

  void add(const std::string& name, const Material& of, LookCase one, TableReader& table) {
    const MaterialId of_id = of.id;
    World::ShownBy& shown = shown_by(of_id);
    if (shown.by_look.size() > kMaxLooks) {
      return table.fail("name", text_of("more than ", kMaxLooks, " looks of one material; leave some out"));
    }
    one.look = static_cast<std::uint8_t>(shown.by_look.size());
    looks_.push_back({name, shown.looks, one.look, of_id});
    rules_[shown.looks].cases.push_back(std::move(one));
    if (shown.looks == 0) tables_.names.push_back(name);
    if (table.has("shows")) {
      showing_.emplace_back(looks_.size() - 1, table);
      shown.by_look.push_back(of_id);
      return;
    }
    const MaterialKind kind = of_id == kWater ? MaterialKind::stratified : of.kind;
    const MaterialId id{static_cast<std::uint16_t>(materials_.size())};
    table.take_material_name("name", name, names_);
    shown.by_look.push_back(id);
    materials_.push_back({id, name, table.colour(), kind});
  }

  void read_provinces() {
    if (rules_.empty()) rules_.emplace_back();
    const std::size_t rules = rules_.size();
    rules_.resize(rules + kRockBorders.size());
    std::vector<TableReader> tables = root_.tables("province");
    for (std::size_t i = 0; i < tables.size(); ++i) {
      if (i == kMaxLooks)
        return tables[i].fail("name", text_of("more than ", kMaxLooks, " provinces; leave some out"));
      read_province(tables[i], rules, static_cast<std::uint8_t>(i + 1));
    }
  }

  void read_province(TableReader& table, std::size_t rules, std::uint8_t number) {
    table.only({"name", "below", "above", "colours"});
    const std::string name = table.text("name", kMaxNameBytes);
    const std::vector<PlaceCondition> conditions = places_.conditions(table);
    for (std::size_t i = 0; i < kRockBorders.size(); ++i) {
      rules_[rules + i].cases.push_back({moved(conditions, kRockBorders[i]), number});
    }
    auto colours = table.table("colours");
    if (!colours) return;
    for (const std::string& rock : colours->keys()) {
      const Material* const of = material_named(rock);
      if (of == nullptr || to_integer(of->id) < 2 || to_integer(of->id) >= to_integer(rock_.end)) {
        colours->fail(rock, "no [[stratified]] material has this name");
        continue;
      }
      if (of->id == rock_.lowest) {
        colours->fail(rock,
                      "the lowest layer goes on without end below y = 0, so it looks the same everywhere");
        continue;
      }
      const MaterialId of_id = of->id;
      World::ShownBy& shown = shown_by(of_id, rules + to_integer(of_id) % kRockBorders.size());
      shown.by_look.resize(number + 1U, of_id);
      const MaterialId id{static_cast<std::uint16_t>(materials_.size())};
      const std::string shown_name = name + " " + rock;
      colours->take_material_name(rock, shown_name, names_);
      shown.by_look[number] = id;
      materials_.push_back({id, shown_name, colours->colour(rock), MaterialKind::stratified});
    }
    for (auto& shown : tables_.shown_by) {
      const bool rock = shown && shown->looks >= rules && shown->looks < rules + kRockBorders.size();
      if (rock) shown->by_look.resize(number + 1U, shown->by_look.front());
    }
  }

  /// Returns the loose material, or water, that a look replaces.
  const Material* replaced(TableReader& table) {
    const std::string of = table.text("of", kMaxNameBytes);
    const Material* const material = material_named(of);
    const bool fits =
        material != nullptr && (material->kind == MaterialKind::eroded || material->id == kWater);
    if (!fits)
      table.fail("of", "no [[eroded]] material is named '" + of + "'; one of them, or \"water\", is needed");
    return fits ? material : nullptr;
  }

  const Material* material_named(const std::string& name) const {
    const auto found = std::find_if(materials_.begin(), materials_.end(),
                                    [&](const Material& material) { return material.name == name; });
    return found == materials_.end() || found->id == kAir ? nullptr : &*found;
  }

  /// The first rules are the ground's, even if it has no looks: they define a column's look.
  World::ShownBy& shown_by(MaterialId material) {
    const std::size_t place = to_integer(material);
    if (place < tables_.shown_by.size() && tables_.shown_by[place]) return *tables_.shown_by[place];
    if (rules_.empty()) rules_.emplace_back();
    const bool first_of_ground = material != kWater && !has_ground_;
    if (first_of_ground) has_ground_ = true;
    return shown_by(material, first_of_ground ? 0 : rules_.size());
  }
  /// Uses rules `rules` if the material has no rules yet.
  World::ShownBy& shown_by(MaterialId material, std::size_t rules) {
    const std::size_t place = to_integer(material);
    if (tables_.shown_by.size() <= place) tables_.shown_by.resize(place + 1);
    auto& shown = tables_.shown_by[place];
    if (!shown) {
      if (rules == rules_.size()) rules_.emplace_back();
      shown = World::ShownBy{rules, {material}};
    }
    return *shown;
  }

  TableReader& root_;
  PlacesReader& places_;
  std::vector<LookRules>& rules_;
  const RockIds rock_;
  std::set<std::string>& names_;
  std::vector<Material>& materials_;
  std::vector<Look> looks_;
  bool has_ground_ = false;  // true if the first rules belong to a loose material
  std::vector<std::pair<std::size_t, TableReader>> showing_;
  LookTables tables_{{}, {""}};
};

}  // namespace

LookTables read_looks(TableReader& root, PlacesReader& places, std::vector<LookRules>& rules,
                      const RockIds& rock, std::set<std::string>& names, std::vector<Material>& materials) {
  return LooksReader{root, places, rules, rock, names, materials}.read();
}

}  // namespace talus::terrain
