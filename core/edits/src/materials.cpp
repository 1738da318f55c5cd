#include <talus/edits/materials.h>

#include <algorithm>
#include <set>

namespace talus::edits {

std::optional<NamedIds> ids_for(std::span<const std::string> names, const MaterialIds& known) {
  std::uint32_t next = kFirstBound;
  for (const auto& [name, id] : known) next = std::max<std::uint32_t>(next, to_integer(id) + 1U);
  NamedIds all;
  std::set<std::string_view> seen;
  for (const std::string& name : names) {
    if (name.empty() || name.size() > kMaxMaterialNameBytes || !seen.insert(name).second) {
      return std::nullopt;
    }
    const auto bound = known.find(name);
    if (bound != known.end() && to_integer(bound->second) >= kFirstBound) {
      all.emplace_back(name, bound->second);
    } else if (next > UINT16_MAX) {
      return std::nullopt;
    } else {
      all.emplace_back(name, MaterialId{static_cast<std::uint16_t>(next++)});
    }
  }
  return all;
}

}  // namespace talus::edits
