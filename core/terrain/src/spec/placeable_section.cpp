#include "spec/placeable_section.h"

#include <array>

namespace talus::terrain {
namespace {

constexpr std::size_t kMaxPlaceables = 1024;  // materials, each state counted
constexpr std::size_t kMaxStates = 16;
constexpr std::array kPhases{MaterialKind::stratified, MaterialKind::water, MaterialKind::air};

}  // namespace

std::vector<Placeable> read_placeables(std::vector<TableReader>& tables, std::set<std::string>& names) {
  std::vector<Placeable> placeables;
  for (TableReader& table : tables) {
    table.only({"name", "colour", "phase", "states"});
    const Colour colour = table.colour();
    const MaterialKind kind =
        table.has("phase") ? kPhases[table.choice("phase", {"solid", "liquid", "gas"})] : kPhases[0];
    const std::string name = table.text("name", kMaxNameBytes);
    if (!table.has("states")) {
      table.take_name("name", name, names);
      placeables.push_back({name, colour, kind});
    } else {
      for (const std::string& state : table.texts("states", kMaxNameBytes, kMaxStates)) {
        const std::string whole = name + ": " + state;
        table.take_name("states", whole, names);
        placeables.push_back({whole, colour, kind});
      }
    }
    if (placeables.size() > kMaxPlaceables) {
      table.fail("name", text_of("is one placeable material too many; at most ", kMaxPlaceables,
                                 ", each state counted"));
      break;
    }
  }
  return placeables;
}

}  // namespace talus::terrain
